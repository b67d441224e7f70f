//! Curves in and out of the slots, and the ways to make one curve from another.
//!
//! A curve crosses as one run of numbers: seven of [`describe`](super::describe::describe)'s header, then its arrays.

use super::describe::{SPACES, pairs, push_short};
use super::kernel::{AnyCurve, run, times};
use super::numbers::take;
use crate::curve::HermiteOptions;
use crate::limits::filled;
use crate::numerics::{Point, Vector};
use crate::{HermiteCurve, Result, Space};
use wasm_bindgen::prelude::wasm_bindgen;

/// The space that a number from JavaScript stands for.
pub(super) fn space_of(code: u32) -> Option<Space> {
    SPACES.get(code as usize).copied()
}

/// Makes the curve whose arrays lie in the input resident.
///
/// Input: points, as many tangents, tangentsIn (as many or none; two numbers each), omega, lengths. Leaves the end of
/// the domain in the record and ω in the output: one number where all segments have the same, else one for each.
#[wasm_bindgen]
pub fn load(slot: u32, points: u32, arriving: u32, omega: u32, lengths: u32, space: u32, closed: u32) -> i32 {
    run(&mut |kernel| {
        let counts = [points, points, arriving].map(|count| times(count, 2));
        let (omega, lengths) = (omega as usize, lengths as usize);
        let mut rest = kernel.given(usize::MAX);
        let [points, tangents, tangents_in] = counts.map(|count| pairs(take(&mut rest, count)));
        let omega = take(&mut rest, omega).to_vec();
        let lengths = take(&mut rest, lengths);
        let closed = closed != 0;
        // One length stands for all of them, as in `describe`; a caller's own array was counted by the face.
        let segments = points.len().saturating_sub(usize::from(!closed));
        let lengths = if let [length] = *lengths { filled(length, segments)? } else { lengths.to_vec() };
        let options =
            HermiteOptions { points, tangents, tangents_in, closed, space: space_of(space), omega, lengths };
        let curve = HermiteCurve::new(options)?;
        kernel.record([curve.domain().1]);
        kernel.output.clear();
        push_short(&mut kernel.output, curve.omega(), None);
        kernel.keep(slot, AnyCurve::Hermite(curve));
        Ok(kernel.output.len())
    })
}

/// Leaves the curve that is made from the one in a slot in the output.
fn derive(slot: u32, make: &dyn Fn(&HermiteCurve) -> Result<HermiteCurve>) -> i32 {
    run(&mut |kernel| {
        let curve = make(kernel.curve(slot)?)?;
        Ok(kernel.give_curves(&[curve]))
    })
}

/// The same curve with `arity` segments in place of each.
#[wasm_bindgen]
pub fn refine(slot: u32, arity: u32) -> i32 {
    derive(slot, &|curve| curve.refine(arity as usize))
}

/// The same curve with one more point.
#[wasm_bindgen]
pub fn insert(slot: u32, t: f64) -> i32 {
    derive(slot, &|curve| curve.insert(t))
}

/// The curve without point i; the deviation is left in the record.
#[wasm_bindgen]
pub fn remove(slot: u32, i: u32) -> i32 {
    run(&mut |kernel| {
        let (curve, deviation) = kernel.curve(slot)?.remove(i as usize)?;
        kernel.record([deviation]);
        Ok(kernel.give_curves(&[curve]))
    })
}

/// The two parts of an open curve, or the closed curve opened at t.
#[wasm_bindgen]
pub fn split(slot: u32, t: f64) -> i32 {
    run(&mut |kernel| {
        let parts = kernel.curve(slot)?.split(t)?;
        Ok(kernel.give_curves(&parts))
    })
}

/// The part of the curve from t0 to t1.
#[wasm_bindgen]
pub fn trim(slot: u32, t0: f64, t1: f64) -> i32 {
    derive(slot, &|curve| curve.trim(t0, t1))
}

/// The same curve run backwards.
#[wasm_bindgen]
pub fn reverse(slot: u32) -> i32 {
    derive(slot, &HermiteCurve::backwards)
}

/// A whole ellipse.
#[wasm_bindgen]
pub fn ellipse(x: f64, y: f64, rx: f64, ry: f64, rotation: f64, count: u32) -> i32 {
    run(&mut |kernel| {
        let curve = HermiteCurve::ellipse(Point::new(x, y), Vector::new(rx, ry), rotation, count as usize)?;
        Ok(kernel.give_curves(&[curve]))
    })
}

/// An open arc of an ellipse.
#[wasm_bindgen]
pub fn arc(x: f64, y: f64, rx: f64, ry: f64, rotation: f64, start: f64, sweep: f64) -> i32 {
    run(&mut |kernel| {
        let curve = HermiteCurve::arc(Point::new(x, y), Vector::new(rx, ry), rotation, start, sweep)?;
        Ok(kernel.give_curves(&[curve]))
    })
}

/// The smooth curve through the `count` points in the input; a negative `omega` stands for the default.
#[wasm_bindgen]
pub fn through(count: u32, closed: u32, omega: f64, space: u32) -> i32 {
    run(&mut |kernel| {
        let points = pairs(kernel.given(times(count, 2)));
        let omega = (omega >= 0.0).then_some(omega);
        let space = space_of(space).unwrap_or(Space::Trigonometric);
        let curve = HermiteCurve::through(points, closed != 0, omega, space)?;
        Ok(kernel.give_curves(&[curve]))
    })
}
