//! Panels side by side: points, a curve through them, its knots.

use expline::numerics::Point;
use std::fmt::Write as _;

/// Ink, for drawings so many times 430 across.
fn style(k: f64) -> String {
    let stroke = |class: &str, ink: &str, width: f64| {
        format!(".{class}{{fill:none;stroke:{ink};stroke-width:{:.1};stroke-linecap:round}}", k * width)
    };
    format!(
        "<style>{}{}{}{}{}.corner{{stroke-linecap:square}}.data{{opacity:.5}}\
         text{{font:{:.0}px system-ui,sans-serif;fill:#1b1f24}}.name{{font-weight:600}}</style>",
        stroke("data", "#8a5a00", 2.6),
        stroke("curve", "#0b57d0", 2.6),
        stroke("ring", "#0b57d0", 15.0),
        stroke("knot", "#fff", 10.0),
        stroke("corner", "#0b57d0", 11.0),
        26.0 * k,
    )
}

/// One panel: path data of the curve, and its knots, those of corners apart.
pub(crate) struct Panel {
    pub(crate) name: String,
    pub(crate) note: String,
    pub(crate) data: usize,
    pub(crate) curve: String,
    pub(crate) corners: Vec<Point>,
    pub(crate) knots: Vec<Point>,
}

/// Dots as one path: lines without length, with round ends.
fn dots(class: &str, places: &[Point], digits: usize) -> String {
    let mut d = String::new();
    for p in places {
        let _ = write!(d, "M{:.digits$} {:.digits$}h0", p.x, p.y);
    }
    format!("<path class=\"{class}\" d=\"{d}\"/>")
}

/// Path data of a closed polygon.
pub(crate) fn polygon(places: &[Point]) -> String {
    let mut d = String::new();
    for p in places {
        let _ = write!(d, "{}{:.1} {:.1}", if d.is_empty() { 'M' } else { 'L' }, p.x, p.y);
    }
    d + "Z"
}

/// A figure of panels in rows; `data` are the points that panels refer to, `size` the side of a drawing.
pub(crate) fn figure(
    label: &str,
    data: &[Vec<Point>],
    panels: &[Panel],
    columns: usize,
    size: f64,
) -> String {
    let k = size / 430.0;
    let (wide, high) = (size + 40.0 * k, size + 110.0 * k);
    let (width, height) = (wide * columns as f64, high * panels.len().div_ceil(columns) as f64);
    let mut drawn = String::new();
    for (i, points) in data.iter().enumerate() {
        let _ = writeln!(drawn, "<defs><g id=\"d{i}\">{}</g></defs>", dots("data", points, 0));
    }
    for (i, panel) in panels.iter().enumerate() {
        let (x, y) = (20.0 * k + wide * (i % columns) as f64, 85.0 * k + high * (i / columns) as f64);
        let _ = write!(
            drawn,
            "<g transform=\"translate({x:.0} {y:.0})\"><text class=\"name\" y=\"{:.0}\">{}</text><text y=\"{:.0}\">{}</text>\n\
             <use href=\"#d{}\"/><path class=\"curve\" d=\"{}\"/>\n{}{}{}</g>\n",
            -44.0 * k,
            panel.name,
            -14.0 * k,
            panel.note,
            panel.data,
            panel.curve,
            dots("ring", &panel.knots, 1),
            dots("knot", &panel.knots, 1),
            dots("corner", &panel.corners, 1),
        );
    }
    let scale = 860.0 / width;
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width:.0} {height:.0}\" width=\"860\" height=\"{:.0}\" role=\"img\" aria-label=\"{label}\">\n{}\n\
         <rect width=\"{width:.0}\" height=\"{height:.0}\" fill=\"#fbfbfa\"/>\n{drawn}</svg>\n",
        height * scale,
        style(k),
    )
}
