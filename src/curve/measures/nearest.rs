//! The nearest point of a curve: never missed, and fast for many questions.
//!
//! Every segment is cut into arcs that stay near their chords, by a bound; boxes around them form a tree. A question
//! visits what could hold a nearer point than the best so far. On an arc Halley's method finds a stationary point, and
//! Taylor's formula with a bound of the fourth derivative proves that nothing on the arc is nearer; where the proof
//! does not succeed, the arc is halved ([`super::search`]).

use super::bounds::bounds;
use super::search::{Question, Stiffness, View, search};
use crate::curve::piece::Piece;
use crate::curve::pieces::Pieces;
use crate::numerics::Point;
use crate::numerics::plane::{norm, smaller, square};

/// Children of a node of the tree.
const FAN: usize = 16;
/// Arcs of a group, which shares a box.
const ARCS: usize = 4;
/// Groups are halved until their arcs are this near their chords, relative to the size of the curve…
const FLATNESS: f64 = 0.02;
/// …but a segment is not cut into more than 2⁵ groups.
const MOST_HALVINGS: u32 = 5;

/// The point of a curve that is nearest to a place.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Nearest {
    /// Its parameter.
    pub t: f64,
    /// The point.
    pub point: Point,
    /// Its distance.
    pub distance: f64,
}

/// A curve prepared for many questions after its nearest point.
///
/// # Example
///
/// ```
/// use expline::{HermiteCurve, numerics::Point};
/// use expline::curve::NearestFinder;
///
/// let circle = HermiteCurve::ellipse(Point::zeros(), Point::new(2.0, 2.0), 0.0, 4)?;
/// let found = NearestFinder::new(&circle).nearest(Point::new(3.0, 4.0));
/// assert!((found.distance - 3.0).abs() < 1e-15);
/// # Ok::<(), expline::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct NearestFinder {
    pieces: Vec<Piece>,
    knots: Vec<f64>,
    groups: Vec<Group>,
    /// From the boxes of the groups up to a level of one node.
    levels: Vec<Vec<Boxes>>,
    center: Point,
    slack: f64,
}

/// Four arcs that follow each other on one piece, and their chords.
#[derive(Clone, Copy, Debug)]
struct Group {
    from: [[f64; ARCS]; 2],
    chord: [[f64; ARCS]; 2],
    /// 1/|chord|², 0 for a chord that is a point.
    inverse: [f64; ARCS],
    /// No point of the arc is farther from the chord, nor of the chord from the arc.
    thickness: [f64; ARCS],
    stiffness: Stiffness,
    piece: usize,
    start: f64,
    width: f64,
}

/// Upright boxes, as many as a node has children; unused ones are infinitely far away.
#[derive(Clone, Copy, Debug)]
struct Boxes {
    low: [[f64; FAN]; 2],
    high: [[f64; FAN]; 2],
}

impl Boxes {
    const NONE: Self = Self { low: [[f64::INFINITY; FAN]; 2], high: [[f64::NEG_INFINITY; FAN]; 2] };

    /// The squares of the distances to all.
    #[inline]
    fn distances(&self, place: Point) -> [f64; FAN] {
        // Zeros would be filled in by a call of the engine's.
        let mut squares = [f64::INFINITY; FAN];
        for (k, square) in squares.iter_mut().enumerate() {
            let gap = |axis: usize| {
                let (below, above) = (self.low[axis][k] - place[axis], place[axis] - self.high[axis][k]);
                let outside = if below > above { below } else { above };
                if outside > 0.0 { outside } else { 0.0 }
            };
            let (x, y) = (gap(0), gap(1));
            *square = x * x + y * y;
        }
        squares
    }
}

/// Which of the distances is the least, or as good as it. As whole numbers, with their place in the last four bits,
/// they are compared several at a time and bring it along; a branch for each would often be foreseen wrongly.
#[inline]
fn first_of(distances: &[f64; FAN]) -> usize {
    let mut keys = [0; FAN];
    for (k, (key, distance)) in keys.iter_mut().zip(distances).enumerate() {
        *key = (distance.to_bits() & !(FAN as u64 - 1)) | k as u64;
    }
    let (mut eight, mut four) = ([0; FAN / 2], [0; FAN / 4]);
    for (k, least) in eight.iter_mut().enumerate() {
        *least = if keys[k] < keys[k + 8] { keys[k] } else { keys[k + 8] };
    }
    for (k, least) in four.iter_mut().enumerate() {
        *least = if eight[k] < eight[k + 4] { eight[k] } else { eight[k + 4] };
    }
    let [a, b, c, d] = four;
    (a.min(b).min(c.min(d)) & (FAN as u64 - 1)) as usize
}

/// An upright box: its least coordinates, and its largest ones negated, so that the box around several has the least of
/// all four.
type Corners = [f64; 4];

/// The tree over these boxes, from their own level up to one of one node.
fn tree(mut corners: Vec<Corners>) -> Vec<Vec<Boxes>> {
    let mut levels = Vec::new();
    loop {
        let nodes = corners.len().div_ceil(FAN);
        let (mut level, mut above) = (Vec::with_capacity(nodes), Vec::with_capacity(nodes));
        for children in corners.chunks(FAN) {
            let (mut boxes, mut around) = (Boxes::NONE, [f64::INFINITY; 4]);
            for (k, child) in children.iter().enumerate() {
                for axis in 0..2 {
                    boxes.low[axis][k] = child[axis];
                    boxes.high[axis][k] = -child[axis + 2];
                }
                for (least, &value) in around.iter_mut().zip(child) {
                    *least = smaller(*least, value);
                }
            }
            level.push(boxes);
            above.push(around);
        }
        levels.push(level);
        if above.len() < 2 {
            return levels;
        }
        corners = above;
    }
}

impl NearestFinder {
    /// Prepares what is known by its pieces.
    pub(crate) fn of(curve: &dyn Pieces) -> Self {
        let bounds = bounds(curve);
        let extent = bounds.extent();
        let count = curve.piece_count();
        let mut groups = Vec::with_capacity(count);
        let (mut pieces, mut knots) = (Vec::with_capacity(count), vec![curve.knot(0)]);
        for i in 0..count {
            let piece = curve.piece(i);
            knots.push(curve.knot(i + 1));
            add_groups(&mut groups, &piece, pieces.len(), FLATNESS * extent);
            pieces.push(piece);
        }
        let levels = tree(groups.iter().map(Group::corners).collect());
        let center = Point::new(0.5 * (bounds.min_x + bounds.max_x), 0.5 * (bounds.min_y + bounds.max_y));
        Self { pieces, knots, groups, levels, center, slack: bounds.tie() }
    }

    /// The point of the curve that is nearest to `place`; see [`Curve::nearest`](crate::curve::Curve::nearest).
    ///
    /// # Cost
    ///
    /// O(log segments) for places near the curve, about 0.4 µs for 16 cubic segments.
    pub fn nearest(&self, place: Point) -> Nearest {
        let far = place - self.center;
        let slack = self.slack + 4.0 * f64::EPSILON * (far.x.abs() + far.y.abs());
        let mut question = Question::new(place, slack);
        // Comparisons with what is not a number would drop no arc, and halve them all.
        if slack.is_finite() {
            self.visit(&mut question, self.levels.len() - 1, 0);
        }
        let (piece, y) = question.found();
        let Some(on) = self.pieces.get(piece) else {
            return Nearest { t: 0.0, point: place, distance: f64::INFINITY };
        };
        let (from, to) = (self.knots[piece], self.knots[piece + 1]);
        let point = on.position(y);
        Nearest { t: smaller(from + (y + 0.5) * (to - from), to), point, distance: norm(point - place) }
    }

    fn visit(&self, question: &mut Question, level: usize, node: usize) {
        let Some(boxes) = self.levels[level].get(node) else { return };
        let distances = boxes.distances(question.place);
        let first = first_of(&distances);
        self.descend(question, level, FAN * node + first);
        // As bits, so that what is not within reach, which is most, is passed by without a branch for each.
        let mut within = 0_u32;
        for (k, &distance) in distances.iter().enumerate() {
            within |= u32::from(distance < question.reach_squared) << k;
        }
        within &= !(1 << first);
        while within != 0 {
            let k = within.trailing_zeros() as usize;
            within &= within - 1;
            if distances[k] < question.reach_squared {
                self.descend(question, level, FAN * node + k);
            }
        }
    }

    fn descend(&self, question: &mut Question, level: usize, child: usize) {
        if level > 0 {
            self.visit(question, level - 1, child);
        } else if let Some(group) = self.groups.get(child) {
            group.ask(&self.pieces[group.piece], question);
        }
    }
}

/// Cuts the piece into groups whose arcs are within `flatness` of their chords where that takes not too many.
fn add_groups(groups: &mut Vec<Group>, piece: &Piece, index: usize, flatness: f64) {
    let mut stack = [(0.0, 0.0, 0); MOST_HALVINGS as usize + 1];
    stack[0] = (-0.5, 0.5, 0);
    let mut open = 1;
    while open > 0 {
        open -= 1;
        let (lo, hi, depth) = stack[open];
        let width = hi - lo;
        let bend = piece.bend(lo, hi);
        let step = width / ARCS as f64;
        let thickness = 0.125 * step * step * bend;
        if thickness > flatness && depth < MOST_HALVINGS {
            let middle = 0.5 * (lo + hi);
            stack[open] = (middle, hi, depth + 1);
            stack[open + 1] = (lo, middle, depth + 1);
            open += 2;
            continue;
        }
        groups.push(Group::new(piece, index, lo, width, thickness, bend));
    }
}

impl Group {
    #[inline(never)]
    fn new(piece: &Piece, index: usize, start: f64, width: f64, thickness: f64, bend: f64) -> Self {
        let step = width / ARCS as f64;
        let mut group = Self {
            from: [[0.0; ARCS]; 2],
            chord: [[0.0; ARCS]; 2],
            inverse: [0.0; ARCS],
            thickness: [thickness; ARCS],
            stiffness: Stiffness::new(piece, start, start + width, bend),
            piece: index,
            start,
            width: step,
        };
        let mut from = piece.position(start);
        for k in 0..ARCS {
            let end = start + step * (k + 1) as f64;
            let to = piece.position(end);
            let chord = to - from;
            if piece.is_cubic() {
                // r″ is linear, so its largest values are at the ends.
                let bend = norm(piece.jet(end).second).max(norm(piece.jet(end - step).second));
                group.thickness[k] = 0.125 * step * step * bend;
            }
            for axis in 0..2 {
                group.from[axis][k] = from[axis];
                group.chord[axis][k] = chord[axis];
            }
            let inverse = 1.0 / square(chord);
            group.inverse[k] = if inverse.is_finite() { inverse } else { 0.0 };
            from = to;
        }
        group
    }

    /// The corners of the box around the arcs.
    fn corners(&self) -> Corners {
        let ((left, right), (bottom, top)) = (self.span(0), self.span(1));
        [left, bottom, -right, -top]
    }

    /// The least and the largest coordinate. Comparisons instead of `min`: nothing here is not a number.
    #[inline(never)]
    fn span(&self, axis: usize) -> (f64, f64) {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for ((&from, chord), &thickness) in self.from[axis].iter().zip(&self.chord[axis]).zip(&self.thickness)
        {
            for end in [from, from + chord] {
                low = if end - thickness < low { end - thickness } else { low };
                high = if end + thickness > high { end + thickness } else { high };
            }
        }
        (low, high)
    }

    /// Asks the arcs that may hold a nearer point, the one with the nearest chord first.
    #[inline(never)]
    fn ask(&self, piece: &Piece, question: &mut Question) {
        let (mut along, mut squares) = ([0.0; ARCS], [0.0; ARCS]);
        let place = question.place;
        for k in 0..ARCS {
            let (x, y) = (place.x - self.from[0][k], place.y - self.from[1][k]);
            let share = (x * self.chord[0][k] + y * self.chord[1][k]) * self.inverse[k];
            let share = if share > 0.0 { share } else { 0.0 };
            let share = if share < 1.0 { share } else { 1.0 };
            let (x, y) = (x - share * self.chord[0][k], y - share * self.chord[1][k]);
            along[k] = share;
            squares[k] = x * x + y * y;
        }
        let mut first = 0;
        for k in 1..ARCS {
            if squares[k] < squares[first] {
                first = k;
            }
        }
        self.ask_arc(piece, question, first, squares[first], along[first]);
        for k in 0..ARCS {
            if k != first {
                self.ask_arc(piece, question, k, squares[k], along[k]);
            }
        }
    }

    #[inline]
    fn ask_arc(&self, piece: &Piece, question: &mut Question, k: usize, square: f64, along: f64) {
        let within = question.reach + self.thickness[k];
        if square >= within * within {
            return;
        }
        let lo = self.start + self.width * k as f64;
        let (hi, guess) = (lo + self.width, lo + self.width * along);
        if !question.ask_arc(piece, self.piece, &self.stiffness, lo, hi, guess) {
            search(&View { piece, place: question.place }, self.piece, question, lo, hi);
        }
    }
}
