//! Pictures drawn for tests, and what is traced from them.

use expline::trace::{Gray, Trace, TraceOptions, trace};

/// Whether there is ink at a place.
pub(crate) type Ink<'a> = &'a dyn Fn(f64, f64) -> bool;

/// Places per pixel and axis at which a picture asks whether there is ink: coverage to a few thousandths.
const FINE: usize = 16;

/// Draws a shape with anti-aliasing, dark on white.
pub(crate) fn draw(width: usize, height: usize, ink: Ink) -> Vec<u8> {
    draw_finely(width, height, FINE, ink)
}

/// The same with so many samples in each pixel's row and column.
pub(crate) fn draw_finely(width: usize, height: usize, fine: usize, ink: Ink) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(width * height);
    for row in 0..height {
        for column in 0..width {
            let place = |start: usize, k: usize| start as f64 + (k as f64 + 0.5) / fine as f64;
            let hits =
                (0..fine * fine).filter(|k| ink(place(column, k % fine), place(row, k / fine))).count();
            bytes.push((255.0 * (1.0 - hits as f64 / (fine * fine) as f64)).round() as u8);
        }
    }
    bytes
}

/// What is traced without any wishes.
pub(crate) fn traced(width: usize, height: usize, bytes: &[u8]) -> Trace {
    let gray = Gray::from_bytes(width, height, bytes).expect("a valid picture");
    trace(gray, &TraceOptions::default()).expect("a drawing")
}

/// Whether a place is inside a polygon.
pub(crate) fn inside(corners: &[(f64, f64)], x: f64, y: f64) -> bool {
    let mut within = false;
    for (i, &(x0, y0)) in corners.iter().enumerate() {
        let (x1, y1) = corners[(i + 1) % corners.len()];
        if (y0 > y) != (y1 > y) && x < x0 + (x1 - x0) * (y - y0) / (y1 - y0) {
            within = !within;
        }
    }
    within
}
