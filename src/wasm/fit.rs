//! Fits under way: opened from a run of numbers, asked, taken further in steps, described, closed.
//!
//! A fit is known by a number, as long as the instance lives. The face keeps the points and opens a fit again in the
//! next instance when this one dies.

use super::describe::{describe, pairs};
use super::kernel::{Kernel, run, times};
use super::numbers::Numbers;
use super::sections::{place, section};
use crate::curve::HermiteCurve;
use crate::fit::{Ask, Finish, Fit, FitStatus, Fitter, Norm, Options};
use crate::{Error, Result};
use wasm_bindgen::prelude::wasm_bindgen;

/// What comes after the convex problem, by the bits of `finish`; the last one is no part of it.
const STEPS: [&str; 6] = ["extreme", "merge", "slide", "debias", "prune", "search"];

/// Numbers of the record of options that comes before the points.
const OPTIONS: usize = 18;

const NOT_OPEN: Error = Error::Degenerate { argument: "fit", index: None, reason: "it is not open" };

/// The fit of a number.
fn fitter(kernel: &mut Kernel, number: u32) -> Result<&mut Fitter> {
    match kernel.fits.get_mut(number as usize) {
        Some(Some(fitter)) => Ok(fitter),
        _ => Err(Box::new(NOT_OPEN)),
    }
}

/// Opens a fit of what lies in the first `count` numbers of the input, and returns its number.
///
/// Input: number of points, of degrees, two degrees, steps of the grid, norm, closed, corners, robust, finish, gap,
/// iterations, mix, period, noise, parameters, weights, the least turn of a corner; then points, parameters, weights.
/// Negative stands for the default.
#[wasm_bindgen]
pub fn fit_open(count: u32) -> i32 {
    run(&mut |kernel| {
        let mut numbers = Numbers(kernel.given(count as usize));
        let mut head = Numbers(numbers.take(OPTIONS));
        let (points, degrees) = (head.count(), head.count());
        let both = [head.count(), head.count()];
        let mut options = Options {
            degrees: both[..degrees.min(2)].to_vec(),
            grid_size: head.optional().map(|size| size as usize),
            norm: if head.flag() { Norm::L1 } else { Norm::L2 },
            closed: Some(head.flag()),
            corners: head.flag(),
            robust: head.flag(),
            ..Options::default()
        };
        let finish = head.count();
        let step = |bit: usize| finish & bit != 0;
        options.finish =
            Finish { extreme: step(1), merge: step(2), slide: step(4), debias: step(8), prune: step(16) };
        options.gap = head.optional().unwrap_or(options.gap);
        options.most_iterations = head.optional().map(|most| most as usize);
        options.mix = head.optional().unwrap_or(options.mix);
        options.period = head.optional();
        options.noise = head.optional();
        let (parameters, weights) = (head.count(), head.count());
        options.least_turn = head.optional().unwrap_or(0.0);
        let points = pairs(numbers.take(times(points as u32, 2)));
        options.parameters = numbers.take(parameters).to_vec();
        options.weights = numbers.take(weights).to_vec();
        let fitter = Fitter::new(&points, &options)?;
        Ok(place(&mut kernel.fits, Box::new(fitter)))
    })
}

/// Leaves the noise of a fit's points in the record, as given or as found.
#[wasm_bindgen]
pub fn fit_noise(number: u32) -> i32 {
    run(&mut |kernel| {
        let noise = fitter(kernel, number)?.noise();
        kernel.record([noise, 0.0]);
        Ok(0)
    })
}

/// Starts a run: 0 as much as the noise allows, 1 by λ, 2 by the smoothing, 3 by a tolerance.
#[wasm_bindgen]
pub fn fit_ask(number: u32, kind: u32, first: f64, second: f64, degrees: u32) -> i32 {
    run(&mut |kernel| {
        fitter(kernel, number)?.ask(match kind {
            1 => Ask::Lambda([first, second][..(degrees as usize).min(2)].to_vec()),
            2 => Ask::Smoothing(first),
            3 => Ask::Tolerance(first),
            _ => Ask::Noise,
        })?;
        Ok(0)
    })
}

/// A gap that is certified: 1, the gap to nothing at all, where no better one is known.
fn certified(gap: f64) -> f64 {
    if gap.is_finite() { gap.clamp(0.0, 1.0) } else { 1.0 }
}

/// Takes the run further by about `budget` microseconds; 1 when it has ended. Iterations and gap are left in the
/// record.
#[wasm_bindgen]
pub fn fit_step(number: u32, budget: f64) -> i32 {
    run(&mut |kernel| {
        let progress = fitter(kernel, number)?.step(budget)?;
        kernel.record([progress.iteration as f64, certified(progress.gap)]);
        Ok(usize::from(progress.done))
    })
}

fn status(status: FitStatus) -> f64 {
    match status {
        FitStatus::Converged => 0.0,
        FitStatus::MostIterations => 1.0,
        FitStatus::Stalled | FitStatus::Running => 2.0,
    }
}

/// A fit in sections, each with its length in front.
fn written(fit: &Fit) -> Vec<f64> {
    let finite = |value: f64, otherwise: f64| if value.is_finite() { value } else { otherwise };
    let output = &mut Vec::new();
    section(output, &mut |to| {
        to.extend_from_slice(&[
            fit.parts.len() as f64,
            finite(fit.objective, fit.data_term),
            fit.data_term,
            finite(fit.regularizer, 0.0),
            certified(fit.gap),
            fit.qfe,
            fit.max_error,
            fit.rms,
            fit.iterations as f64,
            status(fit.status),
            fit.smoothing.unwrap_or(-1.0),
            fit.noise,
            fit.deviation,
        ]);
    });
    section(output, &mut |to| to.extend_from_slice(&fit.lambda));
    let curve = |output: &mut Vec<f64>, curve: &HermiteCurve| section(output, &mut |to| describe(to, curve));
    curve(output, &fit.curve);
    for part in &fit.parts {
        curve(output, &part.curve);
        section(output, &mut |to| to.extend(part.coefficients.iter().flat_map(|c| [c.x, c.y])));
    }
    section(output, &mut |to| {
        for knot in &fit.knots {
            to.extend_from_slice(&[
                knot.t,
                knot.point.x,
                knot.point.y,
                knot.degree as f64,
                knot.jump.x,
                knot.jump.y,
            ]);
        }
    });
    section(output, &mut |to| to.extend_from_slice(&fit.parameters));
    section(output, &mut |to| to.extend(fit.outliers.iter().map(|&i| i as f64)));
    section(output, &mut |to| {
        for change in &fit.changes {
            let step = STEPS.iter().position(|&step| step == change.step).unwrap_or(STEPS.len());
            let (before, after) = change.knots;
            let knots = [step, before, after].map(|n| n as f64);
            to.extend_from_slice(&knots);
            to.extend_from_slice(&[change.qfe.0, change.qfe.1, change.gap.unwrap_or(-1.0)]);
        }
    });
    core::mem::take(output)
}

/// Leaves the best curve of the run so far in the output: sections, each with its length in front.
#[wasm_bindgen]
pub fn fit_describe(number: u32) -> i32 {
    run(&mut |kernel| {
        let fit = fitter(kernel, number)?.fit()?;
        Ok(kernel.give(written(&fit)))
    })
}

/// Gives the memory of a fit back.
#[wasm_bindgen]
pub fn fit_close(number: u32) -> i32 {
    run(&mut |kernel| {
        if let Some(place) = kernel.fits.get_mut(number as usize) {
            *place = None;
        }
        Ok(0)
    })
}
