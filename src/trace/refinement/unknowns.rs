//! What may move in outlines so that smooth joints stay smooth: points, directions and lengths of tangents.

use crate::numerics::order::sort_in_place;
use crate::numerics::plane::{larger, norm};
use crate::numerics::{Point, Vector};
use crate::trace::outline::{Node, Outline, Piece};
use crate::trace::samples::unit;
use core::ops::Range;

/// How one of the four vectors of a piece (its start, the way leaving, the way arriving, its end) changes with one
/// unknown or two.
#[derive(Clone, Copy, Debug)]
pub(super) struct Term {
    /// Which vector.
    pub(super) slot: usize,
    unknowns: [usize; 2],
    count: usize,
    /// How it changes with each.
    pub(super) ways: [Vector; 2],
}

const START: usize = 0;
const LEAVING: usize = 1;
const ARRIVING: usize = 2;
const END: usize = 3;

impl Term {
    /// The unknowns of the first ways.
    #[inline(always)]
    pub(super) fn unknowns(&self) -> &[usize] {
        if self.count == 2 { &self.unknowns } else { &self.unknowns[..1] }
    }

    /// A vector that is two unknowns.
    fn own(slot: usize, first: usize) -> Self {
        let ways = [Vector::new(1.0, 0.0), Vector::new(0.0, 1.0)];
        Self { slot, unknowns: [first, first + 1], count: 2, ways }
    }

    /// A vector whose length is an unknown.
    fn length(slot: usize, unknown: usize, way: Vector) -> Self {
        Self { slot, unknowns: [unknown; 2], count: 1, ways: [unit(way), Vector::zeros()] }
    }

    /// A vector whose angle and length are unknowns.
    fn polar(slot: usize, unknowns: [usize; 2], way: Vector) -> Self {
        Self { slot, unknowns, count: 2, ways: [turned(way), unit(way)] }
    }
}

/// The unknowns of a node: the first of all, that of its point, and those of the ways from and to the control points
/// beside it.
#[derive(Clone, Copy, Debug)]
struct Base {
    first: usize,
    /// The two coordinates and, between cubics that meet smoothly, the angle.
    point: usize,
    arriving: usize,
    leaving: usize,
}

/// The node stays.
const FIXED: Base = Base { first: NONE, point: NONE, arriving: NONE, leaving: NONE };
const NONE: usize = usize::MAX;

impl Base {
    fn is_fixed(&self) -> bool {
        self.point == NONE
    }
}

/// The numbering of the unknowns of some nodes of one outline; the other nodes stay where they are.
///
/// A node has its two coordinates; at a corner both coordinates of the way to the control point of each cubic beside
/// it; between two cubics that meet smoothly the angle of the tangent and two lengths; beside a straight piece one
/// length, for the straight piece has the direction.
#[derive(Debug, Default)]
pub(super) struct Unknowns {
    /// Those of every node.
    base: Vec<Base>,
    nodes: Vec<usize>,
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
            let before = outline.before(node);
            let [arriving, point, leaving] = match joint(outline, node) {
                Joint::Free => [1, 3, 1],
                Joint::AfterLine => [0, 2, 1],
                Joint::BeforeLine => [1, 2, 0],
                Joint::Corner => {
                    let ways = |piece| if outline.is_line(piece) { 0 } else { 2 };
                    [ways(before), 2, ways(node)]
                }
            };
            // A way has to do with one of its neighbours only: first the one that leads to a node in the list already,
            // last the other.
            let first = self.end;
            let next = outline.next(node);
            self.base[node] = if self.base[before].is_fixed() && !self.base[next].is_fixed() {
                Base { first, leaving: first, point: first + leaving, arriving: first + leaving + point }
            } else {
                Base { first, arriving: first, point: first + arriving, leaving: first + arriving + point }
            };
            self.end += arriving + point + leaving;
        }
    }

    /// The nodes in the order of their unknowns, and which these are.
    pub(super) fn ranges(&self) -> impl Iterator<Item = (usize, Range<usize>)> {
        let others = self.nodes.get(1..).unwrap_or_default();
        let ends = others.iter().map(|&next| self.base[next].first).chain([self.end]);
        self.nodes.iter().zip(ends).map(|(&node, end)| (node, self.base[node].first..end))
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

    /// Adds the terms of piece i.
    pub(super) fn terms(&self, outline: &Outline, i: usize, terms: &mut Vec<Term>) {
        let next = outline.next(i);
        let (start, end) = (self.base[i], self.base[next]);
        if !start.is_fixed() {
            terms.push(Term::own(START, start.point));
        }
        if !end.is_fixed() {
            terms.push(Term::own(END, end.point));
        }
        let Piece::Cubic { leaving, arriving } = outline.pieces[i] else { return };
        match joint(outline, i) {
            Joint::AfterLine | Joint::BeforeLine => {
                if !start.is_fixed() {
                    terms.push(Term::length(LEAVING, start.leaving, leaving));
                }
                let before = outline.before(i);
                let line = outline.nodes[i].point - outline.nodes[before].point;
                follow(terms, [start, self.base[before]], (LEAVING, leaving), line);
            }
            _ if start.is_fixed() => {}
            Joint::Corner => terms.push(Term::own(LEAVING, start.leaving)),
            Joint::Free => terms.push(Term::polar(LEAVING, [start.point + 2, start.leaving], leaving)),
        }
        match joint(outline, next) {
            Joint::AfterLine | Joint::BeforeLine => {
                if !end.is_fixed() {
                    terms.push(Term::length(ARRIVING, end.arriving, arriving));
                }
                let after = outline.next(next);
                let line = outline.nodes[after].point - outline.nodes[next].point;
                follow(terms, [self.base[after], end], (ARRIVING, arriving), line);
            }
            _ if end.is_fixed() => {}
            Joint::Corner => terms.push(Term::own(ARRIVING, end.arriving)),
            Joint::Free => terms.push(Term::polar(ARRIVING, [end.point + 2, end.arriving], arriving)),
        }
    }

    /// How far one unit of every unknown moves things, squared, from `first` on.
    pub(super) fn scales(&self, outline: &Outline, scales: &mut [f64]) {
        for &i in &self.nodes {
            if joint(outline, i) == Joint::Free {
                let arriving = outline.cubic(outline.before(i)).arriving;
                let leaving = outline.cubic(i).leaving;
                scales[self.base[i].point + 2] = norm(arriving).powi(2) + norm(leaving).powi(2);
            }
        }
    }

    /// Moves the outline by a step of the unknowns; nothing moves farther than `most`.
    pub(super) fn apply(&self, outline: &mut Outline, step: &[f64], most: f64) {
        let limit = |value: f64| if value.is_finite() { value.max(-most).min(most) } else { 0.0 };
        for &i in &self.nodes {
            let joint = joint(outline, i);
            let (base, before) = (self.base[i], outline.before(i));
            let at = |unknown: usize| Vector::new(limit(step[unknown]), limit(step[unknown + 1]));
            outline.nodes[i].point += at(base.point);
            let least = 0.05;
            let stretch = |v: Vector, by: f64| unit(v) * (norm(v) + limit(by)).max(least);
            let turn_by = |v: Vector, angle: f64| {
                let (sin, cos) = crate::numerics::angle::sin_cos(angle);
                Vector::new(v.x * cos - v.y * sin, v.x * sin + v.y * cos)
            };
            let angle = if joint == Joint::Free {
                let longest = norm(outline.cubic(i).leaving).max(norm(outline.cubic(before).arriving));
                let most_angle = (most / longest.max(least)).min(0.3);
                let wish = step[base.point + 2];
                if wish.is_finite() { wish.max(-most_angle).min(most_angle) } else { 0.0 }
            } else {
                0.0
            };
            let moved = |v: Vector, unknown: usize| match joint {
                Joint::Corner => v + at(unknown),
                Joint::Free => stretch(turn_by(v, angle), step[unknown]),
                _ => stretch(v, step[unknown]),
            };
            if let Piece::Cubic { leaving, .. } = &mut outline.pieces[i] {
                *leaving = moved(*leaving, base.leaving);
            }
            if let Piece::Cubic { arriving, .. } = &mut outline.pieces[before] {
                *arriving = moved(*arriving, base.arriving);
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

/// A tangent that follows a straight piece turns when the ends of that piece move across it.
fn follow(terms: &mut Vec<Term>, [to, from]: [Base; 2], (slot, tangent): (usize, Vector), line: Vector) {
    let along = unit(line);
    let scale = norm(tangent) / larger(norm(line), 0.05);
    // What is across the line, of x and of y.
    let across = [
        Vector::new(1.0 - along.x * along.x, -along.x * along.y) * scale,
        Vector::new(-along.x * along.y, 1.0 - along.y * along.y) * scale,
    ];
    if !to.is_fixed() {
        terms.push(Term { slot, unknowns: [to.point, to.point + 1], count: 2, ways: across });
    }
    if !from.is_fixed() {
        terms.push(Term {
            slot,
            unknowns: [from.point, from.point + 1],
            count: 2,
            ways: across.map(|way| -way),
        });
    }
}

#[cfg(test)]
mod tests {
    use super::Unknowns;
    use crate::numerics::{Point, Vector};
    use crate::trace::outline::{Node, Outline, Piece};
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    /// A corner between cubics, a joint of cubics, a joint before a straight piece, one after it, and a corner after a
    /// straight piece.
    fn outline() -> Outline {
        let node = |x: f64, y: f64, smooth: bool| Node { point: Point::new(x, y), smooth, kept: false };
        let cubic =
            |a: [f64; 2], b: [f64; 2]| Piece::Cubic { leaving: Vector::from(a), arriving: Vector::from(b) };
        let nodes = vec![
            node(0.0, 0.0, false),
            node(9.0, -3.0, true),
            node(16.0, 2.0, true),
            node(18.0, 11.0, true),
            node(10.0, 18.0, false),
            node(2.0, 14.0, false),
        ];
        let pieces = vec![
            cubic([3.0, -2.0], [3.0, 0.5]),
            cubic([2.0, 1.0], [1.0, 2.0]),
            Piece::Line,
            cubic([0.5, 3.0], [-3.0, 1.0]),
            Piece::Line,
            cubic([-1.0, -4.0], [2.0, -5.0]),
        ];
        let mut outline = Outline { nodes, pieces };
        outline.align();
        outline
    }

    fn vectors(outline: &Outline, piece: usize) -> [Vector; 4] {
        let cubic = outline.cubic(piece);
        [cubic.start, cubic.leaving, cubic.arriving, cubic.end]
    }

    #[test]
    fn terms_say_how_the_vectors_of_pieces_move_with_each_unknown() {
        let before = outline();
        // All nodes, from both ends in turn, then some of them.
        for nodes in [vec![0, 5, 1, 4, 2, 3], vec![1, 2], vec![3, 2]] {
            let mut unknowns = Unknowns::default();
            unknowns.number(&before, &nodes);
            let mut pieces = Vec::new();
            unknowns.pieces(&before, &mut pieces);
            for unknown in 0..unknowns.end {
                let small = 1e-6;
                let mut step = vec![0.0; unknowns.end];
                step[unknown] = small;
                let mut after = before.clone();
                unknowns.apply(&mut after, &step, 1.0);
                for &piece in &pieces {
                    let (old, new) = (vectors(&before, piece), vectors(&after, piece));
                    let mut terms = Vec::new();
                    unknowns.terms(&before, piece, &mut terms);
                    for slot in 0..4 {
                        if before.is_line(piece) && (slot == 1 || slot == 2) {
                            continue;
                        }
                        let mut said = Vector::zeros();
                        for term in terms.iter().filter(|term| term.slot == slot) {
                            for (&own, &way) in term.unknowns().iter().zip(&term.ways) {
                                said += if own == unknown { way } else { Vector::zeros() };
                            }
                        }
                        let seen = (new[slot] - old[slot]) / small;
                        // A step of 1e-6 leaves second differences of 1e-6 and rounding of 1e-9.
                        assert!(
                            (seen - said).norm() < 1e-5,
                            "piece {piece}, vector {slot}, unknown {unknown} of {nodes:?}: {seen:?} instead of {said:?}"
                        );
                    }
                }
            }
        }
    }
}
