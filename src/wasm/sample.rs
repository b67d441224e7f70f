//! Points and derivatives of a resident curve, one, many, or uniformly spread.

use super::kernel::{grow, run};
use wasm_bindgen::prelude::wasm_bindgen;

/// One point or derivative, left in the record.
#[wasm_bindgen]
pub fn evaluate_one(slot: u32, t: f64, derivative: u32) -> i32 {
    run(|kernel| {
        let value = kernel.curve(slot)?.evaluate(t, derivative as usize)?;
        kernel.record[0] = value.x;
        kernel.record[1] = value.y;
        Ok(2)
    })
}

/// Points or derivatives at the `count` parameters in the input.
#[wasm_bindgen]
pub fn evaluate_many(slot: u32, count: u32, derivative: u32) -> i32 {
    run(|kernel| {
        let count = count as usize;
        grow(&mut kernel.output, 2 * count, 0.0)?;
        let (curve, given, output) = kernel.parts(slot, count)?;
        curve.evaluate_into(given, derivative as usize, &mut output[..2 * count])?;
        Ok(2 * count)
    })
}

/// Points `first`, … , `first + length − 1` of the uniform sampling by `count`.
#[wasm_bindgen]
pub fn sample(slot: u32, count: u32, first: u32, length: u32) -> i32 {
    run(|kernel| {
        let numbers = 2 * length as usize;
        grow(&mut kernel.output, numbers, 0.0)?;
        let (curve, _, output) = kernel.parts(slot, 0)?;
        curve.sample_range(count as usize, first as usize, &mut output[..numbers]);
        Ok(numbers)
    })
}

/// Four generalised Bézier points for every segment.
#[wasm_bindgen]
pub fn bezier_points(slot: u32) -> i32 {
    run(|kernel| {
        kernel.output = kernel.curve(slot)?.bezier_points();
        Ok(kernel.output.len())
    })
}
