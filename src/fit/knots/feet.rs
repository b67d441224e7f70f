//! The feet of points on a spline: parameters at which it is near them, by Newton's method.
//!
//! Points that follow one another on one piece are looked at together, in loops without branches, which become vector
//! instructions. A point whose foot leaves the piece goes its way alone.

use super::breaks::HIGHEST;
use super::free_knots::Located;
use super::look::{Look, Piece};
use super::spline::{Distances, Spline};
use crate::numerics::plane::{larger, smaller};
use crate::numerics::{Point, Vector};

/// The most points that are looked at together.
const TOGETHER: usize = 64;
/// A step that wins less than this share of the square of the distance is not made.
const WORTH: f64 = 1e-6;
/// At a foot a step wins no more than this share.
const SETTLED: f64 = 1e-12;
/// The most looks on the way there. Nearly all points need three; so many halve the way to a corner fifty times.
const MOST_LOOKS: usize = 120;

impl Spline {
    /// Moves every parameter towards the foot of its point, by at most `rounds` steps that each come nearer, and says
    /// how far the points then are. What it says is never too small: the nearest point is no farther.
    pub(super) fn project(&self, data: &mut Located, rounds: usize) -> Distances {
        self.project_beyond(data, rounds, 0.0)
    }

    /// The same, but points that are nearer than `enough` stay where they are: whether all are takes one look at most
    /// of them.
    pub(super) fn project_beyond(&self, data: &mut Located, rounds: usize, enough: f64) -> Distances {
        let mut feet = core::mem::take(&mut data.parameters);
        let distances = self.feet_beyond(data, &mut feet, rounds, enough);
        data.parameters = feet;
        distances
    }

    /// [`Spline::project`] for parameters that are kept apart from the points.
    pub(in crate::fit) fn feet(&self, data: &Located, feet: &mut [f64], rounds: usize) -> Distances {
        self.feet_beyond(data, feet, rounds, 0.0)
    }

    fn feet_beyond(&self, data: &Located, feet: &mut [f64], rounds: usize, enough: f64) -> Distances {
        let enough = enough * enough;
        match self.space.breaks.degree {
            1 => self.feet_of::<2>(data, feet, rounds, enough),
            2 | 3 => self.feet_of::<4>(data, feet, rounds, enough),
            _ => self.feet_of::<6>(data, feet, rounds, enough),
        }
    }

    /// The same for degrees below T and the square of what is near enough.
    fn feet_of<const T: usize>(
        &self,
        data: &Located,
        feet: &mut [f64],
        rounds: usize,
        enough: f64,
    ) -> Distances {
        let pieces = self.pieces();
        let mut found = Distances::default();
        let mut group = Group::new();
        let (mut s, mut from) = (0, 0);
        while from < feet.len() {
            s = self.space.find(feet[from], s).0;
            let count = self.gathered(&mut group, s, &feet[from..], &data.points[from..]);
            let span = &self.space.spans[s];
            group.move_to_feet::<T>(&pieces[s], count, rounds, [self.reach() / span.half, enough]);
            let points = &data.points[from..from + count];
            for (i, (foot, target)) in feet[from..from + count].iter_mut().zip(points).enumerate() {
                if group.u[i] != group.start[i] {
                    *foot = self.within(span.middle + group.u[i] * span.half);
                }
                let mut square = group.square[i];
                if group.left[i] > 0 {
                    let step = (group.beyond[i] - group.u[i]) * span.half;
                    square = self.onward(&pieces, (foot, square), (s, step), *target, (group.left[i], WORTH));
                }
                found.squares += data.weight(from + i) * square;
                found.largest = larger(found.largest, square);
            }
            from += count;
        }
        found.largest = found.largest.sqrt();
        found
    }

    /// Moves every parameter to the foot of its point, from which the distance grows to both sides, be it a corner, and
    /// says how far the points then are. Slower than [`Spline::feet`], which makes a few steps towards it.
    pub(in crate::fit) fn settle(&self, data: &Located, feet: &mut [f64]) -> Distances {
        let pieces = self.pieces();
        let (mut found, mut s) = (Distances::default(), 0);
        for (i, (foot, target)) in feet.iter_mut().zip(&data.points).enumerate() {
            s = self.space.find(*foot, s).0;
            let square =
                self.onward(&pieces, (foot, f64::INFINITY), (s, 0.0), *target, (MOST_LOOKS, SETTLED));
            found.squares += data.weight(i) * square;
            found.largest = larger(found.largest, square);
        }
        found.largest = found.largest.sqrt();
        found
    }

    /// How far one step may go.
    fn reach(&self) -> f64 {
        0.02 * self.space.breaks.end
    }

    /// Takes points as long as their parameters lie on piece s; the first one does. Answers how many.
    fn gathered(&self, group: &mut Group, s: usize, feet: &[f64], points: &[Point]) -> usize {
        let breaks = &self.space.breaks;
        let (span, spans) = (&self.space.spans[s], self.space.spans.len());
        let low = if s == 0 { f64::NEG_INFINITY } else { span.middle - span.half };
        let high = if s + 1 == spans { f64::INFINITY } else { span.middle + span.half };
        let turn = match breaks.at.first() {
            Some(first) if breaks.closed => *first,
            _ => f64::NEG_INFINITY,
        };
        let mut count = 0;
        for (&t, point) in feet.iter().zip(points).take(TOGETHER) {
            let t = if t < turn { t + breaks.end } else { t };
            if count > 0 && !(t >= low && t < high) {
                break;
            }
            group.start[count] = (t - span.middle) / span.half;
            (group.x[count], group.y[count]) = (point.x, point.y);
            count += 1;
        }
        count
    }

    /// Goes on with a point whose step may lead off piece s: its foot so far, how far that is (squared), how many looks
    /// are left and what share a step has to win. A step that comes no nearer is the last one; where the very foot is
    /// wanted it is halved, and twice that is the most for the next one, so that a corner is reached, too. Answers the
    /// square of the distance.
    #[inline(never)]
    fn onward(
        &self,
        pieces: &[Piece],
        (foot, mut square): (&mut f64, f64),
        (mut s, mut step): (usize, f64),
        target: Point,
        (looks, worth): (usize, f64),
    ) -> f64 {
        // Where the very foot is wanted.
        let settling = worth < WORTH;
        let mut most = self.reach();
        for _ in 0..looks {
            let t = self.within(*foot + step);
            let (found, own) = self.space.find(t, s);
            let span = &self.space.spans[found];
            let look = Look::new::<{ HIGHEST + 1 }>(&pieces[found], (own - span.middle) / span.half, target);
            if look.square < square {
                (*foot, square, s) = (t, look.square, found);
                let (newton, gain) = look.newton();
                if gain <= worth * square {
                    break;
                }
                step = larger(smaller(newton * span.half, most), -most);
                most = smaller(2.0 * most, self.reach());
            } else if settling {
                step *= 0.5;
                most = step.abs();
            } else {
                break;
            }
        }
        square
    }

    /// t in the domain.
    fn within(&self, t: f64) -> f64 {
        let breaks = &self.space.breaks;
        breaks.wrapped(t).max(0.0).min(breaks.end)
    }
}

/// Points on one piece; places are in its own variable.
struct Group {
    x: [f64; TOGETHER],
    y: [f64; TOGETHER],
    /// Where each began.
    start: [f64; TOGETHER],
    /// The nearest place so far, and the square of the distance from there.
    u: [f64; TOGETHER],
    square: [f64; TOGETHER],
    /// The place to look at next.
    next: [f64; TOGETHER],
    /// Where a step led off the piece, and how many steps were left, that one included; 0 where none did.
    beyond: [f64; TOGETHER],
    left: [usize; TOGETHER],
}

impl Group {
    fn new() -> Self {
        let none = [0.0; TOGETHER];
        let left = [0; TOGETHER];
        Self { x: none, y: none, start: none, u: none, square: none, next: none, beyond: none, left }
    }

    /// Up to `rounds` steps of the first `count` points, each at most `most`; squares that are `enough` need no step.
    fn move_to_feet<const T: usize>(
        &mut self,
        piece: &Piece,
        count: usize,
        rounds: usize,
        [most, enough]: [f64; 2],
    ) {
        self.u[..count].copy_from_slice(&self.start[..count]);
        self.next[..count].copy_from_slice(&self.start[..count]);
        self.square[..count].fill(f64::INFINITY);
        self.left[..count].fill(0);
        for round in 0..rounds {
            self.step::<T>(piece, count, most, enough);
            let mut any = false;
            for i in 0..count {
                if self.next[i].abs() > 1.0 {
                    (self.left[i], self.beyond[i]) = (rounds - round, self.next[i]);
                    self.next[i] = self.u[i];
                }
                any |= self.next[i] != self.u[i];
            }
            if !any {
                return;
            }
        }
        self.last::<T>(piece, count);
    }

    /// Takes the places that are nearer than those before, and finds the next ones.
    fn step<const T: usize>(&mut self, piece: &Piece, count: usize, most: f64, enough: f64) {
        let group = self.x[..count].iter().zip(&self.y[..count]).zip(&mut self.u[..count]);
        let found = self.square[..count].iter_mut().zip(&mut self.next[..count]);
        for (((x, y), u), (square, next)) in group.zip(found) {
            let look = Look::new::<T>(piece, *next, Point::new(*x, *y));
            let here = look.square;
            let (step, gain) = look.newton();
            let nearer = here < *square;
            *square = if nearer { here } else { *square };
            *u = if nearer { *next } else { *u };
            let further = look.u + larger(smaller(step, most), -most);
            *next = if nearer & (gain >= WORTH * here) & (here > enough) { further } else { *u };
        }
    }

    /// Takes the places that are nearer than those before.
    fn last<const T: usize>(&mut self, piece: &Piece, count: usize) {
        let group = self.x[..count].iter().zip(&self.y[..count]).zip(&mut self.u[..count]);
        let found = self.square[..count].iter_mut().zip(&self.next[..count]);
        for (((x, y), u), (square, next)) in group.zip(found) {
            let mut place = Vector::zeros();
            for c in piece[..T].iter().rev() {
                place = place * *next + c;
            }
            let (a, b) = (place.x - x, place.y - y);
            let here = a * a + b * b;
            let nearer = here < *square;
            *square = if nearer { here } else { *square };
            *u = if nearer { *next } else { *u };
        }
    }
}
