//! Chords of a piece of any kind, and the proof that they are near it.
//!
//! The cubic with the ends and the end derivatives of a chord is near the chord by its control points, or where those
//! leave it (cusps, turns) by the distance at equal parameters, ¼·max|h·r′ − c|. A piece that is not a cubic differs
//! from that cubic by at most h⁴/384·max|r⁗|.

use super::spreading::{part_count, spread};
use super::tolerance::beyond;
use crate::curve::piece::Piece;
use crate::error::Result;
use crate::limits::{MOST_OUTPUT_POINTS, filled};
use crate::numerics::plane::{cross, dot, norm, square};
use crate::numerics::{Point, Vector};

/// Halvings of a chord after which it is taken as it is.
const MOST_HALVINGS: usize = 48;
/// How often the points of a piece are spread anew before single chords are halved.
const ATTEMPTS: usize = 3;

/// Where the density is looked at on a segment.
const CELLS: usize = 11;
/// A long hyperbolic segment bends within so many widths of its layers at both ends.
const LAYERS: [f64; 12] = [0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 9.0, 13.0, 18.0, 25.0, 40.0];
/// Cells of such a segment, and their edges.
const MOST_CELLS: usize = 2 * LAYERS.len() + 1;

/// Appends the start of a piece of any kind and the points between its ends; returns the bound of the distance.
#[inline(never)]
pub(super) fn cut(piece: &Piece, start: Point, tolerance: f64, out: &mut Vec<[f64; 2]>) -> Result<f64> {
    let density = Density::new(piece, tolerance);
    let all = density.total + out.len() as f64;
    if all > MOST_OUTPUT_POINTS as f64 {
        return Err(beyond(all as usize));
    }
    let count = part_count(density.total * MARGIN);
    let mut places = filled(0.5, count + 1)?;
    places[0] = -0.5;
    density.spread(&mut places[1..count]);
    out.push(start.into());
    mend(piece, places, tolerance, out)
}

/// How many chords a piece wants, cell by cell; the density is linear in each.
struct Density {
    cells: usize,
    /// One more than there are cells.
    edges: [f64; MOST_CELLS + 1],
    /// Chords before each edge.
    before: [f64; MOST_CELLS + 1],
    /// By how much of their sum the densities at the ends of each cell differ.
    tilts: [f64; MOST_CELLS + 1],
    total: f64,
}

/// What densities may be off.
const MARGIN: f64 = 1.05;

/// The edges of the cells of pieces that bend evenly.
const EDGES: [f64; CELLS + 1] = {
    let mut edges = [0.5; CELLS + 1];
    let mut k = 0;
    while k < CELLS {
        edges[k] = k as f64 / CELLS as f64 - 0.5;
        k += 1;
    }
    edges
};

impl Density {
    #[inline]
    fn new(piece: &Piece, tolerance: f64) -> Self {
        let zeros = [0.0; MOST_CELLS + 1];
        let mut density = Self { cells: CELLS, edges: zeros, before: zeros, tilts: zeros, total: 0.0 };
        density.cells = edges(piece, &mut density.edges);
        let mut roots = [0.0; MOST_CELLS + 1];
        for (root, &edge) in roots.iter_mut().zip(&density.edges) {
            let jet = piece.jet(edge);
            let bend = cross(jet.first, jet.second).abs() / norm(jet.first).max(f64::MIN_POSITIVE);
            *root = (bend / (8.0 * tolerance)).sqrt();
        }
        density.sum(&roots);
        density
    }

    /// Sums densities that are given at the edges.
    fn sum(&mut self, roots: &[f64]) {
        let mut from = roots[0];
        for (k, &to) in roots[1..=self.cells].iter().enumerate() {
            let both = from + to + 1e-30;
            self.tilts[k] = (to - from) / both;
            self.total += 0.5 * both * (self.edges[k + 1] - self.edges[k]);
            self.before[k + 1] = self.total;
            from = to;
        }
    }

    /// Fills in the parameters of the points between the ends.
    #[inline]
    fn spread(&self, places: &mut [f64]) {
        let cells = self.cells;
        spread(&self.edges[..=cells], &self.before[..=cells], &self.tilts[..cells], places);
    }
}

/// The edges of the cells of a piece, and how many cells there are.
fn edges(piece: &Piece, edges: &mut [f64; MOST_CELLS + 1]) -> usize {
    if !piece.is_decaying() {
        edges[..=CELLS].copy_from_slice(&EDGES);
        return CELLS;
    }
    let w = piece.rate().abs().sqrt();
    let inner = LAYERS.iter().take_while(|&&depth| depth < 0.45 * w).count();
    edges[0] = -0.5;
    for k in 0..inner {
        edges[k + 1] = LAYERS[k] / w - 0.5;
        edges[2 * inner - k] = 0.5 - LAYERS[k] / w;
    }
    edges[2 * inner + 1] = 0.5;
    2 * inner + 1
}

/// Appends the points between the ends.
#[inline(never)]
fn write(piece: &Piece, places: &[f64], out: &mut Vec<[f64; 2]>) {
    for &y in places.get(1..places.len() - 1).unwrap_or_default() {
        out.push(piece.position(y).into());
    }
}

/// Spreads the points of a piece by the errors that were found, which are a better density than the one before; if all
/// attempts fail, chords that are not good are halved. Returns the largest bound.
fn mend(piece: &Piece, mut places: Vec<f64>, tolerance: f64, out: &mut Vec<[f64; 2]>) -> Result<f64> {
    for attempt in 0..=ATTEMPTS {
        let (mut worst, mut total) = (0.0_f64, 0.0);
        let mut before = vec![total];
        for pair in places.windows(2) {
            let bound = bound(piece, pair[0], pair[1]);
            worst = worst.max(bound);
            total += (bound / tolerance).sqrt().clamp(1e-3, 4.0);
            before.push(total);
        }
        if worst <= tolerance {
            write(piece, &places, out);
            return Ok(worst);
        }
        if attempt == ATTEMPTS {
            break;
        }
        // Evenly is never quite even: a little more makes the next attempt the last.
        let count = part_count(1.02 * total);
        if out.len() + count > MOST_OUTPUT_POINTS {
            return Err(beyond(out.len() + count));
        }
        let mut next = vec![0.5; count + 1];
        next[0] = -0.5;
        spread(&places, &before, &vec![0.0; places.len() - 1], &mut next[1..count]);
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

/// The bound of the distance between a piece and its chord.
#[inline(never)]
fn bound(piece: &Piece, lo: f64, hi: f64) -> f64 {
    let (start, end, h) = (piece.jet(lo), piece.jet(hi), hi - lo);
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
        let bound = bound(piece, from, to);
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
