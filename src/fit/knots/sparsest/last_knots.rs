//! The last knots: one of the cheapest is taken away, and the others are to make up for it.

use super::{Aim, FEW, Found, Phase, Sparsest};
use crate::fit::knots::breaks::Breaks;
use crate::fit::knots::foot_points::{Distances, Spline};
use crate::fit::knots::free_knots::{FreeKnots, Located, Removal};
use crate::fit::knots::search::{Price, apart, hopes, settle};
use crate::numerics::order::sort_by_number;

/// So many knots are not taken away one by one, but one in so many of them at once.
const MANY: usize = 24;
const BOLD: [usize; 3] = [4, 8, 16];

impl Sparsest {
    /// How many knots are tried when fewer are hardly possible: all of them where that takes little time.
    pub(super) fn trials(&self) -> usize {
        match self.view.full.points.len() {
            0..=800 => 40,
            801..=FEW => 4,
            _ => 1,
        }
    }

    /// Takes the next of the cheapest knots away from the best fit and lets the others slide.
    pub(super) fn lighter(&mut self, next: usize, target: f64) -> Phase {
        let Some(best) = &self.found else { return Phase::Done };
        let fitted = FreeKnots::new(best.spline.space.breaks.clone(), &self.view.seen);
        let dear = Price(fitted.squares.max(1e-300));
        let trials = hopes(fitted.breaks(), &fitted.removals(), dear, self.trials());
        let Some(breaks) = trials.into_iter().nth(next) else { return Phase::Done };
        let trial = settle(FreeKnots::new(breaks, &self.view.seen), &self.view.seen, 1e-4 * target, 12);
        if trial.squares > target || Spline::of(&trial).wild_piece(&self.view.full, trial.squares).is_some() {
            return Phase::Last(next + 1);
        }
        self.fitted = trial;
        self.keep_by_squares(None);
        Phase::Last(0)
    }

    /// Takes the next of the cheapest knots away from the best fit and lets the others make up for it, the farthest
    /// points weighing most.
    pub(super) fn last(&mut self, next: usize) -> Phase {
        if let Aim::Squares(target) = self.asked.aim {
            return self.lighter(next, target);
        }
        let (Aim::Tolerance(tolerance), Some(best)) = (self.asked.aim, &self.found) else {
            return Phase::Done;
        };
        let averaged = self.view.is_averaged();
        let mut seen = if averaged { self.view.seen.clone() } else { best.located.clone() };
        let fitted = FreeKnots::new(best.spline.space.breaks.clone(), &seen);
        let removals = fitted.removals();
        let dear = Price(fitted.squares.max(1e-300));
        let mut trials = bold(fitted.breaks(), &removals);
        trials.extend(hopes(fitted.breaks(), &removals, dear, self.trials()));
        let Some(breaks) = trials.into_iter().nth(next) else { return Phase::Done };
        let trial = settle(FreeKnots::new(breaks, &seen), &seen, 1e-3 * fitted.squares, 6);
        let mut spline = Spline::of(&trial);
        let distances = minimax(&mut spline, &mut seen, tolerance);
        let pulled =
            if distances.largest <= tolerance { spline.pulled_back(&mut seen, self.leash()) } else { None };
        if pulled.is_some_and(|distances| distances.largest <= tolerance) {
            let mut located = if averaged { self.view.following(self.fitted.breaks()) } else { seen };
            located.weights.clone_from(&self.view.full.weights);
            let distances = spline.project_beyond(&mut located, 3, self.near());
            if distances.largest <= tolerance {
                self.found = Some(Found { spline, located, distances, wild: None });
                return Phase::Last(0);
            }
        }
        Phase::Last(next + 1)
    }
}

/// Many of the cheapest knots gone at once, where there are many; the boldest first.
fn bold(breaks: &Breaks, removals: &[Removal]) -> Vec<Breaks> {
    let mut cheapest: Vec<usize> = (0..breaks.len()).collect();
    sort_by_number(&mut cheapest, &|&k| removals[k].whole);
    let without = |share: usize| {
        let mut fewer = breaks.clone();
        for &k in apart(&cheapest, breaks.len(), breaks.len() / share).iter().rev() {
            fewer.remove(k);
        }
        fewer
    };
    if breaks.len() < MANY { Vec::new() } else { BOLD.map(without).to_vec() }
}

/// Makes the largest distance smaller: far points weigh more from round to round (Lawson's way). The spline with the
/// smallest largest distance is kept.
pub(super) fn minimax(spline: &mut Spline, data: &mut Located, enough: f64) -> Distances {
    if data.weights.is_empty() {
        data.weights = vec![1.0; data.points.len()];
    }
    let mut best: Option<(Spline, Distances)> = None;
    for round in 0..14 {
        if round > 0 {
            spline.tighten(data);
        }
        let distances = spline.project(data, 2);
        let before = best.as_ref().map_or(f64::INFINITY, |best| best.1.largest);
        if distances.largest < before {
            best = Some((spline.clone(), distances));
        }
        if distances.largest <= enough || (round == 6 && before > 2.0 * enough) {
            break;
        }
        if round >= 2 {
            let mut at = 0;
            for m in 0..data.points.len() {
                let (s, t) = spline.space.find(data.parameters[m], at);
                at = s;
                let far = (spline.on(s, t, 0) - data.points[m]).norm() / distances.largest;
                data.weights[m] = (data.weights[m] * (0.4 + far * far)).clamp(1e-3, 1e3);
            }
        }
    }
    match best {
        Some((kept, distances)) => {
            *spline = kept;
            distances
        }
        None => Distances { largest: f64::INFINITY, squares: f64::INFINITY },
    }
}
