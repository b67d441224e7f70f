//! Draws the figures of the documentation into docs/figures: `cargo run --example figures`.
//!
//! They are computed, never drawn by hand; `tests/house/figures.rs` fails when a figure and the code disagree.

mod circle;
mod generators;
mod plot;
mod refined;
mod solid;
mod surfaces;
mod tracing;
mod trigonometric;

use expline::Result;

/// A figure's file and what draws it.
pub(crate) type Figure = (&'static str, fn() -> Result<String>);

/// Every figure.
pub(crate) const FIGURES: [Figure; 8] = [
    ("circle", circle::circle),
    ("generators", generators::generators),
    ("refined-circle", refined::refined_circle),
    ("cosine-sine-circle", trigonometric::cosine_sine_circle),
    ("roman-surface", surfaces::roman_surface),
    ("hyperbolic-paraboloid", surfaces::hyperbolic_paraboloid),
    ("quadrics", surfaces::quadrics),
    ("shapes", surfaces::shapes),
];

/// The figure whose numbers are fitted: a better tracer may move them by less than anybody sees.
pub(crate) const FITTED: Figure = ("tracing", tracing::tracing);

#[allow(dead_code, reason = "tests/house/figures.rs compares the figures without writing them")]
fn main() -> std::result::Result<(), Box<dyn std::error::Error>> {
    std::fs::create_dir_all("docs/figures")?;
    for (name, draw) in FIGURES.into_iter().chain([FITTED]) {
        std::fs::write(format!("docs/figures/{name}.svg"), draw()?)?;
    }
    Ok(())
}
