//! The figures of the documentation are what the code draws.
#![cfg(not(target_arch = "wasm32"))]

#[path = "../examples/figures.rs"]
mod figures;

#[test]
fn the_circle_of_the_readme_is_the_one_that_the_code_draws() {
    let drawn = figures::circle();
    assert_eq!(
        drawn.as_deref(),
        Ok(include_str!("../docs/figures/circle.svg")),
        "draw it again with `cargo run --example figures` and look at it"
    );
}
