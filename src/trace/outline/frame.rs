//! Outlines end where the picture does: corners that sides of ink on the border lead to may lie far beyond it.

use super::cubic::Cubic;
use super::{Node, Outline, Piece};
use crate::numerics::Point;
use crate::numerics::plane::{larger, smaller};

/// What is beyond the picture by less than this stays, in pixels: sides along the border are as near to it as pixels
/// say.
const STRAY: f64 = 0.25;
/// Parts of a piece below this share of it are none.
const NOTHING: f64 = 1e-9;

/// A side of the picture: beyond it, what is measured along an axis from a limit has this sign.
#[derive(Clone, Copy, Debug)]
struct Side {
    axis: usize,
    limit: f64,
    sign: f64,
}

/// A place on an outline: a piece, and the parameter there.
type Place = (usize, f64);

impl Outline {
    /// Cuts off what is beyond a picture of so many columns and rows, and goes along its border instead. What is beyond
    /// by less than a quarter of a pixel stays.
    pub(in crate::trace) fn cut_to(&mut self, [width, height]: [f64; 2]) {
        for (axis, limit, sign) in [(0, 0.0, -1.0), (1, 0.0, -1.0), (0, width, 1.0), (1, height, 1.0)] {
            let side = Side { axis, limit, sign };
            let parts = side.beyond(self);
            if !parts.is_empty() {
                *self = self.without(&parts, &side);
            }
        }
    }

    /// The outline with straight pieces in the place of some parts, which are given in order by their ends.
    #[inline(never)]
    fn without(&self, parts: &[[Place; 2]], side: &Side) -> Self {
        let mut rest = Self::default();
        for (k, &[from, to]) in parts.iter().enumerate() {
            rest.push(Node { point: side.border(self, from), smooth: false, kept: false }, Piece::Line);
            let [until, _] = parts[(k + 1) % parts.len()];
            rest.append(self, to, until, side.border(self, to));
        }
        rest
    }

    /// Appends the pieces of another outline from a place of it to the next one, which is not a part of them; the first
    /// begins at a point.
    fn append(&mut self, other: &Self, from: Place, until: Place, point: Point) {
        let (mut at, mut node) = (from, Node { point, smooth: false, kept: false });
        let count = self.len();
        loop {
            let last = at.0 == until.0 && at.1 <= until.1;
            let end = if last { until.1 } else { 1.0 };
            if end - at.1 > NOTHING {
                let Cubic { leaving, arriving, .. } = other.cubic(at.0).part(at.1, end);
                let is_line = other.is_line(at.0);
                self.push(node, if is_line { Piece::Line } else { Piece::Cubic { leaving, arriving } });
            }
            if last {
                return;
            }
            at = (other.next(at.0), 0.0);
            node = other.nodes[at.0];
            node.smooth &= self.len() > count;
        }
    }
}

impl Side {
    /// How far a point is beyond the side.
    fn depth(&self, point: Point) -> f64 {
        self.sign * (point[self.axis] - self.limit)
    }

    /// The point of an outline at a place, which is on the side.
    #[inline(never)]
    fn border(&self, outline: &Outline, (piece, t): Place) -> Point {
        let mut point = outline.cubic(piece).point(t);
        point[self.axis] = self.limit;
        point
    }

    /// The parts of an outline that reach too far beyond the side, from where they leave the picture to where they come
    /// back; none if all of it is outside.
    #[inline(never)]
    fn beyond(&self, outline: &Outline) -> Vec<[Place; 2]> {
        let mut parts = Vec::new();
        let count = outline.len();
        let Some(first) = (0..count).find(|&i| self.depth(outline.nodes[i].point) <= 0.0) else {
            return parts;
        };
        let (mut left, mut deepest) = ((first, 0.0), 0.0);
        for piece in (first..first + count).map(|k| k % count) {
            let Cubic { start, leaving, arriving, end } = outline.cubic(piece);
            let depths = [start, start + leaving, end - arriving, end].map(|point| self.depth(point));
            // A cubic is where its control points are.
            if depths.iter().all(|&depth| depth <= 0.0) {
                continue;
            }
            for ends in turns(&depths).windows(2) {
                let [before, after] = [ends[0], ends[1]].map(|t| value(&depths, t));
                if before <= 0.0 && after > 0.0 {
                    (left, deepest) = ((piece, crossing(&depths, ends)), 0.0);
                }
                deepest = larger(deepest, after);
                if before > 0.0 && after <= 0.0 && deepest > STRAY {
                    parts.push([left, (piece, crossing(&depths, ends))]);
                }
            }
        }
        parts
    }
}

/// Bernstein's polynomial of four numbers.
#[inline(never)]
fn value(numbers: &[f64; 4], t: f64) -> f64 {
    let [a, b, c, d] = Cubic::bernstein(t);
    a * numbers[0] + b * numbers[1] + c * numbers[2] + d * numbers[3]
}

/// Its ends, and where between them it turns around.
fn turns(&[from, out, back, to]: &[f64; 4]) -> [f64; 4] {
    let (a, b, c) = (out - from, back - out, to - back);
    // The slope a(1 − t)² + 2b(1 − t)t + ct² is a + 2(b − a)t + (a − 2b + c)t²: both roots without cancellation. Where
    // there are none, two places more do no harm.
    let (half, square) = (b - a, a - 2.0 * b + c);
    let q = -(half + (half * half - a * square).abs().sqrt().copysign(half));
    let [first, second] = [q / square, a / q].map(|t| if t > 0.0 && t < 1.0 { t } else { 0.0 });
    [0.0, smaller(first, second), larger(first, second), 1.0]
}

/// Where it is 0, which it is once between two parameters: halved until nothing is between them.
#[inline(never)]
fn crossing(numbers: &[f64; 4], ends: &[f64]) -> f64 {
    let (mut lo, mut hi) = (ends[0], ends[1]);
    let outside = value(numbers, lo) > 0.0;
    for _ in 0..f64::MANTISSA_DIGITS {
        let middle = 0.5 * (lo + hi);
        if (value(numbers, middle) > 0.0) == outside {
            lo = middle;
        } else {
            hi = middle;
        }
    }
    hi
}

#[cfg(test)]
mod tests {
    use super::super::ellipse::round;
    use super::super::{Node, Outline, Piece};
    use crate::curve::Curve;
    use crate::numerics::{Point, Vector};
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    const SIZE: [f64; 2] = [40.0, 30.0];

    fn polygon(corners: &[(f64, f64)]) -> Outline {
        let node = |&(x, y): &(f64, f64)| Node { point: Point::new(x, y), smooth: false, kept: false };
        Outline { nodes: corners.iter().map(node).collect(), pieces: vec![Piece::Line; corners.len()] }
    }

    /// Four cubics around a centre: a circle to 3e-4 of its radius.
    fn circle(center: Point, radius: f64) -> Outline {
        let angle = |k: i32| f64::from(k) * core::f64::consts::PI / 300.0;
        let places: Vec<Point> =
            (0..600).map(|k| center + Vector::new(angle(k).cos(), angle(k).sin()) * radius).collect();
        round(&places, 0.1).expect("places of a circle")
    }

    /// The outline cut to the picture, and its area then.
    fn cut(outline: &Outline) -> (Outline, f64) {
        let mut cut = outline.clone();
        cut.cut_to(SIZE);
        let b = cut.to_curve(vec![0.0; cut.len()]).expect("a curve").bounds();
        // A root is known to the rounding of its cubic.
        assert!(b.min_x > -1e-12 && b.min_y > -1e-12 && b.max_x < 40.0 + 1e-12 && b.max_y < 30.0 + 1e-12);
        let area = area(&cut);
        (cut, area)
    }

    fn area(outline: &Outline) -> f64 {
        let curve = outline.to_curve(vec![0.0; outline.len()]).expect("a curve");
        curve.area().expect("it is closed")
    }

    #[test]
    fn tips_beyond_the_picture_end_in_two_corners_on_its_border() {
        // One tip, two on one side, and a rhombus around a corner of the picture.
        let tip = polygon(&[(-2.0, 8.0), (6.0, 4.0), (6.0, 12.0)]);
        let (blunt, rest) = cut(&tip);
        assert_eq!(blunt.len(), 4);
        assert!((rest - 30.0).abs() < 1e-12, "{rest}");
        let teeth = polygon(&[(10.0, 2.0), (10.0, 28.0), (-5.0, 20.0), (5.0, 15.0), (-5.0, 10.0)]);
        let (blunt, rest) = cut(&teeth);
        // Beyond the border are two triangles: on the way of 5 to each tip one side rises by 8/3, the other by 5/2.
        let outside = 2.0 * 0.5 * 5.0 * (8.0 / 3.0 + 5.0 / 2.0);
        assert_eq!(blunt.len(), 7);
        assert!((rest - (area(&teeth) - outside)).abs() < 1e-12, "{rest}");
        let rhombus = polygon(&[(44.0, 30.0), (40.0, 34.0), (36.0, 30.0), (40.0, 26.0)]);
        let (corner, rest) = cut(&rhombus);
        assert_eq!(corner.len(), 3);
        assert!((rest - 8.0).abs() < 1e-12, "{rest}");
    }

    #[test]
    fn bulges_beyond_the_picture_end_on_its_border() {
        for (x, y, depth) in [(3.0, 15.0, 2.0), (38.5, 12.0, 3.5), (20.0, 1.0, 4.0), (9.0, 28.0, 3.0)] {
            let round = circle(Point::new(x, y), 5.0);
            let (flat, area) = cut(&round);
            let off = 5.0 - depth;
            let outside = 25.0 * (off / 5.0_f64).acos() - off * (25.0_f64 - off * off).sqrt();
            // Four cubics have 5.5e-4 more of a circle's area.
            assert!((area - (25.0 * core::f64::consts::PI - outside)).abs() < 0.06, "{area}");
            let corners = flat.nodes.iter().filter(|node| !node.smooth).count();
            assert_eq!(corners, 2, "where the border begins and ends");
        }
    }

    #[test]
    fn what_is_inside_or_hardly_outside_stays_and_so_does_what_is_nowhere_inside() {
        for outline in [
            polygon(&[(0.0, 0.0), (40.0, 0.0), (40.0, 30.0), (0.0, 30.0)]),
            polygon(&[(-0.2, 0.1), (40.1, -0.2), (40.0, 30.2), (0.1, 30.0)]),
            circle(Point::new(5.0, 5.0), 5.2),
            polygon(&[(-9.0, 0.0), (-5.0, 4.0), (-9.0, 8.0)]),
        ] {
            let mut cut = outline.clone();
            cut.cut_to(SIZE);
            assert_eq!(cut, outline);
        }
    }
}
