//! One look at a curve from a point.

use super::breaks::HIGHEST;
use crate::numerics::{Point, Vector};

/// One piece of a curve: a polynomial in ascending powers.
pub(super) type Piece = [Vector; HIGHEST + 1];

/// A polynomial of degree below T and its first two derivatives at u.
#[inline(always)]
pub(super) fn taylor<const T: usize>(p: &Piece, u: f64) -> [Vector; 3] {
    let [mut value, mut first, mut second] = [Vector::zeros(); 3];
    for c in p[..T].iter().rev() {
        second = second * u + first;
        first = first * u + value;
        value = value * u + c;
    }
    [value, first, second * 2.0]
}

/// The curve at one place of a piece, seen from a point; derivatives by the piece's own variable.
pub(super) struct Look {
    pub(super) u: f64,
    pub(super) square: f64,
    way: Vector,
    first: Vector,
    second: Vector,
}

impl Look {
    #[inline(always)]
    pub(super) fn new<const T: usize>(polynomial: &Piece, u: f64, target: Point) -> Self {
        let [place, first, second] = taylor::<T>(polynomial, u);
        let way = Vector::new(place.x - target.x, place.y - target.y);
        Self { u, square: way.x * way.x + way.y * way.y, way, first, second }
    }

    /// Newton's step to where the way is across the curve, Gauss's where that would lead to the farthest point, and by
    /// how much the square of the distance should fall.
    #[inline(always)]
    pub(super) fn newton(&self) -> (f64, f64) {
        let (way, first, second) = (self.way, self.first, self.second);
        let speed = first.x * first.x + first.y * first.y;
        let bend = speed + (way.x * second.x + way.y * second.y);
        let slope = if bend > 0.3 * speed { bend } else { speed };
        let along = way.x * first.x + way.y * first.y;
        let step = if slope > 0.0 { -along / slope } else { 0.0 };
        (step, -step * along)
    }
}
