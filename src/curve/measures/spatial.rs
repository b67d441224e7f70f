//! Measures of curves in space, whose pieces are polynomials.
//!
//! Everything rests on Taylor's formula about the middle of an interval: the first three derivatives there and a bound of
//! the fourth bound what the curve can do around it, for complex parameters as well.

use super::bounds::turns;
use super::cubics::Cubics;
use super::nearest::tie;
use super::search::{Near, Question, Slopes, Stiffness, search};
use crate::curve::pieces::Pieces;
use crate::curve::speed::{ROUNDING, RULES, rule_index};
use crate::error::Result;
use crate::numerics::Point;

/// The most intervals that are open at once while a length is added up.
const STACK: usize = 60;
/// Ellipses in which the speed may be analytic, by their larger half-axis.
const AXES: [f64; 5] = [8.0, 4.0, 2.5, 1.7, 1.3];

/// The point of a curve in space that is nearest to a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpaceNearest {
    /// Its parameter.
    pub t: f64,
    /// The point.
    pub point: [f64; 3],
    /// Its distance.
    pub distance: f64,
}

/// A vector of space.
type Triple = [f64; 3];

fn dot(u: &Triple, v: &Triple) -> f64 {
    u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
}

fn norm(v: &Triple) -> f64 {
    dot(v, v).sqrt()
}

/// u + v·scale.
fn along(u: &Triple, v: &Triple, scale: f64) -> Triple {
    [u[0] + v[0] * scale, u[1] + v[1] * scale, u[2] + v[2] * scale]
}

/// A piece of a curve in space: coefficients of ascending powers of y in [−1/2, 1/2].
pub(in crate::curve) struct SpacePiece {
    powers: Vec<Triple>,
}

impl SpacePiece {
    pub(in crate::curve) fn new(curve: &dyn Pieces, i: usize) -> Self {
        let mut numbers = Vec::new();
        curve.coefficients(i, &mut numbers);
        Self { powers: numbers.as_chunks().0.to_vec() }
    }

    /// The point and its first three derivatives.
    #[inline(never)]
    fn jet(&self, y: f64) -> [Triple; 4] {
        let mut jet = [[0.0; 3]; 4];
        for power in self.powers.iter().rev() {
            jet[3] = along(&jet[2], &jet[3], y);
            jet[2] = along(&jet[1], &jet[2], y);
            jet[1] = along(&jet[0], &jet[1], y);
            jet[0] = along(power, &jet[0], y);
        }
        for (derivative, factor) in jet.iter_mut().zip([1.0, 1.0, 2.0, 6.0]) {
            *derivative = derivative.map(|x| x * factor);
        }
        jet
    }

    pub(super) fn position(&self, y: f64) -> Triple {
        self.jet(y)[0]
    }

    pub(in crate::curve) fn speed(&self, y: f64) -> f64 {
        norm(&self.jet(y)[1])
    }

    /// A bound of |r⁗| for all complex y of at most this modulus.
    fn fourth(&self, radius: f64) -> f64 {
        let mut sum = 0.0;
        for (k, power) in self.powers.iter().enumerate().skip(4).rev() {
            let k = k as f64;
            sum = sum * radius + k * (k - 1.0) * (k - 2.0) * (k - 3.0) * norm(power);
        }
        sum
    }

    /// A bound of |r″| on the whole piece.
    fn bend(&self) -> f64 {
        let [_, _, second, third] = self.jet(0.0);
        norm(&second) + 0.5 * norm(&third) + 0.125 * self.fourth(0.5)
    }

    /// The curvature, without a sign; `None` where the speed is below that share of the piece's size.
    pub(super) fn curvature(&self, y: f64, share: f64) -> Option<f64> {
        let [_, first, second, _] = self.jet(y);
        let size: f64 = self.powers.iter().skip(1).map(norm).sum();
        let speed = norm(&first);
        if speed <= share * size {
            return None;
        }
        // What of the second derivative is across the first.
        let across = along(&second, &first, -dot(&first, &second) / (speed * speed));
        let bend = norm(&across) / (speed * speed);
        bend.is_finite().then_some(bend)
    }

    /// Calls `found` with both ends and with every point where a coordinate turns.
    pub(super) fn extremes(&self, found: &mut dyn FnMut(Triple)) {
        let size: f64 = self.powers.iter().map(norm).sum();
        let fourth = self.fourth(0.5);
        for y in [-0.5, 0.5] {
            found(self.position(y));
        }
        for axis in 0..3 {
            let slopes = |y: f64| {
                let [_, first, second, third] = self.jet(y);
                [first[axis], second[axis], third[axis]]
            };
            turns(&slopes, &|_, _| fourth, size, &mut |y| found(self.position(y)));
        }
    }

    /// The length from lo to hi.
    ///
    /// Where |r′(u) − r′(m)| stays below (√2 − 1)·|r′(m)| on a disc, r′·r′ has no zero there and the speed is analytic (D 10.2).
    pub(in crate::curve) fn length(&self, lo: f64, hi: f64, tolerance: f64) -> f64 {
        let mut stack = [(0.0, 0.0); STACK];
        stack[0] = (lo, hi);
        let (mut open, mut total) = (1, 0.0);
        let density = 0.5 * tolerance / (hi - lo).max(f64::MIN_POSITIVE);
        while open > 0 {
            open -= 1;
            let (lo, hi) = stack[open];
            let (middle, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
            let [_, first, second, third] = self.jet(middle);
            let speed = norm(&first);
            let mut index = RULES.len();
            let mut most = speed;
            for axis in AXES {
                let reach = axis * half;
                let fourth = self.fourth(middle.abs() + reach);
                let change = reach * (norm(&second) + 0.5 * reach * (norm(&third) + reach * fourth / 3.0));
                most = speed + change;
                let within = (density * (hi - lo)).max(ROUNDING * half * most);
                if change < 0.414 * speed {
                    index = index.min(rule_index(axis, most, half, within) as usize);
                }
            }
            // Specks that close in on a cusp.
            if 2.0 * half * most <= tolerance / 16.0 {
                index = 0;
            }
            if index >= RULES.len() && open + 2 <= STACK && middle > lo && middle < hi {
                stack[open] = (middle, hi);
                stack[open + 1] = (lo, middle);
                open += 2;
                continue;
            }
            for &(x, weight) in RULES[index.min(RULES.len() - 1)] {
                total += half * weight * (self.speed(middle + half * x) + self.speed(middle - half * x));
            }
        }
        total
    }
}

/// A piece as seen from a place.
struct View<'a> {
    piece: &'a SpacePiece,
    place: Triple,
}

impl Near for View<'_> {
    fn slopes(&self, y: f64) -> Slopes {
        let [position, first, second, third] = self.piece.jet(y);
        let e = along(&position, &self.place, -1.0);
        Slopes {
            square: dot(&e, &e),
            first: dot(&e, &first),
            second: dot(&first, &first) + dot(&e, &second),
            third: 3.0 * dot(&first, &second) + dot(&e, &third),
        }
    }

    fn stiffness(&self, lo: f64, hi: f64) -> Stiffness {
        let [_, first, second, third] = self.piece.jet(0.5 * (lo + hi));
        let (half, fourth) = (0.5 * (hi - lo), self.piece.fourth(0.5));
        let jolt = norm(&third) + half * fourth;
        let fastest = norm(&first) + half * (norm(&second) + half * jolt);
        Stiffness { constant: 4.0 * fastest * jolt, slope: fourth, reach: fastest * (hi - lo) }
    }
}

pub(crate) fn nearest(curve: &dyn Pieces, place: Triple) -> SpaceNearest {
    let far = place.iter().map(|x| x.abs()).fold(0.0, f64::max);
    let slack = tie(&super::bounds::hull(curve)) + 4.0 * f64::EPSILON * far;
    let mut question = Question::new(Point::zeros(), slack);
    for i in 0..curve.piece_count() {
        search(&View { piece: &SpacePiece::new(curve, i), place }, i, &mut question, -0.5, 0.5);
    }
    let (i, y) = question.found();
    let i = i.min(curve.piece_count() - 1);
    let (from, to) = (curve.knot(i), curve.knot(i + 1));
    let point = SpacePiece::new(curve, i).position(y);
    let distance = norm(&along(&point, &place, -1.0));
    SpaceNearest { t: (from + (y + 0.5) * (to - from)).min(to), point, distance }
}

/// The point where piece i starts, to the last bit.
fn start(curve: &dyn Pieces, i: usize) -> Result<Triple> {
    let mut point = [0.0; 3];
    curve.values(&[curve.knot(i)], 0, &mut point)?;
    Ok(point)
}

/// So many equal parts that a bound with the power `order` of their number is within the tolerance.
fn parts(bound: f64, tolerance: f64, order: i32) -> f64 {
    let root = (bound / tolerance).sqrt();
    (if order == 2 { root } else { root.sqrt() }).ceil().max(1.0)
}

/// A chord of width h is at most h²/8·max|r″| away.
pub(super) fn flatten(curve: &dyn Pieces, tolerance: f64, most: usize) -> Result<(Vec<f64>, f64)> {
    let (mut out, mut deviation) = (Vec::new(), 0.0_f64);
    for i in 0..curve.piece_count() {
        let piece = SpacePiece::new(curve, i);
        let bound = 0.125 * piece.bend();
        let count = parts(bound, tolerance, 2);
        let needed = (out.len() / 3) as f64 + count;
        if needed > most as f64 {
            return Err(super::flatten::beyond(needed as usize));
        }
        deviation = deviation.max(bound / (count * count));
        out.extend(start(curve, i)?);
        for k in 1..count as usize {
            out.extend(piece.position(k as f64 / count - 0.5));
        }
    }
    if !curve.closed() {
        out.extend(start(curve, curve.piece_count())?);
    }
    Ok((out, deviation))
}

/// The cubic with the ends and end derivatives of an arc of width h is at most h⁴/384·max|r⁗| away.
pub(super) fn to_cubics(curve: &dyn Pieces, tolerance: f64, most: usize) -> Result<Cubics> {
    let mut cubics = Cubics::default();
    for i in 0..curve.piece_count() {
        cubics.first.push((cubics.path.len() / 12) as u32);
        let piece = SpacePiece::new(curve, i);
        let bound = piece.fourth(0.5) / 384.0;
        let count = parts(bound, tolerance, 4);
        let needed = (cubics.path.len() / 3) as f64 + 4.0 * count;
        if needed > most as f64 {
            return Err(super::flatten::beyond(needed as usize));
        }
        cubics.deviation = cubics.deviation.max(bound / (count * count * count * count));
        let third = 1.0 / (3.0 * count);
        for k in 0..count as usize {
            let at = |k: usize| piece.jet(k as f64 / count - 0.5);
            let ([from, leaving, ..], [to, arriving, ..]) = (at(k), at(k + 1));
            let from = if k == 0 { start(curve, i)? } else { from };
            let to = if k + 1 == count as usize { start(curve, i + 1)? } else { to };
            for point in [from, along(&from, &leaving, third), along(&to, &arriving, -third), to] {
                cubics.path.extend(point);
            }
        }
    }
    Ok(cubics)
}
