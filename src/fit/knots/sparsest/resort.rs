//! What a search resorts to that missed its tolerance, or kept it with a knot for every few points: the polyline of the
//! fewest vertices, and fewer knots from there on.

use super::{Aim, Asked, FEW, Found, Phase, Sparsest, View};
use crate::error::Result;
use crate::fit::knots::free_knots::FreeKnots;
use crate::fit::knots::polyline::Fewest;
use crate::fit::knots::rounded::{Rounds, rounded};
use crate::numerics::angle::sin_cos;

/// A polyline keeps to so much of a tolerance.
pub(super) const ALMOST: f64 = 0.98;
/// The parts of a tolerance that a polyline leaves to its rounds, and that these are from its vertices.
const LEFT: f64 = 0.7;
const DEPTH: f64 = 0.28;
/// From so many points edges of the fewest are drawn in one round.
const IN_A_ROUND: usize = 4096;
/// With a knot for fewer points than this there are hardly fewer knots than points.
const SPARE: usize = 4;
/// How many points a polyline has that is thinned out before it is swept: each of fewer may be a corner, and of more it
/// takes too long.
const THINNED: core::ops::RangeInclusive<usize> = 16..=FEW;
/// How often numbers may become cheaper where a polyline was thinned out too much, and how many times.
const CHEAPENINGS: usize = 3;
const CHEAPENING: f64 = 8.0;

/// How far the polyline is that is an answer where nothing else is.
#[derive(Clone, Debug)]
pub(super) enum Resort {
    None,
    Edges(Fewest),
    Vertices(Vec<usize>),
    Over,
}

/// What became of the polyline.
#[derive(Debug)]
pub(in crate::fit) enum Resorted {
    Underway,
    /// It is what another search begins with.
    Begun(Box<Sparsest>),
    Over,
}

impl Sparsest {
    /// Looks for the polyline of the fewest vertices where [`Self::lacking`] tells that one is wanted, rounded off
    /// where corners may not be. A round of it. O(M) in all but for points that are many times denser than the
    /// tolerance.
    ///
    /// # Errors
    ///
    /// `OutOfMemory`.
    pub(in crate::fit) fn resort_to_polyline(&mut self) -> Result<Resorted> {
        let Some(tolerance) = self.lacking() else { return Ok(Resorted::Over) };
        let closed = self.fitted.breaks().closed;
        let points = &self.view.full.points;
        match &mut self.resort {
            Resort::None => {
                let near = self.rounds(tolerance).map_or(ALMOST * tolerance, |_| LEFT * tolerance);
                self.resort = Resort::Edges(Fewest::new(points, closed, near)?);
            }
            Resort::Edges(fewest) => {
                if fewest.round(points, IN_A_ROUND) {
                    self.resort = Resort::Vertices(fewest.vertices(points.len(), closed)?);
                }
            }
            Resort::Vertices(vertices) => {
                let vertices = core::mem::take(vertices);
                self.resort = Resort::Over;
                let found = self.resorted(&vertices, tolerance)?;
                let Some(found) = found.filter(|found| found.distances.largest <= tolerance) else {
                    return Ok(Resorted::Over);
                };
                let search = if self.may_thin() { Some(self.thinning(&found)?) } else { None };
                if self.missed().is_some() {
                    self.found = Some(found);
                }
                if let Some(search) = search {
                    return Ok(Resorted::Begun(Box::new(search)));
                }
            }
            Resort::Over => return Ok(Resorted::Over),
        }
        Ok(Resorted::Underway)
    }

    /// Within what a polyline is wanted: what is missed, or a tolerance that was kept with hardly fewer knots than
    /// points.
    pub(in crate::fit) fn lacking(&self) -> Option<f64> {
        self.missed().or_else(|| match (self.asked.aim, &self.found) {
            (Aim::Tolerance(tolerance), Some(found)) => {
                let crowded = SPARE * found.spline.space.breaks.pieces() > self.view.full.points.len();
                (crowded && self.may_thin()).then_some(tolerance)
            }
            _ => None,
        })
    }

    /// Whether a search from the polyline may find fewer knots than it has.
    fn may_thin(&self) -> bool {
        let wanted = matches!(self.asked.aim, Aim::Tolerance(_)) && !self.asked.aim.is_fine();
        wanted && (self.asked.sweeps || THINNED.contains(&self.view.full.points.len()))
    }

    /// A search that begins with a curve that keeps the tolerance, and with its feet.
    #[inline(never)]
    fn thinning(&self, found: &Found) -> Result<Self> {
        let mut found = found.clone();
        // Where two rounds meet there may still be no corner.
        found.spline.space.breaks.sharpest = self.sharpest;
        let breaks = found.spline.space.breaks.clone();
        let mut search = Self::begun(self.asked, View::of_all(found.located.copied()?), breaks);
        let thins = THINNED.contains(&self.view.full.points.len());
        (search.phase, search.sharpest) = (if thins { Phase::Thin } else { Phase::Sweep }, self.sharpest);
        search.effort.cheapenings = CHEAPENINGS;
        search.at_first = search.fitted.breaks().len();
        search.found = Some(found);
        Ok(search)
    }

    /// The curve that was begun with once more, with cheaper numbers: as long as nothing else kept the tolerance.
    #[inline(never)]
    pub(super) fn thinned_less(&mut self) -> Option<Phase> {
        let found = self.found.as_ref()?;
        if self.effort.cheapenings == 0 || self.effort.is_tired() {
            return None;
        }
        self.effort.cheapenings -= 1;
        self.pricing.price.0 /= CHEAPENING;
        self.view.seen = found.located.clone();
        self.fitted = FreeKnots::new(found.spline.space.breaks.clone(), &self.view.seen);
        Some(Phase::Thin)
    }

    /// How a polyline is to be rounded off; nothing where any corner may be.
    fn rounds(&self, tolerance: f64) -> Option<Rounds> {
        let (Asked { least_turn, cornered, .. }, degree) = (self.asked, self.fitted.breaks().degree);
        // No angle has a cosine below −1.
        let cosine = if cornered { sin_cos(least_turn).1 } else { -2.0 };
        (degree > 1 && cosine < 1.0).then_some(Rounds { depth: DEPTH * tolerance, cosine })
    }

    /// The polyline through some of the points, or what is to be instead.
    #[inline(never)]
    fn resorted(&self, vertices: &[usize], tolerance: f64) -> Result<Option<Found>> {
        let Some(rounds) = self.rounds(tolerance) else {
            return self.corners_at(vertices)?.map(|breaks| self.polyline(vertices, breaks)).transpose();
        };
        let found = rounded(vertices, &self.view.full, self.fitted.breaks(), rounds)?;
        Ok(found.map(|(spline, mut located)| {
            let distances = spline.project_beyond(&mut located, 3, self.near());
            Found { spline, located, distances, wild: None }
        }))
    }
}
