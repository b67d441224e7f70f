//! Interpolating and B-spline curves in and out of the slots.

use super::exponential::{push_roots, roots_of};
use super::kernel::{AnyCurve, Kernel, run, times};
use crate::{BSplineCurve, Error, InterpolatingCurve};
use wasm_bindgen::prelude::wasm_bindgen;

/// Makes the curve whose `numbers` coordinates lie in the input, followed by its `roots` roots, and keeps it.
///
/// Kind 1 is an interpolating curve, for which no roots stand for the default, kind 2 a B-spline curve. Leaves the ends of
/// the domain in the record and the roots in the output.
#[wasm_bindgen]
#[allow(clippy::too_many_arguments, reason = "numbers are all that crosses")]
pub fn load_spline(
    slot: u32,
    kind: u32,
    numbers: u32,
    dimension: u32,
    closed: u32,
    roots: u32,
    step: f64,
    offset: f64,
) -> i32 {
    run(&mut |kernel| {
        let given = kernel.given(usize::MAX);
        let (points, rest) = given.split_at((numbers as usize).min(given.len()));
        let rest = rest.get(..times(roots, 2)).unwrap_or_default();
        let (points, dimension, closed) = (points.to_vec(), dimension as usize, closed != 0);
        let curve = if kind == 1 {
            let roots = if roots == 0 { None } else { Some(roots_of(rest)?) };
            AnyCurve::Interpolating(InterpolatingCurve::new(points, dimension, closed, roots)?)
        } else {
            AnyCurve::BSpline(BSplineCurve::new(points, dimension, closed, roots_of(rest)?, step, offset)?)
        };
        let pieces = curve.pieces();
        let ends = [pieces.knot(0), pieces.knot(pieces.piece_count())];
        kernel.output.clear();
        if let Some(roots) = pieces.roots() {
            push_roots(&mut kernel.output, roots);
        }
        kernel.record(ends);
        kernel.keep(slot, curve);
        Ok(kernel.output.len())
    })
}

/// Leaves a B-spline curve in the output.
///
/// Header: numbers, dimension, closed, roots, step, offset, both ends of the domain. Then the coordinates and the roots.
fn give_spline(kernel: &mut Kernel, curve: &BSplineCurve) -> usize {
    let (from, to) = curve.domain();
    let counts = [curve.points().len(), curve.dimension(), usize::from(curve.is_closed()), curve.roots().order()];
    kernel.output.clear();
    kernel.output.extend(counts.map(|count| count as f64));
    kernel.output.extend([curve.step(), curve.offset(), from, to]);
    kernel.output.extend(curve.points().iter().map(|x| x + 0.0));
    push_roots(&mut kernel.output, curve.roots());
    kernel.output.len()
}

/// The same curve on a finer grid: an interpolating curve on 1/(m0·m^(levels − 1)), a B-spline curve with m times the points.
#[wasm_bindgen]
pub fn refine_spline(slot: u32, levels: u32, m0: u32, m: u32) -> i32 {
    run(&mut |kernel| {
        let (levels, m0, m) = (levels as usize, m0 as usize, m as usize);
        let finer = match kernel.any(slot)? {
            AnyCurve::Interpolating(curve) => curve.refine(levels, m0, m)?,
            AnyCurve::BSpline(curve) => curve.refine(m)?,
            AnyCurve::Hermite(_) => return Err(wrong_kind()),
        };
        Ok(give_spline(kernel, &finer))
    })
}

#[cold]
fn wrong_kind() -> Box<Error> {
    Error::degenerate("curve", None, "it is of another kind")
}
