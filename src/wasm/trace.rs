//! Pictures under way: opened, filled row by row, traced in steps, described, closed.
//!
//! A picture is known by a number, as long as the instance lives. Its pixels come in blocks of rows through the text
//! buffer, so that the memory never holds all of their colours.

use super::describe::describe;
use super::kernel::{Kernel, run};
use super::numbers::Numbers;
use super::picture::{Job, NOT_OPEN, State};
use super::sections::{place, section};
use crate::Result;
use crate::trace::{BlockScan, LightScan, Model, Source, Stage, Tint, TraceOptions, TracedContour};
use wasm_bindgen::prelude::wasm_bindgen;

/// Numbers of the record of options.
const OPTIONS: usize = 15;

/// The stages in the face's order; it counts the reading of pixels as 0.
const STAGES: [Stage; 5] = [Stage::Edges, Stage::Contours, Stage::Corners, Stage::Splines, Stage::Refinement];

/// What a step says of the work.
const GOES_ON: usize = 0;
const DONE: usize = 1;
/// The colours are known: the rows are wanted again.
const AGAIN: usize = 2;

/// The picture of a number.
fn job(traces: &mut [Option<Box<Job>>], number: u32) -> Result<&mut Job> {
    match traces.get_mut(number as usize) {
        Some(Some(job)) => Ok(job),
        _ => Err(Box::new(NOT_OPEN)),
    }
}

/// Opens a picture that the first `count` numbers of the input tell of, and returns its number.
///
/// Input: width, height, bytes per pixel, source, model, threshold, blur, inverted, speckle, corner, tolerance,
/// refined, most contours, most colours (0 for ink on paper), number of colours given; then those, three numbers each.
/// Negative stands for the default.
#[wasm_bindgen]
pub fn trace_open(count: u32) -> i32 {
    run(&mut |kernel| {
        let mut numbers = Numbers(kernel.given(count as usize));
        let mut head = Numbers(numbers.take(OPTIONS));
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
        options.speckle = head.optional();
        options.corner = head.optional().unwrap_or(options.corner);
        options.tolerance = head.optional().unwrap_or(options.tolerance);
        options.refined = head.flag();
        options.most_contours = head.optional().map_or(options.most_contours, |most| most as usize);
        let (most_colors, given) = (head.count(), head.count());
        let channels_of = |color: &[f64]| Tint::from([0, 1, 2].map(|k| color[k] as u8));
        let palette: Vec<Tint> = numbers.take(3 * given).chunks_exact(3).map(channels_of).collect();
        let (size, state, blocks, read) = ([width, height], State::Failed, None, [0; 2]);
        let mut scan = BlockScan::new(width);
        if most_colors + given == 0 {
            // A picture of ink looks for its squares itself.
            scan.end();
        }
        // Colours that are given are meant as they are.
        let light_scan = (most_colors > 0).then(|| LightScan::new(width, height)).transpose()?;
        let light = None;
        let mut job = Box::new(Job {
            size,
            channels,
            most_colors,
            palette,
            shares_hues: false,
            options,
            state,
            scan,
            blocks,
            light_scan,
            light,
            read,
        });
        job.begin()?;
        Ok(place(&mut kernel.traces, job))
    })
}

/// Takes the next rows: the first `bytes` bytes of the text buffer.
#[wasm_bindgen]
pub fn trace_rows(number: u32, bytes: u32) -> i32 {
    run(&mut |kernel| {
        let Kernel { traces, text, .. } = kernel;
        let rows = text.get_mut(..bytes as usize).unwrap_or_default();
        job(traces, number)?.push(rows)?;
        Ok(0)
    })
}

/// Makes the light of a picture even, once all rows are there; 1 if that changed it.
#[wasm_bindgen]
pub fn trace_even_light(number: u32) -> i32 {
    run(&mut |kernel| {
        let job = job(&mut kernel.traces, number)?;
        let State::Ink(rows) = core::mem::replace(&mut job.state, State::Failed) else {
            return Err(Box::new(NOT_OPEN));
        };
        let mut picture = rows.finish()?;
        let changed = picture.even_light()?;
        job.state = State::Shades(picture);
        Ok(usize::from(changed))
    })
}

/// Leaves some rows of such a picture in the text buffer, a byte for each pixel, and returns how many bytes that are.
#[wasm_bindgen]
pub fn trace_shades(number: u32, first: u32, count: u32) -> i32 {
    run(&mut |kernel| {
        let Kernel { traces, text, .. } = kernel;
        let State::Shades(picture) = &job(traces, number)?.state else {
            return Err(Box::new(NOT_OPEN));
        };
        text.clear();
        text.extend(picture.bytes(first as usize..(first + count) as usize));
        Ok(text.len())
    })
}

/// Takes the work further by about `budget` microseconds; 1 when it has ended, 2 when the rows are wanted again. The
/// record has the stage, how much of it is done, and how much it has.
#[wasm_bindgen]
pub fn trace_step(number: u32, budget: f64) -> i32 {
    run(&mut |kernel| {
        let job = job(&mut kernel.traces, number)?;
        if !matches!(job.state, State::Tracing(_) | State::Layers(_)) && job.filled()? {
            kernel.record([0.0; 3]);
            return Ok(AGAIN);
        }
        let (done, record) = match &mut job.state {
            State::Tracing(tracer) => {
                let progress = tracer.step(budget)?;
                let stage = STAGES.iter().position(|&stage| stage == progress.stage).unwrap_or(0) + 1;
                (progress.done, [stage, progress.completed, progress.total])
            }
            State::Layers(tracer) => {
                let done = tracer.step(budget)?;
                let (completed, total) = tracer.progress();
                (done, [STAGES.len() + 1, completed, total])
            }
            _ => return Err(Box::new(NOT_OPEN)),
        };
        kernel.record(record.map(|number| number as f64));
        Ok(if done { DONE } else { GOES_ON })
    })
}

/// After a step has failed for too many contours: the speckle that would leave as many as there may be, in the record;
/// 0 where none is known.
#[wasm_bindgen]
pub fn trace_offer(number: u32) -> i32 {
    run(&mut |kernel| {
        let offer = match &job(&mut kernel.traces, number)?.state {
            State::Tracing(tracer) => tracer.offer(),
            _ => None,
        };
        kernel.record([offer.unwrap_or(0.0)]);
        Ok(usize::from(offer.is_some()))
    })
}

/// Appends a contour of a layer in three sections: its curve, its numbers, its cusps.
fn contour(output: &mut Vec<f64>, contour: &TracedContour, layer: usize) {
    section(output, &mut |to| describe(to, &contour.curve));
    let metrics = contour.metrics;
    section(output, &mut |to| {
        to.extend([contour.closed, contour.hole].map(|flag| f64::from(u8::from(flag))));
        to.extend([metrics.rmse, metrics.mae, metrics.max, metrics.hausdorff, metrics.jaccard, layer as f64]);
    });
    section(output, &mut |to| to.extend(contour.cusps.iter().flat_map(|cusp| [cusp.x, cusp.y])));
}

/// Leaves what was found in the output: sections, each with its length in front. The first has the colours of the
/// layers, none where there is only ink; then come the contours.
#[wasm_bindgen]
pub fn trace_describe(number: u32) -> i32 {
    run(&mut |kernel| {
        let output = &mut Vec::new();
        match &job(&mut kernel.traces, number)?.state {
            State::Tracing(tracer) => {
                section(output, &mut |_| ());
                for found in &tracer.result()?.contours {
                    contour(output, found, 0);
                }
            }
            State::Layers(tracer) => {
                let layers = tracer.layers();
                section(output, &mut |to| {
                    to.extend(layers.iter().flat_map(|layer| layer.color.map(f64::from)))
                });
                for (i, layer) in layers.iter().enumerate() {
                    for found in &layer.contours {
                        contour(output, found, i);
                    }
                }
            }
            _ => return Err(Box::new(NOT_OPEN)),
        }
        let numbers = core::mem::take(output);
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
