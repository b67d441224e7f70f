//! Gaussian and mean curvature, with their limits at poles.

use super::layer::{Layer, Scratch};
use super::normal::{Jet, is_nothing, rounding};
use super::tensor::TensorSurface;
use crate::error::{Error, Result};
use crate::numerics::Vector3;

/// Beside a pole curvatures are interpolated from places that are multiples of this part of the domain away: rounding,
/// 1e-16 over the square of the distance, and the cubic's error are 1e-8 both where that begins.
const STEP: f64 = 1.0 / 1024.0;
/// So near, in those steps.
const BESIDE: f64 = 0.125;
/// Of a place x steps away: a sixth of x times the third difference is what the cubic may be wrong by, and 1e-16 over
/// the square of the distance what rounding makes of the curvature there; the one over the other, but for x³.
const UNSEEN: f64 = 1e-9;
/// At other degenerate places curvatures are extrapolated from places that are multiples of this part of the domain
/// away.
const FARTHER: f64 = 1.0 / 256.0;
/// No step is longer than this part of one of the grid: four of them stay between two knots.
const LONGEST: f64 = 0.0625;
/// Extrapolations of two orders that differ by more than this part of what they are made of have no limit.
const APART: f64 = 0.0625;
/// Tangents at a pole that leave one plane by more than this part have no limit of curvatures.
const ONE_PLANE: f64 = 1e-6;

/// Gaussian and mean curvature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curvature {
    /// K, the product of the principal curvatures.
    pub gaussian: f64,
    /// H, half their sum: negative where the surface bends away from its normal, as a sphere does.
    pub mean: f64,
}

const NONE: Curvature = Curvature { gaussian: 0.0, mean: 0.0 };

impl Curvature {
    fn add(&mut self, weight: f64, other: Self) {
        self.gaussian += weight * other.gaussian;
        self.mean += weight * other.mean;
    }
}

impl Jet {
    /// K and H, at a place that is regular.
    pub(super) fn curvature(&self) -> Curvature {
        let normal = self.u.cross(&self.v);
        let (e, f, g) = (self.u.norm_squared(), self.u.dot(&self.v), self.v.norm_squared());
        let area = normal.norm_squared();
        let length = area.sqrt();
        let (l, m, n) =
            (self.uu.dot(&normal) / length, self.uv.dot(&normal) / length, self.vv.dot(&normal) / length);
        let gaussian = (l * n - m * m) / area;
        let mean = 0.5 * (e * n - 2.0 * f * m + g * l) / area;
        Curvature { gaussian, mean }
    }
}

impl TensorSurface {
    /// Gaussian and mean curvature at (u, v), with respect to the normal ∂ᵤσ × ∂ᵥσ.
    ///
    /// # Accuracy
    ///
    /// Relative to the curvatures of quadrics, however thin, 1e-12 (measured: 5e-13 where one is 1e-9 times as thin as
    /// it is long); within 1/1000 of the domain of a pole 3e-8, as first derivatives are 0 there, and 2e-3 where what
    /// has the pole is a coin, a hundred times as wide as thick. At the pole itself both are
    /// 0/0, and are the limit, from every side the same: 1e-13, and with m × n points on a sphere 1e-16·m·n. At other
    /// degenerate places where an edge shrinks to a point it is that, too; elsewhere it is extrapolated from four
    /// places inside, to some 1e-6 of the neighbourhood's variation. Where there is no limit, 0
    /// (`tests/surface/shape.rs`).
    ///
    /// # Errors
    ///
    /// Those of [`TensorSurface::evaluate`].
    pub fn curvature(&self, u: f64, v: f64) -> Result<Curvature> {
        self.check_place(u, v)?;
        Ok(self.curvature_at(u, v, &mut Scratch::default()))
    }

    /// Curvatures at pairs of parameters: all Gaussian ones, then all mean ones; see [`TensorSurface::curvature`].
    ///
    /// # Errors
    ///
    /// Those of [`TensorSurface::evaluate_into`].
    pub fn curvatures_into(&self, u: &[f64], v: &[f64], out: &mut [f64]) -> Result<()> {
        self.check_places(u, v)?;
        if out.len() != 2 * u.len() {
            return Err(Error::wrong_length("out", out.len(), 2 * u.len()));
        }
        let mut scratch = Scratch::default();
        let (gaussian, mean) = out.split_at_mut(u.len());
        for (((&u, &v), gaussian), mean) in u.iter().zip(v).zip(gaussian).zip(mean) {
            let curvature = self.curvature_at(u, v, &mut scratch);
            (*gaussian, *mean) = (curvature.gaussian, curvature.mean);
        }
        Ok(())
    }

    /// That part of the domain in u or in v, if that is not longer than the grid allows.
    fn step(&self, by_u: bool, part: f64) -> f64 {
        let scale = |layer: &Layer| if by_u { layer.u.scale } else { layer.v.scale };
        let finest = self.layers.iter().map(scale).fold(1.0, f64::max);
        (part * self.domain()[usize::from(!by_u)]).min(LONGEST / finest)
    }

    /// The end of an open direction that a parameter is so near to that a pole there matters.
    pub(super) fn end_beside(&self, by_u: bool, t: f64) -> Option<f64> {
        let d = usize::from(!by_u);
        let end = if t + t <= self.domain()[d] { 0.0 } else { self.domain()[d] };
        let beside = (t - end).abs() <= BESIDE * self.step(by_u, STEP);
        (beside && !self.directions()[d].closed).then_some(end)
    }

    /// Curvatures at parameters that were checked.
    pub(super) fn curvature_at(&self, u: f64, v: f64, scratch: &mut Scratch) -> Curvature {
        let most = self.most_at(u, v);
        for by_u in [false, true] {
            if let Some(end) = self.end_beside(by_u, if by_u { u } else { v })
                && let Some(curvature) = self.beside(by_u, (u, v), end, &most, scratch)
            {
                return curvature;
            }
        }
        let jet = self.jet(u, v, scratch);
        if jet.is_regular(&most) {
            return jet.curvature();
        }
        let limit = self.limit(false, (u, v), &most, scratch);
        limit
            .or_else(|| self.limit(true, (u, v), &most, scratch))
            .unwrap_or_else(|| self.extrapolated((u, v), &most, scratch))
    }

    /// Curvatures at a degenerate place from four steps towards the middle of the domain, where they say the same as
    /// three.
    fn extrapolated(&self, (u, v): (f64, f64), most: &Jet, scratch: &mut Scratch) -> Curvature {
        let [end_u, end_v] = self.domain();
        let towards = |t: f64, end: f64, step: f64| if t + t <= end { t + step } else { t - step };
        let [step_u, step_v] = [true, false].map(|by_u| self.step(by_u, FARTHER));
        let (mut cubic, mut change, mut largest) = (NONE, NONE, NONE);
        for (k, weight, less) in [(1.0, 4.0, 1.0), (2.0, -6.0, -3.0), (3.0, 4.0, 3.0), (4.0, -1.0, -1.0)] {
            let place = (towards(u, end_u, k * step_u), towards(v, end_v, k * step_v));
            let jet = self.jet(place.0, place.1, scratch);
            if !jet.is_regular(most) {
                return NONE;
            }
            let near = jet.curvature();
            cubic.add(weight, near);
            change.add(less, near);
            largest.gaussian = near.gaussian.abs().max(largest.gaussian);
            largest.mean = near.mean.abs().max(largest.mean);
        }
        let limit = |value: f64, change: f64, largest: f64| {
            if change.abs() <= APART * largest { value } else { 0.0 }
        };
        Curvature {
            gaussian: limit(cubic.gaussian, change.gaussian, largest.gaussian),
            mean: limit(cubic.mean, change.mean, largest.mean),
        }
    }

    /// Curvatures at or beside a pole at the end of a direction, if there is one.
    fn beside(
        &self,
        by_u: bool,
        (u, v): (f64, f64),
        end: f64,
        most: &Jet,
        scratch: &mut Scratch,
    ) -> Option<Curvature> {
        let at = |t: f64| if by_u { (t, v) } else { (u, t) };
        let limit = self.limit(by_u, at(end), most, scratch)?;
        let step = self.step(by_u, STEP);
        let x = (if by_u { u } else { v } - end).abs() / step;
        let inwards = if end > 0.0 { -step } else { step };
        // The cubic through the limit and three places inside.
        let (a, b, c) = (x - 1.0, x - 2.0, x - 3.0);
        let mut sum = NONE;
        sum.add(a * b * c / -6.0, limit);
        if x > 0.0 {
            let mut third = NONE;
            third.add(-1.0, limit);
            for (weight, binomial, k) in
                [(0.5 * x * b * c, 3.0, 1.0), (-0.5 * x * a * c, -3.0, 2.0), (x * a * b / 6.0, 1.0, 3.0)]
            {
                let (u, v) = at(end + k * inwards);
                let near = self.jet(u, v, scratch).curvature();
                sum.add(weight, near);
                third.add(binomial, near);
            }
            // A coin is round its edge in less than a step: what the cubic does not see there is more than rounding.
            let here = self.jet(u, v, scratch).curvature();
            let unseen = |third: f64, here: f64, seen: f64| {
                x * x * x * third.abs() > UNSEEN * here.abs().max(seen.abs())
            };
            if unseen(third.gaussian, here.gaussian, sum.gaussian) || unseen(third.mean, here.mean, sum.mean)
            {
                return Some(here);
            }
        }
        Some(sum)
    }

    /// The limit of curvatures along one direction, at a place where the derivative in the other vanishes (D 11.6);
    /// nothing where that does not, or where there is no limit.
    fn limit(&self, by_u: bool, (u, v): (f64, f64), most: &Jet, scratch: &mut Scratch) -> Option<Curvature> {
        let mut at = |across: usize, along: usize| {
            let order = if by_u { (along, across) } else { (across, along) };
            Vector3::from(self.value(u, v, order, scratch))
        };
        let (of_across, of_along) = if by_u { (&most.v, &most.u) } else { (&most.u, &most.v) };
        if !is_nothing(&at(1, 0), of_across) {
            return None;
        }
        let (b, bb, ab) = (at(0, 1), at(0, 2), at(1, 1));
        let first = ab.cross(&b);
        let area = first.norm_squared();
        let length = area.sqrt();
        if length <= rounding([&ab, &b], [&most.uv, of_along]) {
            return None;
        }
        let (aab, abb, aabb) = (at(2, 1), at(1, 2), at(2, 2));
        let normal = first / length;
        let off = aab.dot(&normal).abs();
        if off > ONE_PLANE * aab.norm() {
            return None;
        }
        let second = 0.5 * abb.cross(&b) + ab.cross(&bb);
        let turns = (second - normal * normal.dot(&second)) / length;
        let l = 0.5 * aabb.dot(&normal) + aab.dot(&turns);
        let m = abb.dot(&normal) + ab.dot(&turns);
        let n = bb.dot(&normal);
        let gaussian = (l * n - m * m) / area;
        let mean = 0.5 * (ab.norm_squared() * n - 2.0 * ab.dot(&b) * m + b.norm_squared() * l) / area;
        // From the last end the way inside is backwards, and the normal turns; so it does where u and v are exchanged.
        let d = usize::from(!by_u);
        let last = !self.directions()[d].closed && [u, v][d] >= self.domain()[d];
        Some(Curvature { gaussian, mean: if last == by_u { mean } else { -mean } })
    }
}
