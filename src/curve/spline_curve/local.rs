//! More control points where the user works, and none elsewhere: patches of displacements over a curve that stays as it
//! is.

use std::sync::Arc;

use super::b_spline::BSplineCurve;
use super::interpolating::InterpolatingCurve;
use super::lattice::{Grid, Lattice, Shape};
use super::spline_sampler::SplineSampler;
use crate::error::{Error, Result};
use crate::generator::ExponentialBSpline;
use crate::limits::{LARGEST_COORDINATE, MOST_OUTPUT_POINTS, check, filled, settle, too_many, with_room};
use crate::numerics::lists::steps;
use crate::numerics::order::sort_by_number;

/// The finest grid of a patch has 2¹² cells in a segment.
const FINEST: usize = 12;

/// An interpolating curve with patches of finer control points where they are wanted.
///
/// A patch is a layer of displacements d on the grid 2⁻ˡᵉᵛᵉˡ: the curve is r(t) + Σ dᵢ b(2ˡᵉᵛᵉˡ·t − i), with the
/// B-splines of [`InterpolatingCurve::refine`]. All displacements are 0 at first, so that making room changes no bit of
/// the shape; a point of the curve that is moved later takes the detail along; a patch that is dropped takes its detail
/// with it. \[FB88\]
///
/// # Example
///
/// ```
/// use expline::{InterpolatingCurve, LocalCurve};
///
/// let square = InterpolatingCurve::new(vec![0.0, 0.0, 9.0, 0.0, 9.0, 9.0, 0.0, 9.0], 2, true, None)?;
/// let curve = LocalCurve::new(square).refine_at(1.5, 3, 0.25)?;
/// let [x, y] = curve.patch_points(0)?[..2] else { unreachable!() };
/// let edited = curve.with_patch_point(0, 0, &[x + 0.5, y])?;
/// assert_eq!(edited.evaluate(3.0, 0)?, curve.evaluate(3.0, 0)?);
/// # Ok::<(), expline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[must_use = "an edited curve is a new one: this one stays as it was"]
pub struct LocalCurve {
    pub(super) base: InterpolatingCurve,
    /// Coarser levels first.
    pub(super) patches: Vec<Patch>,
    /// The parameters at which pieces start, and the end.
    pub(super) knots: Vec<f64>,
}

#[derive(Clone, Debug)]
pub(super) struct Patch {
    level: usize,
    first: usize,
    displacements: Vec<f64>,
    /// The displacements with 0 around them, over all that they act on.
    pub(super) lattice: Lattice,
}

impl PartialEq for Patch {
    fn eq(&self, other: &Self) -> bool {
        (self.level, self.first, &self.displacements) == (other.level, other.first, &other.displacements)
    }
}

impl LocalCurve {
    /// A curve without patches.
    pub fn new(base: InterpolatingCurve) -> Self {
        let knots = (0..=base.piece_count()).map(|i| base.knot(i)).collect();
        Self { base, patches: Vec::new(), knots }
    }

    /// The curve under the patches.
    pub fn base(&self) -> &InterpolatingCurve {
        &self.base
    }

    /// The same patches over another curve, with as many points and the same roots: one that was edited.
    ///
    /// # Errors
    ///
    /// A base on which the patches do not fit.
    pub fn with_base(&self, base: InterpolatingCurve) -> Result<Self> {
        let patches = self.patches.iter();
        let given = patches.map(|p| ((p.level, p.first, self.count(p)), p.displacements.as_slice()));
        Self::new(base).add_patches(given)
    }

    /// The image under an affine map, as [`SplineCurve::transformed`](super::SplineCurve::transformed) has it; the
    /// patches come along.
    ///
    /// # Errors
    ///
    /// Those of [`SplineCurve::transformed`](super::SplineCurve::transformed); `matrix` where a displacement leaves
    /// ±2e9.
    pub fn transformed(&self, matrix: &[f64]) -> Result<Self> {
        let map = self.base.affine(matrix)?;
        let mut curve = self.clone();
        curve.base = self.base.transformed(matrix)?;
        for patch in &mut curve.patches {
            map.map_vectors(&mut patch.displacements, 2.0 * LARGEST_COORDINATE)?;
            patch.lattice =
                self.over(patch.lattice.shape.clone(), (patch.level, patch.first), &patch.displacements)?;
        }
        Ok(curve)
    }

    /// The same curve with room for detail around t: a patch of all control points on the grid 2^−`levels` that lie
    /// within `reach` of t.
    ///
    /// # Errors
    ///
    /// t outside the domain; `levels` not from 1 to 12, or so many that their grid has more than 4 million control
    /// points; `reach` not from 0 to 1e6, or with no control point within it.
    pub fn refine_at(&self, t: f64, levels: usize, reach: f64) -> Result<Self> {
        self.check_level("levels", levels)?;
        check("reach", None, reach, 0.0, 1e6)?;
        let place = self.base.lattice.locate(t, None)?;
        let (cells, total) = self.grid(levels);
        let (order, closed) = (self.base.roots().order(), self.base.is_closed());
        // Control point j lies at j + ½ or j on a closed grid, at j + 1 − n₀/2 on an open one.
        let shift = if closed { 0.5 * (order % 2) as f64 } else { 1.0 - 0.5 * order as f64 };
        let middle = (place.cell as f64 + (0.5 * place.part as f64 + 0.25 + 0.5 * place.y)) * scale(levels);
        let (low, high) = (middle - reach * scale(levels) - shift, middle + reach * scale(levels) - shift);
        let (low, high) = if closed { (low, high) } else { (low.max(0.0), high.min((total - 1) as f64)) };
        let (low, high) = (low.ceil(), high.floor());
        if high < low {
            return Err(Error::degenerate("reach", None, "no control point is within it"));
        }
        // A reach beyond the curve may be more steps than a usize of 32 bits counts.
        let count = (high - low + 1.0).min(total as f64) as usize;
        let turn = if closed { cells as f64 * (low / cells as f64).floor() } else { 0.0 };
        let first = ((low - turn) as usize).min(total - 1);
        self.add_patch((levels, first, count), &filled(0.0, count * self.base.dimension())?)
    }

    /// Cells and control points of the grid of a level.
    fn grid(&self, level: usize) -> (usize, usize) {
        let cells = self.base.lattice.cells.saturating_mul(1 << level);
        let beyond = if self.base.is_closed() { 0 } else { self.base.roots().order() - 1 };
        (cells, cells.saturating_add(beyond))
    }

    /// Refuses a level whose grid has more control points than one call may give back.
    fn check_level(&self, argument: &'static str, level: usize) -> Result<()> {
        check(argument, None, level as f64, 1.0, FINEST as f64)?;
        let (_, total) = self.grid(level);
        if total > MOST_OUTPUT_POINTS {
            return Err(too_many(argument, "maxOutputPoints", MOST_OUTPUT_POINTS, total));
        }
        Ok(())
    }

    fn count(&self, patch: &Patch) -> usize {
        patch.displacements.len() / self.base.dimension()
    }

    /// How many patches there are.
    pub fn patch_count(&self) -> usize {
        self.patches.len()
    }

    /// Level, first control point and their number, of patch k.
    ///
    /// # Errors
    ///
    /// k beyond the last patch.
    pub fn patch_window(&self, k: usize) -> Result<(usize, usize, usize)> {
        let patch = self.patch(k)?;
        Ok((patch.level, patch.first, self.count(patch)))
    }

    /// The displacements of patch k, interleaved.
    ///
    /// # Errors
    ///
    /// k beyond the last patch.
    pub fn displacements(&self, k: usize) -> Result<&[f64]> {
        Ok(&self.patch(k)?.displacements)
    }

    fn patch(&self, k: usize) -> Result<&Patch> {
        let most = self.patches.len() as f64 - 1.0;
        self.patches.get(k).ok_or_else(|| Error::out_of_range("patch", None, k as f64, 0.0, most))
    }

    /// Adds a patch with its displacements, as [`Self::patch_window`] and [`Self::displacements`] tell them.
    ///
    /// # Errors
    ///
    /// A level not from 1 to 12; a window that does not fit on it; displacements of another number, or not finite, or
    /// not within ±2e9; more than 4 million control points.
    pub fn add_patch(&self, window: (usize, usize, usize), displacements: &[f64]) -> Result<Self> {
        self.add_patches([(window, displacements)])
    }

    /// Adds many patches at once, each a window with its displacements as for [`Self::add_patch`]: the same as one
    /// after the other.
    ///
    /// # Errors
    ///
    /// Those of [`Self::add_patch`] for the first patch that does not fit.
    ///
    /// # Cost
    ///
    /// The curve is copied and its knots are sorted once for all of them: 4096 patches take some milliseconds.
    pub fn add_patches<'a>(
        &self,
        patches: impl IntoIterator<Item = ((usize, usize, usize), &'a [f64])>,
    ) -> Result<Self> {
        let mut curve = self.clone();
        let mut shapes: [Option<Arc<Shape>>; FINEST + 1] = [const { None }; FINEST + 1];
        for patch in &self.patches {
            shapes[patch.level] = Some(patch.lattice.shape.clone());
        }
        for (window, displacements) in patches {
            self.check_window(window, displacements)?;
            let (level, first, _) = window;
            let shape = match &shapes[level] {
                Some(shape) => shape.clone(),
                None => self.shape_of(level)?,
            };
            shapes[level] = Some(shape.clone());
            let mut displacements = displacements.to_vec();
            settle(&mut displacements);
            let lattice = self.over(shape, (level, first), &displacements)?;
            curve.patches.push(Patch { level, first, displacements, lattice });
        }
        // Of one level in the order in which they came.
        sort_by_number(&mut curve.patches, &|patch| patch.level as f64);
        curve.knots = curve.cut()?;
        Ok(curve)
    }

    /// Refuses a patch that cannot be.
    fn check_window(&self, window: (usize, usize, usize), displacements: &[f64]) -> Result<()> {
        let (level, first, count) = window;
        self.check_level("level", level)?;
        let (_, total) = self.grid(level);
        check("first", None, first as f64, 0.0, (total - 1) as f64)?;
        let most = if self.base.is_closed() { total } else { total - first };
        check("displacements", None, count as f64, 1.0, most as f64)?;
        let needed = count * self.base.dimension();
        if displacements.len() != needed {
            return Err(Error::wrong_length("displacements", displacements.len(), needed));
        }
        displacements.iter().enumerate().try_for_each(|(i, &d)| check_displacement(i, d))
    }

    /// The B-spline of a level.
    fn shape_of(&self, level: usize) -> Result<Arc<Shape>> {
        let roots = self.base.roots().divided(scale(level));
        Ok(Arc::new(Shape::of_b_spline(&ExponentialBSpline::new(&roots)?)))
    }

    /// The lattice of a patch: its displacements and n₀ − 1 zeros on either side.
    fn over(&self, shape: Arc<Shape>, place: (usize, usize), displacements: &[f64]) -> Result<Lattice> {
        let (level, first) = place;
        let (order, dimension) = (shape.window, self.base.dimension());
        let around = (order - 1) * dimension;
        let mut padded = with_room(displacements.len() + 2 * around)?;
        padded.resize(around, 0.0);
        padded.extend_from_slice(displacements);
        padded.resize(displacements.len() + 2 * around, 0.0);
        // Control point `first` acts from n₀/2 cells before it.
        let before = if self.base.is_closed() { (order / 2) as f64 } else { (order - 1) as f64 };
        let start = (first as f64 - before) / scale(level);
        let grid = Grid { start, step: 1.0 / scale(level), end: None };
        Lattice::new(shape, &padded, dimension, false, 0, grid)
    }

    /// The control points of patch k, interleaved: where the refined curve has them, coarser patches included.
    ///
    /// # Errors
    ///
    /// k beyond the last patch; control points of the refined curve that would not be within ±1e9.
    pub fn patch_points(&self, k: usize) -> Result<Vec<f64>> {
        let (level, first) = (self.patch(k)?.level, self.patch(k)?.first);
        let mut curve = self.base.refine(1, 2, 2)?;
        for at in 1..=level {
            if at > 1 {
                curve = curve.refine(2)?;
            }
            curve = self.displaced(curve, at)?;
        }
        let (count, dimension) = (self.count(self.patch(k)?), self.base.dimension());
        let total = curve.points().len() / dimension;
        let mut points = with_room(count * dimension)?;
        for i in 0..count {
            let at = (first + i) % total * dimension;
            points.extend_from_slice(&curve.points()[at..at + dimension]);
        }
        Ok(points)
    }

    /// A refined curve with the displacements of one level.
    fn displaced(&self, curve: BSplineCurve, level: usize) -> Result<BSplineCurve> {
        let dimension = self.base.dimension();
        let mut points = curve.points().to_vec();
        let total = points.len();
        for patch in self.patches.iter().filter(|patch| patch.level == level) {
            for (i, d) in patch.displacements.iter().enumerate() {
                points[(patch.first * dimension + i) % total] += d;
            }
        }
        curve.with_points(points)
    }

    /// The curve with control point i of patch k elsewhere: it changes on n₀ cells of the patch's grid.
    ///
    /// # Errors
    ///
    /// k or i beyond the last; a point of another dimension, or with a number that is not finite or not within ±1e9;
    /// `displacements` where the point would be moved by more than 2e9.
    pub fn with_patch_point(&self, k: usize, i: usize, point: &[f64]) -> Result<Self> {
        let (patch, dimension) = (self.patch(k)?, self.base.dimension());
        let mut points = self.patch_points(k)?;
        let before = points.clone();
        super::place(&mut points, dimension, i, point)?;
        let at = i * dimension;
        let mut displacements = patch.displacements.clone();
        for d in at..at + dimension {
            displacements[d] += points[d] - before[d];
            check_displacement(d, displacements[d])?;
        }
        let mut curve = self.clone();
        let lattice = self.over(patch.lattice.shape.clone(), (patch.level, patch.first), &displacements)?;
        curve.patches[k] = Patch { displacements, lattice, ..patch.clone() };
        Ok(curve)
    }

    /// The curve without patch k and what it displaced.
    ///
    /// # Errors
    ///
    /// k beyond the last patch.
    pub fn without_patch(&self, k: usize) -> Result<Self> {
        self.patch(k)?;
        let mut curve = self.clone();
        curve.patches.remove(k);
        curve.knots = curve.cut()?;
        Ok(curve)
    }

    /// The point at t, or a derivative; see [`InterpolatingCurve::evaluate`].
    ///
    /// # Errors
    ///
    /// As [`InterpolatingCurve::evaluate`].
    pub fn evaluate(&self, t: f64, derivative: usize) -> Result<Vec<f64>> {
        let mut point = vec![0.0; self.base.dimension()];
        self.evaluate_into(&[t], derivative, &mut point).map_err(Error::of_one)?;
        Ok(point)
    }

    /// Points or derivatives at every parameter, interleaved, into `out`.
    ///
    /// # Errors
    ///
    /// As [`InterpolatingCurve::evaluate_into`].
    pub fn evaluate_into(&self, t: &[f64], derivative: usize, out: &mut [f64]) -> Result<()> {
        self.base.evaluate_into(t, derivative, out)?;
        for (&t, out) in t.iter().zip(out.chunks_exact_mut(self.base.dimension())) {
            self.displace(t, derivative, out)?;
        }
        Ok(())
    }

    /// `count` points that lie uniformly in the parameter, or their derivatives, interleaved.
    ///
    /// # Errors
    ///
    /// More than 4 million points; a derivative above n₀ − 1 and above 2.
    pub fn sample(&self, count: usize, derivative: usize) -> Result<Vec<f64>> {
        let mut points = SplineSampler::all(&self.base.lattice, count, derivative)?;
        self.displace_samples((count, 0), derivative, &mut points)?;
        Ok(points)
    }

    /// Adds what the patches displace to samples of the base: of `count` uniform ones, those from `first` on.
    pub(crate) fn displace_samples(
        &self,
        (count, first): (usize, usize),
        derivative: usize,
        out: &mut [f64],
    ) -> Result<()> {
        let (_, end) = self.base.domain();
        let steps = steps(count, self.base.is_closed());
        for (i, point) in out.chunks_exact_mut(self.base.dimension()).enumerate() {
            self.displace(((first + i) as f64 * end / steps as f64).min(end), derivative, point)?;
        }
        Ok(())
    }

    /// Adds what the patches displace at t.
    fn displace(&self, t: f64, derivative: usize, out: &mut [f64]) -> Result<()> {
        let mut part = [0.0; 3];
        let part = &mut part[..out.len()];
        for patch in &self.patches {
            for t in self.turns(patch, t) {
                patch.lattice.value(patch.lattice.locate(t, None)?, derivative, part);
                for (sum, d) in out.iter_mut().zip(part.iter()) {
                    *sum += d;
                }
            }
        }
        Ok(())
    }

    /// How many polynomial pieces there are.
    pub fn piece_count(&self) -> usize {
        self.knots.len() - 1
    }
}

/// From one end of what is allowed to the other at most.
fn check_displacement(i: usize, d: f64) -> Result<()> {
    check("displacements", Some(i), d, -2.0 * LARGEST_COORDINATE, 2.0 * LARGEST_COORDINATE)
}

fn scale(level: usize) -> f64 {
    (1_usize << level) as f64
}
