//! What the outlines leave of the picture.

use super::coverage::Part;
use super::field::{BEYOND, Field};
use crate::numerics::plane::larger;
use crate::trace::outline::Outline;

/// Pixels that a letter on a screen crosses at most, and that each of its pieces does.
const SMALL: f64 = 256.0;
const DENSE: f64 = 12.0;

/// What is left of the picture in the pixels of some pieces.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Left {
    pub(super) square: f64,
    pub(super) count: f64,
    pub(super) most: f64,
}

impl Left {
    /// That of some pieces.
    pub(super) fn of(lists: &[Vec<Part>], field: &Field) -> Self {
        let mut left = Self::default();
        lists.iter().for_each(|parts| left.add(parts, field));
        left
    }

    #[inline(never)]
    pub(super) fn add(&mut self, parts: &[Part], field: &Field) {
        self.add_some(parts.iter(), field);
    }

    /// Only some parts.
    pub(super) fn add_some<'a>(&mut self, parts: impl Iterator<Item = &'a Part>, field: &Field) {
        let mut last = BEYOND;
        for part in parts {
            if part.pixel == last || part.pixel >= BEYOND {
                continue;
            }
            last = part.pixel;
            self.see(field.rest[last as usize]);
        }
    }

    pub(super) fn join(&mut self, other: &Self) {
        self.square += other.square;
        self.count += other.count;
        self.most = larger(self.most, other.most);
    }

    /// One pixel more.
    pub(super) fn see(&mut self, rest: f32) {
        let value = f64::from(rest).abs();
        self.square += value * value;
        self.count += 1.0;
        self.most = larger(self.most, value);
    }

    /// Whether an outline that leaves this crosses as few pixels as a letter on a screen.
    pub(super) fn is_small(&self) -> bool {
        self.count < SMALL
    }

    /// Whether it crosses few with each piece, too: then these are no chords.
    pub(super) fn is_dense(&self, outline: &Outline) -> bool {
        self.is_small() && self.count < DENSE * outline.len() as f64
    }

    pub(super) fn rms(&self) -> f64 {
        (self.square / self.count.max(1.0)).sqrt()
    }
}
