//! Points and derivatives of a resident curve, one, many, or uniformly spread.

use super::kernel::{AnyCurve, grow, run, times};
use crate::curve::Scheme;
use crate::curve::measures::Pieces;
use wasm_bindgen::prelude::wasm_bindgen;

/// One point or derivative, left in the record.
#[wasm_bindgen]
pub fn evaluate_one(slot: u32, t: f64, derivative: u32) -> i32 {
    run(&mut |kernel| {
        let curve = kernel.any(slot)?;
        let mut value = [0.0; 3];
        let dimension = curve.pieces().dimension();
        if let AnyCurve::Hermite(curve) = curve {
            value[..2].copy_from_slice(curve.evaluate(t, derivative as usize)?.as_slice());
        } else {
            curve.pieces().values(&[t], derivative as usize, &mut value[..dimension])?;
        }
        kernel.record(value);
        Ok(dimension)
    })
}

/// Points or derivatives at the `count` parameters in the input.
#[wasm_bindgen]
pub fn evaluate_many(slot: u32, count: u32, derivative: u32) -> i32 {
    run(&mut |kernel| {
        let numbers = times(count, kernel.pieces(slot)?.dimension());
        grow(&mut kernel.output, numbers, 0.0)?;
        let (curve, given, output) = kernel.parts(slot, count as usize)?;
        curve.pieces().values(given, derivative as usize, &mut output[..numbers])?;
        Ok(numbers)
    })
}

/// Points `first`, … , `first + length − 1` of the uniform sampling by `count`, each followed by its derivative where
/// `tangents` is not 0.
#[wasm_bindgen]
pub fn sample(slot: u32, count: u32, first: u32, length: u32, tangents: u32) -> i32 {
    run(&mut |kernel| {
        let (count, first) = (count as usize, first as usize);
        let dimension = kernel.pieces(slot)?.dimension();
        let numbers = times(length, if tangents == 0 { dimension } else { 2 * dimension });
        grow(&mut kernel.output, numbers, 0.0)?;
        let mut sampler = kernel.sampler.take().unwrap_or_default();
        let mut splines = kernel.spline_sampler.take().unwrap_or_default();
        let (curve, _, output) = kernel.parts(slot, 0)?;
        let output = &mut output[..numbers];
        let mut spread = |derivative: usize, out: &mut [f64]| match curve {
            AnyCurve::Interpolating(curve) => splines.points(curve, count, first, derivative, out),
            AnyCurve::BSpline(curve) => splines.points(curve, count, first, derivative, out),
            _ => curve.pieces().values(&parameters(curve.pieces(), count, first, length), derivative, out),
        };
        match curve {
            AnyCurve::Hermite(curve) if tangents == 0 => sampler.points(curve, count, first, output),
            AnyCurve::Hermite(curve) => sampler.points_and_tangents(curve, count, first, output),
            _ if tangents == 0 => spread(0, output)?,
            _ => {
                let half = numbers / 2;
                let mut values = vec![0.0; numbers];
                let (points, slopes) = values.split_at_mut(half);
                spread(0, points)?;
                spread(1, slopes)?;
                let pairs = points.chunks_exact(dimension).zip(slopes.chunks_exact(dimension));
                for (sample, (point, slope)) in output.chunks_exact_mut(2 * dimension).zip(pairs) {
                    sample[..dimension].copy_from_slice(point);
                    sample[dimension..].copy_from_slice(slope);
                }
            }
        }
        kernel.sampler = Some(sampler);
        kernel.spline_sampler = Some(splines);
        Ok(numbers)
    })
}

/// The parameters of samples `first`, … , `first + length − 1` of a uniform sampling by `count`.
fn parameters(curve: &dyn Pieces, count: usize, first: usize, length: u32) -> Vec<f64> {
    let (start, end) = (curve.knot(0), curve.knot(curve.piece_count()));
    let steps = if curve.closed() { count } else { count.saturating_sub(1) }.max(1) as f64;
    let place = |i: u32| (start + (end - start) * ((first + i as usize) as f64 / steps)).min(end);
    (0..length).map(place).collect()
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
