//! Knot after knot taken away from a curve that keeps a tolerance, each in its neighbourhood. (D 13.19)
//!
//! What a knot more or less changes is decided near it. So the curve is fitted anew between knots a few pieces away,
//! where it stays what it was, and what the points are off elsewhere stays as well: the cost of a trial does not depend
//! on how long the curve is, and after each of them it keeps the tolerance.

mod stretch;
#[cfg(test)]
mod tests;

use self::stretch::Stretch;
use super::breaks::Breaks;
use super::combine::expressed;
use super::free_knots::Located;
use super::look::Piece;
use super::space::Space;
use super::spline::{Spline, derivative_of};
use super::stray::Leash;

/// Pieces beside the two at a knot that may move, first and then: what is off by little elsewhere is not to be used up.
const BESIDE: [usize; 2] = [1, 2];
/// How long a round goes on, in units of a pass over a point.
const A_ROUND: f64 = 1e5;
/// Knots that closed curves are left with.
const LEAST: usize = 4;
/// How many times as fast as any piece was a new one may be: where knots are at all but one parameter, what a speed
/// is made of has no digits left.
const FASTER: f64 = 10.0;
/// Where there is none before or after.
const NONE: usize = usize::MAX;

/// What becomes of a knot.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Change {
    /// It is gone.
    Gone,
    /// It and the next one are one, halfway between them.
    Joined,
    /// It counts so often.
    Counts(usize),
}

/// What is tried with all knots, one after the other.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Pass {
    /// Whether one can go, for as long as there are any.
    Removing,
    /// Whether corners can be smooth.
    Smoothing,
    /// Whether one can go, or be one with the next.
    Joining,
    Over,
}

/// A piece of the curve, with the knot that it begins with.
#[derive(Clone, Debug)]
struct Link {
    polynomial: Piece,
    /// How long it is.
    width: f64,
    /// How often its knot counts; an open curve's start is none.
    multiplicity: usize,
    /// Its points, and how far behind its start their feet are.
    points: Vec<(usize, f64)>,
    before: usize,
    after: usize,
    /// Whether nothing has changed near its knot since it was tried.
    settled: bool,
}

/// The curve as a chain of pieces, and how far the sweep is.
#[derive(Clone, Debug)]
pub(super) struct Sweep {
    links: Vec<Link>,
    /// The first piece, where it starts, and how many there are.
    head: usize,
    start: f64,
    count: usize,
    pass: Pass,
    /// The piece whose knot is next.
    next: usize,
    /// Whether anything has changed in this pass.
    changed: bool,
    /// The curve without its knots.
    bare: Breaks,
    tolerance: f64,
    leash: Leash,
    /// The cosine of the angle by which corners turn that stay; below −1 where none need.
    staying: f64,
    /// The largest speed by the parameter that a piece may have.
    fastest: f64,
}

impl Sweep {
    /// Begins with a curve of which no piece need be straight, and with its points, which keep a tolerance.
    #[inline(never)]
    pub(super) fn new(
        spline: &Spline,
        located: &Located,
        tolerance: f64,
        leash: Leash,
        staying: f64,
    ) -> Self {
        let space = &spline.space;
        let (breaks, pieces) = (&space.breaks, spline.pieces());
        let count = pieces.len();
        let around = if breaks.closed { [count - 1, 0] } else { [NONE; 2] };
        let mut links: Vec<Link> = Vec::with_capacity(count);
        for (s, (polynomial, span)) in pieces.into_iter().zip(&space.spans).enumerate() {
            let knot = if breaks.closed { Some(s) } else { s.checked_sub(1) };
            links.push(Link {
                polynomial,
                width: 2.0 * span.half,
                multiplicity: knot.map_or(0, |k| breaks.multiplicity[k]),
                points: Vec::new(),
                before: s.checked_sub(1).unwrap_or(around[0]),
                after: if s + 1 < count { s + 1 } else { around[1] },
                settled: false,
            });
        }
        for (m, (s, t)) in space.places(&located.parameters).enumerate() {
            let span = &space.spans[s];
            links[s].points.push((m, t - (span.middle - span.half)));
        }
        let start = space.spans[0].middle - space.spans[0].half;
        let bare = breaks.bare();
        let speed = |link: &Link| speed(&link.polynomial, 0.5 * link.width);
        let fastest = FASTER * links.iter().map(speed).fold(0.0, f64::max);
        let (pass, head, next, changed) = (Pass::Removing, 0, 0, false);
        Self { links, head, start, count, pass, next, changed, bare, tolerance, leash, staying, fastest }
    }

    /// A round; answers what was done in it, in units of a pass over a point, or nothing where the sweep is over.
    #[inline(never)]
    pub(super) fn step(&mut self, points: &Located) -> Option<f64> {
        let mut work = 0.0;
        while self.pass != Pass::Over && work < A_ROUND {
            if self.next == NONE {
                self.end_pass();
            } else {
                let knot = self.next;
                self.next = self.following(knot);
                work += 1.0 + self.look_at(knot, points);
            }
        }
        (work > 0.0).then_some(work)
    }

    /// The piece after one, up to the last.
    fn following(&self, link: usize) -> usize {
        let after = self.links[link].after;
        if after == self.head { NONE } else { after }
    }

    /// What is tried next.
    fn end_pass(&mut self) {
        self.pass = match self.pass {
            Pass::Removing if self.changed => Pass::Removing,
            Pass::Removing => Pass::Smoothing,
            Pass::Smoothing => {
                self.links.iter_mut().for_each(|link| link.settled = false);
                Pass::Joining
            }
            Pass::Joining | Pass::Over => Pass::Over,
        };
        (self.next, self.changed) = (self.head, false);
    }

    /// Whether there is a corner at a knot that is to stay.
    #[inline(never)]
    fn stays(&self, knot: usize) -> bool {
        let link = &self.links[knot];
        if link.before == NONE || link.multiplicity < self.bare.degree || self.staying < -1.0 {
            return false;
        }
        let [arriving, leaving] = [(link.before, 1.0), (knot, -1.0)]
            .map(|(piece, u)| derivative_of(&self.links[piece].polynomial, self.bare.degree, u, 1.0, 1));
        arriving.dot(&leaving) <= self.staying * arriving.norm() * leaving.norm()
    }

    /// Tries what the pass asks for; answers the work.
    fn look_at(&mut self, knot: usize, points: &Located) -> f64 {
        let Link { multiplicity, settled, .. } = self.links[knot];
        // The seam of a closed curve is where the chain begins: its knot stays for as long as it does.
        if self.links[knot].before == NONE || knot == self.head || self.stays(knot) {
            return 0.0;
        }
        let mut work = 0.0;
        let few = self.bare.closed && self.count <= LEAST;
        if self.pass == Pass::Smoothing {
            let smoother = (self.bare.smoothest..multiplicity).map(Change::Counts);
            let _ = smoother.into_iter().find(|change| self.tried(knot, *change, points, &mut work));
        } else if !settled && !few {
            self.links[knot].settled = true;
            let gone = self.tried(knot, Change::Gone, points, &mut work);
            let after = self.links[knot].after;
            let joins = self.pass == Pass::Joining && after != NONE && after != self.head;
            if !gone && joins && !self.stays(after) {
                self.tried(knot, Change::Joined, points, &mut work);
            }
        }
        work
    }

    /// Makes a change if the tolerance is kept; answers whether it was.
    #[inline(never)]
    fn tried(&mut self, knot: usize, change: Change, points: &Located, work: &mut f64) -> bool {
        BESIDE.iter().any(|&beside| {
            let Some(mut stretch) = Stretch::around(self, knot, beside, change, points) else { return false };
            let fits = stretch.fit(self.tolerance, self.leash) && stretch.is_steady(self.fastest);
            *work += stretch.work();
            if fits {
                self.take(&stretch, knot, change);
            }
            fits
        })
    }

    /// Puts a stretch in the place of the pieces that it was made of.
    #[inline(never)]
    fn take(&mut self, stretch: &Stretch, knot: usize, change: Change) {
        self.changed = true;
        if let Change::Counts(multiplicity) = change {
            self.links[knot].multiplicity = multiplicity;
            return self.set(stretch, &stretch.pieces);
        }
        let mut pieces = stretch.pieces.clone();
        pieces.remove(stretch.inside + 1);
        let Link { before, after, multiplicity, .. } = self.links[knot];
        self.links[before].after = after;
        if after != NONE {
            let next = &mut self.links[after];
            next.before = before;
            if change == Change::Joined {
                next.multiplicity = next.multiplicity.max(multiplicity);
            }
        }
        self.links[knot].points = Vec::new();
        self.count -= 1;
        // The next knot has had its turn with this one; the one after that sees the change.
        if self.next != NONE {
            self.next = self.following(self.next);
        }
        self.set(stretch, &pieces);
    }

    /// Gives some pieces the polynomials, widths and points of a stretch.
    #[inline(never)]
    fn set(&mut self, stretch: &Stretch, pieces: &[usize]) {
        for ((&link, polynomial), span) in
            pieces.iter().zip(stretch.spline.pieces()).zip(&stretch.spline.space.spans)
        {
            let link = &mut self.links[link];
            (link.polynomial, link.width, link.settled) = (polynomial, 2.0 * span.half, false);
            link.points.clear();
        }
        for (m, s, behind) in stretch.feet() {
            self.links[pieces[s]].points.push((m, behind));
        }
    }

    /// The curve, and its points at their feet.
    #[inline(never)]
    pub(super) fn swept(self, mut located: Located) -> (Spline, Located) {
        let mut breaks = self.bare;
        let (mut starts, mut order) = (Vec::with_capacity(self.count), Vec::with_capacity(self.count));
        let (mut at, mut link) = (self.start, self.head);
        while order.len() < self.count {
            let Link { width, multiplicity, points, after, .. } = &self.links[link];
            if *multiplicity > 0 {
                breaks.insert(breaks.len(), at, *multiplicity);
            }
            for (m, behind) in points {
                let t = breaks.wrapped(at + behind);
                located.parameters[*m] = if t < breaks.end { t } else { breaks.end };
            }
            starts.push(at);
            order.push(link);
            (at, link) = (at + width, *after);
        }
        let spline = expressed(Space::new(breaks), &|middle, _| {
            let s = starts.partition_point(|&start| start <= middle).max(1) - 1;
            let polynomial = &self.links[order[s]].polynomial;
            (polynomial.map(|c| c.x), polynomial.map(|c| c.y))
        });
        (spline, located)
    }
}

/// At most the speed anywhere on a piece that is twice `half` wide.
#[inline(never)]
fn speed(polynomial: &Piece, half: f64) -> f64 {
    let steps = polynomial.iter().enumerate();
    steps.map(|(k, c)| k as f64 * c.norm()).sum::<f64>() / half
}
