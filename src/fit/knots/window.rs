//! Part of a curve with many knots, looked at alone: what changing a few of them does is decided near them.

use super::breaks::Breaks;
use super::free_knots::Located;

/// So many knots beside those that change are looked at, on either side. Between even knots what a coefficient of a
/// cubic spline changes by falls to .27 from one to the next, so that beyond them .0004 of it is left.
const BESIDE: usize = 6;

/// Some knots changed, and those beside them, as an open curve of its own.
#[derive(Clone, Debug)]
pub(super) struct Window {
    /// The part as it was.
    pub(super) before: Breaks,
    /// The part as it is to be.
    pub(super) after: Breaks,
    /// Its points.
    pub(super) data: Located,
    /// Where it begins on the whole curve.
    start: f64,
    /// The whole curve without the knots inside the part.
    rest: Breaks,
}

impl Window {
    /// What differs between two lists of knots, and what is beside it; `None` where that is half of the curve, which
    /// may as well be looked at whole. O(M + K).
    #[inline(never)]
    pub(super) fn of(before: &Breaks, after: &Breaks, data: &Located) -> Option<Self> {
        let count = before.len();
        let (ahead, behind) = alike(before, after);
        if 2 * (count - ahead - behind + 2 * BESIDE) > count || !before.straight.is_empty() {
            return None;
        }
        let (first, last) = (ahead.checked_sub(BESIDE + 1), count - behind + BESIDE);
        let (start, stop) = if before.closed {
            (before.at[first.unwrap_or(ahead + count - BESIDE - 1)], before.at[last % count])
        } else {
            (first.map_or(0.0, |k| before.at[k]), before.at.get(last).copied().unwrap_or(before.end))
        };
        let length = from(before, start, stop);
        let mut rest = before.bare();
        for (&t, &m) in before.at.iter().zip(&before.multiplicity) {
            if !is_inside(from(before, start, t), length) {
                rest.insert(rest.len(), t, m);
            }
        }
        let data = within(data, before, start, length);
        Some(Self {
            before: part(before, start, length),
            after: part(after, start, length),
            data,
            start,
            rest,
        })
    }

    /// The knots of the whole curve, with these in the part.
    #[inline(never)]
    pub(super) fn whole(&self, part: &Breaks) -> Breaks {
        let mut whole = self.rest.clone();
        for (t, &m) in part.at.iter().zip(&part.multiplicity) {
            let t = whole.wrapped(self.start + t);
            whole.insert(whole.at.partition_point(|&other| other < t), t, m);
        }
        whole
    }
}

/// How many knots two lists have in common at their beginnings, and how many of the others at their ends.
fn alike(one: &Breaks, other: &Breaks) -> (usize, usize) {
    let same = |i: usize, j: usize| one.at[i] == other.at[j] && one.multiplicity[i] == other.multiplicity[j];
    let most = one.len().min(other.len());
    let ahead = (0..most).take_while(|&i| same(i, i)).count();
    let behind = (1..=most - ahead).take_while(|i| same(one.len() - i, other.len() - i)).count();
    (ahead, behind)
}

/// How far behind `start` a parameter is, round the seam of a closed curve.
fn from(breaks: &Breaks, start: f64, t: f64) -> f64 {
    let behind = t - start;
    if breaks.closed && behind < 0.0 { behind + breaks.end } else { behind }
}

/// The ends of a part are not inside it.
fn is_inside(t: f64, length: f64) -> bool {
    t > 0.0 && t < length
}

/// The knots inside a part.
#[inline(never)]
fn part(breaks: &Breaks, start: f64, length: f64) -> Breaks {
    let mut part = Breaks { closed: false, end: length, ..breaks.bare() };
    // Those before it come round the seam.
    let turn = breaks.at.partition_point(|&t| t < start);
    for i in 0..breaks.len() {
        let k = (turn + i) % breaks.len();
        let t = from(breaks, start, breaks.at[k]);
        if is_inside(t, length) {
            part.insert(part.len(), t, breaks.multiplicity[k]);
        }
    }
    part
}

/// The points of a part.
fn within(data: &Located, breaks: &Breaks, start: f64, length: f64) -> Located {
    let mut part = Located::default();
    for (m, &t) in data.parameters.iter().enumerate() {
        let t = from(breaks, start, t);
        if t < 0.0 || t > length {
            continue;
        }
        part.points.push(data.points[m]);
        part.parameters.push(t);
        if !data.weights.is_empty() {
            part.weights.push(data.weights[m]);
        }
    }
    part
}

#[cfg(test)]
mod tests {
    use super::{Breaks, Located, Window};
    use crate::fit::knots::free_knots::FreeKnots;
    use crate::numerics::Point;

    fn wavy(closed: bool) -> (Breaks, Located) {
        let breaks = Breaks::even(3, closed, 40.0, 40);
        let parameters: Vec<f64> = (0..400).map(|i| 0.1 * f64::from(i)).collect();
        let points = parameters.iter().map(|t| {
            let angle = core::f64::consts::TAU * t / 40.0;
            Point::new(
                libm::cos(angle) + 0.1 * libm::sin(9.0 * angle),
                libm::sin(angle) + 0.1 * libm::cos(13.0 * angle),
            )
        });
        (breaks, Located { points: points.collect(), parameters, weights: Vec::new() })
    }

    #[test]
    fn a_part_put_back_unchanged_gives_the_knots_that_there_were() {
        for closed in [false, true] {
            let (breaks, data) = wavy(closed);
            for k in 0..breaks.len() {
                let fewer = breaks.without(&[k]);
                let window = Window::of(&breaks, &fewer, &data).expect("one knot of forty is a small part");
                assert_eq!(window.whole(&window.before).multiplicity.len(), breaks.len());
                for (before, after) in [(&breaks, &window.before), (&fewer, &window.after)] {
                    let whole = window.whole(after);
                    assert_eq!(whole.multiplicity, before.multiplicity, "{k}");
                    for (t, expected) in whole.at.iter().zip(&before.at) {
                        assert!((t - expected).abs() < 1e-13, "{k}: {t} for {expected}");
                    }
                }
            }
        }
    }

    #[test]
    fn what_a_knot_is_worth_is_known_from_the_part_to_a_twentieth() {
        for closed in [false, true] {
            let (breaks, data) = wavy(closed);
            let squares = |breaks: &Breaks, data: &Located| FreeKnots::new(breaks.clone(), data).squares();
            let now = squares(&breaks, &data);
            for k in 0..breaks.len() {
                let fewer = breaks.without(&[k]);
                let window = Window::of(&breaks, &fewer, &data).expect("one knot of forty is a small part");
                let whole = squares(&fewer, &data) - now;
                let part = squares(&window.after, &window.data) - squares(&window.before, &window.data);
                assert!((part - whole).abs() < 0.05 * whole, "{k}: {part} for {whole}");
            }
        }
    }

    #[test]
    fn a_change_of_much_of_the_curve_is_not_looked_at_alone() {
        let (breaks, data) = wavy(true);
        let fewer = breaks.without(&Vec::from_iter(0..10));
        assert!(Window::of(&breaks, &fewer, &data).is_none());
    }
}
