//! The last knots: one of the cheapest is taken away, and the others are to make up for it.

use super::{Aim, FEW, Found, Phase, Sparsest};
use crate::fit::knots::breaks::Breaks;
use crate::fit::knots::free_knots::{FreeKnots, Located, Removal};
use crate::fit::knots::search::{Price, apart, cheapest, hopes, settle};
use crate::fit::knots::spline::{Distances, Spline};
use crate::fit::knots::window::Window;

/// So many knots are not taken away one by one, but one in so many of them at once.
pub(super) const MANY: usize = 24;
const BOLD: [usize; 3] = [4, 8, 16];
/// Steps that the others take to make up for one that is gone.
const MOST_SLIDES: usize = 6;

/// The best fit's knots without many of them or one, in ways of which the first promise most.
#[derive(Clone, Debug, Default)]
pub(super) struct Fewer {
    trials: Vec<Breaks>,
    /// The best fit's sum of squares.
    squares: f64,
}

impl Fewer {
    /// Some ways, and then those without one knot.
    #[inline(never)]
    fn of(mut trials: Vec<Breaks>, fitted: &FreeKnots, removals: &[Removal], most: usize) -> Self {
        trials.extend(hopes(fitted.breaks(), removals, Price(fitted.squares.max(1e-300)), most));
        Self { trials, squares: fitted.squares }
    }
}

impl Sparsest {
    /// How many knots are tried when fewer are hardly possible: all of them where that takes little time.
    pub(super) fn trials(&self, best: &Found) -> usize {
        let rough = matches!(self.asked.aim, Aim::Tolerance(_)) && self.is_rough(best);
        match (self.view.full.points.len(), rough) {
            (0..=800, _) | (801..=FEW, true) => 40,
            (_, true) => 10,
            (801..=FEW, false) => 4,
            (_, false) => 1,
        }
    }

    /// Takes the next of the cheapest knots away from the best fit and lets the others slide.
    pub(super) fn lighter(&mut self, next: usize, target: f64) -> Phase {
        let Some(best) = &self.found else { return Phase::Done };
        if next == 0 {
            let fitted = FreeKnots::new(best.spline.space.breaks.clone(), &self.view.seen);
            self.fewer = Fewer::of(Vec::new(), &fitted, &fitted.removals(), self.trials(best));
        }
        let Some(breaks) = self.fewer.trials.get(next).cloned() else { return Phase::Done };
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
        let tolerance = match self.asked.aim {
            Aim::Squares(target) => return self.lighter(next, target),
            Aim::Noise(_) => return self.slide(next),
            Aim::Tolerance(tolerance) => tolerance,
        };
        let Some(best) = &self.found else { return Phase::Done };
        let seen = if self.view.is_averaged() { &self.view.seen } else { &best.located };
        let whole = &best.spline.space.breaks;
        if next == 0 {
            let fitted = FreeKnots::new(whole.clone(), seen);
            let removals = fitted.removals();
            self.fewer = Fewer::of(bold(whole, &removals), &fitted, &removals, self.trials(best));
        }
        let worth = 1e-3 * self.fewer.squares;
        let Some(fewer) = self.fewer.trials.get(next) else { return Phase::Done };
        let slid = match Window::of(whole, fewer, seen) {
            Some(window) => made_up_for(window, worth, tolerance),
            None => Some(fewer.clone()),
        };
        match slid.and_then(|breaks| self.within(breaks, seen.clone(), worth, tolerance)) {
            Some(found) => {
                self.found = Some(found);
                Phase::Last(0)
            }
            None => Phase::Last(next + 1),
        }
    }

    /// A fit that keeps the tolerance, if knots slide to one from here.
    fn within(&self, breaks: Breaks, mut seen: Located, worth: f64, tolerance: f64) -> Option<Found> {
        let trial = settle(FreeKnots::new(breaks, &seen), &seen, worth, MOST_SLIDES);
        let mut spline = Spline::of(&trial);
        if minimax(&mut spline, &mut seen, tolerance).largest > tolerance {
            return None;
        }
        let pulled = spline.pulled_back(&mut seen, self.leash())?;
        if pulled.largest > tolerance {
            return None;
        }
        let averaged = self.view.is_averaged();
        let mut located = if averaged { self.view.following(self.fitted.breaks()) } else { seen };
        located.weights.clone_from(&self.view.full.weights);
        let distances = spline.project_beyond(&mut located, 3, self.near());
        (distances.largest <= tolerance).then_some(Found { spline, located, distances, wild: None })
    }
}

/// The knots of the whole curve, where those of a part slide to where it keeps the tolerance.
#[inline(never)]
fn made_up_for(mut window: Window, worth: f64, tolerance: f64) -> Option<Breaks> {
    let part = settle(FreeKnots::new(window.after.clone(), &window.data), &window.data, worth, MOST_SLIDES);
    let largest = minimax(&mut Spline::of(&part), &mut window.data, tolerance).largest;
    (largest <= tolerance).then(|| window.whole(part.breaks()))
}

/// Many of the cheapest knots gone at once, where there are many; the boldest first.
fn bold(breaks: &Breaks, removals: &[Removal]) -> Vec<Breaks> {
    let cheapest = cheapest(removals);
    let without = |share: usize| breaks.without(&apart(&cheapest, breaks.len(), breaks.len() / share));
    if breaks.len() < MANY { Vec::new() } else { BOLD.map(without).to_vec() }
}

/// Makes the largest distance smaller: far points weigh more from round to round (Lawson's way). The spline with the
/// smallest largest distance is kept.
#[inline(never)]
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
            for (m, (s, t)) in spline.space.places(&data.parameters).enumerate() {
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
