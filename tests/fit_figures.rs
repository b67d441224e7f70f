//! The figures of fits are what the code draws.
#![cfg(not(target_arch = "wasm32"))]

#[path = "../examples/fit_figures.rs"]
mod figures;

#[test]
fn the_noisy_outline_is_the_one_that_the_code_draws() {
    let drawn = figures::noisy_outline();
    assert!(
        drawn.as_deref() == Ok(include_str!("../docs/figures/noisy-outline.svg")),
        "draw it again with `cargo run --example fit_figures` and look at it"
    );
}
