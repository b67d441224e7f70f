//! Chords of a piece of any kind, and the proof that they are near it.
//!
//! The cubic with the ends and the end derivatives of a chord is near the chord by its control points, or where those
//! leave it (cusps, turns) by the distance at equal parameters, ¼·max|h·r′ − c|. A piece that is not a cubic differs
//! from that cubic by at most h⁴/384·max|r⁗|.

use super::spreading::{part_count, spread};
use super::tolerance::beyond;
use crate::curve::piece::{Jet, Piece};
use crate::error::Result;
use crate::limits::{MOST_OUTPUT_POINTS, filled};
use crate::numerics::plane::{cross, dot, square};
use crate::numerics::{Point, Vector};

/// Halvings of a chord after which it is taken as it is.
const MOST_HALVINGS: usize = 48;
/// How often the points of a piece are spread before single chords are halved.
const ATTEMPTS: usize = 4;
/// As how many chords at least, and at most, one counts that is only spread anew.
const LEAST: f64 = 1e-3;
const MOST: f64 = 4.0;

/// Chords of a piece that bends evenly whose errors say where the first points go.
const CELLS: usize = 7;
/// A long hyperbolic segment bends within so many widths of its layers at both ends.
const LAYERS: [f64; 12] = [0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 9.0, 13.0, 18.0, 25.0, 40.0];

/// Appends the start of a piece of any kind and the points between its ends; returns the bound of the distance.
///
/// The errors of a few chords are the density of the points, and the errors of the chords between these a better one;
/// if all attempts fail, chords that are not good are halved.
#[inline(never)]
pub(super) fn cut(piece: &Piece, start: Point, tolerance: f64, out: &mut Vec<[f64; 2]>) -> Result<f64> {
    out.push(start.into());
    let mut places = cells(piece);
    for attempt in 0..ATTEMPTS {
        let most = if attempt == 0 { f64::MAX } else { MOST };
        let (worst, before) = errors(piece, &places, tolerance, most);
        if worst <= tolerance && attempt > 0 {
            write(piece, &places, out);
            return Ok(worst);
        }
        // Evenly is never quite even: a little more makes the next attempt the last.
        let wanted = 1.02 * before[places.len() - 1];
        let all = wanted + out.len() as f64;
        if all > MOST_OUTPUT_POINTS as f64 {
            return Err(beyond(all as usize));
        }
        let count = part_count(wanted);
        let mut next = filled(0.5, count + 1)?;
        next[0] = -0.5;
        spread(&places, &before, &mut next[1..count]);
        places = next;
    }
    let mut worst: f64 = 0.0;
    for (k, pair) in places.windows(2).enumerate() {
        if k > 0 {
            out.push(piece.position(pair[0]).into());
        }
        worst = worst.max(halve(piece, pair[0], pair[1], tolerance, out)?);
    }
    Ok(worst)
}

/// The ends of the chords that are looked at first.
fn cells(piece: &Piece) -> Vec<f64> {
    let mut places = vec![-0.5];
    if piece.is_decaying() {
        let w = piece.rate().abs().sqrt();
        let inner = LAYERS.partition_point(|&depth| depth < 0.45 * w);
        places.extend(LAYERS[..inner].iter().map(|depth| depth / w - 0.5));
        places.extend(LAYERS[..inner].iter().rev().map(|depth| 0.5 - depth / w));
    } else {
        places.extend((1..CELLS).map(|k| k as f64 / CELLS as f64 - 0.5));
    }
    places.push(0.5);
    places
}

/// The largest bound of the chords between the places, and how many chords are wanted before each place.
fn errors(piece: &Piece, places: &[f64], tolerance: f64, most: f64) -> (f64, Vec<f64>) {
    let (mut worst, mut total) = (0.0_f64, 0.0);
    let mut before = vec![total];
    let mut start = piece.jet(places[0]);
    for pair in places.windows(2) {
        let end = piece.jet(pair[1]);
        let bound = bound(piece, &start, &end, pair[0], pair[1]);
        worst = worst.max(bound);
        total += (bound / tolerance).sqrt().max(LEAST).min(most);
        before.push(total);
        start = end;
    }
    (worst, before)
}

/// Appends the points between the ends.
#[inline(never)]
fn write(piece: &Piece, places: &[f64], out: &mut Vec<[f64; 2]>) {
    for &y in places.get(1..places.len() - 1).unwrap_or_default() {
        out.push(piece.position(y).into());
    }
}

/// The bound of the distance between a piece and its chord from lo to hi, by the jets there.
#[inline(never)]
fn bound(piece: &Piece, start: &Jet, end: &Jet, lo: f64, hi: f64) -> f64 {
    let h = hi - lo;
    let chord = end.position - start.position;
    squared_bound(chord, start.first * h, end.first * h).sqrt() + piece.cubic_gap(lo, hi)
}

/// The squared bound of the distance between a chord and the cubic with those ends and end derivatives.
#[inline]
fn squared_bound(chord: Vector, leaving: Vector, arriving: Vector) -> f64 {
    let length = square(chord);
    let (alpha, beta) = (cross(leaving, chord), -cross(arriving, chord));
    let (a, b) = (alpha.abs(), beta.abs());
    let even = 0.125 * (a + b) + (4.0 / 27.0 - 0.125) * (a - b).abs();
    let odd = (4.0 / 27.0) * if a > b { a } else { b };
    let off = if alpha * beta >= 0.0 { even } else { odd };
    let (first, last) = (dot(leaving, chord), dot(arriving, chord));
    let least = if first < last { first } else { last };
    let most = if first > last { first } else { last };
    let across = off * off / length;
    let (start, end) = (square(leaving - chord), square(arriving - chord));
    let parametric = 0.0625 * if start > end { start } else { end };
    // The order of the comparisons makes a chord of length 0, with its 0/0, fall back on the parameters.
    if least >= 0.0 && most <= 3.0 * length && across < parametric { across } else { parametric }
}

/// Halves a chord until its parts are good, writes the points between and returns the largest bound.
#[cold]
fn halve(piece: &Piece, lo: f64, hi: f64, tolerance: f64, out: &mut Vec<[f64; 2]>) -> Result<f64> {
    let mut stack = [(0.0, 0.0); MOST_HALVINGS];
    stack[0] = (lo, hi);
    let (mut open, mut worst) = (1, 0.0_f64);
    while open > 0 {
        open -= 1;
        let (from, to) = stack[open];
        let bound = bound(piece, &piece.jet(from), &piece.jet(to), from, to);
        let middle = 0.5 * (from + to);
        if bound > tolerance && open + 2 <= MOST_HALVINGS && middle > from && middle < to {
            stack[open] = (middle, to);
            stack[open + 1] = (from, middle);
            open += 2;
            continue;
        }
        worst = worst.max(bound);
        if to < hi {
            if out.len() >= MOST_OUTPUT_POINTS {
                return Err(beyond(out.len() + 1));
            }
            out.push(piece.position(to).into());
        }
    }
    Ok(worst)
}
