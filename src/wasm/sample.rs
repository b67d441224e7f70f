//! Points and derivatives of a resident curve, one, many, or uniformly spread.

use super::kernel::{grow, run, times};
use crate::curve::Scheme;
use wasm_bindgen::prelude::wasm_bindgen;

/// One point or derivative, left in the record.
#[wasm_bindgen]
pub fn evaluate_one(slot: u32, t: f64, derivative: u32) -> i32 {
    run(&mut |kernel| {
        let value = kernel.curve(slot)?.evaluate(t, derivative as usize)?;
        kernel.record([value.x, value.y]);
        Ok(2)
    })
}

/// Points or derivatives at the `count` parameters in the input.
#[wasm_bindgen]
pub fn evaluate_many(slot: u32, count: u32, derivative: u32) -> i32 {
    run(&mut |kernel| {
        let numbers = times(count, 2);
        kernel.curve(slot)?;
        grow(&mut kernel.output, numbers, 0.0)?;
        let (curve, given, output) = kernel.parts(slot, count as usize)?;
        curve.evaluate_into(given, derivative as usize, &mut output[..numbers])?;
        Ok(numbers)
    })
}

/// Points `first`, … , `first + length − 1` of the uniform sampling by `count`, each followed by its derivative where
/// `tangents` is not 0.
#[wasm_bindgen]
pub fn sample(slot: u32, count: u32, first: u32, length: u32, tangents: u32) -> i32 {
    run(&mut |kernel| {
        let (count, first) = (count as usize, first as usize);
        let numbers = times(length, if tangents == 0 { 2 } else { 4 });
        kernel.curve(slot)?;
        grow(&mut kernel.output, numbers, 0.0)?;
        let mut sampler = kernel.sampler.take().unwrap_or_default();
        let (curve, _, output) = kernel.parts(slot, 0)?;
        let output = &mut output[..numbers];
        if tangents == 0 {
            sampler.points(curve, count, first, output);
        } else {
            sampler.points_and_tangents(curve, count, first, output);
        }
        kernel.sampler = Some(sampler);
        Ok(numbers)
    })
}

/// Four generalised Bézier points for every segment.
#[wasm_bindgen]
pub fn bezier_points(slot: u32) -> i32 {
    run(&mut |kernel| {
        let points = kernel.curve(slot)?.bezier_points();
        Ok(kernel.give(points))
    })
}

/// The polygon of a subdivision scheme, the scalar one where `scalar` is not 0.
#[wasm_bindgen]
pub fn subdivide(slot: u32, levels: u32, arity: u32, scalar: u32) -> i32 {
    run(&mut |kernel| {
        let scheme = if scalar == 0 { Scheme::Hermite } else { Scheme::Scalar };
        let polygon = kernel.curve(slot)?.subdivide(levels as usize, arity as usize, scheme)?;
        Ok(kernel.give(polygon))
    })
}
