//! The fewest knots that explain the points: knots go, come together, sharpen and slide for as long as the sum of
//! squares and a price for every number that the curve needs go down together.

use super::breaks::{Breaks, HIGHEST};
use super::free_knots::{FreeKnots, Located, Removal, in_order};
use super::window::Window;
use crate::numerics::order::{sort_by_number, sort_in_place};

/// What one number of the curve costs in the sum of squares: a knot has its place and two numbers per multiplicity.
#[derive(Clone, Copy, Debug)]
pub(super) struct Price(pub(super) f64);

/// How many numbers more a corner counts for when whole fits are compared: one that is seen should be there.
pub(super) const CORNER: f64 = 3.0;

/// Within how many points knots may stand for one corner, and how many such groups are tried.
const NEAR: f64 = 20.0;
const MOST_CLUSTERS: usize = 6;

/// How many times what one step of all knots promises a trial may lack.
const HOPE: f64 = 3.0;

/// What a knot would gain that counted once more, twice more and so on.
type Gains = [f64; HIGHEST];

impl Price {
    /// The price of a knot that counts so often.
    pub(super) fn of(self, multiplicity: usize) -> f64 {
        self.0 * (1 + 2 * multiplicity) as f64
    }

    /// What the price changes by when a knot counts otherwise.
    fn change(self, from: usize, to: usize) -> f64 {
        self.of(to) - self.of(from)
    }

    /// Squares and prices together.
    pub(super) fn total(self, fitted: &FreeKnots) -> f64 {
        fitted.squares + self.whole(fitted.breaks())
    }

    /// The price of all knots, less that of the numbers that straight pieces do without.
    #[inline(never)]
    pub(super) fn whole(self, breaks: &Breaks) -> f64 {
        let straight = breaks.straight.iter().filter(|straight| **straight).count();
        let spared = self.0 * (2 * straight * (breaks.degree - 1)) as f64;
        breaks.multiplicity.iter().map(|&m| self.of(m)).sum::<f64>() - spared
    }

    /// The same, corners counting for more: for the choice between fits that began differently.
    pub(super) fn rank(self, fitted: &FreeKnots) -> f64 {
        let breaks = fitted.breaks();
        let corners =
            breaks.multiplicity.iter().filter(|m| **m == breaks.degree && breaks.degree > 1).count();
        // A piece that may be straight does without some numbers.
        let spare = self.0 * (2 * (breaks.degree - 1)) as f64;
        let straight: f64 = match breaks.degree {
            1 => 0.0,
            _ => fitted.straightenings().iter().map(|cost| (spare - cost).max(0.0)).sum(),
        };
        self.total(fitted) + CORNER * self.0 * corners as f64 - straight
    }
}

/// Fewest knots that a fit may be left with.
pub(super) fn least(breaks: &Breaks) -> usize {
    if breaks.closed { 2 } else { 0 }
}

/// Takes away, many at a time, knots that are not worth their price (D 13.1), \[LM88\]; `None` when there is none.
pub(super) fn thinner(fitted: &FreeKnots, data: &Located, price: Price) -> Option<FreeKnots> {
    let breaks = fitted.breaks();
    let removals = fitted.removals();
    let mut order: Vec<usize> =
        (0..breaks.len()).filter(|&k| removals[k].whole < price.of(breaks.multiplicity[k])).collect();
    sort_by_number(&mut order, &|&k| removals[k].whole);
    let most = (breaks.len() / 3).max(1).min(breaks.len().saturating_sub(least(breaks)));
    let doomed = apart(&order, breaks.len(), most);
    if doomed.is_empty() {
        return None;
    }
    Some(FreeKnots::new(breaks.without(&doomed), data))
}

/// All knots, those first that cost least to take away.
#[inline(never)]
pub(super) fn cheapest(removals: &[Removal]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..removals.len()).collect();
    sort_by_number(&mut order, &|&k| removals[k].whole);
    order
}

/// The first `most` of a list of knots of which none is beside another, in ascending order.
pub(super) fn apart(order: &[usize], count: usize, most: usize) -> Vec<usize> {
    let mut taken = vec![false; count];
    let mut chosen = Vec::new();
    for &k in order {
        if chosen.len() < most && !taken[(k + 1) % count] && !taken[(k + count - 1) % count] {
            taken[k] = true;
            chosen.push(k);
        }
    }
    sort_in_place(&mut chosen);
    chosen
}

/// Slides the knots until a step no longer pays for itself, at most `most` times.
#[inline(never)]
pub(super) fn settle(mut fitted: FreeKnots, data: &Located, worth: f64, most: usize) -> FreeKnots {
    let mut damping = 1e-2;
    for _ in 0..most {
        let before = fitted.squares;
        match fitted.slide(data, &mut damping) {
            Some(moved) => fitted = moved,
            None => break,
        }
        if before - fitted.squares < worth {
            break;
        }
    }
    fitted
}

/// A change of one knot whose effect is known exactly before it is made.
#[derive(Clone, Copy, Debug)]
struct Change {
    knot: usize,
    /// The multiplicity afterwards; 0 takes the knot away.
    multiplicity: usize,
    /// By how much squares and prices go up together.
    effect: f64,
}

/// A cheaper fit, by one round of changes, or `None` when nothing that is tried makes it cheaper.
///
/// First come changes whose effect is known, all that are apart at once. Where there is none, knots are taken away or
/// joined that would have to be made up for by the others' sliding, one trial after another; `near_first` by that of
/// those beside them.
pub(super) fn better(
    fitted: &FreeKnots,
    data: &Located,
    price: Price,
    near_first: bool,
) -> Option<FreeKnots> {
    let worth = 0.05 * price.0;
    let now = price.total(fitted);
    let removals = fitted.removals();
    let more = |(k, m): (usize, &usize)| fitted.gains(k, fitted.breaks().sharpest.saturating_sub(*m));
    let gains: Vec<Gains> = fitted.breaks().multiplicity.iter().enumerate().map(more).collect();
    let changes = sure(fitted, &removals, &gains, price);
    for all in [true, false] {
        let order: Vec<usize> = changes.iter().map(|change| change.knot).collect();
        let chosen = apart(&order, fitted.breaks().len(), if all { usize::MAX } else { 1 });
        if chosen.is_empty() || (!all && changes.len() == 1) {
            continue;
        }
        let trial = FreeKnots::new(changed(fitted.breaks(), &changes, &chosen), data);
        let trial = settle(trial, data, worth, 2);
        if price.total(&trial) < now {
            return Some(trial);
        }
    }
    let mut trials = hopes(fitted.breaks(), &removals, price, 6);
    trials.extend(corners(fitted, &gains, price));
    trials.extend(clusters(fitted.breaks(), fitted.points()));
    for breaks in trials {
        let breaks = if near_first { slid_near(fitted.breaks(), breaks, data, price) } else { Some(breaks) };
        if let Some(trial) = breaks.and_then(|breaks| slid_below(breaks, data, price, now)) {
            return Some(settle(trial, data, worth, 1));
        }
    }
    None
}

/// Other knots, where there are many with those beside the change slid to where these make up for it; nothing if they
/// do not.
#[inline(never)]
fn slid_near(before: &Breaks, after: Breaks, data: &Located, price: Price) -> Option<Breaks> {
    let Some(window) = Window::of(before, &after, data) else { return Some(after) };
    let was = price.total(&FreeKnots::new(window.before.clone(), &window.data));
    let part = slid_below(window.after.clone(), &window.data, price, was)?;
    Some(window.whole(part.breaks()))
}

/// A fit that is cheaper than `now`, if knots slide to one from here.
#[inline(never)]
fn slid_below(breaks: Breaks, data: &Located, price: Price, now: f64) -> Option<FreeKnots> {
    let mut trial = FreeKnots::new(breaks, data);
    let mut damping = 1e-2;
    for _ in 0..8 {
        if price.total(&trial) < now {
            return Some(trial);
        }
        let sliding = trial.slide_equations();
        // It will not get there.
        if HOPE * sliding.promise() < price.total(&trial) - now {
            return None;
        }
        trial = trial.slid(&sliding, data, &mut damping)?;
    }
    (price.total(&trial) < now).then_some(trial)
}

/// Changes that are known to pay, the best one of every knot, the best first.
fn sure(fitted: &FreeKnots, removals: &[Removal], gains: &[Gains], price: Price) -> Vec<Change> {
    let breaks = fitted.breaks();
    let mut changes = Vec::new();
    for (k, removal) in removals.iter().enumerate() {
        let m = breaks.multiplicity[k];
        let mut best = Change { knot: k, multiplicity: m, effect: -1e-9 * price.0 };
        let mut offer = |multiplicity: usize, effect: f64| {
            if effect < best.effect {
                best = Change { knot: k, multiplicity, effect };
            }
        };
        if breaks.len() > least(breaks) {
            offer(0, removal.whole - price.of(m));
        }
        if m > breaks.smoothest {
            offer(m - 1, removal.one + price.change(m, m - 1));
        }
        for more in 1..=breaks.sharpest.saturating_sub(m) {
            offer(m + more, price.change(m, m + more) - gains[k][more - 1]);
        }
        if best.multiplicity != m {
            changes.push(best);
        }
    }
    sort_by_number(&mut changes, &|change| change.effect);
    changes
}

fn changed(breaks: &Breaks, changes: &[Change], chosen: &[usize]) -> Breaks {
    let mut breaks = breaks.clone();
    for &k in chosen.iter().rev() {
        let Some(change) = changes.iter().find(|change| change.knot == k) else { continue };
        if change.multiplicity > 0 {
            breaks.multiplicity[k] = change.multiplicity;
        } else if breaks.len() > least(&breaks) {
            breaks.remove(k);
        }
    }
    breaks
}

/// Knots taken away or joined, the `most` promising ones, best first.
#[inline(never)]
pub(super) fn hopes(breaks: &Breaks, removals: &[Removal], price: Price, most: usize) -> Vec<Breaks> {
    let mut found: Vec<(f64, usize, bool)> = Vec::new();
    for (k, removal) in removals.iter().enumerate() {
        let cost = price.of(breaks.multiplicity[k]);
        if breaks.len() > least(breaks) && removal.whole < 4.0 * cost {
            found.push((removal.whole / cost, k, false));
        }
        if let Some(closeness) = closeness(breaks, k) {
            found.push((closeness, k, true));
        }
    }
    sort_by_number(&mut found, &|one| one.0);
    found.truncate(most);
    let hope = |(_, k, joins)| if joins { joined(breaks, removals, k) } else { breaks.without(&[k]) };
    found.into_iter().map(hope).collect()
}

/// Knots that nearly pay as corners where they are, and may where they slide to; those that say most first.
fn corners(fitted: &FreeKnots, gains: &[Gains], price: Price) -> Vec<Breaks> {
    let breaks = fitted.breaks();
    let mut found: Vec<(f64, usize)> = Vec::new();
    for (k, &m) in breaks.multiplicity.iter().enumerate().filter(|(_, m)| **m < breaks.sharpest) {
        let cost = price.change(m, breaks.sharpest);
        let gain = gains[k][breaks.sharpest - m - 1];
        if gain > 0.3 * cost {
            found.push((gain / cost, k));
        }
    }
    sort_by_number(&mut found, &|one| -one.0);
    found.truncate(3);
    let corner = |(_, k): (f64, usize)| {
        let mut corner = breaks.clone();
        corner.multiplicity[k] = breaks.sharpest;
        corner
    };
    found.into_iter().map(corner).collect()
}

/// Neighbouring knots within a few points that together cost no less than a corner, which they may be; the closest
/// first.
#[inline(never)]
pub(super) fn clusters(breaks: &Breaks, points: usize) -> Vec<Breaks> {
    let reach = NEAR * breaks.end / points.max(1) as f64;
    let mut found: Vec<(f64, usize, usize)> = Vec::new();
    let most = breaks.len().saturating_sub(least(breaks).max(1));
    for k in 0..breaks.len() {
        let (mut counted, mut long) = (breaks.multiplicity[k], 0.0);
        let beyond = if breaks.closed { most } else { most.min(breaks.len() - 1 - k) };
        for more in 1..=beyond {
            long += breaks.gap_after((k + more - 1) % breaks.len());
            counted += breaks.multiplicity[(k + more) % breaks.len()];
            if long >= reach {
                break;
            }
            if counted >= breaks.sharpest {
                found.push((long, k, more));
            }
        }
    }
    sort_by_number(&mut found, &|one| one.0);
    found.truncate(MOST_CLUSTERS);
    found.into_iter().map(|(long, k, more)| one_corner(breaks, k, more, long)).collect()
}

/// Knot k and some that follow it as a corner halfway along.
fn one_corner(breaks: &Breaks, mut k: usize, more: usize, long: f64) -> Breaks {
    let mut one = breaks.clone();
    one.at[k] += 0.5 * long;
    one.multiplicity[k] = breaks.sharpest;
    for _ in 0..more {
        let next = (k + 1) % one.len();
        one.remove(next);
        k -= usize::from(next < k);
    }
    in_order(&mut one);
    one
}

/// How promising it is to have knot k and the next one at one place, where they are close.
fn closeness(breaks: &Breaks, k: usize) -> Option<f64> {
    let count = breaks.len();
    if count < 2 || count <= least(breaks) || (k + 1 == count && !breaks.closed) {
        return None;
    }
    let next = (k + 1) % count;
    let gap = breaks.gap_after(k);
    let around = breaks.gap_before(k).min(breaks.gap_after(next));
    let both = breaks.multiplicity[k] + breaks.multiplicity[next];
    (both <= breaks.degree + 2 && gap <= 0.5 * around).then_some(1.0 + 4.0 * gap / around)
}

/// Knot k and the next one at one place.
fn joined(breaks: &Breaks, removals: &[Removal], k: usize) -> Breaks {
    let next = (k + 1) % breaks.len();
    let both = breaks.multiplicity[k] + breaks.multiplicity[next];
    let (a, b) = (removals[k].whole, removals[next].whole);
    let share = if a + b > 0.0 { b / (a + b) } else { 0.5 };
    let mut one = breaks.clone();
    one.at[k] += share * breaks.gap_after(k);
    one.multiplicity[k] = both.min(breaks.sharpest);
    one.remove(next);
    in_order(&mut one);
    one
}
