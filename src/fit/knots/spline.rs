//! A spline, and what points ask of it: their distances from it, and the spline near it that makes these small while
//! their parameters are free. Where on the curve each point belongs is found in `feet`.

use super::breaks::HIGHEST;
use super::envelope::Envelope;
use super::free_knots::{FreeKnots, Located, product};
use super::look::{Look, Piece, taylor};
use super::space::{Polynomial, STIFF, Space};
use crate::numerics::{Point, Vector};

/// How much less a distance along the curve counts than one across it.
const ALONG: f64 = 0.05;
/// Points slide that much more easily than they leave the curve, and at its ends, too.
const SLIDE: Slide = Slide { along: ALONG, over_ends: true };
/// How much more moving a coefficient costs that is held than what points say.
const HELD: f64 = 1e8;
/// How distances along the curve count after a step that brought the points nearer, and after one that did not.
const FREER: f64 = 0.3;
const STIFFER: f64 = 10.0;
/// A step that leaves more than this of the squares gained little; where those along count less than this, the last.
const MOST_LEFT: f64 = 0.9;
const FREE: f64 = 1e-4;

/// How points slide along a curve while it is moved.
#[derive(Clone, Copy, Debug)]
struct Slide {
    /// How much less a distance along it counts than one across it.
    along: f64,
    /// Whether points beyond an end of it slide as well, though its end is their foot.
    over_ends: bool,
}

/// A spline: a space and coefficients.
#[derive(Clone, Debug)]
pub(in crate::fit) struct Spline {
    pub(in crate::fit) space: Space,
    pub(in crate::fit) x: Vec<f64>,
    pub(in crate::fit) y: Vec<f64>,
}

/// What the distances of all points come to.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::fit) struct Distances {
    pub(in crate::fit) largest: f64,
    /// The weighted sum of squares.
    pub(in crate::fit) squares: f64,
}

/// A place of the curve that is pulled back, and the way back.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pull {
    pub(super) piece: usize,
    pub(super) u: f64,
    pub(super) back: Vector,
}

impl Spline {
    #[inline(never)]
    pub(in crate::fit) fn of(fitted: &FreeKnots) -> Self {
        Self { space: fitted.space.clone(), x: fitted.x.clone(), y: fitted.y.clone() }
    }

    /// The curve's polynomials, piece by piece.
    pub(in crate::fit) fn pieces(&self) -> Vec<Piece> {
        (0..self.space.spans.len()).map(|s| self.piece(s)).collect()
    }

    fn piece(&self, s: usize) -> Piece {
        let mut sum = [Vector::zeros(); HIGHEST + 1];
        for (i, basis) in self.space.basis[s].iter().enumerate().take(self.space.breaks.degree + 1) {
            let index = self.space.index(s, i);
            let coefficient = Vector::new(self.x[index], self.y[index]);
            for (sum, b) in sum.iter_mut().zip(basis) {
                *sum += coefficient * *b;
            }
        }
        sum
    }

    /// The point at t, or a derivative, by the polynomials of piece s.
    pub(super) fn on(&self, s: usize, t: f64, order: usize) -> Vector {
        let span = &self.space.spans[s];
        self.at(s, (t - span.middle) / span.half, order)
    }

    /// The same at u in [−1, 1] of the piece.
    #[inline(never)]
    pub(super) fn at(&self, s: usize, u: f64, order: usize) -> Vector {
        derivative_of(&self.piece(s), self.space.breaks.degree, u, self.space.spans[s].half, order)
    }

    /// The derivatives before and after knot k.
    #[inline(never)]
    pub(super) fn ways(&self, k: usize) -> [Vector; 2] {
        let (before, after) = self.space.sides(k);
        [self.at(before, 1.0, 1), self.at(after, -1.0, 1)]
    }

    /// The distance of every point from the curve at its parameter.
    pub(in crate::fit) fn distances(&self, data: &Located) -> Vec<f64> {
        let pieces = self.pieces();
        let one = |(point, (s, t)): (&Point, (usize, f64))| {
            let span = &self.space.spans[s];
            Look::new::<{ HIGHEST + 1 }>(&pieces[s], (t - span.middle) / span.half, *point).square.sqrt()
        };
        data.points.iter().zip(self.space.places(&data.parameters)).map(one).collect()
    }

    /// The weighted sum of squares at the points' parameters.
    pub(in crate::fit) fn squares(&self, data: &Located) -> f64 {
        let pieces = self.pieces();
        let mut sum = 0.0;
        for (m, (point, (s, t))) in data.points.iter().zip(self.space.places(&data.parameters)).enumerate() {
            let span = &self.space.spans[s];
            let place = on_piece(&pieces[s], (t - span.middle) / span.half);
            sum += data.weight(m) * (place - point).norm_squared();
        }
        sum
    }

    /// One Gauss–Newton step of the distances across the curve; those along it count little, for points may slide
    /// (D 13.4), \[WPL06\]. O(M·degree + K·degree²).
    pub(super) fn tighten(&mut self, data: &Located) {
        self.tighten_held(data, &[]);
    }

    /// Steps to the least sum of squares of the distances, with points that slide the more freely the better that works
    /// (Levenberg's and Marquardt's way): until all are near enough, or a step gains little.
    #[inline(never)]
    pub(super) fn ease(&mut self, data: &mut Located, steps: usize, enough: f64) -> Distances {
        let (mut distances, mut along) = (self.project(data, 2), ALONG);
        for _ in 0..steps {
            if distances.largest <= enough {
                break;
            }
            let mut trial = self.clone();
            trial.step_across(data, &[], &[], Slide { along, over_ends: false });
            let mut feet = data.parameters.clone();
            let eased = trial.feet(data, &mut feet, 2);
            if eased.squares < distances.squares {
                let gained = eased.squares <= MOST_LEFT * distances.squares;
                (*self, distances) = (trial, eased);
                data.parameters = feet;
                if !gained && along < FREE {
                    break;
                }
                along *= FREER;
            } else {
                along *= STIFFER;
            }
            if along > 1.0 {
                break;
            }
        }
        distances
    }

    /// The same, with places of the curve that are pulled back and count as points do (D 13.16).
    pub(super) fn tighten_held(&mut self, data: &Located, pulls: &[Pull]) {
        self.step_across(data, pulls, &[], SLIDE);
    }

    /// The same as [`Spline::tighten`], with some coefficients where they are told to be.
    pub(super) fn tighten_between(&mut self, data: &Located, held: &[(usize, [f64; 2])]) {
        self.put(held);
        self.step_across(data, &[], held, SLIDE);
        self.put(held);
    }

    fn put(&mut self, held: &[(usize, [f64; 2])]) {
        for &(i, [x, y]) in held {
            (self.x[i], self.y[i]) = (x, y);
        }
    }

    #[inline(never)]
    fn step_across(&mut self, data: &Located, pulls: &[Pull], held: &[(usize, [f64; 2])], slide: Slide) {
        let degree = self.space.breaks.degree;
        // Loops of a length that is known are unrolled.
        let sums = if degree < 4 {
            self.across::<4>(data, pulls, slide)
        } else {
            self.across::<{ HIGHEST + 1 }>(data, pulls, slide)
        };
        let n = self.space.count;
        let mut equations = self.doubled();
        let mut right = vec![0.0; 2 * n];
        let mut size = 0.0_f64;
        for (s, sums) in sums.iter().enumerate() {
            let basis = &self.space.basis[s];
            for p in 0..=degree {
                let row = self.space.index(s, p);
                right[2 * row] += product(&basis[p], &sums.right[0]);
                right[2 * row + 1] += product(&basis[p], &sums.right[1]);
                let weighted = sums.weighted(degree, &basis[p]);
                for (q, basis) in basis[..=degree].iter().enumerate() {
                    let other = self.space.index(s, q);
                    if other > row {
                        continue;
                    }
                    let [xx, xy, yy] = weighted.each_ref().map(|weighted| product(weighted, basis));
                    equations.add(2 * row, 2 * other, xx);
                    equations.add(2 * row + 1, 2 * other + 1, yy);
                    equations.add(2 * row + 1, 2 * other, xy);
                    if row != other {
                        equations.add(2 * row, 2 * other + 1, xy);
                    }
                    size = size.max(xx).max(yy);
                }
            }
        }
        for i in 0..2 * n {
            equations.add(i, i, 1e-9 * size + 1e-280);
        }
        // So heavy, these stay to eight digits while the others move.
        for row in held.iter().flat_map(|&(i, _)| [2 * i, 2 * i + 1]) {
            equations.add(row, row, HELD * size);
        }
        self.moved(equations, right, STIFF * size);
    }

    /// Moves the coefficients by the solution of some equations, and keeps pieces straight that are to be. Answers the
    /// solution.
    pub(super) fn moved(&mut self, mut equations: Envelope, mut right: Vec<f64>, stiff: f64) -> Vec<f64> {
        if !self.space.breaks.straight.is_empty() {
            self.space.stiffen(&mut equations, &mut right, [&self.x, &self.y], stiff);
        }
        equations.factor();
        equations.solve(&mut right);
        for (i, by) in right.chunks_exact(2).enumerate() {
            self.x[i] += by[0];
            self.y[i] += by[1];
        }
        right
    }

    /// Makes pieces that are to be straight as straight as numbers can be.
    pub(super) fn straighten(&mut self) {
        if !self.space.breaks.straight.contains(&true) {
            return;
        }
        for _ in 0..3 {
            let mut equations = self.doubled();
            (0..2 * self.space.count).for_each(|i| equations.add(i, i, 1.0));
            self.moved(equations, vec![0.0; 2 * self.space.count], STIFF);
        }
    }

    /// The shape of the equations of both coordinates together.
    fn doubled(&self) -> Envelope {
        let single = self.space.reaches();
        let first = single.iter().flat_map(|&f| [2 * f, 2 * f]).collect();
        Envelope::new(first)
    }

    fn across<const T: usize>(&self, data: &Located, pulls: &[Pull], slide: Slide) -> Vec<Across> {
        let pieces = self.pieces();
        let mut sums = vec![Across::default(); pieces.len()];
        for (m, (point, (s, t))) in data.points.iter().zip(self.space.places(&data.parameters)).enumerate() {
            let span = &self.space.spans[s];
            let u = (t - span.middle) / span.half;
            let [place, along, _] = taylor::<T>(&pieces[s], u);
            let rest = point - place;
            let square = along.norm_squared();
            let w = data.weight(m);
            // W = 1 − (1 − ε)·ttᵀ for the unit tangent t. A point beyond an end slides nowhere where that end has to
            // come to it.
            let at_end = !self.space.breaks.closed && (t <= 0.0 || t >= self.space.breaks.end);
            let slides = square > 0.0 && (slide.over_ends || !at_end);
            let less = if slides { (1.0 - slide.along) / square } else { 0.0 };
            let [xx, xy, yy] = [
                w * (1.0 - less * along.x * along.x),
                -w * less * along.x * along.y,
                w * (1.0 - less * along.y * along.y),
            ];
            sums[s].take::<T>(u, [xx, xy, yy], [xx * rest.x + xy * rest.y, xy * rest.x + yy * rest.y]);
        }
        for pull in pulls {
            sums[pull.piece].take::<T>(pull.u, [1.0, 0.0, 1.0], [pull.back.x, pull.back.y]);
        }
        sums
    }
}

/// The point at u of a piece.
#[inline(always)]
pub(super) fn on_piece(piece: &Piece, u: f64) -> Vector {
    piece.iter().rev().fold(Vector::zeros(), |sum, c| sum * u + c)
}

/// Derivative of some order of a piece, by the parameter: `half` is half its length there.
pub(in crate::fit) fn derivative_of(piece: &Piece, degree: usize, u: f64, half: f64, order: usize) -> Vector {
    let mut sum = Vector::zeros();
    for k in (order..=degree).rev() {
        let factor: f64 = ((k - order + 1)..=k).map(|i| i as f64).product();
        sum = sum * u + piece[k] * factor;
    }
    for _ in 0..order {
        sum /= half;
    }
    sum
}

/// Moments with a matrix for a weight.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Across {
    powers: [[f64; 3]; 2 * HIGHEST + 1],
    pub(super) right: [Polynomial; 2],
}

impl Across {
    #[inline(always)]
    pub(super) fn take<const T: usize>(&mut self, u: f64, weight: [f64; 3], rest: [f64; 2]) {
        let mut power = 1.0;
        for (k, sums) in self.powers[..2 * T - 1].iter_mut().enumerate() {
            for (sum, w) in sums.iter_mut().zip(weight) {
                *sum += power * w;
            }
            if k < T {
                self.right[0][k] += power * rest[0];
                self.right[1][k] += power * rest[1];
            }
            power *= u;
        }
    }

    /// Σ W·a(u)·uʲ for all j, entry by entry of W.
    pub(super) fn weighted(&self, degree: usize, a: &Polynomial) -> [Polynomial; 3] {
        if degree < 4 { self.weighted_of::<4>(a) } else { self.weighted_of::<{ HIGHEST + 1 }>(a) }
    }

    #[inline(always)]
    fn weighted_of<const T: usize>(&self, a: &Polynomial) -> [Polynomial; 3] {
        let mut sums = [[0.0; HIGHEST + 1]; 3];
        for (i, a) in a[..T].iter().enumerate() {
            for j in 0..T {
                for (sums, power) in sums.iter_mut().zip(self.powers[i + j]) {
                    sums[j] += a * power;
                }
            }
        }
        sums
    }
}
