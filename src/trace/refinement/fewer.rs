//! An outline with fewer and fewer joints: what is done with one, bit by bit.

use super::field::Field;
use super::refine::{Refiner, Shape, leaves};
use super::settling::Settling;
use super::simplify::{Merging, may_go_on};
use super::tidying::Tidying;
use super::trial::Trial;
use super::{KNOWN, LAST_STEPS, Refinement};
use crate::error::Result;
use crate::numerics::plane::larger;
use crate::trace::outline::ellipse::{ellipse, rounded};

/// How far an outline in a rough picture may be from an ellipse that it is, in pixels, and how many times as much that may leave.
const NEARLY: f64 = 0.3;
const NEARLY_AS_WELL: f64 = 1.2;

impl Refinement {
    /// A bit of taking joints away, which costs in microseconds what it returns; nothing when the outline has as few as it may.
    pub(super) fn fewer(&mut self) -> Result<Option<f64>> {
        let trial = &mut Trial {
            refiner: &mut self.refiner,
            field: &mut self.field,
            shape: &mut self.shapes[self.at],
            limits: &self.limits,
        };
        if let Some(ending) = &mut self.ending {
            let cost = ending.step(trial)?;
            if cost.is_none() {
                self.keep()?;
                (self.ending, self.round, self.settling, self.straightening) = (None, 0, None, None);
            }
            return Ok(cost);
        }
        if let Some(settling) = self.settling.as_mut().filter(|settling| !settling.is_done()) {
            let pieces = trial.shape.outline.len() as f64;
            settling.step(trial)?;
            if settling.is_done() {
                self.tidying = Some(Tidying::last());
                // There may be more to take away now.
                self.round = 1;
            }
            return Ok(Some(100.0 + 0.1 * pieces));
        }
        if let Some(tidying) = &mut self.tidying {
            if let Some(cost) = tidying.step(trial)? {
                return Ok(Some(cost));
            }
            self.tidying = None;
            if self.round == 0 {
                self.start = Some((trial.shape.outline.clone(), trial.shape.left(trial.field).rms()));
            }
        }
        if self.block == 0 && self.merging.is_none() {
            if self.round == 0 && self.start.is_none() {
                if self.rough {
                    make_round(trial.refiner, trial.field, trial.shape, KNOWN * self.grain);
                }
                // Nothing is to be taken away from an ellipse.
                if ellipse(&trial.shape.outline, self.slack)?.is_some() {
                    return Ok(None);
                }
                self.tidying = Some(Tidying::first());
                return Ok(Some(1.0));
            }
            self.round += 1;
            self.merging = may_go_on(self.round).then(|| Merging::new(&trial.shape.outline, trial.limits));
        }
        if let Some(merging) = &mut self.merging {
            if merging.step(trial)? {
                return Ok(Some(100.0));
            }
            let any = merging.any;
            self.merging = None;
            if any {
                return Ok(Some(self.cost()));
            }
        }
        if self.settling.is_none() {
            self.settling = Some(Settling::new(&self.bends));
            return Ok(Some(1.0));
        }
        if self.limits.noise > 0.0 {
            let straightening = self.straightening.get_or_insert_default();
            if straightening.step(trial)? {
                return Ok(Some(100.0));
            }
        }
        if !self.last()? {
            return Ok(Some(self.cost()));
        }
        // Between pieces that are straight only now there may be arcs.
        self.ending = Some(Tidying::end());
        Ok(Some(1.0))
    }

    /// Cubics that hardly bend become lines, and a last refinement, of a long outline bit by bit; whether that was the last bit.
    fn last(&mut self) -> Result<bool> {
        let shape = &mut self.shapes[self.at];
        if !self.straightened {
            self.straightened = true;
            let mut straight = shape.outline.clone();
            straight.straighten();
            if straight != shape.outline {
                self.bent = Some((shape.outline.clone(), shape.left(&self.field)));
                self.refiner.replace(&mut self.field, shape, straight);
            }
        }
        if !self.refine_on(LAST_STEPS)? {
            return Ok(false);
        }
        let shape = &mut self.shapes[self.at];
        if let Some((bent, old)) = self.bent.take()
            && !self.limits.allow(&shape.left(&self.field), &old, 1.0)
        {
            // What turned with the straight pieces did not come back.
            self.refiner.replace(&mut self.field, shape, bent);
            return Ok(false);
        }
        self.straightened = false;
        Ok(true)
    }

    /// An outline that lost its way is as it was before joints were taken away.
    fn keep(&mut self) -> Result<()> {
        let Some((start, before)) = self.start.take() else { return Ok(()) };
        let steps = self.steps(LAST_STEPS);
        let (refiner, field, shape) = (&mut self.refiner, &mut self.field, &mut self.shapes[self.at]);
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
