//! An outline with fewer and fewer joints: what is done with one, bit by bit.

use super::field::Field;
use super::left::Left;
use super::refine::{Refiner, Shape, leaves};
use super::settling::Settling;
use super::simplify::{Merging, may_go_on};
use super::straight::Straightening;
use super::tidying::Tidying;
use super::trial::Trial;
use super::{LAST_STEPS, Refinement};
use crate::error::Result;
use crate::numerics::plane::larger;
use crate::trace::outline::Outline;
use crate::trace::outline::ellipse::{ellipse, rounded};

/// How far an outline in a rough picture may be from an ellipse that it is, in pixels, and how many times as much that
/// may leave.
const NEARLY: f64 = 0.3;
const NEARLY_AS_WELL: f64 = 1.2;

/// What an outline goes through while joints are taken from it.
#[derive(Debug, Default)]
pub(super) struct Thinning {
    /// The outline before joints were taken away, and what it left.
    start: Option<(Outline, f64)>,
    /// Rounds of merging that it has had, and the one that it is in.
    round: usize,
    merging: Option<Merging>,
    /// Its folds, tips and rounded corners.
    tidying: Option<Tidying>,
    /// Its bends, when all that may be merged is.
    settling: Option<Settling>,
    /// Its sides, where pixels do not tell a shallow curve from a line.
    straightening: Option<Straightening>,
    /// Whether cubics that hardly bend are lines by now, and what the outline was before and left.
    straightened: bool,
    bent: Option<(Outline, Left)>,
    /// Its rounded corners, at the end.
    ending: Option<Tidying>,
}

impl Thinning {
    /// Goes on with the bends, if that has begun and is not done; what it cost.
    fn settle(&mut self, trial: &mut Trial) -> Result<Option<f64>> {
        let Some(settling) = self.settling.as_mut().filter(|settling| !settling.is_done()) else {
            return Ok(None);
        };
        let pieces = trial.shape.outline.len() as f64;
        settling.step(trial)?;
        if settling.is_done() {
            self.tidying = Some(Tidying::last());
            // There may be more to take away now.
            self.round = 1;
        }
        Ok(Some(100.0 + 0.1 * pieces))
    }

    /// Goes on with folds, tips and rounded corners, if that has begun and is not done; what it cost.
    fn tidy(&mut self, trial: &mut Trial) -> Result<Option<f64>> {
        let Some(tidying) = &mut self.tidying else { return Ok(None) };
        let cost = tidying.step(trial)?;
        if cost.is_none() {
            self.tidying = None;
            if self.round == 0 {
                self.start = Some((trial.shape.outline.clone(), trial.shape.left(trial.field).rms()));
            }
        }
        Ok(cost)
    }

    /// Begins another round of merging, if there may be one.
    fn merge_again(&mut self, outline: &Outline) {
        self.round += 1;
        self.merging = may_go_on(self.round).then(|| Merging::new(outline));
    }

    /// Tries the next joint of this round; whether there may be more to take away.
    fn merge(&mut self, trial: &mut Trial) -> Result<bool> {
        let Some(merging) = &mut self.merging else { return Ok(false) };
        if merging.step(trial)? {
            return Ok(true);
        }
        let any = merging.any;
        self.merging = None;
        Ok(any)
    }
}

impl Refinement {
    /// A bit of taking joints away, which costs in microseconds what it returns; nothing when the outline has as few as
    /// it may.
    pub(super) fn fewer(&mut self) -> Result<Option<f64>> {
        let thinning = &mut self.thinning;
        let trial = &mut Trial {
            refiner: &mut self.refiner,
            field: &mut self.field,
            shape: &mut self.shapes[self.place.at],
            limits: &self.limits,
        };
        if let Some(ending) = &mut thinning.ending {
            let cost = ending.step(trial)?;
            if cost.is_none() {
                self.keep()?;
                self.thinning = Thinning::default();
            }
            return Ok(cost);
        }
        if let Some(cost) = thinning.settle(trial)? {
            return Ok(Some(cost));
        }
        if let Some(cost) = thinning.tidy(trial)? {
            return Ok(Some(cost));
        }
        let refining = self.place.block > 0 || self.place.descent.is_some() || thinning.bent.is_some();
        if !refining && thinning.merging.is_none() {
            if thinning.round == 0 && thinning.start.is_none() {
                if self.picture.is_rough() {
                    let known = if self.picture.is_sampled() {
                        trial.limits.noise
                    } else {
                        self.picture.most_grain()
                    };
                    make_round(trial.refiner, trial.field, trial.shape, known);
                }
                // Nothing is to be taken away from an ellipse.
                if ellipse(&trial.shape.outline, self.picture.slack)?.is_some() {
                    return Ok(None);
                }
                thinning.tidying = Some(Tidying::first());
                return Ok(Some(1.0));
            }
            thinning.merge_again(&trial.shape.outline);
        }
        if thinning.merge(trial)? {
            return Ok(Some(if thinning.merging.is_some() { 100.0 } else { self.cost() }));
        }
        if thinning.settling.is_none() {
            thinning.settling = Some(Settling::new(&self.bends));
            return Ok(Some(1.0));
        }
        if self.limits.noise > 0.0 && thinning.straightening.get_or_insert_default().step(trial)? {
            return Ok(Some(100.0));
        }
        if !self.last()? {
            return Ok(Some(self.cost()));
        }
        // Between pieces that are straight only now there may be arcs.
        self.thinning.ending = Some(Tidying::end());
        Ok(Some(1.0))
    }

    /// Cubics that hardly bend become lines, and a last refinement, of a long outline bit by bit; whether that was the
    /// last bit.
    fn last(&mut self) -> Result<bool> {
        let (shape, thinning) = (&mut self.shapes[self.place.at], &mut self.thinning);
        if !thinning.straightened {
            thinning.straightened = true;
            let mut straight = shape.outline.clone();
            straight.straighten();
            straight.cut_to(self.field.extent);
            if straight != shape.outline {
                thinning.bent = Some((shape.outline.clone(), shape.left(&self.field)));
                self.exchange(straight);
                return Ok(false);
            }
        }
        if !self.refine_on(LAST_STEPS)? {
            return Ok(false);
        }
        let shape = &mut self.shapes[self.place.at];
        if let Some((bent, old)) = self.thinning.bent.take()
            && !self.limits.allow(&shape.left(&self.field), &old, 1.0)
        {
            // What turned with the straight pieces did not come back.
            self.exchange(bent);
            return Ok(false);
        }
        self.thinning.straightened = false;
        Ok(true)
    }

    /// An outline that lost its way is as it was before joints were taken away.
    fn keep(&mut self) -> Result<()> {
        let Some((start, before)) = self.thinning.start.take() else { return Ok(()) };
        let steps = self.picture.steps(LAST_STEPS);
        let (refiner, field, shape) = (&mut self.refiner, &mut self.field, &mut self.shapes[self.place.at]);
        let lost = (0..shape.outline.len()).any(|i| leaves(&shape.outline.cubic(i), field));
        if lost || shape.left(field).rms() > (1.5 * before).max(2.0 * self.limits.rms) {
            refiner.replace(field, shape, start);
            let nodes = shape.nodes();
            refiner.refine(field, shape, &nodes, steps)?;
        }
        Ok(())
    }
}

/// Puts an ellipse in the place of an outline that is one as far as the picture tells.
fn make_round(refiner: &mut Refiner, field: &mut Field, shape: &mut Shape, enough: f64) {
    let Some(round) = rounded(&shape.outline, NEARLY) else { return };
    let (before, old) = (shape.left(field).rms(), shape.outline.clone());
    refiner.replace(field, shape, round);
    if shape.left(field).rms() > larger(NEARLY_AS_WELL * before, enough) {
        refiner.replace(field, shape, old);
    }
}
