//! One cubic through two given points, as near as it can to places between them.

use crate::numerics::pair::Pair;
use crate::numerics::plane::{cross, dot, larger, norm, square};
use crate::numerics::{Point, Vector};
use crate::trace::samples::unit;

/// A cubic by its ends and the way from each end to its control point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::trace) struct Cubic {
    pub(in crate::trace) start: Point,
    /// First control point less start.
    pub(in crate::trace) leaving: Vector,
    /// End less second control point.
    pub(in crate::trace) arriving: Vector,
    pub(in crate::trace) end: Point,
}

/// What is known of the tangent at an end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::trace) enum Tangent {
    /// Nothing.
    Free,
    /// Its direction, of length 1, along the curve.
    Along(Vector),
}

/// A cubic and how far the places are from it.
#[derive(Clone, Copy, Debug)]
pub(in crate::trace) struct Fitted {
    pub(in crate::trace) cubic: Cubic,
    pub(super) most: f64,
    pub(in crate::trace) rms: f64,
}

/// Places used for one fit: more say nothing new about four unknowns.
const MOST_PLACES: usize = 16;
/// Rounds of least squares and foot points.
const ROUNDS: usize = 3;

impl Cubic {
    pub(in crate::trace) const fn bernstein(t: f64) -> [f64; 4] {
        let u = 1.0 - t;
        [u * u * u, 3.0 * u * u * t, 3.0 * u * t * t, t * t * t]
    }

    pub(in crate::trace) fn point(&self, t: f64) -> Point {
        let [_, b, c, d] = Self::bernstein(t);
        self.start + (self.end - self.start) * (c + d) + self.leaving * b - self.arriving * c
    }

    pub(in crate::trace) fn velocity(&self, t: f64) -> Vector {
        let u = 1.0 - t;
        let middle = self.end - self.start - self.leaving - self.arriving;
        (self.leaving * (u * u) + middle * (2.0 * u * t) + self.arriving * (t * t)) * 3.0
    }

    pub(super) fn acceleration(&self, t: f64) -> Vector {
        let middle = self.end - self.start - self.leaving - self.arriving;
        ((middle - self.leaving) * (1.0 - t) + (self.arriving - middle) * t) * 6.0
    }

    /// Where the curve is nearest to a point, from a guess: one step of Newton's method.
    pub(super) fn foot(&self, p: Point, t: f64) -> f64 {
        let (off, velocity) = (self.point(t) - p, self.velocity(t));
        let slope = square(velocity) + dot(off, self.acceleration(t));
        if slope <= 0.0 {
            return t;
        }
        (t - dot(off, velocity) / slope).clamp(0.0, 1.0)
    }

    /// [`Self::foot`] of some points, in pairs.
    fn feet(&self, points: &[Point], parameters: &mut [f64]) {
        let middle = self.end - self.start - self.leaving - self.arriving;
        let both = |v: Vector| [Pair::twice(v.x), Pair::twice(v.y)];
        let [start, way, leaving, arriving, middle, first, second] = [
            self.start,
            self.end - self.start,
            self.leaving,
            self.arriving,
            middle,
            middle - self.leaving,
            self.arriving - middle,
        ]
        .map(both);
        let [one, two, three, six] = [1.0, 2.0, 3.0, 6.0].map(Pair::twice);
        let (pairs, last) = parameters.as_chunks_mut::<2>();
        for (parameters, &[p, q]) in pairs.iter_mut().zip(points.as_chunks().0) {
            let t = Pair::new(parameters[0], parameters[1]);
            let u = one - t;
            let (b, c, d) = (three * u * u * t, three * u * t * t, t * t * t);
            let (uu, ut, tt) = (u * u, two * u * t, t * t);
            let along = |k: usize, p: f64, q: f64| {
                let off = start[k] + way[k] * (c + d) + leaving[k] * b - arriving[k] * c - Pair::new(p, q);
                let velocity = (leaving[k] * uu + middle[k] * ut + arriving[k] * tt) * three;
                let acceleration = (first[k] * u + second[k] * t) * six;
                (off * velocity, velocity * velocity, off * acceleration)
            };
            let (x, y) = (along(0, p.x, q.x), along(1, p.y, q.y));
            let (slip, slope) = (x.0 + y.0, x.1 + y.1 + (x.2 + y.2));
            let step = slip / slope;
            let foot =
                |t: f64, step: f64, slope: f64| if slope <= 0.0 { t } else { (t - step).clamp(0.0, 1.0) };
            *parameters = [
                foot(parameters[0], step.first(), slope.first()),
                foot(parameters[1], step.second(), slope.second()),
            ];
        }
        for (t, &p) in last.iter_mut().zip(points.last()) {
            *t = self.foot(p, *t);
        }
    }

    /// Fits the ways to the control points to `places` between `start` and `end`.
    pub(in crate::trace) fn fit(
        start: Point,
        end: Point,
        places: &[Point],
        tangents: [Tangent; 2],
    ) -> Fitted {
        let mut chosen = [(start + end) * 0.5; MOST_PLACES];
        let mut count = 0;
        for &place in places.iter().step_by(places.len().div_ceil(MOST_PLACES).max(1)) {
            chosen[count] = place;
            count += 1;
        }
        let points = &chosen[..count.max(1)];
        let mut places = [0.0; MOST_PLACES];
        let parameters = &mut places[..points.len()];
        let total = chord_parameters(start, end, points, parameters);
        let chord = norm(end - start).max(total / core::f64::consts::PI);
        let mut cubic = Self { start, leaving: Vector::zeros(), arriving: Vector::zeros(), end };
        for round in 0..ROUNDS {
            if round > 0 {
                cubic.feet(points, parameters);
            }
            cubic.solve(points, parameters, tangents, chord);
        }
        let (mut most, mut sum) = (0.0_f64, 0.0);
        for (&t, &p) in parameters.iter().zip(points) {
            // Across the curve: along it places may slip.
            let (off, velocity) = (p - cubic.point(t), cubic.velocity(t));
            let across = cross(velocity, off);
            let off = across * across / larger(square(velocity), 1e-18);
            most = larger(most, off);
            sum += off;
        }
        Fitted { cubic, most: most.sqrt(), rms: (sum / points.len() as f64).sqrt() }
    }

    /// Least squares for up to four unknowns: a length along a known tangent, both coordinates else.
    fn solve(&mut self, points: &[Point], parameters: &[f64], tangents: [Tangent; 2], chord: f64) {
        // What the places say to both ways, whatever is known of their directions.
        let (mut squares, mut asked) = ([0.0; 3], [Vector::zeros(); 2]);
        let way = self.end - self.start;
        for (&t, &p) in parameters.iter().zip(points) {
            let [_, b, c, d] = Self::bernstein(t);
            let off = p - self.start - way * (c + d);
            squares[0] += b * b;
            squares[1] -= b * c;
            squares[2] += c * c;
            asked[0] += off * b;
            asked[1] -= off * c;
        }
        let mut unknowns = [(0, Vector::zeros()); 4];
        let mut count = 0;
        for (side, tangent) in tangents.iter().enumerate() {
            let directions = match *tangent {
                Tangent::Along(direction) => [Some(direction), None],
                Tangent::Free => [Some(Vector::new(1.0, 0.0)), Some(Vector::new(0.0, 1.0))],
            };
            for direction in directions.into_iter().flatten() {
                unknowns[count] = (side, direction);
                count += 1;
            }
        }
        let mut normal = [[0.0; 5]; 4];
        for i in 0..count {
            let (side, direction) = unknowns[i];
            for j in 0..=i {
                let (other, along) = unknowns[j];
                normal[i][j] = squares[side + other] * dot(direction, along);
            }
            normal[i][4] = dot(direction, asked[side]);
        }
        // A third of the chord is what a straight piece has; hardly determined lengths stay near it.
        let usual = unit(self.end - self.start) * (chord / 3.0);
        for i in 0..count {
            let (_, direction) = unknowns[i];
            let wish = if count == 2 { chord / 3.0 } else { dot(direction, usual) };
            let ridge = 1e-4 * (1.0 + normal[i][i]);
            normal[i][i] += ridge;
            normal[i][4] += ridge * wish;
        }
        let solution = solve_small(&mut normal, count);
        let mut ways = [Vector::zeros(); 2];
        for ((side, direction), &amount) in unknowns.iter().zip(&solution).take(count) {
            let known = matches!(tangents[*side], Tangent::Along(_));
            ways[*side] += direction * if known { amount.max(0.02 * chord).min(3.0 * chord) } else { amount };
        }
        [self.leaving, self.arriving] = ways;
    }
}

/// Solves a positive definite system of up to four unknowns; the right-hand side is in the last column.
fn solve_small(rows: &mut [[f64; 5]; 4], count: usize) -> [f64; 4] {
    for i in 0..count {
        for j in 0..=i {
            let known: f64 = (0..j).map(|k| rows[i][k] * rows[j][k]).sum();
            let rest = rows[i][j] - known;
            rows[i][j] = if i == j { rest.max(1e-12).sqrt() } else { rest / rows[j][j] };
        }
    }
    let mut x = [0.0; 4];
    for i in 0..count {
        let known: f64 = (0..i).map(|k| rows[i][k] * x[k]).sum();
        x[i] = (rows[i][4] - known) / rows[i][i];
    }
    for i in (0..count).rev() {
        let known: f64 = (i + 1..count).map(|k| rows[k][i] * x[k]).sum();
        x[i] = (x[i] - known) / rows[i][i];
    }
    x
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
