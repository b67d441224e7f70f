//! One second-order cone of the interior-point method, with Nesterov and Todd's scaling.

use crate::numerics::Vector;
use crate::numerics::order::median;

/// A vector (x₀, x₁) with x₁ in the plane; in the cone where x₀ ≥ |x₁|.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lorentz {
    pub(crate) height: f64,
    pub(crate) plane: Vector,
}

impl Lorentz {
    pub(crate) fn new(height: f64, plane: Vector) -> Self {
        Self { height, plane }
    }

    /// x₀² − |x₁|², without cancellation.
    #[inline]
    fn determinant(self) -> f64 {
        let length = norm(self.plane);
        (self.height - length) * (self.height + length)
    }

    #[inline]
    pub(crate) fn dot(self, other: Self) -> f64 {
        self.height * other.height + dot(self.plane, other.plane)
    }

    #[inline]
    pub(crate) fn advanced(self, by: Self, step: f64) -> Self {
        Self::new(self.height + step * by.height, self.plane + by.plane * step)
    }

    /// The longest step along `by` that stays in the cone, at most `most`.
    #[inline]
    pub(crate) fn reach(self, by: Self, most: f64) -> f64 {
        let a = (by.height - norm(by.plane)) * (by.height + norm(by.plane));
        let b = self.height * by.height - dot(self.plane, by.plane);
        let c = self.determinant();
        let discriminant = b * b - a * c;
        if discriminant < 0.0 || (a >= 0.0 && b >= 0.0) {
            return most;
        }
        let denominator = discriminant.sqrt() - b;
        if denominator * most > c { (c / denominator).max(0.0) } else { most }
    }
}

#[inline]
pub(crate) fn dot(u: Vector, v: Vector) -> f64 {
    u.x * v.x + u.y * v.y
}

#[inline]
pub(crate) fn norm(v: Vector) -> f64 {
    dot(v, v).sqrt()
}

/// The median of their lengths; 0 of none.
pub(crate) fn typical_length<'a>(vectors: impl IntoIterator<Item = &'a Vector>) -> f64 {
    median(&mut vectors.into_iter().map(|v| norm(*v)).collect::<Vec<f64>>())
}

/// The matrix W with W z = W⁻¹ s for a primal s and a dual z inside the cone.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scaling {
    /// The unit-determinant vector that W is made of.
    unit: Lorentz,
    size: f64,
    /// W z.
    point: Lorentz,
}

/// A symmetric 2 × 2 matrix: xx, xy, yy.
pub(crate) type Metric = [f64; 3];

impl Scaling {
    #[inline]
    pub(crate) fn new(s: Lorentz, z: Lorentz) -> Self {
        let (root_s, root_z) = (s.determinant().sqrt(), z.determinant().sqrt());
        let (s, z) = (s.advanced(s, 1.0 / root_s - 1.0), z.advanced(z, 1.0 / root_z - 1.0));
        let gamma = (0.5 * (1.0 + s.dot(z))).sqrt();
        let plane = (s.plane - z.plane) / (2.0 * gamma);
        let unit = Lorentz::new((1.0 + dot(plane, plane)).sqrt(), plane);
        let size = (root_s / root_z).sqrt();
        let mut scaling = Self { unit, size, point: z };
        scaling.point = scaling.apply(Lorentz::new(z.height * root_z, z.plane * root_z));
        scaling
    }

    /// W x.
    #[inline]
    pub(crate) fn apply(&self, x: Lorentz) -> Lorentz {
        let along = dot(self.unit.plane, x.plane);
        let share = x.height + along / (1.0 + self.unit.height);
        Lorentz::new(
            self.size * (self.unit.height * x.height + along),
            (x.plane + self.unit.plane * share) * self.size,
        )
    }

    /// W⁻¹ x.
    #[inline]
    pub(crate) fn undo(&self, x: Lorentz) -> Lorentz {
        let along = dot(self.unit.plane, x.plane);
        let share = along / (1.0 + self.unit.height) - x.height;
        Lorentz::new(
            (self.unit.height * x.height - along) / self.size,
            (x.plane + self.unit.plane * share) / self.size,
        )
    }

    /// The Schur complement of W⁻² in the plane, after the height is eliminated. (D 12.6)
    #[inline]
    pub(crate) fn metric(&self) -> Metric {
        let (w, square) = (self.unit, 1.0 / (self.size * self.size));
        let factor = 2.0 * square / (2.0 * w.height * w.height - 1.0);
        let v = w.plane;
        [square - factor * v.x * v.x, -factor * v.x * v.y, square - factor * v.y * v.y]
    }

    /// The part of W⁻² that couples height and plane over the part of the height alone: a direction in the plane.
    #[inline]
    pub(crate) fn slope(&self) -> Vector {
        self.unit.plane * (-2.0 * self.unit.height / (2.0 * self.unit.height * self.unit.height - 1.0))
    }

    /// 1 / (W⁻²)₀₀.
    #[inline]
    pub(crate) fn compliance(&self) -> f64 {
        self.size * self.size / (2.0 * self.unit.height * self.unit.height - 1.0)
    }

    /// The complementarity residual of the corrector, `s + W(v \ (W⁻¹Δs ∘ WΔz − σμe))` with v = W z.
    #[inline]
    pub(crate) fn corrector(&self, s: Lorentz, ds: Lorentz, dz: Lorentz, target: f64) -> Lorentz {
        let (x, y, v) = (self.undo(ds), self.apply(dz), self.point);
        let product = Lorentz::new(x.dot(y) - target, y.plane * x.height + x.plane * y.height);
        let height = (v.height * product.height - dot(v.plane, product.plane)) / v.determinant();
        let quotient = Lorentz::new(height, (product.plane - v.plane * height) / v.height);
        s.advanced(self.apply(quotient), 1.0)
    }
}

/// A metric times a vector.
#[inline]
pub(crate) fn stretch(metric: &Metric, v: Vector) -> Vector {
    Vector::new(metric[0] * v.x + metric[1] * v.y, metric[1] * v.x + metric[2] * v.y)
}

#[cfg(test)]
mod tests {
    use super::{Lorentz, Scaling, dot, norm, stretch};
    use crate::numerics::Vector;

    fn close(a: Lorentz, b: Lorentz) -> bool {
        (a.height - b.height).abs() + norm(a.plane - b.plane) < 1e-12 * (1.0 + b.height.abs())
    }

    #[test]
    fn the_scaling_takes_dual_and_primal_to_the_same_point() {
        let s = Lorentz::new(3.0, Vector::new(1.0, -2.5));
        let z = Lorentz::new(1.5, Vector::new(0.3, 1.4));
        let w = Scaling::new(s, z);
        assert!(close(w.apply(z), w.undo(s)), "W z = W⁻¹ s");
        assert!(close(w.undo(w.apply(s)), s), "W⁻¹ W = 1");
        // Eliminating the height from W⁻² leaves the metric.
        let inverse_square = |x| w.undo(w.undo(x));
        let along = inverse_square(Lorentz::new(1.0, Vector::zeros()));
        assert!((along.height * w.compliance() - 1.0).abs() < 1e-12, "the corner of W⁻²");
        for axis in [Vector::new(1.0, 0.0), Vector::new(0.0, 1.0)] {
            let full = inverse_square(Lorentz::new(0.0, axis));
            let left = full.plane - along.plane * (full.height / along.height);
            assert!(norm(left - stretch(&w.metric(), axis)) < 1e-12, "the Schur complement");
            assert!((dot(w.slope(), axis) - full.height / along.height).abs() < 1e-12, "its slope");
        }
    }

    #[test]
    fn the_longest_step_ends_on_the_boundary() {
        let s = Lorentz::new(2.0, Vector::new(1.0, 0.5));
        for by in [Lorentz::new(-1.0, Vector::new(0.2, 0.1)), Lorentz::new(1.0, Vector::new(3.0, -4.0))] {
            let end = s.advanced(by, s.reach(by, 1e9));
            assert!((end.height - norm(end.plane)).abs() < 1e-12, "on the boundary");
        }
        let inwards = Lorentz::new(1.0, Vector::new(0.1, 0.1));
        assert!(s.reach(inwards, 7.0) >= 7.0, "nothing ends an inward step");
    }
}
