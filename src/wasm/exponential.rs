//! Exponential B-splines, interpolators, and lists of roots by what they keep.

use super::kernel::{Kernel, run, times};
use super::prepared::{Generator, Prepared};
use super::roots::{push_roots, roots_of};
use crate::Result;
use crate::generator::{ExponentialBSpline, Interpolator, Roots};
use wasm_bindgen::prelude::wasm_bindgen;

fn prepare(kernel: &mut Kernel, kind: u32, count: u32) -> Result<Box<Prepared>> {
    let given = kernel.given(times(count, 2)).to_vec();
    if let Some(prepared) = kernel.generator.take()
        && prepared.kind == kind
        && prepared.roots == given
    {
        return Ok(prepared);
    }
    let roots = roots_of(&given)?;
    let generator = match kind {
        0 => Generator::Spline(ExponentialBSpline::new(&roots)?),
        1 => Generator::Interpolator(Interpolator::new(&roots)?),
        _ => Generator::Interpolator(Interpolator::beyond_pi(&roots)?),
    };
    Ok(Box::new(Prepared { kind, roots: given, generator }))
}

/// Asks a generator of the `roots` roots in the input; kind 0 is the B-spline, 1 the interpolator, 2 the interpolator
/// with roots beyond π allowed.
///
/// `what` 0: the numbers λ, with condition and Lebesgue constant in the record; 1: values of a derivative of order
/// `argument` at the `count` places that follow the roots; 2: the filter to a grid finer by `argument`; 3: the same,
/// scaled to keep constants; 4: the Riesz bounds, in the record.
#[wasm_bindgen]
pub fn exponential(kind: u32, roots: u32, what: u32, count: u32, argument: u32) -> i32 {
    run(&mut |kernel| {
        let prepared = prepare(kernel, kind, roots)?;
        let argument = argument as usize;
        let numbers = match (&prepared.generator, what) {
            (Generator::Spline(_), 0) => Vec::new(),
            (Generator::Interpolator(interpolator), 0) => {
                kernel.record([interpolator.condition(), interpolator.lebesgue()]);
                interpolator.lambda().to_vec()
            }
            (generator, 1) => {
                let first = times(roots, 2);
                let given =
                    kernel.given(first.saturating_add(count as usize)).get(first..).unwrap_or_default();
                match generator {
                    Generator::Spline(spline) => spline.evaluate(given, argument)?,
                    Generator::Interpolator(interpolator) => interpolator.evaluate(given, argument)?,
                }
            }
            (Generator::Spline(spline), 2) => spline.refinement_filter(argument)?,
            (Generator::Spline(spline), 3) => spline.affine_refinement_filter(argument)?,
            (Generator::Interpolator(interpolator), 2) => interpolator.pre_filter(argument)?,
            (Generator::Interpolator(interpolator), 3) => interpolator.affine_pre_filter(argument)?,
            (generator, _) => {
                let bounds = match generator {
                    Generator::Spline(spline) => spline.riesz_bounds(),
                    Generator::Interpolator(interpolator) => interpolator.riesz_bounds(),
                };
                kernel.record([bounds.lower, bounds.upper]);
                Vec::new()
            }
        };
        kernel.generator = Some(prepared);
        Ok(kernel.give(numbers))
    })
}

/// Lists of roots by what they keep: polynomials up to degree `count`, harmonics to `k` of `count` points, a hyperbola
/// that grows at `rate`. Left in the output, two numbers each.
#[wasm_bindgen]
pub fn roots_keeping(kind: u32, count: u32, k: u32, rate: f64) -> i32 {
    run(&mut |kernel| {
        let roots = match kind {
            0 => Roots::polynomials(count as usize)?,
            1 => Roots::harmonics(count as usize, k as usize)?,
            _ => Roots::hyperbola(rate)?,
        };
        kernel.output.clear();
        push_roots(&mut kernel.output, &roots);
        Ok(kernel.output.len())
    })
}

/// The union of two lists in the input, of `first` and `second` roots.
#[wasm_bindgen]
pub fn roots_union(first: u32, second: u32) -> i32 {
    run(&mut |kernel| {
        let given = kernel.given(times(first, 2).saturating_add(times(second, 2)));
        let (one, two) = given.split_at(times(first, 2).min(given.len()));
        let roots = Roots::union(&[roots_of(one)?, roots_of(two)?])?;
        kernel.output.clear();
        push_roots(&mut kernel.output, &roots);
        Ok(kernel.output.len())
    })
}
