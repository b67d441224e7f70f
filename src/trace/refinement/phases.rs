//! What all outlines together say of the picture, and what is done with them next.

use super::{FineOutline, Phase, Refinement};
use crate::error::Result;
use crate::limits::with_room;
use crate::numerics::order::nth;
use crate::numerics::plane::{larger, smaller};
use crate::trace::quality::Quality;
use crate::trace::refinement::grain::{Grain, grain, middle};
use crate::trace::refinement::left::Left;
use crate::trace::refinement::refine::{Refiner, Relaxing};

/// The grain from which on pixels are not covered as exactly as bytes tell: edges that a few samples a pixel were drawn
/// by have 0.01 to 0.04. Where at least so many windows of pixels say so, less is enough: of 160 drawings of exact
/// coverage none of so many has more than 0.0053, and curves that are chords a quarter of a pixel off have 0.006 and
/// more.
const GRAINY: [f64; 2] = [8e-3, 5.5e-3];
const MANY: usize = 40;
/// Of fewer windows the lower quartile has to say at least so much of what the one in the middle says, or that nothing
/// is exact.
const ALIKE: f64 = 0.6;
/// And what is left from which on where edges are nearly level: four rows of samples a pixel leave 0.07 there.
const UNEVEN: f64 = 0.04;
/// Stretches that have to say so.
const ENOUGH: usize = 3;
/// How many times as much as fine outlines rough ones may leave for the rest to be none of the drawing, root mean
/// squares: where flat places are not flat, and where they are. There fine outlines follow the grain, which has the
/// period of their pieces, and chords. Last where they are of so few pixels a piece that these are no chords, but small
/// letters, of which rough outlines leave five times the grain: they may leave it so many times.
const ROUGHER: [f64; 3] = [1.25, 3.5, 1.2];
const GRAINS: f64 = 2.0;
/// How many times farther than in a picture of exact coverage a large outline may be from an ellipse that it is: what
/// draws by samples draws chords that are up to a third of a pixel off.
const FLATTENED: f64 = 7.5;
/// More than this no pixels in a row are wrong by, however large the grain is: the limits of what is straight.
const GRAINIEST: f64 = 0.05;

/// What is less than half of what bytes round is nothing.
const LITTLE: f32 = 1e-3;

/// The noise that outlines leave of pictures that say only which centres are inside (D 14.27).
const SAMPLED: f64 = 0.06;

impl Refinement {
    /// Goes on to the phase that follows from what is left.
    pub(super) fn next_phase(&mut self) {
        self.place.at = 0;
        self.place.phase = match self.place.phase {
            Phase::Show => Phase::First,
            Phase::First if self.picture.is_sampled() => {
                self.limits.noise = SAMPLED;
                Phase::Fewer
            }
            Phase::First if self.picture.quality == Quality::Clean => {
                self.expect_more();
                Phase::Again
            }
            Phase::First | Phase::Again => {
                self.judge();
                if self.picture.is_rough() {
                    self.fine.outlines.iter().for_each(|fine| self.fine.left.join(&fine.left));
                    Phase::Rough
                } else {
                    self.fine.outlines = Vec::new();
                    Phase::Fewer
                }
            }
            Phase::Rough => {
                self.choose();
                Phase::Fewer
            }
            Phase::Fewer | Phase::Done => Phase::Done,
        };
    }

    /// Finds from what all outlines leave how exact the picture is, and what that allows.
    fn judge(&mut self) {
        let Grain { middle: own, lower, windows } = grain(&self.shapes, &self.field);
        let mut levels: Vec<f64> =
            self.fine.outlines.iter().flat_map(|fine| fine.level.iter().copied()).collect();
        let level = middle(&mut levels);
        let uneven = levels.len() >= ENOUGH && level > UNEVEN;
        self.picture.grain = if uneven { larger(own, level) } else { own };
        // What a few windows leave may be what their corners lack; grain is in most of them.
        let alike = lower > smaller(ALIKE * own, GRAINY[0]);
        let seen = if windows >= MANY { own > GRAINY[1] } else { own > GRAINY[0] && alike };
        if self.picture.is_noisy() {
            self.limits.noise = self.field.left();
        } else if self.picture.is_clean() && (uneven || seen) {
            self.picture.quality = Quality::Rough;
            self.picture.slack = FLATTENED;
            self.refiner = Refiner::new(Relaxing::CAREFUL);
            self.limits.off *= 1.6;
        }
    }

    /// Takes fine outlines where rough ones explain much less; what is left then is the noise (D 14.26).
    fn choose(&mut self) {
        let grain = self.picture.most_grain();
        self.limits.grain = grain.min(GRAINIEST);
        let flat = self.is_grainy();
        for (shape, FineOutline { outline, left, .. }) in
            self.shapes.iter_mut().zip(core::mem::take(&mut self.fine.outlines))
        {
            let mut rough = shape.left(&self.field);
            let dense = rough.is_dense(&shape.outline);
            if rough.is_small() {
                // A small letter passes by what it lacks.
                rough = shape.left_with(&outline, &self.field);
            }
            let (times, enough) = match (flat, dense) {
                (true, true) => (ROUGHER[2], GRAINS * self.picture.grain),
                (true, false) => (ROUGHER[1], grain),
                _ => (ROUGHER[0], self.picture.grain),
            };
            if rough.rms() > larger(times * left.rms(), enough) {
                self.refiner.replace(&mut self.field, shape, outline);
            }
        }
        // What one outline follows is no reason to take the others for exact.
        let left = self.crossed().rms();
        if left > GRAINY[0] {
            self.limits.noise = left;
        }
    }

    /// What is left in no more pixels than a sixth of those that outlines cross, once all have moved to where the
    /// picture calls them: so many may be at the ends of strokes, which lack their corners still. It counts what is
    /// left between the sides of strokes, too.
    ///
    /// # Errors
    ///
    /// `OutOfMemory` only.
    pub(in crate::trace) fn settled(&self) -> Result<Option<f64>> {
        if self.place.phase <= Phase::First {
            return Ok(None);
        }
        let much = || self.field.rest.iter().filter(|rest| rest.abs() > LITTLE);
        let mut left = with_room(much().count())?;
        left.extend(much().map(|rest| f64::from(rest.abs())));
        let others = self.crossed().count as usize / 6;
        Ok(Some(if left.len() > others {
            let k = left.len() - 1 - others;
            nth(&mut left, k)
        } else {
            0.0
        }))
    }

    /// What is left in the pixels that outlines cross.
    pub(super) fn crossed(&self) -> Left {
        let mut left = Left::default();
        for (shape, _) in self.shapes.iter().zip(&self.still).filter(|(_, still)| !**still) {
            left.join(&shape.left(&self.field));
        }
        left
    }
}
