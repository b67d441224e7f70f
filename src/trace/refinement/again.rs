//! Outlines that explain little of the picture begin again, along their contours: corners that were seen where there
//! are none, or were not seen between strokes of a pixel, hold an outline where no step leads away from.

use super::grain::grain;
use super::{Begin, FineOutline, Other, Refinement};
use crate::error::Result;
use crate::numerics::plane::larger;
use crate::trace::outline::Outline;

/// What leaves so much of coverage, root mean square, and so many times as much as the grain, is worth another
/// beginning.
const POOR: f64 = 0.02;
const GRAINS: f64 = 1.5;
/// The second way is taken if it leaves so much of the squares at most.
const BETTER: f64 = 0.8;

/// An outline that has begun again.
#[derive(Debug)]
pub(super) struct Again {
    /// What it had come to.
    before: Outline,
    /// Where it begins now, and what it came to before pieces were halved.
    first: Outline,
    fine: Option<FineOutline>,
}

impl Refinement {
    /// Finds from what all outlines leave how much is too much. What a quarter of the windows leave less than is told
    /// by outlines that are where they belong.
    pub(super) fn expect_more(&mut self) {
        self.poor = larger(POOR, GRAINS * grain(&self.shapes, &self.field).lower);
    }

    /// A bit of the second way of a small outline, if there is to be one; whether that was the last.
    pub(super) fn again_on(&mut self, begin: &mut Begin) -> Result<bool> {
        let shape = &self.shapes[self.place.at];
        let Some(again) = &mut self.place.again else {
            if !shape.left(&self.field).is_small() {
                return Ok(true);
            }
            let Some(mut first) = begin(self.place.at, Other::Along)? else { return Ok(false) };
            first.cut_to(self.field.extent);
            // The edge of a pixel holds an outline that crosses none where the picture says anything: its contour does.
            if shape.left_with(&first, &self.field).rms() <= self.poor {
                return Ok(true);
            }
            let before = shape.outline.clone();
            self.place.again = Some(Again { before, first: first.clone(), fine: None });
            self.exchange(first);
            return Ok(false);
        };
        if self.place.refined && again.fine.is_none() {
            again.fine = Some(FineOutline::of(shape, &self.field));
        }
        let done = self.converge_on()?;
        if done && let Some(again) = self.place.again.take() {
            self.decide(again);
        }
        Ok(done)
    }

    /// Goes back to the first way, unless the second explains more in the pixels that either crosses.
    fn decide(&mut self, Again { before, first, fine }: Again) {
        let (at, field, refiner) = (self.place.at, &mut self.field, &mut self.refiner);
        let shape = &mut self.shapes[at];
        let second = shape.left_with(&before, field);
        let after = shape.outline.clone();
        refiner.replace(field, shape, before);
        if second.square < BETTER * shape.left_with(&after, field).square {
            refiner.replace(field, shape, after);
            self.first[at] = first;
            if let Some(fine) = fine {
                self.fine.outlines[at] = fine;
            }
        }
    }
}
