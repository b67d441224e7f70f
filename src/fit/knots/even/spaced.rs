//! The curve that explains best points that are equally far apart along it.
//!
//! Where points are is then known from the curve alone, along it as well as across: what a point says along the curve
//! is said of the length of all that lies before it. A corner is where both sides, each as long as its points say,
//! meet.

mod growth;
mod sums;

use self::growth::{Growths, Place};
use self::sums::{Crowd, LENGTHS, Sums};
use super::{PARTS, Spread, place, value};
use crate::fit::knots::breaks::{Breaks, HIGHEST};
use crate::fit::knots::envelope::Envelope;
use crate::fit::knots::free_knots::{FreeKnots, Located};
use crate::fit::knots::look::taylor;
use crate::fit::knots::space::STIFF;
use crate::fit::knots::spline::Spline;

/// The most steps, and the most operations that one may take.
const MOST_STEPS: usize = 6;
const MOST_WORK: usize = 4_000_000;
/// Steps that fail before none is looked for any more, and by how much each is shorter.
const MOST_FAILED: usize = 2;
const SHORTER: f64 = 0.3;
/// How much less it counts at first that a curve's parameter stays as it is than what points say, and how many times
/// that after a whole step and after a part of one: knots slide with the parameter, and little holds them (Levenberg's
/// way).
const STAY: f64 = 0.003;
const EASIER: f64 = 0.3;
const HARDER: f64 = 10.0;
/// How many times what the last step brought may be missing.
const PACE: f64 = 4.0;

/// A curve, its points with the parameters that are equally far apart along it, and the sum of the squares of the
/// distances to those places.
#[derive(Clone, Debug)]
pub(in crate::fit::knots) struct Spaced {
    pub(in crate::fit::knots) spline: Spline,
    pub(in crate::fit::knots) located: Located,
    pub(in crate::fit::knots) squares: f64,
    /// The length to the first point.
    lead: f64,
    /// How much less than what points say it counts that the parameter stays as it is.
    stay: f64,
    /// By how many steps points are ahead of their numbers; empty where they are not.
    ahead: Vec<f64>,
}

impl Spaced {
    /// The points where they belong on a curve; `located` has their feet, or places near them.
    pub(in crate::fit::knots) fn new(spline: Spline, located: &Located) -> Option<Self> {
        let lead = Spread::new(&spline, located)?.lead;
        Self::from(spline, located, lead, &[])
    }

    /// The same curve with points whose spacing drifts (D 13.15), as their feet say; `None` where it does not, by what
    /// a number is worth.
    pub(in crate::fit::knots) fn drifting(&self, feet: &Located, worth: f64) -> Option<Self> {
        let spread = Spread::from(&self.spline, feet.points.len(), self.lead)?;
        let ahead = spread.drift(feet, self.spline.space.breaks.end, worth);
        if ahead.is_empty() { None } else { Self::from(self.spline.clone(), feet, self.lead, &ahead) }
    }

    #[inline(never)]
    fn from(spline: Spline, located: &Located, lead: f64, ahead: &[f64]) -> Option<Self> {
        let spread = Spread::from(&spline, located.points.len(), lead)?;
        let (end, closed, mut guess) = (spline.space.breaks.end, spline.space.breaks.closed, 0);
        let at = |m: usize| {
            let number = m as f64 + ahead.get(m).copied().unwrap_or(0.0);
            let t = spread.parameter(number, &mut guess);
            if closed && t >= end { t - end } else { t.max(0.0).min(end) }
        };
        let parameters = (0..located.points.len()).map(at).collect();
        let located = Located { parameters, ..located.clone() };
        let squares = spline.squares(&located);
        Some(Self { spline, located, squares, lead, stay: STAY, ahead: ahead.to_vec() })
    }

    /// The curve on other breaks, with its points where they are.
    pub(in crate::fit::knots) fn on(&self, breaks: Breaks) -> Option<Self> {
        let mut spline = Spline::of(&FreeKnots::new(breaks, &self.located));
        spline.straighten();
        Self::from(spline, &self.located, self.lead, &self.ahead)
    }

    /// The same after some steps, the last of which brings less than `worth`; `None` where there are too many knots,
    /// and where squares will not come down to `enough`. O(M + K³) for each.
    #[inline(never)]
    pub(in crate::fit::knots) fn settled(mut self, worth: f64, enough: f64) -> Option<Self> {
        let (pieces, unknowns) = (self.spline.space.spans.len(), 2 * self.spline.space.count);
        if pieces * unknowns * unknowns > MOST_WORK {
            return None;
        }
        for _ in 0..MOST_STEPS {
            let before = self.squares;
            match self.eased() {
                Some(eased) => self = eased,
                None => break,
            }
            let gain = before - self.squares;
            if gain < worth || PACE * gain < self.squares - enough {
                break;
            }
        }
        if self.squares > enough {
            return None;
        }
        self.spline.straighten();
        Some(self)
    }

    /// One Gauss–Newton step, or a part of it; `None` where it brings nothing.
    fn eased(&self) -> Option<Self> {
        let (equations, right, stiff) = self.equations()?;
        let mut whole = self.spline.clone();
        let solution = whole.moved(equations, right, stiff);
        let ahead = solution[solution.len() - 1];
        let mut share = 1.0;
        for _ in 0..MOST_FAILED {
            let mut spline = whole.clone();
            for (to, from) in [(&mut spline.x, &self.spline.x), (&mut spline.y, &self.spline.y)] {
                to.iter_mut().zip(from).for_each(|(to, from)| *to = from + share * (*to - from));
            }
            if let Some(mut eased) = Self::from(spline, &self.located, self.lead + share * ahead, &self.ahead)
                .filter(|eased| eased.squares < self.squares)
            {
                eased.stay = self.stay * if share < 1.0 { HARDER } else { EASIER };
                return Some(eased);
            }
            share *= SHORTER;
        }
        None
    }

    /// The equations of both coordinates of all coefficients and of the first point's length, their right side, and
    /// what bending costs.
    fn equations(&self) -> Option<(Envelope, Vec<f64>, f64)> {
        let (space, size) = (&self.spline.space, 2 * self.spline.space.count + 1);
        let spread = Spread::from(&self.spline, self.located.points.len(), self.lead)?;
        let lengths = growth::of(&self.spline, &spread.lengths.at);
        let sums = self.sums(&spread, &lengths);
        let (mut equations, mut right) = (Envelope::new(vec![0; size]), vec![0.0; size]);
        for (s, sums) in sums.iter().enumerate() {
            let mut units = vec![size - 1];
            units.extend(
                (0..=space.breaks.degree).flat_map(|i| [2 * space.index(s, i), 2 * space.index(s, i) + 1]),
            );
            let dense = [&lengths.before[s][..], &lengths.before[space.spans.len()]];
            let basis = &space.basis[s][..=space.breaks.degree];
            sums.spread(&mut equations, &mut right, dense, (&units, basis));
        }
        let most = (0..size).map(|i| equations.diagonal(i)).fold(0.0, f64::max);
        (0..size).for_each(|i| equations.add(i, i, 1e-9 * most + 1e-280));
        Some((equations, right, STIFF * most))
    }

    /// The sums of every piece.
    fn sums(&self, spread: &Spread, lengths: &Growths) -> Vec<Sums> {
        let (space, along) = (&self.spline.space, &spread.lengths);
        let mut sums = vec![Sums::default(); space.spans.len()];
        for (part, crowd) in self.crowds(spread, lengths, &mut sums).iter().enumerate() {
            let s = part / PARTS;
            let (start, step) = (along.at[part], along.at[part + 1] - along.at[part]);
            let cubic = along.cubic(part);
            let share = |length: f64, whole: f64| (length - whole * spread.lead) / along.total();
            let turned = if space.breaks.closed { 1.0 } else { 0.0 };
            for [w, v] in crowd.nodes().into_iter().filter(|node| node[0] > 0.0) {
                let place = Place::new(&self.spline, &lengths.pieces[s], s, start + v * step);
                let grown = lengths.parts[part].sum(&[1.0, v, v * v, v * v * v]);
                let lengths = [-1.0, share(value(&cubic, v).0, 1.0), turned];
                sums[s].take([w, self.stay], lengths, (&place, &grown));
            }
            let (beside, right) = (&crowd.beside, &mut sums[s].right);
            let length = cubic.iter().zip(beside).map(|(c, b)| c * b).sum();
            right[0] -= beside[0];
            right[1] += share(length, beside[0]);
            right[2] += turned * beside[0];
            let grown = lengths.parts[part].sum(beside);
            right[LENGTHS..].iter_mut().zip(grown).for_each(|(right, grown)| *right -= grown);
        }
        sums
    }

    /// The points of every part; the sums take what they are off.
    fn crowds(&self, spread: &Spread, lengths: &Growths, sums: &mut [Sums]) -> Vec<Crowd> {
        let (space, at, mut guess) = (&self.spline.space, &spread.lengths.at, 0);
        let mut crowds = vec![Crowd::default(); lengths.parts.len()];
        for (m, (point, &t)) in self.located.points.iter().zip(&self.located.parameters).enumerate() {
            let t = if space.breaks.closed && t < at[0] { t + space.breaks.end } else { t };
            place(at, t, &mut guess);
            let s = guess / PARTS;
            let u = (t - space.spans[s].middle) / space.spans[s].half;
            let [on, first, _] = taylor::<{ HIGHEST + 1 }>(&lengths.pieces[s], u);
            let (rest, speed, w) = (point - on, first.norm(), self.located.weight(m));
            let beside = if speed > 0.0 { rest.dot(&first) / speed } else { rest.x };
            crowds[guess].take((t - at[guess]) / (at[guess + 1] - at[guess]), w, beside);
            sums[s].pull(u, rest * w);
        }
        crowds
    }
}
