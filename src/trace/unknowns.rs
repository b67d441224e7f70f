//! What may move in outlines so that smooth joints stay smooth: points, directions and lengths of tangents.

use super::outline::{Node, Outline, Piece};
use super::samples::unit;
use crate::numerics::order::sort_in_place;
use crate::numerics::plane::{dot, norm};
use crate::numerics::{Point, Vector};

/// How the eight coordinates of a piece's control points change with one unknown.
pub(super) type Column = (usize, [f64; 8]);

/// The numbering of the unknowns of some nodes of one outline; the other nodes stay where they are.
///
/// A node has its two coordinates; at a corner both coordinates of the way to the control point of each cubic beside it; between
/// two cubics that meet smoothly the angle of the tangent and two lengths; beside a straight piece one length, for the straight piece has the direction.
#[derive(Debug, Default)]
pub(super) struct Unknowns {
    /// The first unknown of every node.
    base: Vec<usize>,
    nodes: Vec<usize>,
    pub(super) end: usize,
}

/// The node stays.
const FIXED: usize = usize::MAX;

/// How much a unit of each unknown moves, squared: what damping is measured with.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Joint {
    Corner,
    /// Two cubics.
    Free,
    /// A straight piece arrives, a cubic leaves.
    AfterLine,
    /// A cubic arrives, a straight piece leaves.
    BeforeLine,
    /// It stays where it is.
    Fixed,
}

fn joint(outline: &Outline, i: usize) -> Joint {
    let Node { smooth, .. } = outline.nodes[i];
    match (smooth, outline.is_line(outline.before(i)), outline.is_line(i)) {
        (true, false, false) => Joint::Free,
        (true, true, false) => Joint::AfterLine,
        (true, false, true) => Joint::BeforeLine,
        _ => Joint::Corner,
    }
}

impl Unknowns {
    /// Numbers the unknowns of `nodes`, in their order: what is near around the outline is to be near in the list.
    pub(super) fn number(&mut self, outline: &Outline, nodes: &[usize]) {
        for &node in &self.nodes {
            if let Some(base) = self.base.get_mut(node) {
                *base = FIXED;
            }
        }
        self.base.resize(outline.len(), FIXED);
        self.nodes.clear();
        self.nodes.extend_from_slice(nodes);
        self.end = 0;
        for &node in nodes {
            self.base[node] = self.end;
            self.end += 2 + match joint(outline, node) {
                Joint::Free => 3,
                Joint::AfterLine | Joint::BeforeLine => 1,
                Joint::Fixed => 0,
                Joint::Corner => {
                    2 * usize::from(!outline.is_line(node))
                        + 2 * usize::from(!outline.is_line(outline.before(node)))
                }
            };
        }
    }

    /// The pieces that change when the nodes move, in order.
    pub(super) fn pieces(&self, outline: &Outline, pieces: &mut Vec<usize>) {
        pieces.clear();
        for &node in &self.nodes {
            let before = outline.before(node);
            pieces.push(before);
            pieces.push(node);
            // Tangents follow straight pieces.
            if outline.is_line(node) && outline.nodes[outline.next(node)].smooth {
                pieces.push(outline.next(node));
            }
            if outline.is_line(before) && outline.nodes[before].smooth {
                pieces.push(outline.before(before));
            }
        }
        sort_in_place(pieces);
        pieces.dedup();
    }

    /// The columns of piece i.
    pub(super) fn columns(&self, outline: &Outline, i: usize, columns: &mut Vec<Column>) {
        columns.clear();
        let next = outline.next(i);
        let (start, end) = (self.base[i], self.base[next]);
        let line = outline.is_line(i);
        let (far, near) = if line { (2.0 / 3.0, 1.0 / 3.0) } else { (1.0, 0.0) };
        if start != FIXED {
            columns.push((start, [1.0, 0.0, far, 0.0, near, 0.0, 0.0, 0.0]));
            columns.push((start + 1, [0.0, 1.0, 0.0, far, 0.0, near, 0.0, 0.0]));
        }
        if end != FIXED {
            columns.push((end, [0.0, 0.0, near, 0.0, far, 0.0, 1.0, 0.0]));
            columns.push((end + 1, [0.0, 0.0, 0.0, near, 0.0, far, 0.0, 1.0]));
        }
        let Piece::Cubic { leaving, arriving } = outline.pieces[i] else { return };
        let moves = |base: usize, joint: Joint| match joint {
            Joint::AfterLine | Joint::BeforeLine => joint,
            _ if base == FIXED => Joint::Fixed,
            _ => joint,
        };
        match moves(start, joint(outline, i)) {
            Joint::Fixed => {}
            Joint::Corner => {
                add(columns, start + 2, 2, Vector::new(1.0, 0.0));
                add(columns, start + 3, 2, Vector::new(0.0, 1.0));
            }
            Joint::Free => {
                add(columns, start + 2, 2, turned(leaving));
                add(columns, start + 3, 2, unit(leaving));
            }
            _ => {
                if start != FIXED {
                    add(columns, start + 2, 2, unit(leaving));
                }
                let before = outline.before(i);
                let from = outline.nodes[before].point;
                follow(columns, [start, self.base[before]], 2, leaving, outline.nodes[i].point - from, 1.0);
            }
        }
        match moves(end, joint(outline, next)) {
            Joint::Fixed => {}
            Joint::Corner => {
                let at = end + 2 + 2 * usize::from(!outline.is_line(next));
                add(columns, at, 4, Vector::new(-1.0, 0.0));
                add(columns, at + 1, 4, Vector::new(0.0, -1.0));
            }
            Joint::Free => {
                add(columns, end + 2, 4, -turned(arriving));
                add(columns, end + 4, 4, -unit(arriving));
            }
            _ => {
                if end != FIXED {
                    add(columns, end + 2, 4, -unit(arriving));
                }
                let after = outline.next(next);
                let to = outline.nodes[after].point;
                follow(columns, [self.base[after], end], 4, arriving, to - outline.nodes[next].point, -1.0);
            }
        }
    }

    /// How far one unit of every unknown moves things, squared, from `first` on.
    pub(super) fn scales(&self, outline: &Outline, scales: &mut [f64]) {
        for &i in &self.nodes {
            let base = self.base[i];
            if joint(outline, i) == Joint::Free {
                let arriving = outline.cubic(outline.before(i)).arriving;
                let leaving = outline.cubic(i).leaving;
                scales[base + 2] = norm(arriving).powi(2) + norm(leaving).powi(2);
            }
        }
    }

    /// Moves the outline by a step of the unknowns; nothing moves farther than `most`.
    pub(super) fn apply(&self, outline: &mut Outline, step: &[f64], most: f64) {
        let limit = |value: f64| if value.is_finite() { value.max(-most).min(most) } else { 0.0 };
        for &i in &self.nodes {
            let joint = joint(outline, i);
            let (base, before) = (self.base[i], outline.before(i));
            outline.nodes[i].point += Vector::new(limit(step[base]), limit(step[base + 1]));
            let least = 0.05;
            let stretch = |v: Vector, by: f64| unit(v) * (norm(v) + limit(by)).max(least);
            let turn_by = |v: Vector, angle: f64| {
                let (sin, cos) = crate::numerics::angle::sin_cos(angle);
                Vector::new(v.x * cos - v.y * sin, v.x * sin + v.y * cos)
            };
            let angle = if joint == Joint::Free {
                let longest = norm(outline.cubic(i).leaving).max(norm(outline.cubic(before).arriving));
                let most_angle = (most / longest.max(least)).min(0.3);
                let wish = step[base + 2];
                if wish.is_finite() { wish.max(-most_angle).min(most_angle) } else { 0.0 }
            } else {
                0.0
            };
            if let Piece::Cubic { leaving, .. } = &mut outline.pieces[i] {
                *leaving = match joint {
                    Joint::Corner => *leaving + Vector::new(limit(step[base + 2]), limit(step[base + 3])),
                    Joint::Free => stretch(turn_by(*leaving, angle), step[base + 3]),
                    _ => stretch(*leaving, step[base + 2]),
                };
            }
            let at = base + 2 + 2 * usize::from(!outline.is_line(i));
            if let Piece::Cubic { arriving, .. } = &mut outline.pieces[before] {
                *arriving = match joint {
                    Joint::Corner => *arriving + Vector::new(limit(step[at]), limit(step[at + 1])),
                    Joint::Free => stretch(turn_by(*arriving, angle), step[base + 4]),
                    _ => stretch(*arriving, step[base + 2]),
                };
            }
        }
        for &node in &self.nodes {
            for i in [outline.before(node), node, outline.next(node)] {
                follow_line(outline, i);
            }
        }
    }
}

/// Turns the tangent at a smooth joint beside a straight piece with that piece.
fn follow_line(outline: &mut Outline, i: usize) {
    let before = outline.before(i);
    let here: Point = outline.nodes[i].point;
    match joint(outline, i) {
        Joint::AfterLine => {
            let along = unit(here - outline.nodes[before].point);
            if let Piece::Cubic { leaving, .. } = &mut outline.pieces[i] {
                *leaving = along * norm(*leaving);
            }
        }
        Joint::BeforeLine => {
            let along = unit(outline.nodes[outline.next(i)].point - here);
            if let Piece::Cubic { arriving, .. } = &mut outline.pieces[before] {
                *arriving = along * norm(*arriving);
            }
        }
        _ => {}
    }
}

fn turned(v: Vector) -> Vector {
    Vector::new(-v.y, v.x)
}

/// Adds to the column of an unknown what it does to the control point whose coordinates begin at `place`.
fn add(columns: &mut Vec<Column>, unknown: usize, place: usize, way: Vector) {
    let at = columns.iter().position(|column| column.0 == unknown).unwrap_or_else(|| {
        columns.push((unknown, [0.0; 8]));
        columns.len() - 1
    });
    columns[at].1[place] += way.x;
    columns[at].1[place + 1] += way.y;
}

/// A tangent that follows a straight piece turns when the ends of that piece move across it.
fn follow(
    columns: &mut Vec<Column>,
    [to, from]: [usize; 2],
    place: usize,
    tangent: Vector,
    line: Vector,
    sign: f64,
) {
    let length = norm(line).max(0.05);
    let along = unit(line);
    let scale = sign * norm(tangent) / length;
    for k in 0..2 {
        let axis = Vector::new(f64::from(k == 0), f64::from(k == 1));
        let across = (axis - along * dot(axis, along)) * scale;
        if to != FIXED {
            add(columns, to + k, place, across);
        }
        if from != FIXED {
            add(columns, from + k, place, -across);
        }
    }
}
