//! Normals, at poles and other places where the partial derivatives say nothing too, and curvatures.

use super::layer::Scratch;
use super::tensor::TensorSurface;
use crate::error::{Error, Result};
use crate::numerics::Vector3;

/// ∂ᵤσ × ∂ᵥσ counts where it is not smaller than this part of its own derivatives: closer to a degenerate place the limit
/// is taken. The limit is wrong by at most this part there, the product's rounding (1e-16) is the same part of it.
const NEAR: f64 = 1e-8;
/// Vectors below this part of the size squared are rounding: there is no normal.
const NOTHING: f64 = 1e-13;
/// How far off, in units of the parameter, a place without first and second derivatives looks for its neighbours.
const STEP: f64 = 1e-3;
/// The same for curvatures at a degenerate place.
const CURVATURE_STEP: f64 = 0.03125;
/// EG − F² below this part of the size to the fourth power is taken for a degenerate place by curvatures.
const SINGULAR: f64 = 1e-12;

/// First and second derivatives.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Jet {
    pub(super) u: Vector3,
    pub(super) v: Vector3,
    pub(super) uu: Vector3,
    pub(super) uv: Vector3,
    pub(super) vv: Vector3,
}

/// Gaussian and mean curvature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curvature {
    /// K, the product of the principal curvatures.
    pub gaussian: f64,
    /// H, half their sum: negative where the surface bends away from its normal, as a sphere does.
    pub mean: f64,
}

impl Jet {
    /// K and H, unless the place is degenerate.
    pub(super) fn curvature(&self, size: f64) -> Option<Curvature> {
        let normal = self.u.cross(&self.v);
        let (e, f, g) = (self.u.norm_squared(), self.u.dot(&self.v), self.v.norm_squared());
        let area = normal.norm_squared();
        let square = size * size;
        if area <= SINGULAR * square * square {
            return None;
        }
        let length = area.sqrt();
        let (l, m, n) =
            (self.uu.dot(&normal) / length, self.uv.dot(&normal) / length, self.vv.dot(&normal) / length);
        let gaussian = (l * n - m * m) / area;
        let mean = 0.5 * (e * n - 2.0 * f * m + g * l) / area;
        Some(Curvature { gaussian, mean })
    }
}

impl TensorSurface {
    pub(super) fn jet(&self, u: f64, v: f64, scratch: &mut Scratch) -> Jet {
        let mut at = |order| Vector3::from(self.value(u, v, order, scratch));
        Jet { u: at((1, 0)), v: at((0, 1)), uu: at((2, 0)), uv: at((1, 1)), vv: at((0, 2)) }
    }

    fn cross(&self, u: f64, v: f64, scratch: &mut Scratch) -> Vector3 {
        let by_u = Vector3::from(self.value(u, v, (1, 0), scratch));
        let by_v = Vector3::from(self.value(u, v, (0, 1), scratch));
        by_u.cross(&by_v)
    }

    /// The unit normal at parameters that were checked, or 0 where there is none.
    ///
    /// Where ∂ᵤσ × ∂ᵥσ vanishes, the normal is its limit from inside the domain: the direction in which it grows (D 11.3).
    ///
    /// `size` is that of the points that weigh on the place.
    pub(super) fn normal_at(&self, u: f64, v: f64, size: f64, scratch: &mut Scratch) -> Vector3 {
        let jet = self.jet(u, v, scratch);
        let least = NOTHING * size * size;
        let here = jet.u.cross(&jet.v);
        let along_u = jet.uu.cross(&jet.v) + jet.u.cross(&jet.uv);
        let along_v = jet.uv.cross(&jet.v) + jet.u.cross(&jet.vv);
        let [end_u, end_v] = self.domain();
        let [closed_u, closed_v] = self.directions().map(|direction| direction.closed);
        let by_u = along_u.norm_squared() > along_v.norm_squared();
        let (grows, t, end) = if by_u { (along_u, u, end_u) } else { (along_v, v, end_v) };
        let (length, growth) = (here.norm(), grows.norm());
        if length > least && length >= NEAR * growth {
            return here / length;
        }
        if growth > NEAR * size * size {
            // What is there of the product, be it ever so short, has the right sense; at the place itself the inside has.
            let closed = if by_u { closed_u } else { closed_v };
            let backwards =
                if length > least { here.dot(&grows) < 0.0 } else { !closed && t > (1.0 - NEAR) * end };
            return if backwards { -grows / growth } else { grows / growth };
        }
        // Neither derivative says anything: the neighbours' mean.
        let mut sum = Vector3::zeros();
        for (a, b) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
            let near = |t: f64, s: f64, end: f64, closed: bool| {
                if closed { t + s * STEP } else { (t + s * STEP).max(0.0).min(end) }
            };
            sum += self.cross(near(u, a, end_u, closed_u), near(v, b, end_v, closed_v), scratch);
        }
        let length = sum.norm();
        if length > least * STEP { sum / length } else { Vector3::zeros() }
    }

    /// Unit normals at pairs of parameters, three numbers each: ∂ᵤσ × ∂ᵥσ, and its limit at poles and other places where it
    /// vanishes. Where the surface has none — all points equal, or on a line — the three numbers are 0.
    ///
    /// # Errors
    ///
    /// Those of [`TensorSurface::evaluate_into`].
    pub fn normals_into(&self, u: &[f64], v: &[f64], out: &mut [f64]) -> Result<()> {
        self.check_places(u, v)?;
        if out.len() != 3 * u.len() {
            return Err(Error::wrong_length("out", out.len(), 3 * u.len()));
        }
        let mut scratch = Scratch::default();
        for ((&u, &v), normal) in u.iter().zip(v).zip(out.chunks_exact_mut(3)) {
            let size = self.extent_at(u, v);
            normal.copy_from_slice(self.normal_at(u, v, size, &mut scratch).as_slice());
        }
        Ok(())
    }

    /// The unit normal at (u, v), or nothing where the surface has none.
    ///
    /// # Errors
    ///
    /// Those of [`TensorSurface::evaluate`].
    pub fn normal(&self, u: f64, v: f64) -> Result<Option<Vector3>> {
        let mut out = [0.0; 3];
        self.normals_into(&[u], &[v], &mut out)?;
        Ok((out != [0.0; 3]).then(|| Vector3::from(out)))
    }

    /// Gaussian and mean curvature at (u, v), with respect to the normal ∂ᵤσ × ∂ᵥσ.
    ///
    /// # Accuracy
    ///
    /// At poles, where both are 0/0, the limit by extrapolation from three places inside: heuristic, 1e-6 of the
    /// neighbourhood's variation. Elsewhere some 1e-13 of the size's inverse powers (`tests/surface_shape.rs`). Where
    /// there is no limit, 0.
    ///
    /// # Errors
    ///
    /// Those of [`TensorSurface::evaluate`].
    pub fn curvature(&self, u: f64, v: f64) -> Result<Curvature> {
        self.check_places(&[u], &[v])?;
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

    /// Curvatures at parameters that were checked.
    pub(super) fn curvature_at(&self, u: f64, v: f64, scratch: &mut Scratch) -> Curvature {
        let size = self.extent_at(u, v);
        if let Some(curvature) = self.jet(u, v, scratch).curvature(size) {
            return curvature;
        }
        let [end_u, end_v] = self.domain();
        // Towards the middle of the domain, three steps: the parabola through them is followed back.
        let towards = |t: f64, end: f64, step: f64| if t + t <= end { t + step } else { t - step };
        let mut limit = Curvature { gaussian: 0.0, mean: 0.0 };
        for (weight, steps) in [(3.0, 1.0), (-3.0, 2.0), (1.0, 3.0)] {
            let step = steps * CURVATURE_STEP;
            let place = (towards(u, end_u, step), towards(v, end_v, step));
            let Some(near) = self.jet(place.0, place.1, scratch).curvature(size) else {
                return Curvature { gaussian: 0.0, mean: 0.0 };
            };
            limit.gaussian += weight * near.gaussian;
            limit.mean += weight * near.mean;
        }
        limit
    }
}
