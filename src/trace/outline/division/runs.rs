//! Where a contour is straight.

use super::{Anchor, Divider};
use crate::numerics::Point;
use crate::numerics::plane::{cross, square};
use crate::trace::samples::{Line, Moments, line_through, unit};

/// A straight run of a contour.
#[derive(Debug)]
pub(super) struct Run {
    pub(super) first: isize,
    pub(super) last: isize,
    pub(super) line: Line,
}

/// Straight runs that are being looked for.
#[derive(Debug)]
pub(super) struct Search {
    /// What they are in.
    pub(super) ends: (Anchor, Anchor),
    first: isize,
    last: isize,
    /// Whether there are corners at both ends.
    pub(super) corners: bool,
    /// The place that is next.
    at: isize,
    pub(super) runs: Vec<Run>,
}

impl Search {
    /// From one place to another.
    pub(super) fn new(ends: (Anchor, Anchor), [first, last]: [isize; 2], corners: bool) -> Self {
        Self { ends, first, last, corners, at: first, runs: Vec::new() }
    }
}

impl Divider<'_> {
    /// Goes on looking for straight runs for about as many places as there is room for; whether these were all.
    pub(super) fn search_on(&self, search: &mut Search, room: &mut isize) -> bool {
        let &mut Search { first, last, corners, .. } = search;
        let least = self.samples.steps(self.rule.least_run).max(4);
        let most = (self.samples.len() as isize / 12).min(5 * least).max(least);
        let near = self.samples.steps(1.2);
        let (runs, mut i) = (&mut search.runs, search.at);
        while i + least <= last {
            if *room <= i - search.at {
                *room -= i - search.at;
                search.at = i;
                return false;
            }
            let Some(mut moments) = self.straight(i, i + least, None) else {
                i += 1;
                continue;
            };
            // Doubling and halving: the longest run from here.
            let (mut good, mut step, mut grows) = (i + least, least, true);
            while step > 0 {
                let wish = good + step;
                let longer = if wish <= last { self.straight(i, wish, Some((good, &moments))) } else { None };
                grows &= longer.is_some();
                if let Some(longer) = longer {
                    (good, moments) = (wish, longer);
                }
                step = if grows { 2 * step } else { step / 2 };
            }
            let trim = (good - i) / 8;
            let core = self.samples.stretch(i + trim, good - trim);
            let line = line_through(core);
            if sagitta(core, &line).abs() < 0.3 * self.rule.straight {
                // The ends of the longest run lean into what follows.
                let fits = |i: isize| line.offset(self.samples.at(i)).abs() < 0.5 * self.rule.straight;
                let (mut from, mut to) = (i, good);
                while from < i + trim && !fits(from) {
                    from += 1;
                }
                while to > good - trim && !fits(to) {
                    to -= 1;
                }
                // On a curve the contour is straight for a while by chance; beside a corner there is nothing else to go
                // by.
                let beside = corners && (from - first <= near || last - to <= near);
                if beside || to - from >= most {
                    runs.push(Run { first: from, last: to, line });
                }
                i = good + 1;
            } else {
                i += ((good - i) / 4).max(1);
            }
        }
        *room -= i - search.at;
        true
    }

    /// The moments of a stretch, if it is straight; those of its places up to one may be known.
    #[inline(never)]
    fn straight(&self, first: isize, last: isize, known: Option<(isize, &Moments)>) -> Option<Moments> {
        // Where all are near a line, the middle is not twice as far from the chord.
        let place = |i: isize| self.samples.at(i);
        let (start, middle) = (place(first), place(first + (last + 1 - first) / 2));
        let chord = place(last) - start;
        let bend = cross(chord, middle - start);
        if bend * bend > 4.0 * self.rule.straight * self.rule.straight * square(chord) {
            return None;
        }
        let points = self.samples.stretch(first, last);
        let moments = match known {
            Some((end, moments)) => moments.with(&points[(end + 1 - first) as usize..]),
            None => Moments::of(points),
        };
        // Where it is not one line, most often its last places say so.
        moments.is_line(points, self.rule.straight).then_some(moments)
    }

    /// Whether a stretch is one line.
    pub(super) fn is_line(&self, start: Anchor, end: Anchor) -> bool {
        let gap = self.samples.steps(self.rule.gap);
        let direction = unit(end.point - start.point);
        let line = Line { middle: start.point, direction };
        let (first, last) = (start.index + gap, end.index - gap);
        if end.index - start.index >= self.longest * 2 {
            return false;
        }
        let is_off = |i: isize| line.offset(self.samples.at(i)).abs() > 1.5 * self.rule.straight;
        if (first..=last).any(is_off) {
            return false;
        }
        let places = self.samples.stretch(first, last);
        last - first < 6 || sagitta(places, &line_through(places)).abs() < 0.4 * self.rule.straight
    }
}

/// How far the middle of some places bends away from the line through them, by least squares of a parabola.
fn sagitta(points: &[Point], line: &Line) -> f64 {
    let n = points.len() as f64;
    let (mut moment, mut fourth) = (0.0, 0.0);
    for (i, &p) in points.iter().enumerate() {
        let x = (i as f64 + 0.5) / n * 2.0 - 1.0;
        let bowl = x * x - 1.0 / 3.0;
        moment += bowl * line.offset(p);
        fourth += bowl * bowl;
    }
    moment / fourth
}
