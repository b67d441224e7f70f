//! Path data in and out.

use super::kernel::run;
use crate::svg::{self, PrintOptions};
use wasm_bindgen::prelude::wasm_bindgen;

/// Reads the `bytes` bytes of path data in the text buffer and leaves the curves in the output.
///
/// The record says how far the text made sense: −1 for all of it, else the offset from which on nothing was used, the
/// offset of the character at fault, and the words of what was expected there.
#[wasm_bindgen]
pub fn parse_path(bytes: u32) -> i32 {
    run(&mut |kernel| {
        let text = kernel.text.get(..bytes as usize).unwrap_or_default();
        let parsed = svg::parse_bytes(text)?;
        kernel.record([-1.0]);
        if let Some(stop) = parsed.truncation {
            let words = stop.expected;
            let fields = [stop.offset, stop.found, words.as_ptr() as usize, words.len()];
            kernel.record(fields.map(|field| field as f64));
        }
        Ok(kernel.give_curves(&parsed.curves))
    })
}

/// Writes a curve as path data, into the text buffer; the deviation is left in the record.
///
/// A tolerance of 0 and negative decimals stand for the defaults; `flags` is 1 for arcs plus 2 for relative commands
/// plus 4 for text that is put behind that of the last call.
#[wasm_bindgen]
pub fn to_path(slot: u32, tolerance: f64, decimals: i32, flags: u32) -> i32 {
    run(&mut |kernel| {
        let mut options = PrintOptions::default();
        if tolerance != 0.0 {
            options.tolerance = tolerance;
        }
        options.decimals = u32::try_from(decimals).ok();
        options.arcs = flags & 1 != 0;
        options.relative = flags & 2 != 0;
        let mut pen = kernel.pen.filter(|_| flags & 4 != 0);
        let (text, deviation) = svg::print_hermite(kernel.curve(slot)?, &options, &mut pen)?;
        kernel.pen = pen;
        kernel.record([deviation]);
        kernel.text = text;
        Ok(kernel.text.len())
    })
}
