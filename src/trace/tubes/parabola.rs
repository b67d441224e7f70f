//! The parabola in the distance along a chain that is nearest to some points.

use crate::numerics::Vector;

/// Moments of distances, and of distances times offsets.
#[derive(Clone, Copy, Debug)]
pub(super) struct Parabola {
    moments: [f64; 5],
    right: [Vector; 3],
}

impl Parabola {
    pub(super) fn new() -> Self {
        Self { moments: [0.0; 5], right: [Vector::zeros(); 3] }
    }

    /// One point, at a distance along the chain, by its offset from where the distance is 0.
    pub(super) fn add(&mut self, distance: f64, offset: Vector) {
        let mut power = 1.0;
        for (k, moment) in self.moments.iter_mut().enumerate() {
            *moment += power;
            if k < 3 {
                self.right[k] += offset * power;
            }
            power *= distance;
        }
    }

    /// Value, slope and second derivative at distance 0; `None` where there are fewer than three places.
    pub(super) fn solve(&self) -> Option<[Vector; 3]> {
        let (s, right) = (&self.moments, &self.right);
        let minor = |a: usize, b: usize, c: usize, d: usize| s[a] * s[d] - s[b] * s[c];
        let determinant = s[0] * minor(2, 3, 3, 4) - s[1] * minor(1, 3, 2, 4) + s[2] * minor(1, 2, 2, 3);
        if determinant <= 1e-9 * s[0] * s[2] * s[4] || s[0] < 3.0 {
            return None;
        }
        // The inverse of the symmetric matrix of moments, times the right-hand sides.
        let combine = |a: f64, b: f64, c: f64| (right[0] * a + right[1] * b + right[2] * c) / determinant;
        Some([
            combine(minor(2, 3, 3, 4), -minor(1, 2, 3, 4), minor(1, 2, 2, 3)),
            combine(-minor(1, 3, 2, 4), minor(0, 2, 2, 4), -minor(0, 1, 2, 3)),
            combine(minor(1, 2, 2, 3), -minor(0, 2, 1, 3), minor(0, 1, 1, 2)) * 2.0,
        ])
    }
}
