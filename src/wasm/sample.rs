//! Points and derivatives of a resident curve, one, many, or uniformly spread.

use super::kernel::{AnyCurve, grow, run, times};
#[cfg(feature = "wasm-spline")]
use crate::Result;
#[cfg(feature = "wasm")]
use crate::curve::Scheme;
#[cfg(feature = "wasm-spline")]
use crate::curve::SplineSampler;
use wasm_bindgen::prelude::wasm_bindgen;

/// One point or derivative, left in the record.
#[wasm_bindgen]
pub fn evaluate_one(slot: u32, t: f64, derivative: u32) -> i32 {
    run(&mut |kernel| {
        let curve = kernel.pieces(slot)?;
        let mut value = [0.0; 3];
        let dimension = curve.coordinate_count();
        curve.values(&[t], derivative as usize, &mut value[..dimension])?;
        kernel.record(value);
        Ok(dimension)
    })
}

/// Points or derivatives at the `count` parameters in the input.
#[wasm_bindgen]
pub fn evaluate_many(slot: u32, count: u32, derivative: u32) -> i32 {
    run(&mut |kernel| {
        let numbers = times(count, kernel.pieces(slot)?.coordinate_count());
        grow(&mut kernel.output, numbers, 0.0)?;
        let (curve, given, output) = kernel.parts(slot, count as usize)?;
        curve.pieces().values(given, derivative as usize, &mut output[..numbers])?;
        Ok(numbers)
    })
}

/// Points `first`, `first + 1`, … of the uniform sampling by `count`, `length` or a few less, each followed by its
/// derivative where `tangents` is not 0. There are no fewer than `length` of the last ones, and at least one.
#[wasm_bindgen]
pub fn sample(slot: u32, count: u32, first: u32, length: u32, tangents: u32) -> i32 {
    run(&mut |kernel| {
        let (count, first) = (count as usize, first as usize);
        let dimension = kernel.pieces(slot)?.coordinate_count();
        let numbers = times(length, if tangents == 0 { dimension } else { 2 * dimension });
        grow(&mut kernel.output, numbers, 0.0)?;
        let made = match kernel.any(slot)? {
            #[cfg(feature = "wasm")]
            AnyCurve::Hermite(_) => {
                let mut sampler = kernel.sampler.take().unwrap_or_default();
                let (curve, _, output) = kernel.parts(slot, 0)?;
                let output = &mut output[..numbers];
                let made = curve
                    .pieces()
                    .as_hermite()
                    .map_or(0, |curve| sampler.blocks(curve, count, first, tangents != 0, output));
                kernel.sampler = Some(sampler);
                made * if tangents == 0 { 2 } else { 4 }
            }
            #[cfg(feature = "wasm-spline")]
            _ => {
                let mut sampler = kernel.spline_sampler.take().unwrap_or_default();
                let (curve, _, output) = kernel.parts(slot, 0)?;
                let output = &mut output[..numbers];
                let made = if tangents == 0 {
                    spread(&mut sampler, curve, (count, first), 0, output)?
                } else {
                    let mut values = vec![0.0; numbers];
                    let (points, slopes) = values.split_at_mut(numbers / 2);
                    let made = spread(&mut sampler, curve, (count, first), 0, points)?;
                    spread(&mut sampler, curve, (count, first), 1, slopes)?;
                    let pairs = points.chunks_exact(dimension).zip(slopes.chunks_exact(dimension));
                    for (sample, (point, slope)) in output.chunks_exact_mut(2 * dimension).zip(pairs) {
                        sample[..dimension].copy_from_slice(point);
                        sample[dimension..].copy_from_slice(slope);
                    }
                    2 * made
                };
                kernel.spline_sampler = Some(sampler);
                made * dimension
            }
        };
        Ok(made)
    })
}

/// Points or derivatives of a curve on a grid: as many samples from `first` on as there is room for, of `count`, or a
/// few less, so that no block is cut in two. Returns how many.
#[cfg(feature = "wasm-spline")]
fn spread(
    sampler: &mut SplineSampler,
    curve: &AnyCurve,
    (count, first): (usize, usize),
    derivative: usize,
    out: &mut [f64],
) -> Result<usize> {
    match curve {
        AnyCurve::Interpolating(curve) => sampler.blocks(curve, count, first, derivative, out),
        AnyCurve::BSpline(curve) => sampler.blocks(curve, count, first, derivative, out),
        AnyCurve::Local(curve) => {
            let made = sampler.blocks(curve.base(), count, first, derivative, out)?;
            let numbers = made * curve.base().dimension();
            curve.displace_samples((count, first), derivative, &mut out[..numbers])?;
            Ok(made)
        }
        #[cfg(feature = "wasm")]
        AnyCurve::Hermite(_) => Ok(0),
    }
}

/// Four generalised Bézier points for every segment.
#[cfg(feature = "wasm")]
#[wasm_bindgen]
pub fn bezier_points(slot: u32) -> i32 {
    run(&mut |kernel| {
        let points = kernel.curve(slot)?.bezier_points();
        Ok(kernel.give(points))
    })
}

/// The polygon of a subdivision scheme, the scalar one where `scalar` is not 0.
#[cfg(feature = "wasm")]
#[wasm_bindgen]
pub fn subdivide(slot: u32, levels: u32, arity: u32, scalar: u32) -> i32 {
    run(&mut |kernel| {
        let scheme = if scalar == 0 { Scheme::Hermite } else { Scheme::Scalar };
        let polygon = kernel.curve(slot)?.subdivide(levels as usize, arity as usize, scheme)?;
        Ok(kernel.give(polygon))
    })
}
