//! The circle from two points, beside four Béziers.

use expline::numerics::{Point, Vector};
use expline::svg::{PrintOptions, to_path_d};
use expline::{HermiteCurve, Result};

/// How many times too large the Bézier's error is drawn.
const MAGNIFICATION: f64 = 500.0;

/// A circle from two points with its handles, beside the best known circle of four cubic Béziers.
pub(crate) fn circle() -> Result<String> {
    let (center, radius) = (Point::new(160.0, 120.0), 80.0);
    let curve = HermiteCurve::ellipse(center, Vector::new(radius, radius), 0.0, 2)?;
    let options = PrintOptions { tolerance: 1e-3, decimals: Some(3), arcs: true, relative: false };
    let d = to_path_d(&curve, &options)?.d;
    let mut marks = String::new();
    for (point, tangent) in curve.points().iter().zip(curve.tangents()) {
        // Handles are shown at a third of the tangent, as long as a Bézier's would be.
        for end in [point + tangent / 3.0, point - tangent / 3.0] {
            marks += &format!(
                "<path class=\"stem\" d=\"M{:.2} {:.2}L{:.2} {:.2}\"/><circle class=\"end\" cx=\"{:.2}\" cy=\"{:.2}\" r=\"4\"/>",
                point.x, point.y, end.x, end.y, end.x, end.y
            );
        }
        marks += &format!("<circle class=\"point\" cx=\"{:.2}\" cy=\"{:.2}\" r=\"4.5\"/>", point.x, point.y);
    }
    Ok(format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 320 240\" width=\"640\" height=\"480\" role=\"img\" \
         aria-label=\"A circle from two points; four Béziers, their error 500 times as large\">\n<style>\
         .curve{{fill:#0b57d014;stroke:#1b1f24;stroke-width:2}}.ghost{{fill:none;stroke:#8a5a00;stroke-dasharray:2 3}}\
         .stem{{stroke:#0e7490}}.end{{fill:#fff;stroke:#0e7490;stroke-width:1.5}}.point{{fill:#0b57d0}}\
         text{{font:11px system-ui,sans-serif;fill:#8a5a00}}</style>\n\
         <rect width=\"320\" height=\"240\" fill=\"#fbfbfa\"/>\n<path class=\"ghost\" d=\"{}\"/>\n<path class=\"curve\" d=\"{d}\"/>\n{marks}\n\
         <text x=\"308\" y=\"18\" text-anchor=\"end\">four Béziers, error × 500</text>\n</svg>\n",
        ghost(center, radius)
    ))
}

/// The quarter circle of κ = 0.5519150244935106, the least largest error, turned four times and magnified.
fn ghost(center: Point, radius: f64) -> String {
    let kappa = 0.551_915_024_493_510_6;
    let steps = 90;
    let mut d = String::new();
    for quarter in 0..4 {
        for i in 0..steps {
            let (t, s) = (f64::from(i) / f64::from(steps), 1.0 - f64::from(i) / f64::from(steps));
            let (a, b, c, e) = (s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t);
            let (x, y) = (a + b + c * kappa, b * kappa + c + e);
            let norm = x.hypot(y);
            let scale = radius * (1.0 + (norm - 1.0) * MAGNIFICATION) / norm;
            let (x, y) = match quarter {
                0 => (x, y),
                1 => (-y, x),
                2 => (-x, -y),
                _ => (y, -x),
            };
            let letter = if d.is_empty() { 'M' } else { 'L' };
            d += &format!("{letter}{:.2} {:.2}", center.x + scale * x, center.y + scale * y);
        }
    }
    d + "Z"
}
