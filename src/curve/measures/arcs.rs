//! Arcs of a curve: the parts that are cut into chords, group by group.
//!
//! Densities of chords are taken to be linear in each of a few cells, which near an inflection is wrong by more the
//! more chords a cell has. So an arc of many chords is cut into shorter ones first, and so is one whose chords are not
//! near enough.

use super::arc_chords::{Arc, Chords, Densities, GROUP};
use super::spreading::part_count;
use super::tolerance::beyond;
use crate::curve::piece::Piece;
use crate::error::{Error, Result};
use crate::limits::MOST_OUTPUT_POINTS;
use crate::numerics::plane::larger;
use crate::numerics::{Point, Vector};

/// Chords of an arc that are spread at once.
const MOST_CHORDS: f64 = 40.0;
/// How often an arc is cut into arcs.
const MOST_CUTS: usize = 3;
/// Into how many arcs one is cut whose chords are not near enough.
const PARTS: usize = 4;
/// How often more chords are tried.
const ATTEMPTS: usize = 3;
/// What smooth densities may be off, and what those of an arc with an inflection.
const MARGINS: [f64; 2] = [1.01, 1.05];

/// A group before it is taken in; as a constant it is filled in at once, not arc by arc.
const NO_ARCS: [Arc; GROUP] = {
    let zero = Vector::new(0.0, 0.0);
    [Arc { middle: [zero; 4], rate: 0.0, start: zero }; GROUP]
};

/// Cuts arcs into chords, a group at a time.
pub(super) struct Cutter {
    tolerance: f64,
    /// The largest bound of the distance between a chord and the curve so far.
    pub(super) deviation: f64,
    /// How often the arcs can be cut into arcs.
    cuts: usize,
    count: usize,
    arcs: [Arc; GROUP],
    /// What lengths are in units of.
    sizes: [f64; GROUP],
    densities: Densities,
    chords: Chords,
}

impl Cutter {
    pub(super) fn new(tolerance: f64) -> Self {
        Self::with_cuts(tolerance, MOST_CUTS)
    }

    #[inline(never)]
    fn with_cuts(tolerance: f64, cuts: usize) -> Self {
        Self {
            tolerance,
            deviation: 0.0,
            cuts,
            count: 0,
            arcs: NO_ARCS,
            sizes: [0.0; GROUP],
            densities: Densities::new(),
            chords: Chords::new(),
        }
    }

    /// Takes the next arc of the curve; when there are enough, appends the start of each and the points between the
    /// ends.
    pub(super) fn push(&mut self, arc: &Arc, out: &mut Vec<[f64; 2]>) -> Result<()> {
        let lane = self.count;
        self.arcs[lane] = *arc;
        self.sizes[lane] = self.densities.take(lane, arc);
        self.count += 1;
        if self.count == GROUP { self.flush(out) } else { Ok(()) }
    }

    /// Takes the next piece of the curve as so many arcs of equal width.
    pub(super) fn push_parts(
        &mut self,
        piece: &Piece,
        start: Point,
        parts: usize,
        out: &mut Vec<[f64; 2]>,
    ) -> Result<()> {
        let width = 1.0 / parts as f64;
        let square = width * width;
        for k in 0..parts {
            let from = k as f64 * width - 0.5;
            let jet = piece.jet(from + 0.5 * width);
            let middle = [jet.position, jet.first * width, jet.second * square, jet.third * (square * width)];
            let start = if k == 0 { start } else { piece.position(from) };
            self.push(&Arc { middle, rate: piece.rate() * square, start }, out)?;
        }
        Ok(())
    }

    /// Cuts a piece of a kind that has no arcs.
    pub(super) fn cut_piece(&mut self, piece: &Piece, start: Point, out: &mut Vec<[f64; 2]>) -> Result<()> {
        self.flush(out)?;
        self.deviation = larger(self.deviation, super::chords::cut(piece, start, self.tolerance, out)?);
        Ok(())
    }

    /// Cuts the arcs that were taken.
    pub(super) fn flush(&mut self, out: &mut Vec<[f64; 2]>) -> Result<()> {
        self.densities.look(self.count);
        for lane in 0..self.count {
            self.deviation = larger(self.deviation, self.cut(lane, out)?);
        }
        self.count = 0;
        Ok(())
    }

    /// Cuts one of them; returns the bound of the distance.
    #[inline(never)]
    fn cut(&mut self, lane: usize, out: &mut Vec<[f64; 2]>) -> Result<f64> {
        let Self { ref densities, ref mut chords, tolerance, cuts, .. } = *self;
        let (arc, size) = (&self.arcs[lane], self.sizes[lane]);
        let margin = MARGINS[usize::from(densities.turns(lane))];
        let mut wanted = densities.total(lane) * margin * (size / (8.0 * tolerance)).sqrt();
        let written = out.len();
        let all = wanted + written as f64;
        if all > MOST_OUTPUT_POINTS as f64 {
            return Err(beyond(all as usize));
        }
        if wanted > MOST_CHORDS && cuts > 0 {
            return cut_finely(arc, tolerance, cuts, (wanted / MOST_CHORDS) as usize + 1, out);
        }
        for _ in 0..ATTEMPTS {
            let count = part_count(wanted);
            out.try_reserve(count).map_err(|_| Error::memory(16 * count))?;
            out.push(arc.start.into());
            let bound = f64::from(chords.run(arc, lane, densities, count, out)) * size;
            if bound <= tolerance {
                return Ok(bound);
            }
            out.truncate(written);
            // The bound goes with the square of the number; where it takes many more, chords of other lengths do with
            // fewer.
            let next = 1.005 * (count as f64) * (bound / tolerance).sqrt();
            if next > 1.02 * (count as f64) + 1.0 {
                break;
            }
            wanted = next;
        }
        if wanted > PARTS as f64 && cuts > 0 {
            return cut_finely(arc, tolerance, cuts, PARTS, out);
        }
        super::chords::cut(&Piece::about(arc.middle, arc.rate), arc.start, tolerance, out)
    }
}

/// Cuts an arc into arcs, and these into chords.
#[cold]
fn cut_finely(arc: &Arc, tolerance: f64, cuts: usize, parts: usize, out: &mut Vec<[f64; 2]>) -> Result<f64> {
    let mut finer = Cutter::with_cuts(tolerance, cuts - 1);
    finer.push_parts(&Piece::about(arc.middle, arc.rate), arc.start, parts, out)?;
    finer.flush(out)?;
    Ok(finer.deviation)
}
