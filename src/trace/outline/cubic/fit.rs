//! A cubic through two given points, as near as it can to places between them.

use super::{Cubic, Tangent};
use crate::numerics::pair::Pair;
use crate::numerics::plane::{dot, larger, norm, smaller};
use crate::numerics::{Point, Vector};
use crate::trace::samples::unit;

/// A cubic and how far the places are from it.
#[derive(Clone, Copy, Debug)]
pub(in crate::trace) struct Fitted {
    pub(in crate::trace) cubic: Cubic,
    pub(in crate::trace::outline) most: f64,
    pub(in crate::trace) rms: f64,
}

/// Places used for one fit: more say nothing new about four unknowns.
const MOST_PLACES: usize = 16;
/// Rounds of least squares and foot points.
const ROUNDS: usize = 3;

impl Cubic {
    /// Fits the ways to the control points to `places` between `start` and `end`.
    pub(in crate::trace) fn fit(
        start: Point,
        end: Point,
        places: &[Point],
        tangents: [Tangent; 2],
    ) -> Fitted {
        let mut chosen = [start; MOST_PLACES];
        let mut count = 0;
        for &place in places.iter().step_by(places.len().div_ceil(MOST_PLACES).max(1)) {
            chosen[count] = place;
            count += 1;
        }
        if count == 0 {
            (chosen[0], count) = ((start + end) * 0.5, 1);
        }
        let mut shares = [0.0; MOST_PLACES];
        let total = chord_parameters(start, end, &chosen[..count], &mut shares[..count]);
        let chord = norm(end - start).max(total / core::f64::consts::PI);
        // A place too many for an even number is the start: there the ways say nothing, and nothing is off.
        let pairs = count.div_ceil(2);
        let (points, parameters) = (&chosen.as_chunks().0[..pairs], &mut shares.as_chunks_mut().0[..pairs]);
        let mut cubic = Self { start, leaving: Vector::zeros(), arriving: Vector::zeros(), end };
        for round in 0..ROUNDS {
            if round > 0 {
                Twice::of(&cubic).feet(points, parameters);
            }
            cubic.solve(&Twice::of(&cubic).sums(points, parameters), tangents, chord);
        }
        let [most, sum] = Twice::of(&cubic).offs(points, parameters);
        Fitted { cubic, most: most.sqrt(), rms: (sum / count as f64).sqrt() }
    }

    /// Least squares for up to four unknowns: a length along a known tangent, both coordinates else.
    fn solve(&mut self, sums: &Sums, tangents: [Tangent; 2], chord: f64) {
        // A third of the chord is what a straight piece has; hardly determined lengths stay near it.
        let third = chord / 3.0;
        let usual = unit(self.end - self.start) * third;
        let [x, y] = [Vector::new(1.0, 0.0), Vector::new(0.0, 1.0)];
        let known =
            |direction: Vector, length: f64| direction * smaller(larger(length, 0.02 * chord), 3.0 * chord);
        [self.leaving, self.arriving] = match tangents {
            [Tangent::Along(u), Tangent::Along(v)] => {
                let [leaving, arriving] = sums.solve([(0, u), (1, v)], [third; 2]);
                [known(u, leaving), known(v, arriving)]
            }
            [Tangent::Along(u), Tangent::Free] | [Tangent::Free, Tangent::Along(u)] => {
                let side = usize::from(tangents[0] == Tangent::Free);
                let (unknowns, wishes) =
                    ([(side, u), (1 - side, x), (1 - side, y)], [dot(u, usual), usual.x, usual.y]);
                let [length, first, second] = sums.solve(unknowns, wishes);
                let mut ways = [Vector::new(first, second); 2];
                ways[side] = known(u, length);
                ways
            }
            [Tangent::Free, Tangent::Free] => {
                // Either coordinate has equations of its own.
                let along = sums.solve([(0, x), (1, x)], [usual.x; 2]);
                let across = sums.solve([(0, y), (1, y)], [usual.y; 2]);
                [Vector::new(along[0], across[0]), Vector::new(along[1], across[1])]
            }
        };
    }
}

/// What the places say to both ways, whatever is known of their directions.
struct Sums {
    squares: [f64; 3],
    asked: [Vector; 2],
}

impl Sums {
    /// Solves for some unknowns, each a way's amount in one direction, which rather are what is wished.
    fn solve<const N: usize>(&self, unknowns: [(usize, Vector); N], wishes: [f64; N]) -> [f64; N] {
        let (mut normal, mut right) = ([[0.0; N]; N], [0.0; N]);
        for (i, &(side, direction)) in unknowns.iter().enumerate() {
            for (j, &(other, along)) in unknowns[..=i].iter().enumerate() {
                normal[i][j] = self.squares[side + other] * dot(direction, along);
            }
            let ridge = 1e-4 * (1.0 + normal[i][i]);
            normal[i][i] += ridge;
            right[i] = dot(direction, self.asked[side]) + ridge * wishes[i];
        }
        solve_small(normal, right)
    }
}

/// Solves a positive definite system of a few unknowns.
fn solve_small<const N: usize>(mut rows: [[f64; N]; N], mut x: [f64; N]) -> [f64; N] {
    for i in 0..N {
        for j in 0..=i {
            let known: f64 = (0..j).map(|k| rows[i][k] * rows[j][k]).sum();
            let rest = rows[i][j] - known;
            // One over the pivot's root stands on the diagonal.
            rows[i][j] = if i == j { 1.0 / rest.max(1e-12).sqrt() } else { rest * rows[j][j] };
        }
    }
    for i in 0..N {
        let known: f64 = (0..i).map(|k| rows[i][k] * x[k]).sum();
        x[i] = (x[i] - known) * rows[i][i];
    }
    for i in (0..N).rev() {
        let known: f64 = (i + 1..N).map(|k| rows[k][i] * x[k]).sum();
        x[i] = (x[i] - known) * rows[i][i];
    }
    x
}

/// A cubic at two parameters at once: x and y of what it is made of.
struct Twice {
    start: [Pair; 2],
    way: [Pair; 2],
    leaving: [Pair; 2],
    arriving: [Pair; 2],
    middle: [Pair; 2],
}

impl Twice {
    #[inline(always)]
    fn of(cubic: &Cubic) -> Self {
        let both = |v: Vector| [Pair::twice(v.x), Pair::twice(v.y)];
        let way = cubic.end - cubic.start;
        Self {
            start: both(cubic.start),
            way: both(way),
            leaving: both(cubic.leaving),
            arriving: both(cubic.arriving),
            middle: both(way - cubic.leaving - cubic.arriving),
        }
    }

    /// Where the curve is nearest to some points, from guesses: one step of Newton's method.
    #[inline(always)]
    fn feet(&self, points: &[[Point; 2]], parameters: &mut [[f64; 2]]) {
        let six = Pair::twice(6.0);
        for (parameters, &[p, q]) in parameters.iter_mut().zip(points) {
            let [first, second] = *parameters;
            let (t, p) = (Pair::new(first, second), Pair::of(p, q));
            let u = Pair::twice(1.0) - t;
            let along = |k: usize| {
                let (off, velocity) = self.off_and_velocity(k, t, p[k]);
                let (first, second) = (self.middle[k] - self.leaving[k], self.arriving[k] - self.middle[k]);
                let acceleration = (first * u + second * t) * six;
                (off * velocity, velocity * velocity, off * acceleration)
            };
            let (x, y) = (along(0), along(1));
            let (slip, slope) = (x.0 + y.0, x.1 + y.1 + (x.2 + y.2));
            let step = slip / slope;
            let foot = |t: f64, step: f64, slope: f64| {
                if slope <= 0.0 { t } else { smaller(larger(t - step, 0.0), 1.0) }
            };
            *parameters =
                [foot(first, step.first(), slope.first()), foot(second, step.second(), slope.second())];
        }
    }

    /// What points at parameters say to both ways.
    #[inline(always)]
    fn sums(&self, points: &[[Point; 2]], parameters: &[[f64; 2]]) -> Sums {
        let [xx, xy, yy, ax, ay, bx, by] = over(points, parameters, |t, p| {
            let [b, c, d] = bernstein(t);
            let off = |k: usize| p[k] - self.start[k] - self.way[k] * (c + d);
            let (x, y) = (off(0), off(1));
            [b * b, b * c, c * c, x * b, y * b, x * c, y * c]
        });
        Sums { squares: [xx, -xy, yy], asked: [Vector::new(ax, ay), Vector::new(-bx, -by)] }
    }

    /// The largest and the sum of the squared distances of points, across the curve: along it they may slip.
    #[inline(always)]
    fn offs(&self, points: &[[Point; 2]], parameters: &[[f64; 2]]) -> [f64; 2] {
        let least = Pair::twice(1e-18);
        let mut most = 0.0;
        let [sum] = over(points, parameters, |t, p| {
            let (x, y) = (self.off_and_velocity(0, t, p[0]), self.off_and_velocity(1, t, p[1]));
            let across = x.1 * y.0 - y.1 * x.0;
            let off = across * across / (x.1 * x.1 + y.1 * y.1 + least);
            most = larger(larger(most, off.first()), off.second());
            [off]
        });
        [most, sum]
    }

    /// On one axis, how far the curve is from a coordinate at a parameter, and its velocity.
    #[inline(always)]
    fn off_and_velocity(&self, k: usize, t: Pair, p: Pair) -> (Pair, Pair) {
        let (two, three, u) = (Pair::twice(2.0), Pair::twice(3.0), Pair::twice(1.0) - t);
        let [b, c, d] = bernstein(t);
        let off = self.start[k] + self.way[k] * (c + d) + self.leaving[k] * b - self.arriving[k] * c - p;
        let velocity =
            (self.leaving[k] * (u * u) + self.middle[k] * (two * u * t) + self.arriving[k] * (t * t)) * three;
        (off, velocity)
    }
}

/// Bernstein's polynomials of degree 3 but the first, as in [`Cubic::bernstein`].
#[inline(always)]
fn bernstein(t: Pair) -> [Pair; 3] {
    let (three, u) = (Pair::twice(3.0), Pair::twice(1.0) - t);
    [three * u * u * t, three * u * t * t, t * t * t]
}

/// Sums over points and their parameters, in pairs.
#[inline(always)]
fn over<const N: usize>(
    points: &[[Point; 2]],
    parameters: &[[f64; 2]],
    mut says: impl FnMut(Pair, [Pair; 2]) -> [Pair; N],
) -> [f64; N] {
    let mut both = [Pair::twice(0.0); N];
    for (&[s, t], &[p, q]) in parameters.iter().zip(points) {
        let said = says(Pair::new(s, t), Pair::of(p, q));
        for k in 0..N {
            both[k] += said[k];
        }
    }
    both.map(|sum| sum.first() + sum.second())
}

/// The share of the way from the start at every point, and the length of the way.
fn chord_parameters(start: Point, end: Point, points: &[Point], parameters: &mut [f64]) -> f64 {
    let (mut travelled, mut last) = (0.0, start);
    for (t, &p) in parameters.iter_mut().zip(points) {
        travelled += norm(p - last);
        last = p;
        *t = travelled;
    }
    let total = travelled + norm(end - last);
    let scale = 1.0 / larger(total, 1e-12);
    parameters.iter_mut().for_each(|t| *t *= scale);
    total
}
