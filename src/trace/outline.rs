//! A closed outline as few pieces: nodes, straight pieces and cubics, smooth where it says so.

pub(super) mod arcs;
pub(super) mod corners;
pub(super) mod cubic;
pub(super) mod division;
pub(super) mod ellipse;
mod frame;
pub(super) mod rounds;
pub(super) mod stairs;

use self::cubic::Cubic;
use super::samples::{turn, unit};
use crate::curve::{HermiteCurve, HermiteOptions};
use crate::error::Result;
use crate::limits::with_room;
use crate::numerics::plane::{cross, larger, norm};
use crate::numerics::{Point, Vector};

/// How far neighbours of a piece that becomes straight may move, in pixels.
const SWING: f64 = 0.1;

/// An outline encloses at least this share of the area that its contour does, and at most so many times as much.
const AREAS: [f64; 2] = [0.6, 4.0];

/// Whether an outline may have an area where its contour has another, of which outlines have a share at least.
pub(super) fn is_about(area: f64, of_contour: f64, share: f64) -> bool {
    (AREAS[0] * share..=AREAS[1]).contains(&(area / of_contour))
}

/// What leads from one node to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Piece {
    Line,
    /// The way from the first node to its control point, and from the second control point to the second node.
    Cubic {
        leaving: Vector,
        arriving: Vector,
    },
}

/// A joint of two pieces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Node {
    pub(super) point: Point,
    /// Whether both pieces share the tangent here. Two straight pieces never do.
    pub(super) smooth: bool,
    /// Whether it has been tried without.
    pub(super) kept: bool,
}

/// Nodes, and the pieces that leave them; the last piece leads back to the first node.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Outline {
    pub(super) nodes: Vec<Node>,
    pub(super) pieces: Vec<Piece>,
}

impl Outline {
    pub(super) fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Appends a node and the piece that leaves it.
    #[inline(never)]
    pub(super) fn push(&mut self, node: Node, piece: Piece) {
        self.nodes.push(node);
        self.pieces.push(piece);
    }

    /// Drops all nodes but the first ones, and their pieces.
    fn truncate(&mut self, count: usize) {
        self.nodes.truncate(count);
        self.pieces.truncate(count);
    }

    pub(super) fn next(&self, i: usize) -> usize {
        if i + 1 == self.nodes.len() { 0 } else { i + 1 }
    }

    pub(super) fn before(&self, i: usize) -> usize {
        if i == 0 { self.nodes.len() - 1 } else { i - 1 }
    }

    pub(super) fn is_line(&self, i: usize) -> bool {
        self.pieces[i] == Piece::Line
    }

    /// Piece i as a cubic; a straight one has its control points at the thirds.
    pub(super) fn cubic(&self, i: usize) -> Cubic {
        let (start, end) = (self.nodes[i].point, self.nodes[self.next(i)].point);
        match self.pieces[i] {
            Piece::Line => {
                let third = (end - start) / 3.0;
                Cubic { start, leaving: third, arriving: third, end }
            }
            Piece::Cubic { leaving, arriving } => Cubic { start, leaving, arriving, end },
        }
    }

    /// The area inside, positive as a contour's.
    pub(super) fn area(&self) -> f64 {
        let seen = self.nodes.first().map_or(Point::zeros(), |node| node.point);
        (0..self.len()).fold(0.0, |sum, i| {
            let Cubic { start, leaving, arriving, end } = self.cubic(i);
            let chord = end - start;
            // Green's theorem: the triangle under the chord, and what is between the chord and the cubic.
            let bow = 2.0 * cross(leaving - arriving, chord) - cross(leaving, arriving);
            sum + 0.5 * cross(start - seen, end - seen) + 0.15 * bow
        })
    }

    /// Whether it has about the area of what it is the outline of, or a share of that at least: two sides that became
    /// one line enclose nothing.
    pub(super) fn encloses(&self, area: f64, share: f64) -> bool {
        is_about(self.area(), area, share)
    }

    /// What its lists take.
    pub(super) fn bytes(&self) -> usize {
        self.len() * (size_of::<Node>() + size_of::<Piece>())
    }

    /// Straight pieces from one place to the next.
    ///
    /// # Errors
    ///
    /// `OutOfMemory` only.
    pub(super) fn polygon(places: &[Point]) -> Result<Self> {
        let (mut nodes, mut pieces) = (with_room(places.len())?, with_room(places.len())?);
        nodes.extend(places.iter().map(|&point| Node { point, smooth: false, kept: false }));
        pieces.resize(places.len(), Piece::Line);
        Ok(Self { nodes, pieces })
    }

    /// Makes the ways to the control points at smooth nodes parallel: to the straight piece, if there is one, else to
    /// the mean of both.
    pub(super) fn align(&mut self) {
        for i in 0..self.len() {
            let before = self.before(i);
            if self.is_line(before) && self.is_line(i) {
                self.nodes[i].smooth = false;
            }
            if !self.nodes[i].smooth {
                continue;
            }
            let here = self.nodes[i].point;
            let along = match (self.pieces[before], self.pieces[i]) {
                (Piece::Line, _) => here - self.nodes[before].point,
                (_, Piece::Line) => self.nodes[self.next(i)].point - here,
                (Piece::Cubic { arriving, .. }, Piece::Cubic { leaving, .. }) => {
                    unit(arriving) + unit(leaving)
                }
            };
            let along = unit(along);
            if let Piece::Cubic { arriving, .. } = &mut self.pieces[before] {
                *arriving = along * norm(*arriving);
            }
            if let Piece::Cubic { leaving, .. } = &mut self.pieces[i] {
                *leaving = along * norm(*leaving);
            }
        }
    }

    /// Where the tangent turns by at least an angle.
    pub(super) fn cusps(&self, angle: f64) -> Vec<Point> {
        let turning = |i: usize| {
            let (before, after) = (self.cubic(self.before(i)), self.cubic(i));
            turn(before.velocity(1.0), after.velocity(0.0)).abs()
        };
        let sharp = |&i: &usize| !self.nodes[i].smooth && turning(i) >= angle;
        (0..self.len()).filter(sharp).map(|i| self.nodes[i].point).collect()
    }

    /// Halves some pieces.
    pub(super) fn halved(&self, which: &[bool]) -> Self {
        let mut halved = Self::default();
        for (i, &halve) in which.iter().enumerate() {
            if !halve || self.is_line(i) {
                halved.push(self.nodes[i], self.pieces[i]);
                continue;
            }
            let halves = [self.cubic(i).part(0.0, 0.5), self.cubic(i).part(0.5, 1.0)];
            let middle = Node { point: halves[1].start, smooth: true, kept: false };
            for (node, Cubic { leaving, arriving, .. }) in [self.nodes[i], middle].into_iter().zip(halves) {
                halved.push(node, Piece::Cubic { leaving, arriving });
            }
        }
        halved
    }

    /// Makes lines of cubics that hardly bend: by less than a twentieth of a pixel between corners, a fiftieth beside a
    /// smooth joint, if the neighbours that turn with them hardly move either.
    pub(super) fn straighten(&mut self) {
        for i in 0..self.len() {
            let next = self.next(i);
            let Piece::Cubic { leaving, arriving } = self.pieces[i] else { continue };
            let chord = self.nodes[next].point - self.nodes[i].point;
            let across = unit(chord);
            let bend = 0.75 * cross(across, leaving).abs().max(cross(across, arriving).abs());
            let corners = !self.nodes[i].smooth && !self.nodes[next].smooth;
            let short = norm(leaving) + norm(arriving) < 1.2 * norm(chord);
            let swing = self.swing(i, leaving, across) + self.swing(next, arriving, across);
            if short && swing < SWING && bend < if corners { 0.05 } else { 0.02 } {
                self.pieces[i] = Piece::Line;
            }
        }
        self.align();
    }

    /// How far control points move if the tangent at joint i turns from one direction to another.
    fn swing(&self, i: usize, from: Vector, to: Vector) -> f64 {
        if !self.nodes[i].smooth {
            return 0.0;
        }
        let reach = |piece: usize| match self.pieces[piece] {
            Piece::Cubic { leaving, arriving } => norm(if piece == i { leaving } else { arriving }),
            Piece::Line => 0.0,
        };
        cross(unit(from), to).abs() * larger(reach(self.before(i)), reach(i))
    }

    /// The outline without its last piece, which only closes it.
    pub(super) fn to_open_curve(&self) -> Result<HermiteCurve> {
        let last = self.len() - 1;
        let leaving = |i: usize| self.cubic(if i == last { self.before(i) } else { i });
        let arriving = |i: usize| self.cubic(if i == 0 { 0 } else { self.before(i) });
        HermiteCurve::new(HermiteOptions {
            points: self.nodes.iter().map(|node| node.point).collect(),
            tangents: (0..=last)
                .map(|i| if i == last { leaving(i).arriving } else { leaving(i).leaving } * 3.0)
                .collect(),
            tangents_in: (0..=last)
                .map(|i| if i == 0 { arriving(i).leaving } else { arriving(i).arriving } * 3.0)
                .collect(),
            omega: vec![0.0; last],
            ..Default::default()
        })
    }

    /// The outline as a curve whose segments are its pieces; those with an angle are arcs of circles.
    pub(super) fn to_curve(&self, angles: Vec<f64>) -> Result<HermiteCurve> {
        let points = self.nodes.iter().map(|node| node.point).collect();
        let tangents = (0..self.len()).map(|i| self.cubic(i).leaving * 3.0).collect();
        let tangents_in = (0..self.len()).map(|i| self.cubic(self.before(i)).arriving * 3.0).collect();
        let omega = angles;
        HermiteCurve::new(HermiteOptions {
            points,
            tangents,
            tangents_in,
            closed: true,
            omega,
            ..Default::default()
        })
    }
}
