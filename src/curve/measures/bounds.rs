//! The smallest upright box around a curve.

use crate::curve::HermiteCurve;
use crate::curve::piece::Piece;
use crate::curve::pieces::{Pieces, hermite, in_space, space_piece};
use crate::curve::space_piece::{SpacePiece, Triple};
use crate::numerics::Point;
use crate::numerics::plane::{larger, taxi};
use crate::numerics::roots::bracketed_root;

/// Intervals below this share of a piece are not halved any more.
const LEAST_HALF: f64 = 1e-9;
/// The most intervals that are open at once.
const STACK: usize = 40;
/// Distances that differ by less than this share of the curve's size count as equal.
const TIE: f64 = 1e-13;

/// An upright box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Smallest x.
    pub min_x: f64,
    /// Smallest y.
    pub min_y: f64,
    /// Largest x.
    pub max_x: f64,
    /// Largest y.
    pub max_y: f64,
    /// Smallest z; 0 for a curve of the plane.
    pub min_z: f64,
    /// Largest z; 0 for a curve of the plane.
    pub max_z: f64,
}

impl Bounds {
    /// The largest of width, height and depth.
    pub fn extent(&self) -> f64 {
        larger(larger(self.max_x - self.min_x, self.max_y - self.min_y), self.max_z - self.min_z)
    }

    /// The largest coordinate, whatever its sign.
    pub(crate) fn largest(&self) -> f64 {
        let Self { min_x, min_y, min_z, max_x, max_y, max_z } = *self;
        [min_x, min_y, min_z, max_x, max_y, max_z].into_iter().fold(0.0, |most, x| larger(most, x.abs()))
    }

    /// Distances that differ by no more than this count as equal: less than the curve's points are rounded by cannot be
    /// told apart, and looking for it would halve arcs without end.
    pub(super) fn tie(&self) -> f64 {
        larger(TIE * self.extent(), 4.0 * f64::EPSILON * self.largest())
    }
}

/// A box that grows.
struct Grown {
    low: [f64; 3],
    high: [f64; 3],
}

impl Grown {
    const EMPTY: Self = Self { low: [f64::INFINITY; 3], high: [f64::NEG_INFINITY; 3] };

    #[inline]
    fn include(&mut self, coordinates: &[f64]) {
        // Comparisons instead of `min`: nothing here is not a number, and one instruction is enough.
        for (axis, &value) in coordinates.iter().enumerate() {
            self.low[axis] = if value < self.low[axis] { value } else { self.low[axis] };
            self.high[axis] = if value > self.high[axis] { value } else { self.high[axis] };
        }
    }

    #[inline(never)]
    fn include_place(&mut self, piece: &Piece, y: f64) {
        self.include(piece.position(y).as_slice());
    }

    fn holds(&self, axis: usize, value: f64) -> bool {
        value >= self.low[axis] && value <= self.high[axis]
    }

    fn bounds(&self, dimension: usize) -> Bounds {
        let ([min_x, min_y, z], [max_x, max_y, top]) = (self.low, self.high);
        let [min_z, max_z] = if dimension == 3 { [z, top] } else { [0.0; 2] };
        Bounds { min_x, min_y, max_x, max_y, min_z, max_z }
    }
}

pub(crate) fn bounds(curve: &dyn Pieces) -> Bounds {
    let mut grown = Grown::EMPTY;
    let last = curve.piece_count();
    if in_space(curve) {
        for i in 0..last {
            extremes(&space_piece(curve, i), &mut |point| grown.include(&point));
        }
        return grown.bounds(3);
    }
    let own = hermite(curve);
    match own {
        Some(curve) => curve.points().iter().for_each(|point| grown.include(point.as_slice())),
        None => (0..=last).for_each(|i| grown.include(curve.start(i).as_slice())),
    }
    for i in 0..last {
        let [first, second] = handles(curve, own, i);
        for axis in 0..2 {
            if !(grown.holds(axis, first[axis]) && grown.holds(axis, second[axis])) {
                let piece = curve.piece(i);
                stationary(&piece, axis, &mut |y| grown.include_place(&piece, y));
            }
        }
    }
    grown.bounds(2)
}

/// [`Pieces::handles`], without a call through a table where it would show.
#[inline]
fn handles(curve: &dyn Pieces, own: Option<&HermiteCurve>, i: usize) -> [Point; 2] {
    match own {
        Some(own) => own.nth_segment(i).inner_points(),
        None => curve.handles(i),
    }
}

/// A box that holds the curve, quicker than the smallest one.
pub(crate) fn hull(curve: &dyn Pieces) -> Bounds {
    let mut grown = Grown::EMPTY;
    let last = curve.piece_count();
    if in_space(curve) {
        for i in 0..last {
            space_piece(curve, i).corners().iter().for_each(|corner| grown.include(corner));
        }
        return grown.bounds(3);
    }
    if let Some(own) = hermite(curve) {
        return frame(own, 0.0);
    }
    for i in 0..=last {
        grown.include(curve.start(i).as_slice());
        if i < last {
            for handle in curve.handles(i) {
                grown.include(handle.as_slice());
            }
        }
    }
    grown.bounds(2)
}

/// The box around the points of a Hermite curve and its generalised Bézier points, those with a κ below `least` as far
/// out as with that.
#[inline(never)]
pub(crate) fn frame(curve: &HermiteCurve, least: f64) -> Bounds {
    let mut grown = Grown::EMPTY;
    for point in curve.points() {
        grown.include(point.as_slice());
    }
    for segment in curve.segments() {
        let reach = larger(segment.basis.kappa(), least) * segment.length;
        grown.include((segment.start + segment.leaving * reach).as_slice());
        grown.include((segment.end - segment.arriving * reach).as_slice());
    }
    grown.bounds(2)
}

/// Calls `found` with every y in (−1/2, 1/2) where one coordinate of the piece turns.
#[inline(never)]
pub(crate) fn stationary(piece: &Piece, axis: usize, found: &mut dyn FnMut(f64)) {
    let [a, b, p, q] = piece.coefficients();
    if piece.is_cubic() {
        let (b, p, q) = (b[axis], p[axis], q[axis]);
        let discriminant = p * p - 2.0 * q * b;
        if discriminant > 0.0 {
            let s = -(p + discriminant.sqrt().copysign(p));
            for y in [s / q, 2.0 * b / s] {
                if y > -0.5 && y < 0.5 {
                    found(y);
                }
            }
        }
        return;
    }
    let slopes = |y: f64| {
        let jet = piece.jet(y);
        [jet.first[axis], jet.second[axis], jet.third[axis]]
    };
    let fourth = |lo: f64, hi: f64| piece.fourth(piece.bend(lo, hi));
    turns(&slopes, &fourth, taxi(a) + taxi(b) + taxi(p) + taxi(q), found);
}

/// Calls `found` with both ends of a piece in space and with every point where a coordinate turns.
fn extremes(piece: &SpacePiece, found: &mut dyn FnMut(Triple)) {
    let size = piece.size();
    for y in [-0.5, 0.5] {
        found(piece.position(y));
    }
    for axis in 0..3 {
        // The bound of this coordinate: by that of all a flat one, of a curve in a plane, would be halved down to its
        // roundings.
        let fourth = piece.fourth_of(0.5, &|power| power[axis].abs());
        let slopes = |y: f64| {
            let [_, first, second, third] = piece.jet(y);
            [first[axis], second[axis], third[axis]]
        };
        turns(&slopes, &|_, _| fourth, size, &mut |y| found(piece.position(y)));
    }
}

/// Calls `found` where a function of the size `size` on [−1/2, 1/2] turns, by its first three derivatives and a bound
/// of the fourth.
///
/// An interval is passed over where Taylor's formula proves that the first derivative has no zero, solved where it
/// proves it monotone, and else halved. Where the function stays within a rounding any point will do (D 10.3).
#[inline(never)]
fn turns(
    slopes: &dyn Fn(f64) -> [f64; 3],
    fourth: &dyn Fn(f64, f64) -> f64,
    size: f64,
    found: &mut dyn FnMut(f64),
) {
    let mut stack = [(0.0, 0.0); STACK];
    stack[0] = (-0.5, 0.5);
    let mut open = 1;
    while open > 0 {
        open -= 1;
        let (lo, hi) = stack[open];
        let (middle, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
        let ([first, second, third], rest) = (slopes(middle), fourth(lo, hi));
        let bend = half * (third.abs() + 0.5 * half * rest);
        let sway = half * (second.abs() + 0.5 * half * (third.abs() + half * rest / 3.0));
        if first.abs() > sway {
            continue;
        }
        if half * (first.abs() + sway) <= f64::EPSILON * size || half < LEAST_HALF || open + 2 > STACK {
            found(middle);
        } else if second.abs() > bend {
            let rising = second > 0.0;
            let (at_lo, at_hi) = (slopes(lo)[0], slopes(hi)[0]);
            // A zero where two intervals meet belongs to both.
            let (below, above) = if rising { (at_lo, at_hi) } else { (at_hi, at_lo) };
            if below <= 0.0 && above >= 0.0 {
                found(bracketed_root(lo, hi, rising, middle, &mut |y| {
                    let [first, second, _] = slopes(y);
                    (first, second)
                }));
            }
        } else {
            stack[open] = (middle, hi);
            stack[open + 1] = (lo, middle);
            open += 2;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What does not change across a plane turns nowhere: the answer is a few points, whatever the curve does within
    /// the plane.
    #[test]
    fn a_curve_in_a_plane_of_space_takes_no_longer_for_the_flat_coordinate() {
        // A quarter of a circle at a height of 0.1, by its Taylor coefficients.
        let mut coefficients = vec![1.0, 0.0, 0.1];
        let mut factor = 1.0;
        for k in 1..24 {
            factor *= 1.5 / f64::from(k);
            let [x, y] = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]][k as usize % 4];
            coefficients.extend([x * factor, y * factor, 0.0]);
        }
        let mut seen = 0;
        extremes(&SpacePiece::polynomial(&coefficients), &mut |point| {
            assert!((point[2] - 0.1).abs() < 1e-16);
            seen += 1;
        });
        assert!(seen <= 6, "{seen} points");
    }
}
