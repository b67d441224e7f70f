//! Contours for the experiments: corners, arcs, and noise that is the same on every machine.

use expline::numerics::{Point, Vector};
use expline::svg::parse_path;
use expline::{Curve, Result};

/// A small generator, so that every machine draws the same noise.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Normally distributed, nearly.
    pub(crate) fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.unit()).sum::<f64>() - 6.0
    }
}

/// A polygon with twenty corners, some 430 across.
pub(crate) const CASTLE: &str = "M20 60L90 20L130 90L180 60L200 120L270 100L300 20L360 70L340 150L430 180L410 250L350 240L380 330\
L310 400L270 340L200 420L150 350L70 380L100 270L30 220Z";

/// Straight sides, arcs, and five places where two of them meet in a kink.
pub(crate) const SHIELD: &str = "M40 330L40 150C40 40 190 20 215 120C240 20 390 40 390 150L390 330C330 430 290 300 215 400\
C140 300 100 430 40 330Z";

/// Ears, cheeks and a chin: a contour like that of a mascot.
pub(crate) const FOX: &str = "M60 20L150 110C190 95 250 95 290 110L380 20C400 90 405 150 385 210L430 250L370 265C355 320 290 350 250 415\
L220 430L190 415C150 350 85 320 70 265L10 250L55 210C35 150 40 90 60 20Z";

/// So many places, evenly by length, on path data; `size` is the scale.
pub(crate) fn along(d: &str, count: usize, size: f64) -> Result<Vec<Point>> {
    let parsed = parse_path(d)?;
    let curve = &parsed.curves[0];
    let place = |t: f64| Ok(curve.evaluate(t, 0)? * size);
    curve.sample_by_length(count, 1e-6)?.into_iter().map(place).collect()
}

/// The same places with noise of this deviation in each coordinate.
pub(crate) fn noisy(places: &[Point], deviation: f64, seed: u64) -> Vec<Point> {
    let mut random = Random(seed);
    places.iter().map(|p| p + Vector::new(random.normal(), random.normal()) * deviation).collect()
}

/// The same places on whole pixels, as contours of pictures have them.
pub(crate) fn on_pixels(places: &[Point]) -> Vec<Point> {
    places.iter().map(|p| Point::new(libm::round(p.x), libm::round(p.y))).collect()
}

/// Turned by an angle in degrees round the middle of the drawing.
pub(crate) fn turned(places: &[Point], degrees: f64) -> Vec<Point> {
    let angle = degrees.to_radians();
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    let middle = Point::new(215.0, 215.0);
    let turn = |p: &Point| {
        let way = p - middle;
        middle + Vector::new(cos * way.x - sin * way.y, sin * way.x + cos * way.y)
    };
    places.iter().map(turn).collect()
}
