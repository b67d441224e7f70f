//! Outlines moved until the coverage that they have is the coverage that the picture shows.

use super::coverage::{Part, parts, pieces};
use super::equations::Equations;
use super::field::Field;
use super::left::Left;
use super::sweep::Sweep;
use crate::error::Result;
use crate::numerics::plane::larger;
use crate::trace::outline::cubic::Cubic;
use crate::trace::outline::{Node, Outline, Piece};
use core::ops::Range;

/// Weight of staying where it is, in coverage per pixel, squared.
const DAMPING: f64 = 5e-3;
/// How damping falls: after a good step by `factor`, and never below `least`; and what share of a step is taken.
#[derive(Clone, Copy, Debug)]
pub(super) struct Relaxing {
    factor: f64,
    least: f64,
    share: f64,
}

impl Relaxing {
    /// Where the picture is of exact coverage, the nearer the better.
    pub(super) const BOLD: Self = Self { factor: 0.25, least: 1e-4, share: 1.0 };
    /// Where it is not, long steps follow what is noise.
    pub(super) const CAREFUL: Self = Self { factor: 0.5, least: 1e-3, share: 1.0 };
    /// Where both sides of strokes cross the same pixels: the equations of a side know nothing of the other one, and
    /// each would take all that is left.
    pub(super) const SHARED: Self = Self { share: 0.6, ..Self::BOLD };
}

/// The square of what a byte leaves of coverage, with a little more: 1/255 over √12 is 0.0011.
const ROUNDING: f64 = 2e-6;
/// Nothing moves farther in one step, in pixels.
const LONGEST_STEP: f64 = 0.6;
/// The share of what is left that a step has to take away for another where most of it is noise.
pub(super) const NOISY_SHARE: f64 = 5e-4;
/// The share of what bytes round that a step has to promise.
const WORTH: f64 = 0.3;
/// A node comes to rest that promises less than this share of what bytes round in the parts beside it.
const RESTING: f64 = 0.3;
/// A step is tried if the equations promise this share of what would be enough: they know what they promise to a third
/// or so.
const PROMISE: f64 = 0.5;
/// Places of a piece that are looked at to know whether it leaves the picture.
const LOOKS: u8 = 16;

/// An outline and the parts of its pieces, which the field knows.
#[derive(Debug)]
pub(super) struct Shape {
    pub(super) outline: Outline,
    pub(super) parts: Vec<Vec<Part>>,
}

impl Shape {
    /// The outline, not yet in the field.
    pub(super) fn new(outline: Outline) -> Self {
        Self { parts: vec![Vec::new(); outline.len()], outline }
    }

    /// Another outline, not yet in the field.
    pub(super) fn turn_into(&mut self, outline: Outline) {
        self.parts.resize(outline.len(), Vec::new());
        self.outline = outline;
    }

    /// The same outline from another node on.
    pub(super) fn begin_at(&mut self, first: usize) {
        rotate(&mut self.outline.nodes, first);
        rotate(&mut self.outline.pieces, first);
        rotate(&mut self.parts, first);
    }

    /// All nodes, from both ends of the list in turn: what is near around the outline is near in the list.
    pub(super) fn nodes(&self) -> Vec<usize> {
        let count = self.outline.len();
        (0..count).map(|step| if step % 2 == 0 { step / 2 } else { count - 1 - step / 2 }).collect()
    }

    pub(super) fn left(&self, field: &Field) -> Left {
        Left::of(&self.parts, field)
    }

    /// And in the pixels that another outline would cross.
    #[inline(never)]
    pub(super) fn left_with(&self, other: &Outline, field: &Field) -> Left {
        let mut left = self.left(field);
        pieces(other, other.len(), field).for_each(|parts| left.add(&parts, field));
        left
    }
}

/// Steps of some nodes that may still be taken.
#[derive(Debug)]
pub(super) struct Descent {
    most: usize,
    /// The share of what is left that a step has to take away for another; nothing goes on below what bytes round
    /// either.
    enough: f64,
    damping: f64,
    /// The nodes that have not come to rest, if any have.
    moving: Option<Vec<usize>>,
    /// The pieces that moved last, and what those leave that did before.
    pieces: Vec<usize>,
    resting: Left,
}

impl Descent {
    pub(super) fn new((most, enough): (usize, f64)) -> Self {
        Self { most, enough, damping: DAMPING, moving: None, pieces: Vec::new(), resting: Left::default() }
    }

    /// These pieces still move; the others that did no longer do.
    fn narrow(&mut self, pieces: &[usize], shape: &Shape, field: &Field) {
        let mut next = pieces.iter().peekable();
        for &i in &self.pieces {
            if next.next_if_eq(&&i).is_none() {
                self.resting.add(&shape.parts[i], field);
            }
        }
        self.pieces.clear();
        self.pieces.extend_from_slice(pieces);
    }
}

/// Room for one step after another.
#[derive(Debug)]
pub(super) struct Refiner {
    relaxing: Relaxing,
    pub(super) sweep: Sweep,
    equations: Equations,
    /// The parts of the pieces after a step, and their ends before it.
    fresh: Vec<Vec<Part>>,
    saved: Vec<Saved>,
    /// Lists of parts that nobody uses: allocating takes longer than copying.
    spare: Vec<Vec<Part>>,
}

/// So many lists are kept.
const SPARE: usize = 32;

impl Refiner {
    pub(super) fn new(relaxing: Relaxing) -> Self {
        Self {
            relaxing,
            sweep: Sweep::default(),
            equations: Equations::default(),
            fresh: Vec::new(),
            saved: Vec::new(),
            spare: Vec::new(),
        }
    }

    /// Whether steps are taken by a share only.
    pub(super) fn shares(&self) -> bool {
        self.relaxing.share < 1.0
    }

    /// An empty list of parts.
    pub(super) fn list(&mut self) -> Vec<Part> {
        self.spare.pop().unwrap_or_default()
    }

    /// Lists that are no longer used.
    pub(super) fn give_back(&mut self, lists: Vec<Vec<Part>>) {
        for mut list in lists.into_iter().take(SPARE - self.spare.len().min(SPARE)) {
            list.clear();
            self.spare.push(list);
        }
    }

    /// Notes some pieces of a new shape. They are in the field once that is covered.
    pub(super) fn show(&mut self, field: &Field, shape: &mut Shape, pieces: Range<usize>) {
        for i in pieces {
            parts(&shape.outline.cubic(i), field, &mut shape.parts[i]);
            self.sweep.note(field, &shape.parts[i], 1.0);
        }
    }

    /// Replaces an outline by another.
    pub(super) fn replace(&mut self, field: &mut Field, shape: &mut Shape, outline: Outline) {
        shape.parts.iter().for_each(|parts| self.sweep.note(field, parts, -1.0));
        shape.turn_into(outline);
        self.show(field, shape, 0..shape.outline.len());
        self.sweep.cover(field);
        field.settle();
    }

    /// Moves nodes, step by step, until that is over.
    ///
    /// # Cost
    ///
    /// O(length of the pieces beside the nodes) for each step.
    pub(super) fn refine(
        &mut self,
        field: &mut Field,
        shape: &mut Shape,
        nodes: &[usize],
        steps: (usize, f64),
    ) -> Result<()> {
        let mut descent = Descent::new(steps);
        while self.descend(field, shape, nodes, &mut descent)? {}
        Ok(())
    }

    /// Moves nodes by one step; whether there may be another.
    pub(super) fn descend(
        &mut self,
        field: &mut Field,
        shape: &mut Shape,
        nodes: &[usize],
        descent: &mut Descent,
    ) -> Result<bool> {
        let moving = descent.moving.take();
        let Some((left, growth)) = self.step(field, shape, moving.as_deref().unwrap_or(nodes), descent)?
        else {
            return Ok(false);
        };
        let &mut Descent { damping, enough, .. } = descent;
        descent.most -= 1;
        let goes_on = if growth < 0.0 {
            descent.damping = (self.relaxing.factor * damping).max(self.relaxing.least);
            // What much damping holds back asks for more later.
            descent.moving = if damping < DAMPING { Some(self.moving(shape)) } else { moving };
            -growth >= enough * left.square && left.square + growth >= ROUNDING * left.count
        } else {
            descent.damping = 8.0 * damping;
            descent.moving = moving;
            descent.damping <= 1e3 * DAMPING
        };
        Ok(goes_on && descent.most > 0)
    }

    /// The nodes of the last step that asked for more than bytes round.
    fn moving(&self, shape: &Shape) -> Vec<usize> {
        let beside = |node: usize| shape.parts[node].len() + shape.parts[shape.outline.before(node)].len();
        let asks =
            |&(node, promised): &(usize, f64)| promised.abs() >= RESTING * ROUNDING * beside(node) as f64;
        self.equations.promises().filter(asks).map(|(node, _)| node).collect()
    }

    /// One step: what was left before it and how much it has grown; if it would grow, nothing moves. `None` where no
    /// step promises enough to be tried.
    fn step(
        &mut self,
        field: &mut Field,
        shape: &mut Shape,
        nodes: &[usize],
        descent: &mut Descent,
    ) -> Result<Option<(Left, f64)>> {
        let equations = &mut self.equations;
        equations.begin(&shape.outline, nodes);
        descent.narrow(&equations.pieces, shape, field);
        let &mut Descent { damping, enough, resting, .. } = descent;
        let (mut left, promised) = equations.solve(field, &shape.outline, &shape.parts, damping)?;
        left.join(&resting);
        let noise = ROUNDING * left.count;
        if promised < larger(PROMISE * enough * left.square, WORTH * noise) || left.square < noise {
            return Ok(None);
        }
        let Equations { unknowns, pieces, step, .. } = equations;
        save(&shape.outline, pieces, &mut self.saved);
        if self.relaxing.share < 1.0 {
            step.iter_mut().for_each(|value| *value *= self.relaxing.share);
        }
        unknowns.apply(&mut shape.outline, step, LONGEST_STEP);
        if pieces.iter().any(|&i| leaves(&shape.outline.cubic(i), field)) {
            restore(&mut shape.outline, pieces, &self.saved);
            return Ok(Some((left, f64::INFINITY)));
        }
        self.fresh.resize(pieces.len().max(self.fresh.len()), Vec::new());
        for (&i, fresh) in pieces.iter().zip(&mut self.fresh) {
            parts(&shape.outline.cubic(i), field, fresh);
            self.sweep.note(field, &shape.parts[i], -1.0);
            self.sweep.note(field, fresh, 1.0);
        }
        let growth = self.sweep.cover(field) + field.settle();
        if growth < 0.0 {
            for (&i, fresh) in pieces.iter().zip(&mut self.fresh) {
                core::mem::swap(&mut shape.parts[i], fresh);
            }
        } else {
            self.sweep.take_back(field);
            field.unsettle();
            restore(&mut shape.outline, pieces, &self.saved);
        }
        Ok(Some((left, growth)))
    }
}

/// A list from another of its things on. The standard library's way needs no second list, and three times the code.
fn rotate<T>(list: &mut Vec<T>, first: usize) {
    let mut all = list.split_off(first);
    all.append(list);
    *list = all;
}

/// A piece and the nodes at its ends.
type Saved = ([Node; 2], Piece);

/// Keeps what a step moves.
fn save(outline: &Outline, pieces: &[usize], saved: &mut Vec<Saved>) {
    saved.clear();
    let both = |i: usize| [outline.nodes[i], outline.nodes[outline.next(i)]];
    saved.extend(pieces.iter().map(|&i| (both(i), outline.pieces[i])));
}

fn restore(outline: &mut Outline, pieces: &[usize], saved: &[Saved]) {
    for (&i, &([node, after], piece)) in pieces.iter().zip(saved) {
        let next = outline.next(i);
        (outline.nodes[i], outline.nodes[next], outline.pieces[i]) = (node, after, piece);
    }
}

/// Whether a piece goes where no pixel would call it back.
pub(super) fn leaves(cubic: &Cubic, field: &Field) -> bool {
    let corners = [cubic.start, cubic.start + cubic.leaving, cubic.end - cubic.arriving, cubic.end];
    if !corners.iter().any(|&corner| field.is_beyond(corner)) {
        return false;
    }
    (0..=LOOKS).any(|k| field.is_beyond(cubic.point(f64::from(k) / f64::from(LOOKS))))
}

#[cfg(test)]
mod tests {
    use super::{Descent, Left, Refiner, Relaxing, Shape};
    use crate::error::Result;
    use crate::numerics::Point;
    use crate::trace::Gray;
    use crate::trace::outline::{Node, Outline, Piece};
    use crate::trace::refinement::field::{Field, Shading};
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    /// A field of ink where a picture has a square from 8 to 24, and a diamond for it.
    fn diamond() -> Result<(Field, Shape)> {
        let inside = |i: usize| (8..24).contains(&(i % 32)) && (8..24).contains(&(i / 32));
        let bytes: Vec<u8> = (0..1024).map(|i| if inside(i) { 0 } else { 255 }).collect();
        let gray = Gray::from_bytes(32, 32, &bytes)?;
        let shading = Shading { ink: 0.0, paper: 65_280.0, level: 32_640.0, inverted: false };
        let middle = [Point::new(16.0, 16.0)];
        let field = Field::new(&gray, &shading, [middle.as_slice()].into_iter(), 15.0)?;
        let node = |x: f64, y: f64| Node { point: Point::new(x, y), smooth: false, kept: false };
        let nodes = vec![node(16.3, 6.1), node(25.8, 16.2), node(15.9, 25.7), node(6.4, 15.8)];
        Ok((field, Shape::new(Outline { pieces: vec![Piece::Line; nodes.len()], nodes })))
    }

    #[test]
    fn what_rests_counts_once_in_what_is_left() -> Result<()> {
        let (mut field, mut shape) = diamond()?;
        let mut refiner = Refiner::new(Relaxing::BOLD);
        refiner.show(&field, &mut shape, 0..4);
        refiner.sweep.cover(&mut field);
        let mut descent = Descent::new((8, 0.0));
        descent.narrow(&[0, 1, 2, 3], &shape, &field);
        assert_eq!(descent.resting.count, 0.0);
        descent.narrow(&[1, 2, 3], &shape, &field);
        descent.narrow(&[1], &shape, &field);
        descent.narrow(&[1], &shape, &field);
        let (all, mut own) = (shape.left(&field), Left::default());
        own.add(&shape.parts[1], &field);
        assert_eq!(descent.resting.count + own.count, all.count);
        assert!((descent.resting.square + own.square - all.square).abs() < 1e-12 * all.square);
        Ok(())
    }
}
