//! The scalar scheme: control points become more control points that close in on the curve.

use super::vector::{HermiteData, check_segment};
use super::{check_levels, subdivide_hermite};
use crate::error::Result;
use crate::generator::{Basis, Space};
use crate::limits::with_room;
use crate::numerics::Point;

/// The four rules of one dyadic step for control points `p[2n]`, `p[2n + 1]` on either side of point n.
///
/// ```text
/// p′[4n]     = (1 + ρ)/2 p[2n] + (1 − ρ)/2 p[2n + 1]      p′[4n + 2] = c₀ p[2n] + c₁ p[2n + 1] + c₂ p[2n + 2]
/// p′[4n + 1] = (1 − ρ)/2 p[2n] + (1 + ρ)/2 p[2n + 1]      p′[4n + 3] = c₂ p[2n + 1] + c₁ p[2n + 2] + c₀ p[2n + 3]
/// ```
///
/// For ω·step ≤ π all weights are positive: every new point lies between old ones.
///
/// # Source
///
/// [CRU15, eq. 40–42] with the level's own frequency in M (docs/SOURCES.md), multiplied out (D 5.4).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScalarMask {
    /// ρ = κ(w/2)/(2κ(w)); 1/2 for the cubic.
    pub reach: f64,
    /// c₀, c₁, c₂; 1/8, 5/8, 1/4 for the cubic.
    pub inner: [f64; 3],
}

impl ScalarMask {
    /// The rules for w = ω times the step of the coarser grid.
    ///
    /// # Errors
    ///
    /// A frequency that is not finite or not below 2π in size in the trigonometric space, above 1e4 in others.
    pub fn new(space: Space, frequency: f64) -> Result<Self> {
        check_segment(None, space, frequency, 1.0)?;
        let basis = Basis::new(space, frequency);
        let (kappa, finer) = (basis.kappa(), Basis::new(space, 0.5 * frequency).kappa());
        let reach = 0.5 * finer / kappa;
        let outer = 0.5 - basis.weights(0.5, 0).leaving / kappa;
        // p′[4n + 2] + p′[4n + 3] is twice the new point, p′[4n + 3] − p′[4n + 2] twice κ·step times its derivative.
        let slope = basis.weights(0.5, 1);
        let far = 0.5 * (1.0 - outer) - 0.5 * finer * (0.5 * slope.chord - 0.5 * slope.leaving / kappa);
        Ok(Self { reach, inner: [outer, 1.0 - outer - far, far] })
    }

    /// One step of the scheme for a control polygon as [`control_polygon`] makes it, of a smooth curve with
    /// one frequency.
    ///
    /// # Errors
    ///
    /// Where memory is short.
    pub fn apply(&self, points: &[Point], closed: bool) -> Result<Vec<Point>> {
        let nodes = points.len() / 2;
        let segments = if closed { nodes } else { nodes.saturating_sub(1) };
        let mut finer = with_room(2 * (nodes + segments))?;
        // c₁ is what the others leave of 1: written as differences, a translation stays a translation.
        let [c0, _, c2] = self.inner;
        for (n, pair) in points.chunks_exact(2).enumerate() {
            let (before, after) = (pair[0], pair[1]);
            let (first, last) = (!closed && n == 0, !closed && n + 1 == nodes);
            // An open polygon begins and ends in the end points themselves; the mirror image completes the pair.
            let before = if first { before + before - after } else { before };
            let after = if last { after + after - before } else { after };
            let middle = (before + after) * 0.5;
            let half = (after - before) * (0.5 * self.reach);
            finer.push(if first { middle } else { middle - half });
            finer.push(if last { middle } else { middle + half });
            if last {
                break;
            }
            let next = if n + 1 == nodes { 0 } else { n + 1 };
            let (near, far) = (points[2 * next], points[2 * next + 1]);
            let far = if !closed && next + 1 == nodes { far + far - near } else { far };
            finer.push(after + (before - after) * c0 + (near - after) * c2);
            finer.push(near + (after - near) * c2 + (far - near) * c0);
        }
        Ok(finer)
    }
}

/// The control polygon of a curve: at every point P the two generalised Bézier points P − κ·H·D on its arriving and
/// P + κ·H·D on its leaving side, with κ and the parameter length H of the segment on that side. An open polygon
/// begins and ends in the curve's end points.
///
/// # Errors
///
/// Fewer than two points; lists that do not belong to as many; numbers that are not finite or that no curve may have;
/// where memory is short.
///
/// # Source
///
/// [CRU15, eq. 38, 40].
pub fn control_polygon(data: &HermiteData) -> Result<Vec<Point>> {
    data.check()?;
    let segments = data.lengths.len();
    let reach = |i: usize| {
        let length = data.lengths[i];
        length * Basis::new(data.space, data.omega[i] * length).kappa()
    };
    let mut polygon = with_room(2 * data.points.len())?;
    let mut before = if data.closed { reach(segments - 1) } else { 0.0 };
    for (i, &point) in data.points.iter().enumerate() {
        let after = if i == segments {
            0.0
        } else if i > 0 && data.omega[i] == data.omega[i - 1] && data.lengths[i] == data.lengths[i - 1] {
            before
        } else {
            reach(i)
        };
        polygon.push(point - data.arriving[i] * before);
        polygon.push(point + data.leaving[i] * after);
        before = after;
    }
    Ok(polygon)
}

/// The scalar scheme: the control polygon after `levels` dyadic refinements. It closes in on the curve fourfold a
/// level.
///
/// A smooth curve with one frequency and one length goes through the four rules of [`ScalarMask`]. Any other goes
/// through the vector scheme and [`control_polygon`], which is the same by definition (D 5.3).
///
/// # Errors
///
/// As [`subdivide_hermite`].
pub fn subdivide_scalar(data: &HermiteData, levels: usize) -> Result<Vec<Point>> {
    data.check()?;
    check_levels(2 * data.lengths.len(), 2, levels)?;
    let same = |values: &[f64]| values.windows(2).all(|pair| pair[0] == pair[1]);
    if !(same(&data.omega) && same(&data.lengths) && data.leaving == data.arriving) {
        return control_polygon(&subdivide_hermite(data, 2, levels)?);
    }
    let mut polygon = control_polygon(data)?;
    let mut frequency = data.omega[0] * data.lengths[0];
    for _ in 0..levels {
        polygon = ScalarMask::new(data.space, frequency)?.apply(&polygon, data.closed)?;
        frequency *= 0.5;
    }
    Ok(polygon)
}
