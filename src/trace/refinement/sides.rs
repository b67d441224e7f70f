//! What lies on both sides of a bend, and what may take its place.

use super::bends::Bend;
use crate::numerics::plane::{cross, dot, norm};
use crate::numerics::{Point, Vector};
use crate::trace::outline::cubic::Cubic;
use crate::trace::outline::{Node, Outline, Piece};
use crate::trace::samples::unit;

/// The farthest that a corner may be from its sides, in pixels.
const FARTHEST: f64 = 12.0;
/// A side is at least so long, in pixels, or the joint before it goes too.
const SIDE: f64 = 1.0;

/// What stays on both sides of a bend.
pub(super) struct Sides {
    /// The first piece and the last.
    pub(super) pieces: [usize; 2],
    /// How many pieces there are from one to the other.
    pub(super) count: usize,
    pub(super) cubics: [Cubic; 2],
    pub(super) tangents: [Vector; 2],
}

pub(super) fn sides(outline: &Outline, bend: &Bend) -> Option<Sides> {
    let [(mut first, mut from), (mut last, mut to)] = bend.sides;
    let mut count = if last >= first { last - first } else { last + outline.len() - first } + 1;
    if first == last && from >= to {
        return None;
    }
    let reach = |piece: usize, t: f64, first: bool| {
        let cubic = if first { outline.cubic(piece).part(0.0, t) } else { outline.cubic(piece).part(t, 1.0) };
        norm(cubic.end - cubic.start)
    };
    if reach(first, from, true) < SIDE && outline.nodes[first].smooth {
        (first, from) = (outline.before(first), 1.0);
        count += 1;
    }
    if reach(last, to, false) < SIDE && outline.nodes[outline.next(last)].smooth {
        (last, to) = (outline.next(last), 0.0);
        count += 1;
    }
    if count >= outline.len() || reach(first, from, true) < 0.3 || reach(last, to, false) < 0.3 {
        return None;
    }
    let cubics = [outline.cubic(first).part(0.0, from), outline.cubic(last).part(to, 1.0)];
    let tangents = [unit(outline.cubic(first).velocity(from)), unit(outline.cubic(last).velocity(to))];
    Some(Sides { pieces: [first, last], count, cubics, tangents })
}

impl Sides {
    /// Where the sides meet if they go straight on.
    pub(super) fn meet(&self) -> Option<Point> {
        let (from, to) = (self.cubics[0].end, self.cubics[1].start);
        let (gap, across) = (to - from, cross(self.tangents[0], self.tangents[1]));
        let (ahead, behind) = (cross(gap, self.tangents[1]) / across, cross(self.tangents[0], gap) / across);
        let near = |way: f64| way > -0.2 && way < FARTHEST;
        (near(ahead) && near(behind)).then(|| from + self.tangents[0] * ahead)
    }

    /// Both sides led on to a corner.
    pub(super) fn corner(&self, outline: &Outline, corner: Point) -> Change {
        let pieces = vec![self.led(outline, 0, corner), self.led(outline, 1, corner)];
        Change { between: vec![sharp(corner)], pieces, corner: Some(1) }
    }

    /// A side as it was cut, led on to a place.
    fn led(&self, outline: &Outline, side: usize, to: Point) -> Piece {
        if outline.is_line(self.pieces[side]) {
            return Piece::Line;
        }
        let Cubic { start, leaving, arriving, end } = self.cubics[side];
        let (cut, far) = if side == 0 { (end, start) } else { (start, end) };
        let scale = (1.0 + dot(to - cut, unit(cut - far)) / norm(cut - far)).max(0.5);
        let [leaving, arriving] = if scale > 1.5 {
            [leaving, arriving].map(|way| unit(way) * (norm(to - far) / 3.0))
        } else {
            [leaving * scale, arriving * scale]
        };
        Piece::Cubic { leaving, arriving }
    }

    /// Both sides led on to one smooth joint.
    pub(super) fn joint(&self, outline: &Outline) -> Change {
        let ([from, to], [there, back]) = ([self.cubics[0].end, self.cubics[1].start], self.tangents);
        let way = to - from;
        let point = (from + to) * 0.5 + (there - back) * (0.125 * norm(way));
        let along = unit(unit(way) * 1.5 - (there + back) * 0.25);
        let led = |side: usize| match self.led(outline, side, point) {
            Piece::Line => {
                let third =
                    (if side == 0 { point - self.cubics[0].start } else { self.cubics[1].end - point }) / 3.0;
                [third, third]
            }
            Piece::Cubic { leaving, arriving } => [leaving, arriving],
        };
        let ([first, before], [after, last]) = (led(0), led(1));
        let pieces = vec![
            Piece::Cubic { leaving: first, arriving: along * norm(before) },
            Piece::Cubic { leaving: along * norm(after), arriving: last },
        ];
        Change { between: vec![smooth(point)], pieces, corner: None }
    }

    /// Both sides as they are, and straight ways from them to a corner.
    pub(super) fn led_corner(&self, outline: &Outline, corner: Point) -> Change {
        let [from, to] = [self.cubics[0].end, self.cubics[1].start];
        let straight = |way: Vector| Piece::Cubic { leaving: way / 3.0, arriving: way / 3.0 };
        Change {
            between: vec![smooth(from), sharp(corner), smooth(to)],
            pieces: vec![
                self.side(outline, 0),
                straight(corner - from),
                straight(to - corner),
                self.side(outline, 1),
            ],
            corner: Some(2),
        }
    }

    /// Both sides as they are, and a smooth piece from one to the other.
    pub(super) fn bridge(&self, outline: &Outline) -> Change {
        let [from, to] = [self.cubics[0].end, self.cubics[1].start];
        let third = norm(to - from) / 3.0;
        let bridge = Piece::Cubic { leaving: self.tangents[0] * third, arriving: self.tangents[1] * third };
        Change {
            between: vec![smooth(from), smooth(to)],
            pieces: vec![self.side(outline, 0), bridge, self.side(outline, 1)],
            corner: None,
        }
    }

    fn side(&self, outline: &Outline, side: usize) -> Piece {
        let Cubic { leaving, arriving, .. } = self.cubics[side];
        if outline.is_line(self.pieces[side]) { Piece::Line } else { Piece::Cubic { leaving, arriving } }
    }
}

fn smooth(point: Point) -> Node {
    Node { point, smooth: true, kept: false }
}

fn sharp(point: Point) -> Node {
    Node { point, smooth: false, kept: false }
}

/// What takes the place of a bend.
pub(super) struct Change {
    /// Nodes from one side to the other.
    pub(super) between: Vec<Node>,
    /// One more: the first side, what is between the nodes, and the other side.
    pub(super) pieces: Vec<Piece>,
    /// Which node is a corner, counted from the start of the first side.
    pub(super) corner: Option<usize>,
}
