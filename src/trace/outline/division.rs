//! A first outline: straight runs as lines, what is between them as few smooth cubics.

mod chords;
mod runs;

use self::runs::Run;
use super::corners::Corner;
use super::cubic::{Cubic, Fitted, Tangent};
use super::{Node, Outline, Piece};
use crate::numerics::Point;
use crate::numerics::plane::norm;
use crate::trace::samples::{Line, Samples};

/// How near is near enough, in pixels.
#[derive(Clone, Copy, Debug)]
pub(in crate::trace) struct DivisionRule {
    /// The contour next to a corner that is not looked at.
    pub(in crate::trace) gap: f64,
    /// The largest deviation of a straight run.
    pub(in crate::trace) straight: f64,
    /// The least length of a straight run that begins or ends at a corner; others are up to five times as long.
    pub(in crate::trace) least_run: f64,
    /// The largest deviation of a cubic, and its root mean square.
    pub(in crate::trace) most: f64,
    pub(in crate::trace) rms: f64,
    /// How much on both sides a tangent is taken from.
    pub(in crate::trace) reach: f64,
    /// Whether straight runs may be the chords that a curve was drawn by.
    pub(in crate::trace) chords: bool,
}

/// Where a stretch begins or ends.
#[derive(Clone, Copy, Debug)]
struct Anchor {
    index: isize,
    point: Point,
    tangent: Tangent,
}

struct Divider<'a> {
    samples: &'a Samples,
    rule: &'a DivisionRule,
    outline: &'a mut Outline,
    longest: isize,
}

/// Stretches between corners that are divided in one step.
const STRETCHES: usize = 512;

/// A contour that is being divided.
#[derive(Debug)]
pub(in crate::trace) struct Division {
    outline: Outline,
    /// The corner that is next.
    at: usize,
}

impl Division {
    pub(in crate::trace) fn new() -> Self {
        Self { outline: Outline { nodes: Vec::new(), pieces: Vec::new() }, at: 0 }
    }

    /// Some stretches more; the outline, when they were the last.
    ///
    /// # Cost
    ///
    /// O(places of the stretches), and O(nodes) at last.
    pub(in crate::trace) fn step(
        &mut self,
        samples: &Samples,
        corners: &[Corner],
        rule: &DivisionRule,
    ) -> Option<Outline> {
        let count = samples.len() as isize;
        let mut divider = Divider { samples, rule, outline: &mut self.outline, longest: count / 2 };
        let end = (self.at + STRETCHES).min(corners.len());
        for (corner, i) in corners[self.at..end].iter().zip(self.at + 1..) {
            let (next, wrap) = if i < corners.len() { (&corners[i], 0) } else { (&corners[0], count) };
            let start = Anchor { index: corner.index, point: corner.point, tangent: Tangent::Free };
            let end = Anchor { index: next.index + wrap, point: next.point, tangent: Tangent::Free };
            let gap = samples.steps(rule.gap);
            let runs = divider.runs(start.index + gap, end.index - gap, true);
            divider.stretch(start, end, &runs);
        }
        if corners.is_empty() {
            divider.round();
        }
        self.at = end;
        if end < corners.len() {
            return None;
        }
        let mut outline = core::mem::replace(self, Self::new()).outline;
        outline.align();
        Some(outline)
    }
}

/// Divides a contour at its corners, finds straight runs, and follows the rest by cubics.
pub(in crate::trace) fn divide(samples: &Samples, corners: &[Corner], rule: &DivisionRule) -> Outline {
    let mut division = Division::new();
    loop {
        if let Some(outline) = division.step(samples, corners, rule) {
            return outline;
        }
    }
}

/// Divides an open line at its corners as [`divide`] does. A straight piece that leads from its end to its start closes the outline.
pub(in crate::trace) fn divide_open(samples: &Samples, corners: &[Corner], rule: &DivisionRule) -> Outline {
    let mut outline = Outline { nodes: Vec::new(), pieces: Vec::new() };
    let last = samples.len() as isize - 1;
    let mut divider = Divider { samples, rule, outline: &mut outline, longest: last };
    let free = |index: isize, point: Point| Anchor { index, point, tangent: Tangent::Free };
    let mut start = free(0, samples.at(0));
    let ends = corners.iter().map(|corner| free(corner.index, corner.point));
    for end in ends.chain([free(last, samples.at(last))]) {
        let gap = samples.steps(rule.gap);
        let runs = divider.runs(start.index + gap, end.index - gap, true);
        divider.stretch(start, end, &runs);
        start = end;
    }
    divider.emit(start, Piece::Line);
    outline.align();
    outline
}

impl Divider<'_> {
    /// A contour without corners begins with a straight run, or where it is flattest.
    fn round(&mut self) {
        let count = self.samples.len() as isize;
        let reach = self.samples.steps(3.0).clamp(1, count / 4);
        let bend = |i: isize| self.samples.curvature(i, reach).abs();
        let (mut sharpest, mut flattest) = ((0, -1.0), (0, f64::MAX));
        for i in 0..count {
            let bend = bend(i);
            if bend > sharpest.1 {
                sharpest = (i, bend);
            }
            if bend < flattest.1 {
                flattest = (i, bend);
            }
        }
        let runs = self.runs(sharpest.0, sharpest.0 + count, false);
        if let Some(run) = runs.first() {
            let start = self.on_line(run.first, &run.line);
            let end = Anchor { index: start.index + count, ..start };
            self.straight_first(start, end, &runs);
        }
        let start = self.smooth(flattest.0, count / 4);
        let end = Anchor { index: start.index + count, ..start };
        if runs.is_empty() {
            self.curve(start, end);
        } else {
            self.fewer(0, start, end);
        }
    }

    fn smooth(&self, index: isize, room: isize) -> Anchor {
        let most = self.samples.steps(8.0 * self.rule.reach).min(room);
        let (point, direction) =
            self.samples.smoothed(index, self.samples.steps(self.rule.reach).min(room), most);
        Anchor { index, point, tangent: Tangent::Along(direction) }
    }

    fn on_line(&self, index: isize, line: &Line) -> Anchor {
        let point = line.nearest(self.samples.at(index));
        Anchor { index, point, tangent: Tangent::Along(line.direction) }
    }

    /// One stretch between two anchors, with the straight runs in it.
    fn stretch(&mut self, start: Anchor, end: Anchor, runs: &[Run]) {
        if start.tangent == Tangent::Free && self.is_line(start, end) {
            self.emit(start, Piece::Line);
            return;
        }
        let first = self.outline.len();
        self.straight_first(start, end, runs);
        self.fewer(first, start, end);
    }

    /// The straight runs of a stretch, and curves between them.
    fn straight_first(&mut self, start: Anchor, end: Anchor, runs: &[Run]) {
        let near = self.samples.steps(self.rule.gap + 1.2);
        let mut at = start;
        for (i, run) in runs.iter().enumerate() {
            let mut first = self.on_line(run.first, &run.line);
            if at.tangent == Tangent::Free && run.first - at.index <= near {
                first = at;
            } else if at.index < first.index {
                self.curve(at, first);
            }
            let mut last = self.on_line(run.last, &run.line);
            if end.tangent == Tangent::Free && end.index - run.last <= near {
                last = end;
            } else if let Some(next) = runs.get(i + 1)
                && next.first - run.last <= near + near
                && let Some(point) = run.line.meets(&next.line)
                && norm(point - self.samples.at(middle_of(run.last, next.first))) < 0.8
            {
                let index = middle_of(run.last, next.first);
                last = Anchor { index, point, tangent: Tangent::Free };
            }
            self.emit(first, Piece::Line);
            at = last;
        }
        if at.index < end.index {
            self.curve(at, end);
        }
    }

    fn emit(&mut self, anchor: Anchor, piece: Piece) {
        self.outline.nodes.push(Node {
            point: anchor.point,
            smooth: anchor.tangent != Tangent::Free,
            kept: false,
        });
        self.outline.pieces.push(piece);
    }

    /// Cubics from one anchor to the next: as few as the tolerance allows, of about equal deviation.
    fn curve(&mut self, start: Anchor, end: Anchor) {
        self.emit_cubics(self.greedy(start, end));
    }

    fn emit_cubics(&mut self, cubics: Vec<(Anchor, Cubic)>) {
        for (anchor, cubic) in cubics {
            self.emit(anchor, Piece::Cubic { leaving: cubic.leaving, arriving: cubic.arriving });
        }
    }

    /// The longest cubic that is near enough, then the next.
    fn greedy(&self, start: Anchor, end: Anchor) -> Vec<(Anchor, Cubic)> {
        let mut pieces = Vec::new();
        let mut at = start;
        let mut span = self.samples.steps(4.0).max(4);
        while at.index < end.index {
            let least = 4.min(end.index - at.index);
            let furthest = end.index.min(at.index + self.longest);
            let mut good = at.index + least;
            // The whole way is tried first, if it may not be too long.
            let whole = at.index == start.index || furthest - at.index <= 4 * span;
            let mut found = if whole { self.near(at, furthest, end) } else { None };
            if found.is_some() {
                good = furthest;
            } else {
                // Pieces are about as long as the one before: double from there, then halve.
                let mut step = span;
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
            span = ((good - at.index) / 2).max(least);
            let (next, fitted) = found.unwrap_or_else(|| self.fit(at, good, end));
            pieces.push((at, fitted.cubic));
            at = next;
        }
        pieces
    }

    /// The anchor at a place between two others: smooth, its tangent from its side of both.
    fn anchor(&self, index: isize, start: Anchor, end: Anchor) -> Anchor {
        if index >= end.index {
            return end;
        }
        let gap = |anchor: Anchor| {
            if anchor.tangent == Tangent::Free { self.samples.steps(self.rule.gap) } else { 0 }
        };
        let room = (index - start.index - gap(start)).min(end.index - index - gap(end));
        self.smooth(index, room.max(2))
    }

    /// A cubic from an anchor to the one at a place before `end`.
    #[inline(never)]
    fn fit(&self, start: Anchor, index: isize, end: Anchor) -> (Anchor, Fitted) {
        let next = self.anchor(index, start, end);
        let gap = |anchor: Anchor| {
            if anchor.tangent == Tangent::Free { self.samples.steps(self.rule.gap) } else { 1 }
        };
        let (first, last) = (start.index + gap(start), next.index - gap(next));
        let places = if first <= last { self.samples.stretch(first, last) } else { &[] };
        (next, Cubic::fit(start.point, next.point, places, [start.tangent, next.tangent]))
    }

    /// The same, if it is near enough.
    fn near(&self, start: Anchor, index: isize, end: Anchor) -> Option<(Anchor, Fitted)> {
        let near =
            |(_, fitted): &(Anchor, Fitted)| fitted.most <= self.rule.most && fitted.rms <= self.rule.rms;
        Some(self.fit(start, index, end)).filter(near)
    }
}

fn middle_of(first: isize, last: isize) -> isize {
    first + (last - first) / 2
}
