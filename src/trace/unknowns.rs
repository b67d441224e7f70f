//! What may move in outlines so that smooth joints stay smooth: points, directions and lengths of tangents.

use super::outline::{Node, Outline, Piece};
use super::samples::unit;
use crate::numerics::plane::{dot, norm};
use crate::numerics::{Point, Vector};

/// How the eight coordinates of a piece's control points change with one unknown.
pub(super) type Column = (usize, [f64; 8]);

/// The numbering of the unknowns of one outline.
///
/// A node has its two coordinates; at a corner both coordinates of the way to the control point of each cubic beside it; between
/// two cubics that meet smoothly the angle of the tangent and two lengths; beside a straight piece one length, for the straight piece has the direction.
pub(super) struct Unknowns {
    base: Vec<usize>,
    pub(super) end: usize,
}

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
    /// Numbers from `first` on. Nodes are taken from both ends of the list in turn: what is near around the outline is near in the numbering.
    pub(super) fn new(outline: &Outline, first: usize) -> Self {
        let count = outline.len();
        let mut base = vec![0; count];
        let mut end = first;
        for step in 0..count {
            let node = if step % 2 == 0 { step / 2 } else { count - 1 - step / 2 };
            base[node] = end;
            end += 2 + match joint(outline, node) {
                Joint::Free => 3,
                Joint::AfterLine | Joint::BeforeLine => 1,
                Joint::Corner => {
                    2 * usize::from(!outline.is_line(node))
                        + 2 * usize::from(!outline.is_line(outline.before(node)))
                }
            };
        }
        Self { base, end }
    }

    /// The columns of piece i.
    pub(super) fn columns(&self, outline: &Outline, i: usize, columns: &mut Vec<Column>) {
        columns.clear();
        let next = outline.next(i);
        let (start, end) = (self.base[i], self.base[next]);
        let Piece::Cubic { leaving, arriving } = outline.pieces[i] else {
            let (far, near) = (2.0 / 3.0, 1.0 / 3.0);
            columns.push((start, [1.0, 0.0, far, 0.0, near, 0.0, 0.0, 0.0]));
            columns.push((start + 1, [0.0, 1.0, 0.0, far, 0.0, near, 0.0, 0.0]));
            columns.push((end, [0.0, 0.0, near, 0.0, far, 0.0, 1.0, 0.0]));
            columns.push((end + 1, [0.0, 0.0, 0.0, near, 0.0, far, 0.0, 1.0]));
            return;
        };
        add(columns, start, 0, Vector::new(1.0, 0.0));
        add(columns, start + 1, 0, Vector::new(0.0, 1.0));
        add(columns, start, 2, Vector::new(1.0, 0.0));
        add(columns, start + 1, 2, Vector::new(0.0, 1.0));
        add(columns, end, 4, Vector::new(1.0, 0.0));
        add(columns, end + 1, 4, Vector::new(0.0, 1.0));
        add(columns, end, 6, Vector::new(1.0, 0.0));
        add(columns, end + 1, 6, Vector::new(0.0, 1.0));
        match joint(outline, i) {
            Joint::Corner => {
                add(columns, start + 2, 2, Vector::new(1.0, 0.0));
                add(columns, start + 3, 2, Vector::new(0.0, 1.0));
            }
            Joint::Free => {
                add(columns, start + 2, 2, turned(leaving));
                add(columns, start + 3, 2, unit(leaving));
            }
            _ => {
                add(columns, start + 2, 2, unit(leaving));
                let before = outline.before(i);
                let from = outline.nodes[before].point;
                follow(columns, [start, self.base[before]], 2, leaving, outline.nodes[i].point - from, 1.0);
            }
        }
        match joint(outline, next) {
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
                add(columns, end + 2, 4, -unit(arriving));
                let after = outline.next(next);
                let to = outline.nodes[after].point;
                follow(columns, [self.base[after], end], 4, arriving, to - outline.nodes[next].point, -1.0);
            }
        }
    }

    /// How far one unit of every unknown moves things, squared, from `first` on.
    pub(super) fn scales(&self, outline: &Outline, scales: &mut [f64]) {
        for i in 0..outline.len() {
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
        let joints: Vec<Joint> = (0..outline.len()).map(|i| joint(outline, i)).collect();
        let limit = |value: f64| if value.is_finite() { value.max(-most).min(most) } else { 0.0 };
        for (i, &joint) in joints.iter().enumerate() {
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
        for (i, &joint) in joints.iter().enumerate() {
            let before = outline.before(i);
            let here: Point = outline.nodes[i].point;
            match joint {
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
        add(columns, to + usize::from(k == 1), place, across);
        add(columns, from + usize::from(k == 1), place, -across);
    }
}
