//! Where a curve ends whose ends were free. (D 13.16)

use super::breaks::Breaks;
use super::combine::{expressed, sum_on};
use super::free_knots::Located;
use super::space::Space;
use super::spline::Spline;
use crate::error::Result;

/// Pieces are not shorter than this part of the parameter's range.
const SHORTEST: f64 = 1e-11;

impl Spline {
    /// The same curve without what is beyond the feet of the points, and the points on it; nothing where both ends have
    /// feet. While parameters are free, ends may slip past the first and the last foot, and there nothing holds the
    /// curve. O(M + K·degree²).
    pub(in crate::fit) fn trimmed(&self, data: &Located) -> Result<Option<(Self, Located)>> {
        let breaks = &self.space.breaks;
        if breaks.closed {
            return Ok(None);
        }
        let mut located = data.copied()?;
        self.settle(data, &mut located.parameters);
        let feet = located.parameters.iter();
        let (from, to) = feet.fold((breaks.end, 0.0_f64), |(low, high), &t| (low.min(t), high.max(t)));
        let shortest = SHORTEST * breaks.end;
        if to - from < shortest || (from < shortest && breaks.end - to < shortest) {
            return Ok(None);
        }
        let space = Space::new(between(breaks, from, to, shortest));
        for (own, t) in located.parameters.iter_mut().zip(&data.parameters) {
            *own = (t - from).max(0.0).min(space.breaks.end);
        }
        let whole = core::slice::from_ref(self);
        let spline = expressed(space, &|middle, half| sum_on(whole, middle + from, half, breaks.end));
        Ok(Some((spline, located)))
    }
}

/// The breaks between two places, counted from the first one. Knots at the very ends would leave pieces of no length.
fn between(breaks: &Breaks, from: f64, to: f64, shortest: f64) -> Breaks {
    let start = breaks.at.partition_point(|&t| t < from + shortest);
    let end = breaks.at.partition_point(|&t| t <= to - shortest).max(start);
    let pieces = if breaks.straight.is_empty() { 0..0 } else { start..end + 1 };
    Breaks {
        at: breaks.at[start..end].iter().map(|t| t - from).collect(),
        multiplicity: breaks.multiplicity[start..end].to_vec(),
        straight: breaks.straight[pieces].to_vec(),
        end: to - from,
        ..*breaks
    }
}
