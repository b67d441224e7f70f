//! Pictures drawn for tests, and what is traced from them.

use expline::HermiteCurve;
use expline::numerics::Point;
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

/// The largest and the mean value of a distance along a curve.
pub(crate) fn along(curve: &HermiteCurve, distance: &dyn Fn(Point) -> f64) -> (f64, f64) {
    let (mut most, mut sum) = (0.0_f64, 0.0);
    for i in 0..2000 {
        let t = curve.domain().1 * f64::from(i) / 2000.0;
        let off = distance(curve.evaluate(t, 0).expect("inside the domain"));
        most = most.max(off);
        sum += off / 2000.0;
    }
    (most, sum)
}

/// A small generator of noise: the same numbers everywhere.
pub(crate) struct Noise(pub(crate) u64);

impl Noise {
    pub(crate) fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as f64 / (1_u64 << 31) as f64
    }

    /// About normal, of deviation 1.
    pub(crate) fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.unit()).sum::<f64>() - 6.0
    }
}

/// The corners of a star.
pub(crate) const STAR: [(f64, f64); 10] = [
    (32.3, 4.2),
    (38.1, 24.4),
    (59.2, 25.1),
    (42.6, 37.8),
    (48.7, 58.3),
    (31.9, 46.4),
    (14.2, 58.9),
    (21.3, 38.2),
    (4.6, 24.8),
    (25.4, 24.1),
];
