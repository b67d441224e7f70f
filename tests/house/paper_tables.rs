//! The table of estimators is what the code prints.

#[path = "../../examples/paper_tables.rs"]
mod tables;

/// RMSE and coefficients of one row.
fn figures(row: &str) -> (f64, f64) {
    let cells: Vec<&str> = row.split('|').map(str::trim).collect();
    let number = |i: usize| cells[i].parse().expect("a number");
    (number(2), number(7))
}

#[test]
fn the_improved_estimator_predicts_best_on_every_picture_with_no_more_coefficients_than_the_next() {
    let page = include_str!("../../docs/PROFILES.md");
    let pictures: Vec<&str> = page.split("\n**").skip(1).collect();
    assert_eq!(pictures.len(), 10);
    for picture in pictures {
        let rows = || picture.lines().filter(|line| line.starts_with("| ") && !line.contains("RMSE"));
        let improved = figures(rows().find(|row| row.contains("improved")).expect("a row"));
        let others = rows().filter(|row| !row.contains("improved")).map(figures);
        let next = others.min_by(|a, b| a.0.total_cmp(&b.0)).expect("a row");
        assert!(improved.0 <= next.0, "{picture}");
        assert!(improved.1 <= next.1, "{picture}");
    }
}

#[test]
fn the_table_of_estimators_is_the_one_that_the_code_prints() {
    let page = include_str!("../../docs/PROFILES.md");
    let printed = page.split(tables::MARK).nth(1);
    let table = tables::table().expect("a table");
    assert_eq!(printed, Some(table.as_str()), "print it again with `cargo run --example paper_tables`");
}
