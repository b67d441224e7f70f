//! Pictures under way: opened, filled row by row, traced in steps, described, closed.
//!
//! A picture is known by a number, as long as the instance lives. Its pixels come in blocks of rows through the text buffer, so that
//! the memory never holds all of their colours.

use super::describe::describe;
use super::kernel::{Kernel, run};
use super::record::{Numbers, place, section};
use crate::trace::{Gray, GrayRows, Model, Source, Stage, Trace, TraceOptions, Tracer};
use crate::{Error, Result};
use wasm_bindgen::prelude::wasm_bindgen;

/// Numbers of the record of options.
const OPTIONS: usize = 13;

const NOT_OPEN: Error = Error::Degenerate { argument: "image", index: None, reason: "it is not open" };

/// The stages in the face's order; it counts the reading of pixels as 0.
const STAGES: [Stage; 5] = [Stage::Edges, Stage::Contours, Stage::Corners, Stage::Splines, Stage::Refinement];

/// A picture and how far it is.
pub(super) struct Job {
    channels: usize,
    options: TraceOptions,
    state: State,
}

enum State {
    Filling(GrayRows),
    Tracing(Tracer),
    /// The rows could not be made a picture.
    Failed,
}

/// The picture of a number.
fn job(traces: &mut [Option<Box<Job>>], number: u32) -> Result<&mut Job> {
    match traces.get_mut(number as usize) {
        Some(Some(job)) => Ok(job),
        _ => Err(Box::new(NOT_OPEN)),
    }
}

/// Opens a picture that the first `count` numbers of the input tell of, and returns its number.
///
/// Input: width, height, bytes per pixel, source, model, threshold, blur, inverted, speckle, corner, tolerance, refined, most contours.
/// Negative stands for the default.
#[wasm_bindgen]
pub fn trace_open(count: u32) -> i32 {
    run(&mut |kernel| {
        let mut head = Numbers(kernel.given((count as usize).min(OPTIONS)));
        let [width, height, channels] = core::array::from_fn(|_| head.count());
        let mut options = TraceOptions {
            source: match head.count() {
                0 => Source::Brightness,
                1 => Source::Edges,
                _ => Source::Lines,
            },
            model: if head.flag() { Model::QuasiInterpolant } else { Model::Sparse },
            threshold: head.optional(),
            blur: head.optional(),
            inverted: head.flag(),
            ..TraceOptions::default()
        };
        options.speckle = head.optional().unwrap_or(options.speckle);
        options.corner = head.optional().unwrap_or(options.corner);
        options.tolerance = head.optional().unwrap_or(options.tolerance);
        options.refined = head.flag();
        options.most_contours = head.optional().map_or(options.most_contours, |most| most as usize);
        let state = State::Filling(Gray::begin(width, height)?);
        Ok(place(&mut kernel.traces, Box::new(Job { channels, options, state })))
    })
}

/// Takes the next rows: the first `bytes` bytes of the text buffer.
#[wasm_bindgen]
pub fn trace_rows(number: u32, bytes: u32) -> i32 {
    run(&mut |kernel| {
        let Kernel { traces, text, .. } = kernel;
        let rows = text.get(..bytes as usize).unwrap_or_default();
        let job = job(traces, number)?;
        match &mut job.state {
            State::Filling(picture) if job.channels == 4 => picture.push_rgba_rows(rows)?,
            State::Filling(picture) => picture.push_gray_rows(rows)?,
            _ => return Err(Box::new(NOT_OPEN)),
        }
        Ok(0)
    })
}

/// Takes the work further by about `budget` microseconds; 1 when it has ended. The record has the stage, how much of it is done, and
/// how much it has.
#[wasm_bindgen]
pub fn trace_step(number: u32, budget: f64) -> i32 {
    run(&mut |kernel| {
        let job = job(&mut kernel.traces, number)?;
        if let State::Filling(_) = job.state
            && let State::Filling(rows) = core::mem::replace(&mut job.state, State::Failed)
        {
            job.state = State::Tracing(Tracer::new(rows.finish()?, &job.options)?);
        }
        let State::Tracing(tracer) = &mut job.state else { return Err(Box::new(NOT_OPEN)) };
        let progress = tracer.step(budget)?;
        let stage = STAGES.iter().position(|&stage| stage == progress.stage).unwrap_or(0) + 1;
        kernel.record([stage as f64, progress.completed as f64, progress.total as f64]);
        Ok(usize::from(progress.done))
    })
}

/// A trace in sections, each with its length in front: numbers of the whole; then of each contour its curve, its numbers, its cusps.
fn written(trace: &Trace) -> Vec<f64> {
    let output = &mut Vec::new();
    section(output, &mut |to| to.push(trace.contours.len() as f64));
    for contour in &trace.contours {
        section(output, &mut |to| describe(to, &contour.curve));
        let metrics = contour.metrics;
        section(output, &mut |to| {
            to.extend([contour.closed, contour.hole].map(|flag| f64::from(u8::from(flag))));
            to.extend([metrics.rmse, metrics.mae, metrics.hausdorff, metrics.jaccard]);
        });
        section(output, &mut |to| to.extend(contour.cusps.iter().flat_map(|cusp| [cusp.x, cusp.y])));
    }
    core::mem::take(output)
}

/// Leaves what was found in the output: sections, each with its length in front.
#[wasm_bindgen]
pub fn trace_describe(number: u32) -> i32 {
    run(&mut |kernel| {
        let State::Tracing(tracer) = &job(&mut kernel.traces, number)?.state else {
            return Err(Box::new(NOT_OPEN));
        };
        let numbers = written(&tracer.result()?);
        Ok(kernel.give(numbers))
    })
}

/// Gives the memory of a picture back.
#[wasm_bindgen]
pub fn trace_close(number: u32) -> i32 {
    run(&mut |kernel| {
        if let Some(place) = kernel.traces.get_mut(number as usize) {
            *place = None;
        }
        Ok(0)
    })
}
