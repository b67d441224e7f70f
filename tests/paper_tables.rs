//! The table of estimators is what the code prints.
#![cfg(not(target_arch = "wasm32"))]

#[path = "../examples/paper_tables.rs"]
mod tables;

#[test]
fn the_table_of_estimators_is_the_one_that_the_code_prints() {
    let page = include_str!("../docs/PROFILES.md");
    let printed = page.split(tables::MARK).nth(1);
    let table = tables::table().expect("a table");
    assert_eq!(printed, Some(table.as_str()), "print it again with `cargo run --example paper_tables`");
}
