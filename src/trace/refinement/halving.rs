//! Pieces of an outline that say too little of the picture are cut in two.

use super::left::Left;
use super::refine::Shape;
use super::{Field, Phase, Refinement};
use crate::error::Result;
use crate::trace::outline::ellipse::ellipse;

/// How often pieces are halved; in a compressed picture once.
const HALVINGS: usize = 2;
/// By how many of its standard deviations a sum of squares is above what noise makes it where something is missing.
const SURELY: f64 = 2.0;
/// Pixels that a piece crosses at least to be halved.
const PIXELS: f64 = 8.0;

impl Refinement {
    /// Halves pieces that explain the picture worse than joints are taken away for, or than noise; whether there were
    /// any.
    pub(super) fn is_halved(&mut self) -> Result<bool> {
        let shape = &mut self.shapes[self.place.at];
        let most = match self.place.phase {
            Phase::Rough => usize::from(self.field.is_compressed()),
            _ if !self.picture.is_clean() => 0,
            _ => HALVINGS,
        };
        if self.place.halvings == most {
            return Ok(false);
        }
        // A circle that was not drawn by exact coverage is still a circle.
        if self.place.halvings == 0 && ellipse(&shape.outline, self.picture.slack)?.is_some() {
            return Ok(false);
        }
        let (limits, noise) = (&self.limits, self.fine.left.rms());
        let is_much = |left: &Left| {
            if self.picture.is_rough() {
                // More than noise of that deviation leaves (D 14.26).
                left.square > noise * noise * (left.count + SURELY * (2.0 * left.count).sqrt())
            } else {
                left.rms() > 1.5 * limits.rms || left.most > 2.0 * limits.most
            }
        };
        let far = far(shape, &self.field, is_much);
        let any = far.contains(&true);
        if any {
            let halved = shape.outline.halved(&far);
            self.exchange(halved);
            self.place.halvings += 1;
        }
        Ok(any)
    }
}

/// Which curved pieces leave what is too much.
fn far(shape: &Shape, field: &Field, is_much: impl Fn(&Left) -> bool) -> Vec<bool> {
    let is_far = |i: usize| {
        let mut left = Left::default();
        left.add(&shape.parts[i], field);
        !shape.outline.is_line(i) && left.count > PIXELS && is_much(&left)
    };
    (0..shape.outline.len()).map(is_far).collect()
}
