//! Draws the figures of fits into docs/figures and the tables into docs/FITS.md: `cargo run --example fit_figures`.

#[path = "fits/contours.rs"]
mod contours;
#[path = "fits/experiments.rs"]
pub(crate) mod experiments;
#[path = "fits/matched.rs"]
mod matched;
#[path = "fits/panels.rs"]
mod panels;

use contours::Random;
use experiments::Shown;
use expline::fit::{Ask, Options, fit};
use expline::numerics::Point;
use expline::svg::{PrintOptions, to_path_d};
use expline::{Error, Result};

/// Two straight sides, a side that waves and an arc, 600 points with noise.
fn outline() -> Vec<Point> {
    let tau = core::f64::consts::TAU;
    let mut random = Random(3);
    let mut points = Vec::new();
    let mut side = |count: u32, at: &dyn Fn(f64) -> Point| {
        for k in 0..count {
            let noise = Point::new(random.normal(), random.normal()) * 1.5;
            points.push(at(f64::from(k) / f64::from(count)) + noise);
        }
    };
    side(150, &|u| Point::new(60.0 + 360.0 * u, 80.0));
    side(125, &|u| Point::new(420.0, 80.0 + 300.0 * u));
    side(165, &|u| Point::new(420.0 - 360.0 * u, 380.0 + 40.0 * libm::sin(tau * u)));
    side(160, &|u| {
        let angle = tau * (0.25 + 0.5 * u);
        Point::new(60.0 + 52.5 * libm::cos(angle), 230.0 + 150.0 * libm::sin(angle))
    });
    points
}

/// Noisy points, the curve that they say, and its knots: corners square, others round.
pub(crate) fn noisy_outline() -> Result<String> {
    let points = outline();
    let fitted = fit(&points, Ask::Noise, &Options::default())?;
    let options = PrintOptions { tolerance: 1e-2, decimals: Some(2), arcs: false, relative: false };
    let d = to_path_d(&fitted.curve, &options)?.d;
    let mut marks = String::new();
    for point in &points {
        marks += &format!("<circle class=\"data\" cx=\"{:.1}\" cy=\"{:.1}\" r=\"1.3\"/>", point.x, point.y);
    }
    for knot in &fitted.knots {
        let (x, y) = (knot.point.x, knot.point.y);
        marks += &if knot.degree == 1 {
            format!(
                "<rect class=\"corner\" x=\"{:.1}\" y=\"{:.1}\" width=\"8\" height=\"8\"/>",
                x - 4.0,
                y - 4.0
            )
        } else {
            format!("<circle class=\"knot\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\"/>")
        };
    }
    Ok(format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 40 460 400\" width=\"690\" height=\"600\" role=\"img\" \
         aria-label=\"600 noisy points and the curve fitted to them, with its knots\">\n<style>\
         .data{{fill:#8a5a00;opacity:.55}}.curve{{fill:none;stroke:#0b57d0;stroke-width:2}}.knot{{fill:#fff;stroke:#0b57d0;stroke-width:2}}\
         .corner{{fill:#0b57d0}}text{{font:12px system-ui,sans-serif;fill:#1b1f24}}</style>\n\
         <rect y=\"40\" width=\"460\" height=\"400\" fill=\"#fbfbfa\"/>\n<path class=\"curve\" d=\"{d}\"/>\n{marks}\n\
         <text x=\"210\" y=\"240\" text-anchor=\"middle\">600 points, {} knots</text>\n</svg>\n",
        fitted.knots.len()
    ))
}

/// Where a table begins on the page.
pub(crate) fn mark(name: &str) -> String {
    format!("<!-- {name}: cargo run --example fit_figures -->\n")
}

/// Where it ends.
pub(crate) const END: &str = "<!-- end -->";

#[allow(dead_code, reason = "tests/house/fit_figures.rs compares the figures without writing them")]
fn main() -> std::result::Result<(), Box<dyn std::error::Error>> {
    let plain = |error: Box<Error>| *error;
    std::fs::write("docs/figures/noisy-outline.svg", noisy_outline().map_err(plain)?)?;
    let mut page = std::fs::read_to_string("docs/FITS.md")?;
    let mut show = |name: &str, shown: Shown| -> std::io::Result<()> {
        std::fs::write(format!("docs/figures/fit-{name}.svg"), shown.figure)?;
        if let Some((before, rest)) = page.clone().split_once(&mark(name))
            && let Some((_, after)) = rest.split_once(END)
        {
            page = format!("{before}{}{}{END}{after}", mark(name), shown.table);
        }
        Ok(())
    };
    show("rotation", experiments::rotation().map_err(plain)?.1)?;
    show("sparsity", experiments::sparsity().map_err(plain)?.1)?;
    show("noise", experiments::noise().map_err(plain)?.1)?;
    show("hybrid", experiments::hybrid().map_err(plain)?.1)?;
    show("sweep", experiments::sweep().map_err(plain)?.1)?;
    std::fs::write("docs/FITS.md", page)?;
    Ok(())
}
