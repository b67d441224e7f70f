//! A polyline near a curve.
//!
//! A chord of parameter width h is κ·ds²/8 away from a short arc, so points that are evenly spread over
//! ∫√(|r′ × r″|/|r′|) dy make equal errors: as few as can be. Then every chord is proved, whatever was assumed before.

use super::chords::mend;
use super::cubic_chords::{Cutter, GROUP};
use super::spreading::{equal_parts, part_count, spread};
use super::tolerance::{beyond, check_tolerance, least_tolerance};
use crate::curve::piece::{Piece, cubic_middle};
use crate::curve::pieces::{Pieces, hermite, in_space, space_piece, space_start};
use crate::error::Result;
use crate::limits::{MOST_OUTPUT_POINTS, filled, with_room};
use crate::numerics::Point;
use crate::numerics::plane::{cross, norm};

/// Where the density is looked at on a segment.
const CELLS: usize = 11;
/// A long hyperbolic segment bends within so many widths of its layers at both ends.
const LAYERS: [f64; 12] = [0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 9.0, 13.0, 18.0, 25.0, 40.0];
/// Cells of such a segment, and their edges.
const MOST_CELLS: usize = 2 * LAYERS.len() + 1;

pub(crate) fn flatten(curve: &dyn Pieces, tolerance: f64) -> Result<(Vec<f64>, f64)> {
    check_tolerance(tolerance)?;
    let tolerance = least_tolerance(curve, tolerance);
    if in_space(curve) {
        return flatten_in_space(curve, tolerance);
    }
    let pieces = curve.piece_count();
    let mut out = with_room(16 * pieces)?;
    let mut deviation = 0.0;
    let mut cutter = Cutter::new();
    let mut i = 0;
    while i < pieces {
        let cubics = take_cubics(curve, i, &mut cutter);
        for lane in 0..cubics.max(1) {
            let cubic = if lane < cubics { cutter.cut(lane, tolerance, &mut out)? } else { None };
            let bound = match cubic {
                Some(bound) => bound,
                None => cut_any(&curve.piece(i + lane), curve.start(i + lane), tolerance, &mut out)?,
            };
            deviation = if bound > deviation { bound } else { deviation };
        }
        i += cubics.max(1);
    }
    if !curve.closed() {
        out.push(curve.start(pieces).into());
    }
    Ok((out.into_flattened(), deviation))
}

/// A chord of width h is at most h²/8·max|r″| away.
fn flatten_in_space(curve: &dyn Pieces, tolerance: f64) -> Result<(Vec<f64>, f64)> {
    let (mut out, mut deviation) = (Vec::new(), 0.0_f64);
    for i in 0..curve.piece_count() {
        let piece = space_piece(curve, i);
        let bound = 0.125 * piece.bend();
        let count = equal_parts(bound, tolerance, 2);
        let needed = (out.len() / 3) as f64 + count;
        if needed > MOST_OUTPUT_POINTS as f64 {
            return Err(beyond(needed as usize));
        }
        deviation = deviation.max(bound / (count * count));
        out.extend(space_start(curve, i)?);
        for k in 1..count as usize {
            out.extend(piece.position(k as f64 / count - 0.5));
        }
    }
    if !curve.closed() {
        out.extend(space_start(curve, curve.piece_count())?);
    }
    Ok((out, deviation))
}

/// Takes in the cubics from piece i on, up to a group; returns how many. Curves of other kinds, whose pieces are
/// made in any case, go without, and so does their module.
fn take_cubics(curve: &dyn Pieces, i: usize, cutter: &mut Cutter) -> usize {
    let Some(own) = hermite(curve) else { return 0 };
    let most = GROUP.min(own.segment_count() - i);
    let mut count = 0;
    while count < most {
        let segment = own.nth_segment(i + count);
        let Some(middle) = cubic_middle(&segment) else { break };
        cutter.take(count, &middle, segment.start);
        count += 1;
    }
    if count > 0 {
        cutter.look(count);
    }
    count
}

/// Appends the start of a piece of any kind and the points between its ends; returns the bound of the distance.
#[inline(never)]
fn cut_any(piece: &Piece, start: Point, tolerance: f64, out: &mut Vec<[f64; 2]>) -> Result<f64> {
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

/// The edges of a cubic's cells.
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
