//! A stretch between corners on its way to be lines and cubics, in steps: one may be as long as the whole contour.

use super::runs::Run;
use super::{Anchor, Divider, middle_of};
use crate::numerics::plane::norm;
use crate::trace::outline::Piece;
use crate::trace::outline::cubic::{Cubic, Tangent};

/// What has become of a stretch so far.
#[derive(Debug)]
pub(super) struct Stretch {
    end: Anchor,
    runs: Vec<Run>,
    /// The straight run that is next, and where what is before it begins.
    next: usize,
    at: Anchor,
    /// The first of its pieces.
    first: usize,
    /// What is followed by cubics now.
    way: Option<Way>,
    /// Between which anchors it may be chords, when all its pieces are there.
    chords: Option<(Anchor, Anchor)>,
    /// Whether all its pieces are there.
    divided: bool,
}

/// A way that is being followed by cubics: those that there are, and where the next begins.
#[derive(Debug)]
pub(super) struct Way {
    start: Anchor,
    end: Anchor,
    at: Anchor,
    /// About how long the next one is.
    span: isize,
    pub(super) cubics: Vec<(Anchor, Cubic)>,
}

impl Stretch {
    /// With these straight runs in it; pieces may be chords of what is between two anchors.
    pub(super) fn new(
        (start, end): (Anchor, Anchor),
        runs: Vec<Run>,
        first: usize,
        chords: Option<(Anchor, Anchor)>,
    ) -> Self {
        Self { end, runs, next: 0, at: start, first, way: None, chords, divided: false }
    }
}

impl Divider<'_> {
    /// Goes on with a stretch for about as many places as there is room for; whether that was all of it.
    pub(super) fn divide_on(&mut self, stretch: &mut Stretch, room: &mut isize) -> bool {
        if !stretch.divided && !self.straight_on(stretch, room) {
            return false;
        }
        stretch.divided = true;
        stretch.chords.is_none_or(|ends| self.fewer_on(stretch.first, ends, &mut stretch.way, room))
    }

    /// The straight runs of a stretch, and curves between them.
    fn straight_on(&mut self, stretch: &mut Stretch, room: &mut isize) -> bool {
        let near = self.samples.steps(self.rule.gap + 1.2);
        let end = stretch.end;
        while let Some(run) = stretch.runs.get(stretch.next) {
            let (at, mut first) = (stretch.at, self.on_line(run.first, &run.line));
            if at.tangent == Tangent::Free && run.first - at.index <= near {
                first = at;
            } else if at.index < first.index && !self.curve_on(at, first, &mut stretch.way, room) {
                return false;
            }
            let mut last = self.on_line(run.last, &run.line);
            if end.tangent == Tangent::Free && end.index - run.last <= near {
                last = end;
            } else if let Some(next) = stretch.runs.get(stretch.next + 1)
                && next.first - run.last <= near + near
                && let Some(point) = run.line.meets(&next.line)
                && norm(point - self.samples.at(middle_of(run.last, next.first))) < 0.8
            {
                let index = middle_of(run.last, next.first);
                last = Anchor { index, point, tangent: Tangent::Free };
            }
            self.emit(first, Piece::Line);
            (stretch.at, stretch.next) = (last, stretch.next + 1);
        }
        stretch.at.index >= end.index || self.curve_on(stretch.at, end, &mut stretch.way, room)
    }

    /// Cubics from one anchor to the next: as few as the tolerance allows, of about equal deviation. Whether they are
    /// all there.
    fn curve_on(&mut self, from: Anchor, to: Anchor, way: &mut Option<Way>, room: &mut isize) -> bool {
        let cubics = self.follow(from, to, way, room);
        let done = cubics.is_some();
        self.emit_cubics(cubics.unwrap_or_default());
        done
    }

    /// The longest cubic that is near enough, then the next; all of them, when they are there.
    pub(super) fn follow(
        &self,
        from: Anchor,
        to: Anchor,
        way: &mut Option<Way>,
        room: &mut isize,
    ) -> Option<Vec<(Anchor, Cubic)>> {
        let span = self.samples.steps(4.0).max(4);
        let on = way.get_or_insert_with(|| Way { start: from, end: to, at: from, span, cubics: Vec::new() });
        while on.at.index < on.end.index {
            if *room <= 0 {
                return None;
            }
            let before = on.at.index;
            self.next_cubic(on);
            *room -= on.at.index - before;
        }
        way.take().map(|way| way.cubics)
    }

    /// The longest cubic from where the way has been followed to.
    fn next_cubic(&self, way: &mut Way) {
        let (at, end) = (way.at, way.end);
        let least = 4.min(end.index - at.index);
        let furthest = end.index.min(at.index + self.longest);
        let mut good = at.index + least;
        // The whole way is tried first, if it may not be too long.
        let whole = at.index == way.start.index || furthest - at.index <= 4 * way.span;
        let mut found = if whole { self.near(at, furthest, end) } else { None };
        if found.is_some() {
            good = furthest;
        } else {
            // Pieces are about as long as the one before: double from there, then halve.
            let mut step = way.span;
            let mut grows = true;
            while step > 0 {
                let wish = good + step;
                let longer = if wish < furthest { self.near(at, wish, end) } else { None };
                grows &= longer.is_some();
                if longer.is_some() {
                    (good, found) = (wish, longer);
                }
                step = if grows { 2 * step } else { step / 2 };
            }
        }
        way.span = ((good - at.index) / 2).max(least);
        let (next, fitted) = found.unwrap_or_else(|| self.fit(at, good, end));
        way.cubics.push((at, fitted.cubic));
        way.at = next;
    }
}
