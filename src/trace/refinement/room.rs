//! Whether there is memory for what is done with an outline next: its many lists grow in passing, and none of them can
//! fail.

use super::coverage::Part;
use super::field::{Change, Field, SIDE};
use super::{Phase, Refinement};
use crate::error::Result;
use crate::limits::probe;
use crate::trace::outline::Outline;

/// What any outline takes: a few pieces, their parts, tiles on trial and systems of equations.
const LEAST: usize = 1 << 20;
/// Parts that are written anew while others are there, and tiles that are noted with them.
const MOST_PARTS: usize = 1 << 16;

impl Refinement {
    /// Finds whether there is room for the outline that is next in the phase.
    ///
    /// # Errors
    ///
    /// `OutOfMemory`.
    pub(super) fn make_sure(&mut self) -> Result<()> {
        if self.sure == Some(self.completed()) {
            return Ok(());
        }
        self.sure = Some(self.completed());
        let outline = &self.shapes[self.place.at].outline;
        let long = ways(outline) as usize;
        let all = if self.place.phase == Phase::Show { shown(long, &self.field) } else { 0 };
        let trials = 2 * size_of::<Part>() * long.min(MOST_PARTS);
        probe(LEAST + all + trials + 4 * outline.bytes())
    }
}

/// What parts of so long an outline take, and the tiles that they change.
fn shown(long: usize, field: &Field) -> usize {
    let tiles = (long / SIDE + SIDE).min(field.tiles());
    size_of::<Part>() * (long + long / 4) + size_of::<Change>() * tiles
}

/// How many borders of pixels an outline crosses, at most.
fn ways(outline: &Outline) -> f64 {
    (0..outline.len()).map(|i| outline.cubic(i).taxi_length()).sum()
}
