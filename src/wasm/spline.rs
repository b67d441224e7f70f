//! Interpolating curves, with patches or without, and B-spline curves: in and out of the slots, finer and coarser.

use super::kernel::{AnyCurve, Kernel, PATCH, run, times};
use super::roots::{push_roots, roots_of};
use crate::generator::{Interpolator, Roots};
use crate::svg::{PrintOptions, outline as outline_of};
use crate::{BSplineCurve, Error, InterpolatingCurve, LocalCurve, Result};
use std::sync::Arc;
use wasm_bindgen::prelude::wasm_bindgen;

/// The kinds, as the face numbers them.
const INTERPOLATING: u32 = 1;
const B_SPLINE: u32 = 2;
const LOCAL: u32 = 3;

/// Makes the curve whose `numbers` coordinates lie in the input, followed by its `roots` roots and its `patches`
/// patches, and keeps it.
///
/// No roots stand for the default of an interpolating curve. A patch is its level, the first of its points, how many
/// they are, and their displacements. A start that is no number leaves the domain of a B-spline curve to its step and
/// offset. Leaves the ends of the domain in the record and the roots in the output.
#[wasm_bindgen]
#[allow(clippy::too_many_arguments, reason = "numbers are all that crosses")]
pub fn load_spline(
    slot: u32,
    kind: u32,
    numbers: u32,
    dimension: u32,
    closed: u32,
    roots: u32,
    patches: u32,
    step: f64,
    offset: f64,
    start: f64,
    end: f64,
) -> i32 {
    run(&mut |kernel| {
        let given = kernel.input.as_slice();
        let (points, rest) = given.split_at((numbers as usize).min(given.len()));
        let (given_roots, rest) = rest.split_at(times(roots, 2).min(rest.len()));
        let (points, dimension, closed) = (points.to_vec(), dimension as usize, closed != 0);
        let curve = if kind == B_SPLINE {
            let roots = roots_of(given_roots)?;
            let curve = BSplineCurve::new(points, dimension, closed, roots, step, offset)?;
            AnyCurve::BSpline(if start.is_nan() { curve } else { curve.with_domain(start, end)? })
        } else {
            let roots = if roots == 0 { None } else { Some(roots_of(given_roots)?) };
            let base = match roots.as_ref().and_then(|roots| known(kernel, roots)) {
                Some(known) => InterpolatingCurve::with_interpolator(points, dimension, closed, known)?,
                None => InterpolatingCurve::new(points, dimension, closed, roots)?,
            };
            if kind == LOCAL {
                AnyCurve::Local(with_patches(
                    &LocalCurve::new(base),
                    patches,
                    rest,
                    &mut kernel.record[PATCH],
                )?)
            } else {
                AnyCurve::Interpolating(base)
            }
        };
        let pieces = curve.pieces();
        let ends = [pieces.knot(0), pieces.knot(pieces.piece_count())];
        kernel.output.clear();
        if let Some(roots) = roots_in(&curve) {
            push_roots(&mut kernel.output, roots);
        }
        kernel.record(ends);
        kernel.keep(slot, curve);
        Ok(kernel.output.len())
    })
}

/// The interpolator of these roots, where a resident curve has it: as a rule the one that is loaded again because a
/// point has moved.
fn known(kernel: &Kernel, roots: &Roots) -> Option<Arc<Interpolator>> {
    kernel.slots.iter().flatten().find_map(|resident| {
        let curve = match &resident.curve {
            AnyCurve::Interpolating(curve) => curve,
            AnyCurve::Local(curve) => curve.base(),
            _ => return None,
        };
        (curve.roots() == roots).then(|| Arc::clone(curve.interpolator()))
    })
}

/// The curve with the patches that lie in `rest`; `patch` counts them, so that an error says which.
fn with_patches(curve: &LocalCurve, patches: u32, mut rest: &[f64], patch: &mut f64) -> Result<LocalCurve> {
    let mut list = Vec::new();
    for _ in 0..patches {
        let [level, first, count] = *rest.first_chunk::<3>().ok_or_else(wrong_kind)?;
        let size = count as usize * curve.base().dimension();
        let numbers = rest.get(3..3 + size).ok_or_else(wrong_kind)?;
        list.push(((level as usize, first as usize, count as usize), numbers));
        rest = &rest[3 + size..];
    }
    curve.add_patches(list.into_iter().inspect(|_| *patch += 1.0))
}

fn roots_in(curve: &AnyCurve) -> Option<&crate::generator::Roots> {
    match curve {
        #[cfg(feature = "wasm")]
        AnyCurve::Hermite(_) => None,
        AnyCurve::Interpolating(curve) => Some(curve.roots()),
        AnyCurve::BSpline(curve) => Some(curve.roots()),
        AnyCurve::Local(curve) => Some(curve.base().roots()),
    }
}

/// Leaves a curve on a grid in the output.
///
/// Header: kind, numbers, dimension, closed, roots, patches, step, offset, both ends of the domain. Then the
/// coordinates, the roots and the patches.
fn give_spline(kernel: &mut Kernel, curve: &AnyCurve) -> Result<usize> {
    let (kind, points, step, offset) = match curve {
        #[cfg(feature = "wasm")]
        AnyCurve::Hermite(_) => return Err(wrong_kind()),
        AnyCurve::Interpolating(curve) => (INTERPOLATING, curve.points(), 1.0, 0.0),
        AnyCurve::BSpline(curve) => (B_SPLINE, curve.points(), curve.step(), curve.offset()),
        AnyCurve::Local(curve) => (LOCAL, curve.base().points(), 1.0, 0.0),
    };
    let (pieces, output) = (curve.pieces(), &mut kernel.output);
    let local = if let AnyCurve::Local(curve) = curve { Some(curve) } else { None };
    let patches = local.map_or(0, LocalCurve::patch_count);
    let roots = roots_in(curve).ok_or_else(wrong_kind)?;
    let counts = [
        kind as usize,
        points.len(),
        pieces.coordinate_count(),
        usize::from(pieces.closed()),
        roots.order(),
        patches,
    ];
    output.clear();
    output.extend(counts.map(|count| count as f64));
    output.extend([step, offset, pieces.knot(0), pieces.knot(pieces.piece_count())]);
    // Adding 0 turns −0 into 0, so that JSON can carry every number.
    output.extend(points.iter().map(|x| x + 0.0));
    push_roots(output, roots);
    for k in 0..patches {
        if let Some(curve) = local {
            let (level, first, count) = curve.patch_window(k)?;
            output.extend([level, first, count].map(|n| n as f64));
            output.extend(curve.displacements(k)?.iter().map(|x| x + 0.0));
        }
    }
    Ok(output.len())
}

/// Leaves the curve that is made from the one in a slot in the output.
fn derive(slot: u32, make: &dyn Fn(&AnyCurve) -> Result<(AnyCurve, f64)>) -> i32 {
    run(&mut |kernel| {
        let (curve, deviation) = make(kernel.any(slot)?)?;
        kernel.record([deviation]);
        give_spline(kernel, &curve)
    })
}

/// The same curve on a finer grid: an interpolating curve on 1/(m0·m^(levels − 1)), a B-spline curve with m times the
/// points.
#[wasm_bindgen]
pub fn refine_spline(slot: u32, levels: u32, m0: u32, m: u32) -> i32 {
    derive(slot, &|curve| {
        let finer = match curve {
            AnyCurve::Interpolating(curve) => curve.refine(levels as usize, m0 as usize, m as usize)?,
            AnyCurve::BSpline(curve) => curve.refine(m as usize)?,
            _ => return Err(wrong_kind()),
        };
        Ok((AnyCurve::BSpline(finer), 0.0))
    })
}

/// The nearest curve on a grid that is coarser by m, or for m = 0 the interpolating one; the deviation is left in the
/// record.
#[wasm_bindgen]
pub fn reduce_spline(slot: u32, m: u32) -> i32 {
    derive(slot, &|curve| match curve {
        AnyCurve::BSpline(curve) if m == 0 => {
            let (curve, deviation) = curve.interpolating()?;
            Ok((AnyCurve::Interpolating(curve), deviation))
        }
        AnyCurve::BSpline(curve) => {
            let (curve, deviation) = curve.reduce(m as usize)?;
            Ok((AnyCurve::BSpline(curve), deviation))
        }
        _ => Err(wrong_kind()),
    })
}

/// A curve with points and tangents for a path within a tolerance, that of paths for 0; how far it is from this one,
/// and what that leaves of the tolerance, are in the record.
#[wasm_bindgen]
pub fn outline(slot: u32, tolerance: f64) -> i32 {
    run(&mut |kernel| {
        let asked = if tolerance == 0.0 { PrintOptions::default().tolerance } else { tolerance };
        let (curve, near, rest) = outline_of(kernel.pieces(slot)?, asked)?;
        kernel.record([near, rest]);
        Ok(kernel.give_curves(&[curve]))
    })
}

/// The same curve with a patch around t.
#[wasm_bindgen]
pub fn refine_at(slot: u32, t: f64, levels: u32, reach: f64) -> i32 {
    derive(slot, &|curve| {
        let finer = match curve {
            AnyCurve::Interpolating(curve) => {
                LocalCurve::new(curve.clone()).refine_at(t, levels as usize, reach)?
            }
            AnyCurve::Local(curve) => curve.refine_at(t, levels as usize, reach)?,
            _ => return Err(wrong_kind()),
        };
        Ok((AnyCurve::Local(finer), 0.0))
    })
}

fn local(curve: &AnyCurve) -> Result<&LocalCurve> {
    if let AnyCurve::Local(curve) = curve { Ok(curve) } else { Err(wrong_kind()) }
}

/// The control points of patch k.
#[wasm_bindgen]
pub fn patch_points(slot: u32, k: u32) -> i32 {
    run(&mut |kernel| {
        let points = local(kernel.any(slot)?)?.patch_points(k as usize)?;
        Ok(kernel.give(points))
    })
}

/// The curve with control point i of patch k elsewhere.
#[wasm_bindgen]
pub fn move_patch_point(slot: u32, k: u32, i: u32, x: f64, y: f64, z: f64) -> i32 {
    derive(slot, &|curve| {
        let (curve, place) = (local(curve)?, [x, y, z]);
        let place = &place[..curve.base().dimension()];
        Ok((AnyCurve::Local(curve.with_patch_point(k as usize, i as usize, place)?), 0.0))
    })
}

#[cold]
fn wrong_kind() -> Box<Error> {
    Error::degenerate("curve", None, "it is of another kind")
}
