//! Lengths, areas, distances, and approximations of a resident curve.
//!
//! A tolerance of 0 stands for the default, a share of the curve's size.

use super::kernel::{grow, run, times};
use crate::numerics::Point;
use crate::{Curve, HermiteCurve, Result};
use wasm_bindgen::prelude::wasm_bindgen;

/// The default tolerance of lengths and of recognition, as a share of the size.
const FINE: f64 = 1e-9;

fn tolerance_of(curve: &HermiteCurve, given: f64, share: f64) -> f64 {
    if given == 0.0 { (share * curve.bounds().extent()).max(f64::MIN_POSITIVE) } else { given }
}

/// Leaves one number in the record.
fn measure(slot: u32, body: &dyn Fn(&HermiteCurve) -> Result<f64>) -> i32 {
    run(&mut |kernel| {
        let value = body(kernel.curve(slot)?)?;
        kernel.record([value]);
        Ok(1)
    })
}

/// The length.
#[wasm_bindgen]
pub fn length(slot: u32, tolerance: f64) -> i32 {
    measure(slot, &|curve| curve.length(tolerance_of(curve, tolerance, FINE)))
}

/// The parameter up to which the curve has that length.
#[wasm_bindgen]
pub fn parameter_at_length(slot: u32, length: f64, tolerance: f64) -> i32 {
    measure(slot, &|curve| curve.parameter_at_length(length, tolerance_of(curve, tolerance, FINE)))
}

/// The signed area.
#[wasm_bindgen]
pub fn area(slot: u32) -> i32 {
    measure(slot, &Curve::area)
}

/// The centre of gravity.
#[wasm_bindgen]
pub fn centroid(slot: u32) -> i32 {
    run(&mut |kernel| {
        let center = kernel.curve(slot)?.centroid()?;
        kernel.record([center.x, center.y]);
        Ok(2)
    })
}

/// The smallest rectangle around the curve.
#[wasm_bindgen]
pub fn bounds(slot: u32) -> i32 {
    run(&mut |kernel| {
        let bounds = kernel.curve(slot)?.bounds();
        kernel.record([bounds.min_x, bounds.min_y, bounds.max_x, bounds.max_y]);
        Ok(4)
    })
}

/// The nearest point: t, x, y, distance.
#[wasm_bindgen]
pub fn nearest(slot: u32, x: f64, y: f64) -> i32 {
    run(&mut |kernel| {
        let found = kernel.finder(slot, 0)?.0.nearest(Point::new(x, y));
        kernel.record([found.t, found.point.x, found.point.y, found.distance]);
        Ok(4)
    })
}

/// The nearest points to the `count` places in the input, four numbers each.
#[wasm_bindgen]
pub fn nearest_many(slot: u32, count: u32) -> i32 {
    run(&mut |kernel| {
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
        kernel.curve(slot)?;
        grow(&mut kernel.output, count, 0.0)?;
        let (curve, given, output) = kernel.parts(slot, count)?;
        curve.check_parameters(given)?;
        let mut still = -1.0;
        for (i, (&t, value)) in given.iter().zip(output).enumerate().rev() {
            let curvature = curve.curvature(t)?;
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
        let (points, deviation) = kernel.curve(slot)?.flatten(tolerance)?;
        kernel.record([deviation]);
        Ok(kernel.give(points))
    })
}

/// Cubic Béziers within a tolerance; the proved deviation is left in the record.
#[wasm_bindgen]
pub fn to_cubics(slot: u32, tolerance: f64) -> i32 {
    run(&mut |kernel| {
        let cubics = kernel.curve(slot)?.to_cubics(tolerance)?;
        kernel.record([cubics.deviation]);
        Ok(kernel.give(cubics.path))
    })
}

/// Points at equal distances along the curve.
#[wasm_bindgen]
pub fn sample_by_length(slot: u32, count: u32, tolerance: f64) -> i32 {
    run(&mut |kernel| {
        let tolerance = tolerance_of(kernel.curve(slot)?, tolerance, FINE);
        let (curve, table) = kernel.table(slot, tolerance)?;
        let points = table.points(curve, count as usize)?;
        Ok(kernel.give(points))
    })
}

/// The ellipse that the curve follows, in the record, or nothing.
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
