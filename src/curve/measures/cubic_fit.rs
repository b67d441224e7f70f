//! One cubic Bézier curve for one arc.
//!
//! The cubic shares the ends and the tangent directions of the arc; the lengths of its two handles are free, and are
//! chosen so that it crosses the arc at two places, which for a short arc makes the three lobes of the error equal:
//! s²(1 − s)²((s − ½)² − x) is least for x = 0.026 446. The error is of the sixth order in the width.
//!
//! Around an inflection there may be no such lengths, because there the handles hardly move the cubic sideways. The
//! squares of its distances from the arc still have a least sum, which is far below what handles of a third of the
//! derivatives leave.

use crate::curve::piece::{Jet, Piece};
use crate::numerics::dense::damped_step;
use crate::numerics::plane::{cross, dot, norm, square};
use crate::numerics::{Point, Vector};

/// Where the cubic crosses the arc: ½ ± √0.026 446.
const CROSSINGS: [f64; 2] = [0.337_377, 0.662_623];
/// Where the three lobes of the error are highest.
const LOBES: [f64; 3] = [0.1823, 0.5, 0.8177];
/// The crossings between the lobes.
const PLACES: [f64; 5] = [LOBES[0], CROSSINGS[0], LOBES[1], CROSSINGS[1], LOBES[2]];
/// The most steps of Newton's method, and of Levenberg and Marquardt's.
const CROSSING_STEPS: usize = 12;
const NEARING_STEPS: usize = 16;
/// Handles are exact to this share of the tolerance, which does not change how far the cubic is.
const SHARE: f64 = 0.01;

/// A cubic near an arc.
pub(super) type Cubic = [Point; 4];

/// The point of a cubic.
pub(super) fn cubic_at(cubic: &Cubic, s: f64) -> Point {
    let z = 1.0 - s;
    let (start, end) = (cubic[0] * z + cubic[1] * (3.0 * s), cubic[2] * (3.0 * z) + cubic[3] * s);
    start * (z * z) + end * (s * s)
}

/// The cubic with the ends and the end derivatives of the arc.
pub(super) fn hermite_cubic(piece: &Piece, lo: f64, hi: f64) -> Cubic {
    let (from, to, third) = (piece.jet(lo), piece.jet(hi), (hi - lo) / 3.0);
    [from.position, from.position + from.first * third, to.position - to.first * third, to.position]
}

/// A cubic that may stand for an arc.
pub(super) struct Candidate {
    pub(super) cubic: Cubic,
    /// The places of the arc that are nearest to the cubic's points at 0, the two of `CROSSINGS`, and 1.
    feet: [f64; 4],
    /// The distance at the three lobes of the error: an estimate of the largest.
    pub(super) off: f64,
}

/// The cubic that crosses the arc twice; where there is none, the one whose squared distances are least.
pub(super) fn fit(piece: &Piece, lo: f64, hi: f64, tolerance: f64) -> Candidate {
    let mut handles = Handles::new(piece, lo, hi, tolerance);
    if !handles.cross(piece) {
        handles = Handles::new(piece, lo, hi, tolerance);
        handles.come_near(piece);
    }
    let [_, low, _, high, _] = handles.feet;
    let mut candidate = Candidate { cubic: handles.cubic(), feet: [lo, low, high, hi], off: 0.0 };
    for s in LOBES {
        candidate.off = candidate.off.max(norm(candidate.foot(piece, s).offset));
    }
    candidate
}

impl Candidate {
    /// Where the arc begins and ends.
    pub(super) fn ends(&self) -> [f64; 2] {
        [self.feet[0], self.feet[3]]
    }

    /// Where on the arc the cubic's point at s is.
    pub(super) fn foot(&self, piece: &Piece, s: f64) -> Foot {
        let (point, ends) = (cubic_at(&self.cubic, s), self.ends());
        let near = Foot::of(piece, point, self.near(s), ends);
        Foot::of(piece, point, near.at, ends)
    }

    /// About where that is: the polynomial through what is known.
    fn near(&self, s: f64) -> f64 {
        let [one, two] = CROSSINGS;
        let [from, to] = [s, 1.0 - s];
        let [past, left] = [s - one, s - two];
        // Lagrange's weights; the crossings lie evenly about the middle, so that two denominators serve for four.
        let (outer, inner) = (one * two, one * two * (two - one));
        let ends = (self.feet[0] * to + self.feet[3] * from) * (past * left / outer);
        ends + (self.feet[2] * past - self.feet[1] * left) * (from * to / inner)
    }
}

/// A cubic with the ends and the tangent directions of an arc, the lengths of whose handles are free.
struct Handles {
    ends: [Point; 2],
    directions: [Vector; 2],
    lengths: [f64; 2],
    /// Longer handles make loops.
    most: [f64; 2],
    /// About where on the arc the cubic's points at `PLACES` are.
    feet: [f64; 5],
    limits: [f64; 2],
    /// A step as short as this is the last one.
    enough: f64,
}

impl Handles {
    /// Handles of a third of the derivatives.
    fn new(piece: &Piece, lo: f64, hi: f64, tolerance: f64) -> Self {
        let (from, to, width) = (piece.jet(lo), piece.jet(hi), hi - lo);
        let chord = norm(to.position - from.position);
        let (leaving, first) = direction(from.first * width, from.second * (width * width), chord);
        let (arriving, last) = direction(to.first * width, to.second * (-width * width), chord);
        Self {
            ends: [from.position, to.position],
            directions: [leaving, arriving],
            lengths: [first / 3.0, last / 3.0],
            most: [first * (4.0 / 3.0), last * (4.0 / 3.0)],
            feet: PLACES.map(|s| lo + width * s),
            limits: [lo, hi],
            enough: (SHARE * tolerance).max(1e-9 * chord),
        }
    }

    fn cubic(&self) -> Cubic {
        let [start, end] = self.ends;
        let [leaving, arriving] = self.directions;
        [start, start + leaving * self.lengths[0], end - arriving * self.lengths[1], end]
    }

    /// How far the cubic is to the side of the arc at one of the places, and how that changes with each handle's
    /// length.
    fn row(&mut self, piece: &Piece, cubic: &Cubic, place: usize) -> [f64; 3] {
        let s = PLACES[place];
        let foot = Foot::of(piece, cubic_at(cubic, s), self.feet[place], self.limits);
        self.feet[place] = foot.at;
        let tangent = foot.velocity / norm(foot.velocity);
        let z = 1.0 - s;
        let [leaving, arriving] = self.directions;
        [
            3.0 * s * z * z * cross(tangent, leaving),
            -3.0 * s * s * z * cross(tangent, arriving),
            cross(tangent, foot.offset),
        ]
    }

    /// Newton's method for the lengths with which the cubic crosses the arc at both crossings; whether there are any.
    fn cross(&mut self, piece: &Piece) -> bool {
        for _ in 0..CROSSING_STEPS {
            let cubic = self.cubic();
            let [[a, b, u], [c, d, v]] = [self.row(piece, &cubic, 1), self.row(piece, &cubic, 3)];
            let determinant = a * d - b * c;
            let step = [(b * v - d * u) / determinant, (c * u - a * v) / determinant];
            if !self.change(step) {
                return false;
            }
            if self.is_last(step) {
                return true;
            }
        }
        false
    }

    /// Levenberg and Marquardt's method for the lengths with which the squares at all places are least.
    fn come_near(&mut self, piece: &Piece) {
        let (mut damping, mut least) = (1e-6, f64::INFINITY);
        let (mut kept, mut matrix, mut side) = (self.lengths, [0.0; 3], [0.0; 2]);
        for _ in 0..NEARING_STEPS {
            let cubic = self.cubic();
            let rows: [[f64; 3]; 5] = core::array::from_fn(|place| self.row(piece, &cubic, place));
            let sum = |i: usize, j: usize| rows.iter().fold(0.0, |sum, row| sum + row[i] * row[j]);
            let squares = sum(2, 2);
            if squares < least {
                (least, kept, damping) = (squares, self.lengths, 0.1 * damping);
                (matrix, side) = ([sum(0, 0), sum(0, 1), sum(1, 1)], [-sum(0, 2), -sum(1, 2)]);
            } else {
                (self.lengths, damping) = (kept, 100.0 * damping);
            }
            let step = damped_step(matrix, side, damping);
            if self.is_last(step) {
                break;
            }
            if !self.change(step) {
                damping *= 100.0;
            }
        }
        self.lengths = kept;
    }

    fn is_last(&self, step: [f64; 2]) -> bool {
        step[0].abs() + step[1].abs() <= self.enough
    }

    /// Changes the lengths, if they stay positive and not much longer than they were.
    fn change(&mut self, step: [f64; 2]) -> bool {
        let lengths = [self.lengths[0] + step[0], self.lengths[1] + step[1]];
        let sound = (0..2).all(|k| lengths[k] > 0.0 && lengths[k] < self.most[k]);
        if sound {
            self.lengths = lengths;
        }
        sound
    }
}

/// The unit tangent at an end and the speed there; where the speed is zero the second derivative points the way. Where
/// that is zero, too, there is no direction, but numbers that every comparison refuses.
fn direction(first: Vector, second: Vector, chord: f64) -> (Vector, f64) {
    let speed = norm(first);
    let acceleration = norm(second);
    if speed > 1e-6 * acceleration {
        return (first / speed, speed);
    }
    // Of the second derivative the sign at an end is that of the way into the arc, or out of it.
    (second / acceleration, chord)
}

/// Where a point is seen from the arc.
pub(super) struct Foot {
    pub(super) at: f64,
    /// The way from the arc's point there to the point, and the derivative there.
    offset: Vector,
    velocity: Vector,
}

impl Foot {
    /// Two of Newton's steps from y towards the foot of a point, with one look at the arc: what is near y is Taylor's
    /// sum.
    #[inline(never)]
    fn of(piece: &Piece, point: Point, y: f64, [lo, hi]: [f64; 2]) -> Self {
        let Jet { position, first, second, third } = piece.jet(y);
        let (mut offset, mut velocity) = (point - position, first);
        let mut way = 0.0;
        for _ in 0..2 {
            let bend = second + third * way;
            let speed = square(velocity);
            // Beyond the centre of curvature the full Newton step would lead away.
            let step = way + dot(offset, velocity) / (speed - dot(offset, bend)).max(0.25 * speed);
            if !(y + step > lo && y + step < hi) {
                break;
            }
            way = step;
            offset = point - position - (first + (second * 0.5 + third * (way / 6.0)) * way) * way;
            velocity = first + (second + third * (0.5 * way)) * way;
        }
        Self { at: y + way, offset, velocity }
    }
}
