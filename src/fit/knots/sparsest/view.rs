//! The points of a search, and what is looked at in their place while knots are looked for.

use crate::fit::knots::bins::{averages, followed};
use crate::fit::knots::breaks::Breaks;
use crate::fit::knots::free_knots::Located;

/// About so many averages of points are looked at at first; half as many points more are not averaged.
const SEEN: usize = 450;

/// All points, and the same or averages of them.
#[derive(Clone, Debug)]
pub(super) struct View {
    pub(super) full: Located,
    pub(super) seen: Located,
    /// About how many averages there are where points are many.
    pub(super) averages: usize,
}

impl View {
    /// Points to be averaged where they are many.
    pub(super) fn new(full: Located) -> Self {
        Self { seen: from_afar(&full, SEEN), full, averages: SEEN }
    }

    /// Points that are all looked at.
    pub(super) fn of_all(full: Located) -> Self {
        Self { seen: full.clone(), full, averages: SEEN }
    }

    /// The points as they are looked at before anything moved them.
    pub(super) fn unmoved(&self) -> Located {
        from_afar(&self.full, self.averages)
    }

    /// Whether averages are looked at.
    pub(super) fn is_averaged(&self) -> bool {
        self.seen.points.len() < self.full.points.len()
    }

    /// All points, moved along the curve as their averages were.
    pub(super) fn following(&self, breaks: &Breaks) -> Located {
        let parameters = [&self.unmoved().parameters[..], &self.seen.parameters];
        let parameters = followed(&self.full, self.averages, parameters, breaks);
        Located { parameters, points: self.full.points.clone(), weights: self.full.weights.clone() }
    }
}

/// The points, or averages of them where they are many.
pub(super) fn from_afar(full: &Located, count: usize) -> Located {
    if 2 * full.points.len() > 3 * count { averages(full, count) } else { full.clone() }
}
