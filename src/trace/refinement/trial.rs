//! What is tried on an outline, and what has to hold for it to stay.

use super::field::Field;
use super::left::Left;
use super::refine::{Refiner, Shape};
use crate::trace::quality::Quality;

/// What changes an outline on trial, and what has to hold afterwards.
pub(super) struct Trial<'a> {
    pub(super) refiner: &'a mut Refiner,
    pub(super) field: &'a mut Field,
    pub(super) shape: &'a mut Shape,
    pub(super) limits: &'a Limits,
}

/// What a merged piece may leave of the picture.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    /// The root mean square of coverage that is always allowed.
    pub(super) rms: f64,
    /// The largest difference of coverage in a pixel that is always allowed.
    pub(super) most: f64,
    /// The largest distance of a merged piece from the two, before it is refined: root mean square, in pixels.
    pub(super) off: f64,
    /// The noise of one pixel; 0 for a clean picture.
    pub(super) noise: f64,
    /// How much the sum of squares may grow, in squares of the noise.
    pub(super) share: f64,
    /// What pixels in a row may all be wrong by where few samples or compression made them.
    pub(super) grain: f64,
}

impl Limits {
    /// What is allowed before it is known what no outline explains.
    pub(super) fn of(quality: Quality) -> Self {
        Self {
            rms: 0.012,
            most: 0.055,
            off: if quality == Quality::Clean { 0.25 } else { 0.4 },
            noise: 0.0,
            share: if quality == Quality::Sampled { 24.0 } else { 12.0 },
            grain: 0.0,
        }
    }

    /// Whether what was put in the place of something explains the picture as well, or well enough. `ease` makes more
    /// enough.
    pub(super) fn allow(&self, now: &Left, before: &Left, ease: f64) -> bool {
        now.square <= before.square + self.share * self.noise * self.noise
            || now.rms() <= ease * self.rms && now.most <= ease * self.most
    }
}
