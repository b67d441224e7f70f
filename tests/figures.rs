//! The figures of the documentation are what the code draws.
#![cfg(not(target_arch = "wasm32"))]

#[path = "../examples/figures/main.rs"]
mod figures;

use std::path::Path;

#[test]
fn every_figure_of_the_documentation_is_the_one_that_the_code_draws() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/figures");
    for (name, draw) in figures::FIGURES {
        let kept = std::fs::read_to_string(folder.join(format!("{name}.svg"))).expect("the figure is there");
        let drawn = draw().expect("it can be drawn");
        assert!(drawn == kept, "draw {name} again with `cargo run --example figures` and look at it");
        assert!(drawn.len() < 150_000, "{name} has {} bytes", drawn.len());
    }
}
