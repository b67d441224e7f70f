//! A first outline: straight runs as lines, what is between them as few smooth cubics.

mod chords;
mod runs;
mod stretch;

use self::runs::Search;
use self::stretch::Stretch;
use super::corners::Corner;
use super::cubic::{Cubic, Fitted, Tangent};
use super::{Node, Outline, Piece};
use crate::numerics::Point;
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

impl DivisionRule {
    /// Along a contour whose corners are not known: near enough for no stroke of a pixel to be cut off.
    pub(in crate::trace) const ALONG: Self =
        Self { gap: 0.0, straight: 0.06, least_run: 4.0, most: 0.12, rms: 0.06, reach: 1.0, chords: false };
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

/// Places that are divided in about one step: looked at for straight runs, and followed by cubics.
const PLACES: isize = 8192;

/// A contour that is being divided.
#[derive(Debug)]
pub(in crate::trace) struct Division {
    outline: Outline,
    /// The corner that is next.
    at: usize,
    /// What is between the one before and it: first its straight runs are looked for.
    search: Option<Search>,
    stretch: Option<Stretch>,
}

impl Division {
    pub(in crate::trace) fn new() -> Self {
        Self { outline: Outline::default(), at: 0, search: None, stretch: None }
    }

    /// Some places more; the outline, when they were the last.
    ///
    /// # Cost
    ///
    /// O(1), but for a contour without corners, whose flattest place is looked for at once: O(places). O(nodes) at
    /// last.
    pub(in crate::trace) fn step(
        &mut self,
        samples: &Samples,
        corners: &[Corner],
        rule: &DivisionRule,
    ) -> Option<Outline> {
        let count = samples.len() as isize;
        let mut divider = Divider { samples, rule, outline: &mut self.outline, longest: count / 2 };
        let mut room = PLACES;
        while self.at < corners.len().max(1) {
            if room <= 0 {
                return None;
            }
            if self.search.is_none() && self.stretch.is_none() {
                self.search = match corners.get(self.at) {
                    None => Some(divider.round()),
                    Some(corner) => {
                        let (next, wrap) =
                            corners.get(self.at + 1).map_or((&corners[0], count), |next| (next, 0));
                        let ends = [free(corner.index, corner.point), free(next.index + wrap, next.point)];
                        let search = divider.between(ends);
                        if search.is_none() {
                            room -= ends[1].index - ends[0].index;
                        }
                        search
                    }
                };
            }
            if let Some(mut search) = self.search.take() {
                if !divider.search_on(&mut search, &mut room) {
                    self.search = Some(search);
                    return None;
                }
                self.stretch = Some(divider.begin(search));
            }
            if let Some(mut stretch) = self.stretch.take()
                && !divider.divide_on(&mut stretch, &mut room)
            {
                self.stretch = Some(stretch);
                return None;
            }
            self.at += 1;
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

/// Divides an open line at its corners as [`divide`] does. A straight piece that leads from its end to its start closes
/// the outline.
pub(in crate::trace) fn divide_open(samples: &Samples, corners: &[Corner], rule: &DivisionRule) -> Outline {
    let mut outline = Outline::default();
    let last = samples.len() as isize - 1;
    let mut divider = Divider { samples, rule, outline: &mut outline, longest: last };
    let (mut start, mut room) = (free(0, samples.at(0)), isize::MAX);
    let ends = corners.iter().map(|corner| free(corner.index, corner.point));
    for end in ends.chain([free(last, samples.at(last))]) {
        if let Some(mut search) = divider.between([start, end]) {
            divider.search_on(&mut search, &mut room);
            divider.divide_on(&mut divider.begin(search), &mut room);
        }
        start = end;
    }
    divider.emit(start, Piece::Line);
    outline.align();
    outline
}

/// The same anchor after all places.
fn around(start: Anchor, count: isize) -> Anchor {
    Anchor { index: start.index + count, ..start }
}

/// A corner.
fn free(index: isize, point: Point) -> Anchor {
    Anchor { index, point, tangent: Tangent::Free }
}

impl Divider<'_> {
    /// A contour without corners begins with a straight run, or where it is flattest.
    fn round(&self) -> Search {
        let count = self.samples.len() as isize;
        let reach = self.samples.steps(3.0).clamp(1, count / 4);
        let (mut sharpest, mut flattest) = ((0, -1.0), (0, f64::MAX));
        for i in 0..count {
            if self.samples.bends_between(i, reach, [flattest.1, sharpest.1]) {
                continue;
            }
            let bend = self.samples.curvature(i, reach).abs();
            if bend > sharpest.1 {
                sharpest = (i, bend);
            }
            if bend < flattest.1 {
                flattest = (i, bend);
            }
        }
        let start = self.smooth(flattest.0, count / 4);
        Search::new((start, around(start, count)), [sharpest.0, sharpest.0 + count], false)
    }

    /// The stretch whose straight runs are known.
    fn begin(&self, Search { ends, runs, corners, .. }: Search) -> Stretch {
        match runs.first() {
            _ if corners => Stretch::new(ends, runs, self.outline.len(), Some(ends)),
            None => Stretch::new(ends, runs, 0, None),
            Some(run) => {
                let start = self.on_line(run.first, &run.line);
                Stretch::new((start, around(start, self.samples.len() as isize)), runs, 0, Some(ends))
            }
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

    /// What is between two corners; nothing is left of it where it is one line.
    fn between(&mut self, [start, end]: [Anchor; 2]) -> Option<Search> {
        if self.is_line(start, end) {
            self.emit(start, Piece::Line);
            return None;
        }
        let gap = self.samples.steps(self.rule.gap);
        Some(Search::new((start, end), [start.index + gap, end.index - gap], true))
    }

    fn emit(&mut self, anchor: Anchor, piece: Piece) {
        let smooth = anchor.tangent != Tangent::Free;
        self.outline.push(Node { point: anchor.point, smooth, kept: false }, piece);
    }

    fn emit_cubics(&mut self, cubics: Vec<(Anchor, Cubic)>) {
        for (anchor, cubic) in cubics {
            self.emit(anchor, Piece::Cubic { leaving: cubic.leaving, arriving: cubic.arriving });
        }
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
