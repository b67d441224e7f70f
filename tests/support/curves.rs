//! Curves to test on: seeded, of every space, degenerate ones among them.

use expline::numerics::{Point, Vector};
use expline::{HermiteCurve, HermiteOptions, Space};

/// A small generator (splitmix64), so that every host draws the same numbers.
pub(crate) struct Random(u64);

impl Random {
    /// Seeds that follow one another begin streams that have nothing in common: unmixed they would begin one stream at
    /// places next to each other, and a loop over them would try nearly the same thing again and again.
    pub(crate) fn new(seed: u64) -> Self {
        Self(Self(seed).bits())
    }

    pub(crate) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// Uniform in [0, 1).
    pub(crate) fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Uniform in [−1, 1).
    pub(crate) fn symmetric(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }

    /// Uniform in the square of half side `size`.
    pub(crate) fn vector(&mut self, size: f64) -> Vector {
        Vector::new(self.symmetric() * size, self.symmetric() * size)
    }

    /// Normally distributed, of variance 1 (Box and Muller).
    pub(crate) fn normal(&mut self) -> f64 {
        let radius = libm::sqrt(-2.0 * libm::log(1.0 - self.unit()));
        radius * libm::cos(core::f64::consts::TAU * self.unit())
    }

    /// Noise of the plane, of variance 1 in each coordinate.
    pub(crate) fn noise(&mut self) -> Vector {
        Vector::new(self.normal(), self.normal())
    }

    /// The points with noise of this standard deviation in each coordinate.
    pub(crate) fn noisy(&mut self, points: &[Point], sigma: f64) -> Vec<Point> {
        points.iter().map(|point| point + self.noise() * sigma).collect()
    }

    /// A natural number below `n`.
    pub(crate) fn below(&mut self, n: usize) -> usize {
        (self.bits() % n as u64) as usize
    }
}

/// Curve number `case`: the space, the frequency, the scale and the degeneracy go through all their combinations.
pub(crate) fn random_curve(random: &mut Random, case: usize) -> HermiteCurve {
    let scale = [1.0, 1e-6, 1e6, 300.0][case / 7 % 4];
    let space = [Space::Trigonometric, Space::Polynomial, Space::Hyperbolic][case % 3];
    let most = match space {
        Space::Trigonometric => [0.3, 1.6, 3.1, 6.2][case / 3 % 4],
        Space::Polynomial => 0.0,
        Space::Hyperbolic => [0.5, 3.0, 30.0, 9e3][case / 3 % 4],
    };
    let count = 2 + random.bits() as usize % 5;
    let closed = random.bits().is_multiple_of(2);
    let mut points: Vec<Point> = (0..count).map(|_| random.vector(scale)).collect();
    let mut tangents: Vec<Vector> = (0..count).map(|_| random.vector(scale * 3.0)).collect();
    let mut tangents_in = Vec::new();
    match case / 5 % 7 {
        0 => tangents.iter_mut().for_each(|v| *v = Vector::zeros()),
        1 => tangents[0] = Vector::zeros(),
        2 => points.iter_mut().chain(&mut tangents).for_each(|v| v.y = 0.25 * v.x),
        3 => points[1] = points[0],
        4 => tangents_in = (0..count).map(|_| random.vector(scale * 3.0)).collect(),
        _ => {}
    }
    let segments = if closed { count } else { count - 1 };
    let omega = (0..segments).map(|_| most * random.unit()).collect();
    HermiteCurve::new(HermiteOptions {
        points,
        tangents,
        tangents_in,
        closed,
        space: Some(space),
        omega,
        ..Default::default()
    })
    .expect("within the limits")
}
