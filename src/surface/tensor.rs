//! `TensorSurface`: what it is made of, points and derivatives.

use super::axis::{Axis, Direction};
use super::layer::{Layer, Scratch, Window};
use crate::error::{Error, Result};
use crate::limits::{LARGEST_COORDINATE, MOST_EVALUATIONS, MOST_SURFACE_POINTS, check, settle, too_many};
use crate::numerics::Vector3;
use crate::numerics::affine::Affine;

/// The highest derivative that may be asked for in one direction.
const MOST_DERIVATIVES: usize = 8;

/// A surface through (or, refined, near) a net of points: σ(u, v) = Σ σ\[k, l\] φᵤ(u − k) φᵥ(v − l).
///
/// ```text
/// grid units: a closed direction of `count` points lives on [0, count] and is periodic,
/// an open one on [0, count − (2·n₀ − 3)]; its row n₀ − 2 sits at 0
/// ```
///
/// Directions of level k > 0 are in B-spline form on the grid 2⁻ᵏ, in the same units: see [`TensorSurface::refine`].
///
/// # Source
///
/// [SFBGU17, eq. 31].
#[derive(Clone, Debug, PartialEq)]
#[must_use = "a refined surface is a new one: this one stays as it was"]
pub struct TensorSurface {
    /// The base, and then the detail that [`TensorSurface::refine_at`] has made room for.
    pub(super) layers: Vec<Layer>,
}

impl TensorSurface {
    /// The surface of a net of 3-D points, three numbers each, v fastest.
    ///
    /// # Domain
    ///
    /// Closed directions have 3 points or more, open ones 2·n₀ − 2 (n₀ in B-spline form); coordinates are at most 1e9.
    ///
    /// # Errors
    ///
    /// `TooFewPoints` for `u.count` and `v.count`; `LimitExceeded`, `WrongLength`, `NotFinite`, `OutOfRange` for `net`;
    /// for `u.roots` and `v.roots` those of [`crate::generator::Interpolator::new`].
    pub fn new(mut net: Vec<f64>, u: Direction, v: Direction) -> Result<Self> {
        let points = u.count.saturating_mul(v.count);
        if points > MOST_SURFACE_POINTS {
            return Err(too_many("net", "maxSurfacePoints", MOST_SURFACE_POINTS, points));
        }
        let u = Axis::given(u, ["u.count", "u.roots"])?;
        let v = if u.direction == v { u.clone() } else { Axis::given(v, ["v.count", "v.roots"])? };
        if net.len() != 3 * points {
            return Err(Error::wrong_length("net", net.len(), 3 * points));
        }
        settle(&mut net);
        Self::from_axes(net, u, v).within_limits()
    }

    /// The surface, if its numbers are those that a surface can be made of: what is derived can be loaded and asked,
    /// too.
    pub(super) fn within_limits(self) -> Result<Self> {
        for (i, &number) in self.net().iter().enumerate() {
            check("net", Some(i), number, -LARGEST_COORDINATE, LARGEST_COORDINATE)?;
        }
        for &number in self.layers[1..].iter().flat_map(|patch| &patch.net) {
            check_displacement(None, number)?;
        }
        Ok(self)
    }

    /// The surface of a net that is known to fit its axes.
    pub(super) fn from_axes(net: Vec<f64>, u: Axis, v: Axis) -> Self {
        let (rows, columns) = (Window::whole(&u), Window::whole(&v));
        Self { layers: vec![Layer { u, v, rows, columns, net }] }
    }

    pub(super) fn base(&self) -> &Layer {
        &self.layers[0]
    }

    /// The net, three numbers a point, v fastest.
    pub fn net(&self) -> &[f64] {
        &self.base().net
    }

    /// How the net runs in u and in v.
    pub fn directions(&self) -> [&Direction; 2] {
        [&self.base().u.direction, &self.base().v.direction]
    }

    /// The last parameters in u and in v; both begin at 0.
    pub fn domain(&self) -> [f64; 2] {
        [self.base().u.end(), self.base().v.end()]
    }

    /// The parameters of net point (i, j).
    pub fn parameters(&self, i: usize, j: usize) -> [f64; 2] {
        [self.base().u.parameter(i), self.base().v.parameter(j)]
    }

    /// The image under the affine map of a 4 × 4 matrix, 16 numbers column by column; patches come along. Where the
    /// matrix reflects, normals point to the other side.
    ///
    /// Exact to rounding where 0 is a root in u and in v, as for all shapes that are here. Without it, linear maps are
    /// exact and translations are refused.
    ///
    /// # Errors
    ///
    /// `matrix`: `WrongLength`; `NotFinite`; `OutOfRange` for a last row that is not 0, 0, 0, 1 to 1e-6, and where a
    /// point leaves ±1e9 or a displacement ±2e9; `Degenerate` for a translation where 0 is no root.
    pub fn transformed(&self, matrix: &[f64]) -> Result<Self> {
        let movable = self.directions().iter().all(|direction| direction.roots.keeps_constants());
        let map = Affine::new(matrix, 3, movable)?;
        let mut image = self.clone();
        map.map_points(&mut image.layers[0].net)?;
        for patch in &mut image.layers[1..] {
            map.map_vectors(&mut patch.net, 2.0 * LARGEST_COORDINATE)?;
        }
        Ok(image)
    }

    /// The point at (u, v), or a derivative.
    ///
    /// # Domain
    ///
    /// Closed directions take any parameter, open ones those of their domain. Derivatives to order n₀ − 2 are
    /// continuous; beyond, the value at a knot is that to the right of it.
    ///
    /// # Accuracy
    ///
    /// 2e-13 of ten times the largest number of the net (`tests/surface/reference.rs`).
    ///
    /// # Errors
    ///
    /// `NotFinite` and `OutOfRange` for `u`, `v`, `du`, `dv` (at most 8).
    pub fn evaluate(&self, u: f64, v: f64, du: usize, dv: usize) -> Result<Vector3> {
        let mut out = [0.0; 3];
        self.evaluate_into(&[u], &[v], du, dv, &mut out).map_err(Error::of_one)?;
        Ok(Vector3::from(out))
    }

    /// Points, or derivatives, at pairs of parameters, three numbers each.
    ///
    /// # Errors
    ///
    /// Those of [`TensorSurface::evaluate`]; `WrongLength` where `v` or `out` does not fit `u`; `LimitExceeded` beyond
    /// 4 million pairs.
    pub fn evaluate_into(&self, u: &[f64], v: &[f64], du: usize, dv: usize, out: &mut [f64]) -> Result<()> {
        check("du", None, du as f64, 0.0, MOST_DERIVATIVES as f64)?;
        check("dv", None, dv as f64, 0.0, MOST_DERIVATIVES as f64)?;
        self.at_each(u, v, out, &|u, v, scratch| self.value(u, v, (du, dv), scratch))
    }

    /// Three numbers for each pair of parameters, after all checks.
    pub(super) fn at_each(
        &self,
        u: &[f64],
        v: &[f64],
        out: &mut [f64],
        at: &dyn Fn(f64, f64, &mut Scratch) -> [f64; 3],
    ) -> Result<()> {
        self.check_places(u, v)?;
        if out.len() != 3 * u.len() {
            return Err(Error::wrong_length("out", out.len(), 3 * u.len()));
        }
        let mut scratch = Scratch::default();
        for ((&u, &v), numbers) in u.iter().zip(v).zip(out.as_chunks_mut::<3>().0) {
            *numbers = at(u, v, &mut scratch);
        }
        Ok(())
    }

    /// Checks a pair of parameters.
    pub(super) fn check_place(&self, u: f64, v: f64) -> Result<()> {
        self.base().u.check("u", None, u)?;
        self.base().v.check("v", None, v)
    }

    /// Checks pairs of parameters.
    pub(super) fn check_places(&self, u: &[f64], v: &[f64]) -> Result<()> {
        if v.len() != u.len() {
            return Err(Error::wrong_length("v", v.len(), u.len()));
        }
        if u.len() > MOST_EVALUATIONS {
            return Err(too_many("u", "maxEvalPoints", MOST_EVALUATIONS, u.len()));
        }
        for (i, (&u, &v)) in u.iter().zip(v).enumerate() {
            self.base().u.check("u", Some(i), u)?;
            self.base().v.check("v", Some(i), v)?;
        }
        Ok(())
    }

    /// The value, or a derivative, at parameters that were checked.
    pub(super) fn value(&self, u: f64, v: f64, order: (usize, usize), scratch: &mut Scratch) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for layer in &self.layers {
            let places = (layer.u.nearest_place(u), layer.v.nearest_place(v));
            layer.add(places, order, scratch, &mut sum);
        }
        sum
    }
}

/// Checks the coordinates of a point.
pub(super) fn check_point(point: &Vector3) -> Result<()> {
    for (argument, &number) in ["x", "y", "z"].into_iter().zip(point.iter()) {
        check(argument, None, number, -LARGEST_COORDINATE, LARGEST_COORDINATE)?;
    }
    Ok(())
}

/// From one end of what is allowed to the other at most.
pub(super) fn check_displacement(index: Option<usize>, number: f64) -> Result<()> {
    check("displacements", index, number, -2.0 * LARGEST_COORDINATE, 2.0 * LARGEST_COORDINATE)
}
