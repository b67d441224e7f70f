//! Control points on finer grids: the interpolator's points become B-spline points, and those more of their kind.
//!
//! Points are interleaved, of any dimension from 1 up (0 counts as 1): a row of a surface's net is a point, too. All
//! control points here belong to B-splines that are divided by their integral, so that, where 0 is a root, a
//! translation stays a translation on every level.

use crate::error::{Error, Result};
use crate::generator::{Interpolator, Roots, affine_refinement_filter};
use crate::limits::{MOST_OUTPUT_POINTS, MOST_SURFACE_POINTS, filled, too_many};

/// From points on the curve to control points on the grid 1/m₀.
///
/// A closed list of M points becomes m₀M control points; number j belongs to the parameter (j + ½)/m₀ where n₀ is odd
/// and to j/m₀ where it is even. An open list has n₀ − 2 points more on each side than the parameter range [0, N − 1]
/// needs, see [`extended`]; it becomes m₀(N − 1) + n₀ − 1 control points, the first at (1 − n₀/2)/m₀.
///
/// # Errors
///
/// m₀ not even or not from 2 to 1024; a list that is empty, too short for its ends, or not a whole number of points;
/// more than 4 million points.
///
/// # Source
///
/// [SFBGU17, eq. 17–20] with the index shifts of docs/SOURCES.md (D 9.8).
pub fn from_points(
    points: &[f64],
    dimension: usize,
    closed: bool,
    interpolator: &Interpolator,
    m0: usize,
) -> Result<Vec<f64>> {
    let dimension = dimension.max(1);
    let ends = if closed { 0 } else { 2 * (interpolator.order() - 2) + 1 };
    let count = counted(points, dimension, ends + 1)?;
    let filter = interpolator.affine_pre_filter(m0)?;
    let target =
        Target::from_points(count, closed, interpolator.order(), m0).within_limits("m0", dimension)?;
    target.fill(points, dimension, m0, &filter)
}

/// From control points on a grid to control points on the grid that is finer by m; `roots` are those of the coarser
/// grid, per step of it.
///
/// A closed list of L becomes mL, an open one m(L − n₀ + 1) + n₀ − 1; the parameters are as in [`from_points`].
///
/// # Errors
///
/// m not from 1 to 1024; otherwise as [`from_points`].
///
/// # Source
///
/// [SFBGU17, eq. 15, 16, 20] (D 9.8).
pub fn finer(points: &[f64], dimension: usize, closed: bool, roots: &Roots, m: usize) -> Result<Vec<f64>> {
    let dimension = dimension.max(1);
    let count = counted(points, dimension, 1)?;
    let filter = affine_refinement_filter(roots, m)?;
    let target = Target::finer(count, closed, roots.order(), m)?.within_limits("m", dimension)?;
    target.fill(points, dimension, m, &filter)
}

/// The points of an open curve with n₀ − 2 more on each side, so that the curve is defined from its first point to its
/// last.
///
/// They continue the sequence by the recurrence of the roots, Π(1 − e^a z): what the roots stand for goes on as it is,
/// an arc as an arc. Fewer points than roots are continued by the polynomial through them.
///
/// # Accuracy
///
/// That of doubles, of numbers that may be e^{(n₀ − 2)a} as large as the points for the largest real part a: on the
/// curve they cancel again.
///
/// # Errors
///
/// Fewer than two points, or not a whole number of them; more than fit.
///
/// # Source
///
/// (D 9.9).
pub fn extended(points: &[f64], dimension: usize, roots: &Roots) -> Result<Vec<f64>> {
    let dimension = dimension.max(1);
    let count = counted(points, dimension, 2)?;
    let extra = roots.order().saturating_sub(2);
    let forward = recurrence(roots, count)?;
    let total = (count + 2 * extra) * dimension;
    let mut all = filled(0.0, total)?;
    let (begin, end) = (extra * dimension, (extra + count) * dimension);
    all[begin..end].copy_from_slice(points);
    // A symmetric list has a recurrence that is the same backwards, up to its sign.
    for k in end..total {
        all[k] = forward.iter().enumerate().map(|(j, c)| c * all[k - (j + 1) * dimension]).sum();
    }
    for k in (0..begin).rev() {
        all[k] = forward.iter().enumerate().map(|(j, c)| c * all[k + (j + 1) * dimension]).sum();
    }
    Ok(all)
}

/// cⱼ with `x[k]` = Σ cⱼ `x[k − 1 − j]`, for at most `count` terms.
fn recurrence(roots: &Roots, count: usize) -> Result<Vec<f64>> {
    let roots = if count < roots.order() { Roots::polynomials(count - 1)? } else { roots.clone() };
    Ok(roots.recurrence().iter().skip(1).map(|p| -p.high).collect())
}

/// The number of points in an interleaved list, at least `least`.
fn counted(points: &[f64], dimension: usize, least: usize) -> Result<usize> {
    let count = points.len() / dimension;
    if count * dimension != points.len() {
        return Err(Error::wrong_length("points", points.len(), count * dimension));
    }
    if count < least {
        return Err(Error::too_few("points", count, least));
    }
    Ok(count)
}

/// Where the taps of a filter go.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Target {
    /// Tap i of point k goes to place mk + i − lead.
    lead: usize,
    /// How many places there are.
    count: usize,
    closed: bool,
}

impl Target {
    /// The places of [`from_points`], for a list that is long enough.
    pub(crate) fn from_points(count: usize, closed: bool, order: usize, m0: usize) -> Self {
        if closed {
            Self { lead: m0 * (order - 1) - order / 2, count: m0 * count, closed }
        } else {
            let places = m0 * (count + 3 - 2 * order) + order - 1;
            Self { lead: m0 * (2 * order - 3) + 1 - order, count: places, closed }
        }
    }

    /// The places of [`finer`].
    pub(crate) fn finer(count: usize, closed: bool, order: usize, m: usize) -> Result<Self> {
        if closed {
            return Ok(Self { lead: (m - 1) * (order / 2), count: m * count, closed });
        }
        if count < order {
            return Err(Error::too_few("points", count, order));
        }
        Ok(Self { lead: (m - 1) * (order - 1), count: m * (count + 1 - order) + order - 1, closed })
    }

    /// The same places, if they are as many as one call may give back; a row of a net counts by its numbers, too.
    fn within_limits(self, argument: &'static str, dimension: usize) -> Result<Self> {
        let numbers = self.count.saturating_mul(dimension);
        if self.count > MOST_OUTPUT_POINTS || numbers > 3 * MOST_SURFACE_POINTS {
            return Err(too_many(argument, "maxOutputPoints", MOST_OUTPUT_POINTS, self.count));
        }
        Ok(self)
    }

    /// Σ `filter[i]`·point k at place mk + i − lead.
    pub(crate) fn fill(
        &self,
        points: &[f64],
        dimension: usize,
        m: usize,
        filter: &[f64],
    ) -> Result<Vec<f64>> {
        let mut sums = filled(0.0, self.count * dimension)?;
        for (k, point) in points.chunks_exact(dimension).enumerate() {
            for (i, tap) in filter.iter().enumerate() {
                let Some(place) = self.place(m * k + i) else { continue };
                let sums = &mut sums[place * dimension..(place + 1) * dimension];
                for (sum, coordinate) in sums.iter_mut().zip(point) {
                    *sum += tap * coordinate;
                }
            }
        }
        Ok(sums)
    }

    /// The transpose of [`Self::fill`]: what the places give back to the points.
    pub(crate) fn gather(
        &self,
        places: &[f64],
        dimension: usize,
        m: usize,
        filter: &[f64],
        sums: &mut [f64],
    ) {
        for (k, sums) in sums.chunks_exact_mut(dimension).enumerate() {
            sums.fill(0.0);
            for (i, tap) in filter.iter().enumerate() {
                let Some(place) = self.place(m * k + i) else { continue };
                for (sum, value) in sums.iter_mut().zip(&places[place * dimension..]) {
                    *sum += tap * value;
                }
            }
        }
    }

    fn place(&self, index: usize) -> Option<usize> {
        if self.closed {
            // Filters may be longer than the turn.
            let around = self.lead.div_ceil(self.count) * self.count;
            Some((index + around - self.lead) % self.count)
        } else {
            index.checked_sub(self.lead).filter(|&place| place < self.count)
        }
    }
}
