//! The end of a search among points that follow one another evenly: where along the curve they belong tells most of it.

use super::rounding::without_seeming_corners;
use super::{Found, PER_NUMBER, Sparsest};
use crate::fit::knots::even::Spaced;
use crate::fit::report::weight;

/// Points that are so many times farther from where they belong by length, in the mean of squares, than noise says are
/// not even.
const EXPLAINED: f64 = 1.3;
/// How often it is told how the spacing of points drifts: feet on a curve by length say it better.
const DRIFTS: usize = 2;
/// The share of a number's price that makes another step.
const PLAINLY: f64 = 0.5;

impl Sparsest {
    /// The curve that explains its points best where they are equally far apart along it (D 13.12), and slight corners
    /// smooth where that pays; `None` where they are not.
    pub(super) fn spaced_out(&self, best: &Found) -> Option<Found> {
        let mut located = best.located.clone();
        best.spline.project(&mut located, 3);
        let noise = self.both_ways(best);
        let worth = PLAINLY * self.pricing.price.0;
        let evenly = Spaced::new(best.spline.clone(), &located)?;
        let explained = |spaced: &Spaced| spaced.squares <= EXPLAINED * noise;
        let mut spaced = evenly.clone().settled(worth, f64::INFINITY)?;
        if !explained(&spaced) {
            spaced = evenly;
            for _ in 0..DRIFTS {
                spaced = spaced.drifting(&located, self.pricing.price.0)?.settled(worth, f64::INFINITY)?;
                if !explained(&spaced) {
                    return None;
                }
                located = spaced.located.clone();
                spaced.spline.project(&mut located, 3);
            }
        }
        let smooth =
            without_seeming_corners(&spaced.spline).and_then(|breaks| spaced.on(breaks)).and_then(|smooth| {
                let [with, without] =
                    [&spaced, &smooth].map(|fit| self.pricing.price.whole(&fit.spline.space.breaks));
                smooth.settled(worth, spaced.squares + with - without)
            });
        let found = smooth.and_then(|smooth| self.near_enough(smooth, best));
        found.or_else(|| self.near_enough(spaced, best))
    }

    /// The squares of what noise leaves of all points in both coordinates: by what is known of it, or by what they are
    /// off across the curve where that is more. Of 600 points differences tell noise to 6 %, what a curve leaves across
    /// to 3 %, whether points are even or not.
    fn both_ways(&self, best: &Found) -> f64 {
        let (price, points) = (self.pricing.price, weight(&best.located));
        let numbers = price.whole(&best.spline.space.breaks) / price.0;
        let across = best.distances.squares / (points - numbers).max(1.0);
        2.0 * points * across.max(price.0 / PER_NUMBER)
    }

    /// The curve, if its points are hardly farther from it than from the best one.
    fn near_enough(&self, spaced: Spaced, best: &Found) -> Option<Found> {
        let Spaced { spline, located, .. } = spaced;
        let mut feet = located.parameters.clone();
        let distances = spline.feet(&located, &mut feet, 3);
        let farther = distances.squares - best.distances.squares;
        let near = farther <= self.pricing.price.whole(&spline.space.breaks);
        let kept = near && !self.is_spoiled(&spline, &located);
        kept.then_some(Found { spline, located, distances, wild: None })
    }
}
