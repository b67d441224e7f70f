//! One question after the nearest point, asked of one arc after another.
//!
//! With e = r − place and φ = |e|²/2,
//!
//! ```text
//! φ′ = e·r′    φ″ = |r′|² + e·r″    φ‴ = 3r′·r″ + e·r‴    φ⁗ = 3|r″|² + 4r′·r‴ + e·r⁗,   r⁗ = −rate·r″
//! ```
//!
//! so φ⁗ ≥ −(4|r′||r‴| + |rate||e||r″|), and Taylor's formula bounds φ from below on any arc.

use crate::curve::piece::{Jet, Piece};
use crate::numerics::Point;
use crate::numerics::plane::{dot, larger, norm, smaller, square};
use crate::numerics::roots::bracketed_root;

/// Halley's steps before an arc is halved instead.
const MOST_STEPS: usize = 8;
/// Steps below this share of a segment are most often the last: the error after them is of the order of their cube.
const SMALL_STEP: f64 = 1e-4;
/// Newton's steps up to this share of a segment are exact to rounding.
const LAST_STEP: f64 = 1e-9;
/// What Taylor's formula leaves of |e|², where it is a smaller share than this, has lost digits that another look at
/// the curve has: of a place on a branch 1e-12 away from another the wrong one would be taken.
const CANCELLED: f64 = 1e-3;
/// The most intervals that are open at once.
const STACK: usize = 64;
/// Intervals below this share of a segment are not halved any more.
const LEAST_HALF: f64 = 1e-9;

/// What bounds φ⁗ from below on an arc: −φ⁗ ≤ constant + slope·|e|.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stiffness {
    pub(super) constant: f64,
    pub(super) slope: f64,
    /// A bound of the arc's length.
    pub(super) reach: f64,
}

/// An arc as seen from a place.
pub(super) trait Near {
    /// φ and its derivatives at y.
    fn slopes(&self, y: f64) -> Slopes;

    /// What bounds φ⁗ between lo and hi.
    fn stiffness(&self, lo: f64, hi: f64) -> Stiffness;
}

/// A piece of a plane curve as seen from a place.
pub(super) struct View<'a> {
    pub(super) piece: &'a Piece,
    pub(super) place: Point,
}

impl Near for View<'_> {
    #[inline(never)]
    fn slopes(&self, y: f64) -> Slopes {
        Slopes::new(&self.piece.jet(y), self.place)
    }

    fn stiffness(&self, lo: f64, hi: f64) -> Stiffness {
        Stiffness::new(self.piece, lo, hi, self.piece.bend(lo, hi))
    }
}

impl Stiffness {
    #[inline(never)]
    pub(super) fn new(piece: &Piece, lo: f64, hi: f64, bend: f64) -> Self {
        let fastest = norm(piece.jet(0.5 * (lo + hi)).first) + 0.5 * (hi - lo) * bend;
        Self {
            constant: 4.0 * fastest * piece.jolt(lo, hi),
            slope: piece.fourth(bend),
            reach: fastest * (hi - lo),
        }
    }

    /// A bound of −φ⁗ where the place is `distance` away from some point of the arc.
    #[inline]
    fn quartic(&self, distance: f64) -> f64 {
        self.constant + self.slope * (distance + self.reach)
    }
}

/// |e|² and the first three derivatives of φ.
pub(super) struct Slopes {
    pub(super) square: f64,
    pub(super) first: f64,
    pub(super) second: f64,
    pub(super) third: f64,
}

impl Slopes {
    #[inline]
    fn new(jet: &Jet, place: Point) -> Self {
        let e = jet.position - place;
        Self {
            square: square(e),
            first: dot(e, jet.first),
            second: square(jet.first) + dot(e, jet.second),
            third: 3.0 * dot(jet.first, jet.second) + dot(e, jet.third),
        }
    }

    /// Halley's step, backwards: a place with three derivatives is worth the third order.
    #[inline(always)]
    fn halley(&self) -> f64 {
        self.first * self.second / (self.second * self.second - 0.5 * self.first * self.third)
    }

    /// Those of a cubic a step further, without another look at it, from the fourth to the sixth derivative of φ.
    #[inline(always)]
    fn after(&self, u: f64, [fourth, fifth, sixth]: [f64; 3]) -> Self {
        let &Self { square, first, second, third } = self;
        let (u2, u3, u4, u5, u6) = (u * 0.5, u * (1.0 / 3.0), u * 0.25, u * 0.2, u * (1.0 / 6.0));
        let rest = third + u4 * (fourth + u5 * (fifth + u6 * sixth));
        Self {
            square: square + 2.0 * u * (first + u2 * (second + u3 * rest)),
            first: first + u * (second + u2 * (third + u3 * (fourth + u4 * (fifth + u5 * sixth)))),
            second: second + u * (third + u2 * (fourth + u3 * (fifth + u4 * sixth))),
            third: third + u * (fourth + u2 * (fifth + u3 * sixth)),
        }
    }

    /// Whether Newton's step is exact to rounding from here, and so small that what it gains needs no other look.
    #[inline]
    fn is_settled(&self) -> bool {
        self.first.abs() <= LAST_STEP * self.second.abs()
    }

    /// φ(u) − φ(0) − φ′(0)u ≥ (u²/2)·this, for every u between 0 and `u`'s values at both ends.
    #[inline]
    fn room(&self, u: f64, quartic: f64) -> f64 {
        self.second + u * (self.third / 3.0 - u * quartic / 12.0)
    }
}

/// A place and what is the nearest to it so far.
pub(super) struct Question {
    pub(super) place: Point,
    /// The least distance so far, plus the slack.
    pub(super) reach: f64,
    /// Its square.
    pub(super) reach_squared: f64,
    slack: f64,
    distance: f64,
    piece: usize,
    y: f64,
}

impl Question {
    pub(super) fn new(place: Point, slack: f64) -> Self {
        let far = f64::INFINITY;
        Self { place, reach: far, reach_squared: far, slack, distance: far, piece: usize::MAX, y: 0.0 }
    }

    /// The piece and the y of the answer.
    pub(super) fn found(&self) -> (usize, f64) {
        (self.piece, self.y)
    }

    /// Takes a point of the curve into account.
    ///
    /// The answer is the first point, by parameter, of those within the slack of the least distance.
    #[inline(never)]
    fn offer(&mut self, distance: f64, piece: usize, y: f64) {
        if distance + self.slack < self.reach {
            self.reach = distance + self.slack;
            self.reach_squared = self.reach * self.reach;
        }
        let earlier = piece < self.piece || (piece == self.piece && y < self.y);
        if distance <= self.reach && (earlier || self.distance > self.reach) {
            (self.distance, self.piece, self.y) = (distance, piece, y);
        }
    }

    /// Halley's method on the arc from a guess; false where it does not prove that the arc holds nothing nearer.
    #[inline]
    pub(super) fn ask_arc(
        &mut self,
        piece: &Piece,
        index: usize,
        stiffness: &Stiffness,
        lo: f64,
        hi: f64,
        guess: f64,
    ) -> bool {
        let jet = piece.inline_jet(guess);
        let from = Slopes::new(&jet, self.place);
        let (y, at) = if piece.is_cubic() {
            let (y, at) = settle_cubic(&jet, &from, lo, hi, guess);
            if at.square > CANCELLED * from.square {
                (y, at)
            } else {
                (y, View { piece, place: self.place }.slopes(y))
            }
        } else {
            settle(&View { piece, place: self.place }, from, lo, hi, guess)
        };
        // Newton's step from here is exact to rounding; what it gains is known without another look at the curve.
        let last = at.first / at.second;
        let inside = y > lo && y < hi && at.is_settled();
        let distance = larger(0.0, at.square - if inside { last * at.first } else { 0.0 }).sqrt();
        self.offer(distance, index, if inside { smaller(larger(y - last, lo), hi) } else { y });
        // At an end the slope must point out of the arc; inside it is zero to rounding.
        let outward = if y <= lo { at.first >= 0.0 } else { at.first <= 0.0 };
        let quartic = stiffness.quartic(distance);
        (inside || outward && (y <= lo || y >= hi))
            && at.room(lo - y, quartic) >= 0.0
            && at.room(hi - y, quartic) >= 0.0
    }
}

/// Halley's method on an arc of a cubic: φ is a polynomial of degree 6, so no other look at the curve is needed.
#[inline(always)]
fn settle_cubic(jet: &Jet, from: &Slopes, lo: f64, hi: f64, guess: f64) -> (f64, Slopes) {
    let (least, most) = (lo - guess, hi - guess);
    let fourth = 3.0 * square(jet.second) + 4.0 * dot(jet.first, jet.third);
    let (fifth, sixth) = (10.0 * dot(jet.second, jet.third), 10.0 * square(jet.third));
    let rest = [fourth, fifth, sixth];
    let mut u = 0.0;
    let mut at = Slopes { ..*from };
    for _ in 0..MOST_STEPS {
        let next = u - at.halley();
        let next = if next > least { next } else { least };
        let next = if next < most { next } else { most };
        if next == u {
            break;
        }
        u = next;
        at = from.after(u, rest);
        if at.is_settled() {
            break;
        }
    }
    let y = if u >= most { hi } else { smaller(guess + u, hi) };
    (if u <= least { lo } else { larger(y, lo) }, at)
}

/// Halley's method on an arc of any other piece.
#[inline(never)]
fn settle(arc: &View<'_>, from: Slopes, lo: f64, hi: f64, guess: f64) -> (f64, Slopes) {
    let (mut y, mut at) = (guess, from);
    for _ in 0..MOST_STEPS {
        let next = smaller(hi, larger(lo, y - at.halley()));
        let moved = (next - y).abs();
        if moved == 0.0 {
            break;
        }
        y = next;
        at = arc.slopes(y);
        if moved < SMALL_STEP && at.is_settled() {
            break;
        }
    }
    (y, at)
}

/// Asks an arc by halving: an interval is dropped where Taylor's formula proves it farther than the best so far, and
/// solved where φ is convex on it.
#[cold]
pub(super) fn search(arc: &dyn Near, index: usize, question: &mut Question, lo: f64, hi: f64) {
    let mut stack = [(0.0, 0.0); STACK];
    stack[0] = (lo, hi);
    let mut open = 1;
    for end in [lo, hi] {
        question.offer(arc.slopes(end).square.sqrt(), index, end);
    }
    while open > 0 {
        open -= 1;
        let (lo, hi) = stack[open];
        let (middle, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
        let at = arc.slopes(middle);
        let distance = at.square.sqrt();
        question.offer(distance, index, middle);
        let quartic = arc.stiffness(lo, hi).quartic(distance);
        let room = smaller(smaller(at.room(half, quartic), at.room(-half, quartic)), 0.0);
        let least = at.square - 2.0 * at.first.abs() * half + room * half * half;
        let wanted = larger(0.0, question.reach - 2.0 * question.slack);
        if least >= wanted * wanted {
            continue;
        }
        if at.second > half * (at.third.abs() + 0.5 * half * quartic) {
            solve(arc, index, question, lo, hi);
        } else if half > LEAST_HALF && open + 2 <= STACK {
            stack[open] = (middle, hi);
            stack[open + 1] = (lo, middle);
            open += 2;
        }
    }
}

/// The minimum of a convex φ.
fn solve(arc: &dyn Near, index: usize, question: &mut Question, lo: f64, hi: f64) {
    let mut slope = |y: f64| {
        let at = arc.slopes(y);
        (at.first, at.second)
    };
    let y = if slope(lo).0 >= 0.0 {
        lo
    } else if slope(hi).0 <= 0.0 {
        hi
    } else {
        bracketed_root(lo, hi, true, 0.5 * (lo + hi), &mut slope)
    };
    question.offer(arc.slopes(y).square.sqrt(), index, y);
}
