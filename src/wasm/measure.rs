//! Lengths, areas, distances, and approximations of a resident curve.
//!
//! A tolerance of 0 stands for the default, a share of the curve's size.

use super::kernel::{grow, run, times};
use crate::Result;
use crate::curve::{Pieces, check_parameters, in_space, measures};
use crate::numerics::Point;
use wasm_bindgen::prelude::wasm_bindgen;

/// The default tolerance of lengths and of recognition, as a share of the size.
const FINE: f64 = 1e-9;

pub(super) fn tolerance_of(curve: &dyn Pieces, given: f64, share: f64) -> f64 {
    if given == 0.0 { (share * measures::bounds(curve).extent()).max(f64::MIN_POSITIVE) } else { given }
}

/// Leaves one number in the record.
fn measure(slot: u32, body: &dyn Fn(&dyn Pieces) -> Result<f64>) -> i32 {
    run(&mut |kernel| {
        let value = body(kernel.pieces(slot)?)?;
        kernel.record([value]);
        Ok(1)
    })
}

/// The length.
#[wasm_bindgen]
pub fn length(slot: u32, tolerance: f64) -> i32 {
    measure(slot, &|curve| measures::length(curve, tolerance_of(curve, tolerance, FINE)))
}

/// The parameter up to which the curve has that length.
#[wasm_bindgen]
pub fn parameter_at_length(slot: u32, length: f64, tolerance: f64) -> i32 {
    measure(slot, &|curve| measures::parameter_at_length(curve, length, tolerance_of(curve, tolerance, FINE)))
}

/// The signed area.
#[wasm_bindgen]
pub fn area(slot: u32) -> i32 {
    measure(slot, &measures::area)
}

/// The centre of gravity.
#[wasm_bindgen]
pub fn centroid(slot: u32) -> i32 {
    run(&mut |kernel| {
        let center = measures::centroid(kernel.pieces(slot)?)?;
        kernel.record([center.x, center.y]);
        Ok(2)
    })
}

/// The smallest rectangle around the curve.
#[wasm_bindgen]
pub fn bounds(slot: u32) -> i32 {
    run(&mut |kernel| {
        let box_of = measures::bounds(kernel.pieces(slot)?);
        kernel.record([box_of.min_x, box_of.min_y, box_of.max_x, box_of.max_y, box_of.min_z, box_of.max_z]);
        Ok(6)
    })
}

/// The nearest point: t, x, y, distance; of a curve in space t, x, y, z, distance.
#[wasm_bindgen]
pub fn nearest(slot: u32, x: f64, y: f64, z: f64) -> i32 {
    run(&mut |kernel| {
        let curve = kernel.pieces(slot)?;
        if in_space(curve) {
            let found = measures::nearest_in_space(curve, [x, y, z]);
            let [x, y, z] = found.point;
            kernel.record([found.t, x, y, z, found.distance]);
            return Ok(5);
        }
        let found = kernel.finder(slot, 0)?.0.nearest(Point::new(x, y));
        kernel.record([found.t, found.point.x, found.point.y, found.distance]);
        Ok(4)
    })
}

/// The nearest points to the `count` places in the input, four numbers each; of a curve in space five each.
#[wasm_bindgen]
pub fn nearest_many(slot: u32, count: u32) -> i32 {
    run(&mut |kernel| {
        let curve = kernel.pieces(slot)?;
        if in_space(curve) {
            let mut numbers = Vec::new();
            for place in kernel.given(times(count, 3)).as_chunks::<3>().0 {
                let found = measures::nearest_in_space(curve, *place);
                let [x, y, z] = found.point;
                numbers.extend([found.t, x, y, z, found.distance]);
            }
            return Ok(kernel.give(numbers));
        }
        let (finder, given, output) = kernel.finder(slot, times(count, 2))?;
        grow(output, 2 * given.len(), 0.0)?;
        for (place, numbers) in given.chunks_exact(2).zip(output.chunks_exact_mut(4)) {
            let found = finder.nearest(Point::new(place[0], place[1]));
            numbers.copy_from_slice(&[found.t, found.point.x, found.point.y, found.distance]);
        }
        Ok(2 * given.len())
    })
}

/// The curvature at the `count` parameters in the input, 0 where the speed is zero; the record then holds the place of
/// the first such parameter, else −1.
#[wasm_bindgen]
pub fn curvature(slot: u32, count: u32) -> i32 {
    run(&mut |kernel| {
        let count = count as usize;
        kernel.any(slot)?;
        grow(&mut kernel.output, count, 0.0)?;
        let (curve, given, output) = kernel.parts(slot, count)?;
        let curve = curve.pieces();
        check_parameters(curve.closed(), (curve.knot(0), curve.knot(curve.piece_count())), given)?;
        let mut still = -1.0;
        for (i, (&t, value)) in given.iter().zip(output).enumerate().rev() {
            let curvature = measures::curvature(curve, t)?;
            *value = curvature.unwrap_or(0.0);
            if curvature.is_none() {
                still = i as f64;
            }
        }
        kernel.record([still]);
        Ok(count)
    })
}

/// A polyline within a tolerance; the measured deviation is left in the record.
#[wasm_bindgen]
pub fn flatten(slot: u32, tolerance: f64) -> i32 {
    run(&mut |kernel| {
        let (points, deviation) = measures::flatten(kernel.pieces(slot)?, tolerance)?;
        kernel.record([deviation]);
        Ok(kernel.give(points))
    })
}

/// Cubic Béziers within a tolerance; the proved deviation is left in the record.
#[wasm_bindgen]
pub fn to_cubics(slot: u32, tolerance: f64) -> i32 {
    run(&mut |kernel| {
        let cubics = measures::to_cubics(kernel.pieces(slot)?, tolerance)?;
        kernel.record([cubics.deviation]);
        Ok(kernel.give(cubics.path))
    })
}

/// Points at equal distances along the curve.
#[wasm_bindgen]
pub fn sample_by_length(slot: u32, count: u32, tolerance: f64) -> i32 {
    run(&mut |kernel| {
        let within = tolerance_of(kernel.pieces(slot)?, tolerance, FINE);
        let (curve, table) = kernel.table(slot, within)?;
        let points = table.points_of(curve, count as usize)?;
        Ok(kernel.give(points))
    })
}

/// The ellipse that a Hermite curve follows, in the record, or nothing.
#[cfg(feature = "wasm")]
#[wasm_bindgen]
pub fn as_ellipse(slot: u32, tolerance: f64) -> i32 {
    run(&mut |kernel| {
        let curve = kernel.curve(slot)?;
        let Some(arc) = curve.as_ellipse(tolerance_of(curve, tolerance, FINE)) else { return Ok(0) };
        let (center, radii) = (arc.center, arc.radii);
        kernel.record([center.x, center.y, radii.x, radii.y, arc.rotation, arc.start, arc.sweep]);
        Ok(7)
    })
}

/// The same curve with points and tangents; the deviation is left in the record.
#[cfg(feature = "wasm-spline")]
#[wasm_bindgen]
pub fn to_hermite(slot: u32, tolerance: f64) -> i32 {
    run(&mut |kernel| {
        let curve = kernel.pieces(slot)?;
        let (curve, deviation) = crate::curve::to_hermite(curve, tolerance_of(curve, tolerance, FINE))?;
        kernel.record([deviation]);
        Ok(kernel.give_curves(&[curve]))
    })
}
