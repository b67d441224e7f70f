//! How exactly pixels say where edges are, as far as it is known by now, and what follows from that.

use super::refine::NOISY_SHARE;
use crate::numerics::plane::larger;
use crate::trace::quality::Quality;

/// How far pieces may be from an arc that they are, in pixels: in a picture of exact coverage, a compressed, a noisy
/// and one that samples and chords made.
const BOWS: [f64; 4] = [0.01, 0.05, 0.075, 0.15];
/// Outlines follow some of the grain, so that what is known of it is this share of what it is at most.
const KNOWN: f64 = 4.0;
/// What leaves so much of coverage, root mean square, explains nothing: outlines of two tones leave .1 at most where
/// they are a pixel and more from their contour.
const UNEXPLAINED: f64 = 0.1;
/// What leaves so much in many pixels explains nothing even near the contour.
const NOTHING: f64 = 0.15;
/// How many times as much as noise of one pixel it has to be.
const ABOVE_NOISE: f64 = 2.0;

/// What is known by now of how exactly the picture's pixels say where edges are.
#[derive(Debug)]
pub(super) struct Exactness {
    pub(super) quality: Quality,
    /// What no outline explains in a pixel of a rough picture.
    pub(super) grain: f64,
    /// How many times farther than in a picture of exact coverage an outline may be from an ellipse that it is.
    pub(super) slack: f64,
}

impl Exactness {
    pub(super) fn is_clean(&self) -> bool {
        matches!(self.quality, Quality::Clean | Quality::Soft)
    }

    pub(super) fn is_sampled(&self) -> bool {
        self.quality == Quality::Sampled
    }

    pub(super) fn is_rough(&self) -> bool {
        matches!(self.quality, Quality::Rough | Quality::Sampled)
    }

    pub(super) fn is_noisy(&self) -> bool {
        self.quality == Quality::Noisy
    }

    /// The most that the grain may be.
    pub(super) fn most_grain(&self) -> f64 {
        KNOWN * self.grain
    }

    /// What has to be left for nothing to be explained: far from the contour and near it.
    pub(super) fn nothing(&self, noise: f64) -> [f64; 2] {
        let near = if self.is_noisy() || self.is_sampled() { f64::INFINITY } else { NOTHING };
        [if self.is_sampled() { f64::INFINITY } else { larger(UNEXPLAINED, ABOVE_NOISE * noise) }, near]
    }

    /// Steps that stop where the picture says no more.
    pub(super) fn steps(&self, (most, enough): (usize, f64)) -> (usize, f64) {
        (most, if self.is_clean() { enough } else { NOISY_SHARE })
    }

    /// How far pieces may be from an arc that they are, in pixels: where programs drew chords, of which flat places are
    /// flat, farthest.
    pub(super) fn bow(&self, flat: bool) -> f64 {
        match self.quality {
            Quality::Clean => BOWS[0],
            Quality::Rough => BOWS[if flat { 3 } else { 1 }],
            Quality::Soft => BOWS[1],
            Quality::Noisy => BOWS[2],
            Quality::Sampled => BOWS[3],
        }
    }
}
