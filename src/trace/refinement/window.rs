//! A stretch of an outline that is changed on trial: with the pieces beside it, it is a small outline of its own.

use super::coverage::parts;
use super::field::Field;
use super::refine::{Refiner, Shape};
use crate::trace::outline::{Node, Outline, Piece};

/// Pieces on each side: a step of the refinement looks no farther.
const BESIDE: usize = 3;

/// What takes the place of some pieces of an outline.
#[derive(Debug)]
pub(super) struct Stretch {
    /// The first piece that goes, and how many go.
    pub(super) first: usize,
    pub(super) count: usize,
    /// The new pieces, and the nodes between them.
    pub(super) pieces: Vec<Piece>,
    pub(super) between: Vec<Node>,
}

/// A stretch on trial. Its outline begins with the new pieces; then come those behind it and those before it. Where the
/// rest of a long outline is, there is one straight piece without parts, which nothing moves.
#[derive(Debug)]
pub(super) struct Window {
    pub(super) shape: Shape,
    /// New pieces.
    pub(super) fresh: usize,
    first: usize,
    count: usize,
    /// How many pieces the outline has, and whether all of them are here.
    all: usize,
    whole: bool,
}

impl Window {
    /// Puts the stretch into the field, in place of what was there.
    ///
    /// # Cost
    ///
    /// O(length of the pieces in the window).
    pub(super) fn open(refiner: &mut Refiner, field: &mut Field, shape: &Shape, stretch: Stretch) -> Self {
        let Stretch { first, count, pieces, between } = stretch;
        let (outline, all) = (&shape.outline, shape.outline.len());
        let whole = all - count <= 2 * BESIDE;
        let mut small = Outline { nodes: vec![outline.nodes[first]], pieces };
        small.nodes.extend(between);
        let fresh = small.pieces.len();
        let lists = (0..fresh).map(|_| refiner.list()).collect();
        let small = Shape { outline: small, parts: lists };
        let mut window = Self { shape: small, fresh, first, count, all, whole };
        let behind = if whole { all - count } else { BESIDE };
        (0..behind).for_each(|k| window.take(refiner, shape, (first + count + k) % all));
        if !whole {
            window.shape.outline.push(outline.nodes[(first + count + BESIDE) % all], Piece::Line);
            window.shape.parts.push(Vec::new());
            (0..BESIDE).for_each(|k| window.take(refiner, shape, (first + all - BESIDE + k) % all));
        }
        field.begin_trial();
        for k in 0..count {
            refiner.sweep.note(field, &shape.parts[(first + k) % all], -1.0);
        }
        for i in 0..fresh {
            parts(&window.shape.outline.cubic(i), field, &mut window.shape.parts[i]);
            refiner.sweep.note(field, &window.shape.parts[i], 1.0);
        }
        refiner.sweep.cover(field);
        field.settle();
        window
    }

    fn take(&mut self, refiner: &mut Refiner, shape: &Shape, piece: usize) {
        self.shape.outline.push(shape.outline.nodes[piece], shape.outline.pieces[piece]);
        let mut list = refiner.list();
        list.extend_from_slice(&shape.parts[piece]);
        self.shape.parts.push(list);
    }

    /// The pieces beside the stretch: here, and in the outline.
    fn beside(&self) -> impl Iterator<Item = (usize, usize)> + use<> {
        let (fresh, all, after) = (self.fresh, self.all, self.first + self.count);
        let behind = if self.whole { all - self.count } else { BESIDE };
        let before = if self.whole { 0 } else { BESIDE };
        let first = self.first + all - BESIDE;
        (0..behind)
            .map(move |k| (fresh + k, (after + k) % all))
            .chain((0..before).map(move |k| (fresh + BESIDE + 1 + k, (first + k) % all)))
    }

    /// All is as it was.
    pub(super) fn close(self, refiner: &mut Refiner, field: &mut Field) {
        field.revert();
        refiner.give_back(self.shape.parts);
    }

    /// The outline has the stretch now; the number of its first piece. Pieces before it keep their numbers, unless the
    /// stretch led past the last piece.
    ///
    /// # Cost
    ///
    /// O(pieces of the outline), which are moved.
    pub(super) fn keep(mut self, field: &mut Field, shape: &mut Shape) -> usize {
        field.keep();
        for (here, there) in self.beside() {
            shape.outline.nodes[there] = self.shape.outline.nodes[here];
            shape.outline.pieces[there] = self.shape.outline.pieces[here];
            core::mem::swap(&mut shape.parts[there], &mut self.shape.parts[here]);
        }
        let Shape { outline: Outline { nodes, pieces }, parts } = self.shape;
        let (first, count, fresh) = (self.first, self.count, self.fresh);
        splice(&mut shape.outline.nodes, (first, count), nodes, fresh);
        splice(&mut shape.outline.pieces, (first, count), pieces, fresh);
        splice(&mut shape.parts, (first, count), parts, fresh);
        first - (first + count).saturating_sub(self.all)
    }
}

/// The first of some things take the place of others, of which the last may be at the start of the list.
fn splice<T>(list: &mut Vec<T>, (first, count): (usize, usize), mut things: Vec<T>, fresh: usize) {
    things.truncate(fresh);
    let end = first + count;
    let past = end.saturating_sub(list.len());
    let mut rest = list.split_off(end - past);
    list.truncate(first);
    list.append(&mut things);
    list.append(&mut rest);
    if past > 0 {
        *list = list.split_off(past);
    }
}
