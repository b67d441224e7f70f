//! Corners that nobody drew: tips that pixels have cut off become the one corner where their sides meet; folds and
//! kinks go.

use super::field::Field;
use super::left::Left;
use super::refine::Shape;
use super::trial::Trial;
use super::window::{Stretch, Window};
use crate::error::Result;
use crate::numerics::plane::{cross, norm};
use crate::numerics::{Point, Vector};
use crate::trace::outline::{Node, Outline, Piece};
use crate::trace::samples::{turn, unit};

/// The longest piece that a tip is cut off by, and the farthest that the tip may be from it, in pixels.
const LONGEST: f64 = 5.0;
const FARTHEST: f64 = 12.0;
/// The least turning at a tip, in radians: less is a corner that was cut on purpose.
const LEAST: f64 = 1.9;
/// The longest piece of a fold, in pixels, and the least turning at its end.
const FOLD: f64 = 6.0;
const BACK: f64 = 2.6;
/// The longest piece that goes round for nothing: a longer one may be a tip that turns so far.
const LOOP: f64 = 1.0;
/// A corner that turns by no more, in radians, is tried without: where the picture is exact, and where there is noise.
const KINKS: [f64; 2] = [0.175, 0.35];
const STEPS: [(usize, f64); 2] = [(8, 5e-4), (6, 0.01)];

impl Trial<'_> {
    /// Puts a tip where the sides beside piece i meet, as long as the picture is explained as well as before or as the
    /// limits say. The next piece, and whether it was tried.
    ///
    /// # Cost
    ///
    /// O(1), and O(length of the pieces beside it) for a tip that is tried.
    pub(super) fn sharpen(&mut self, i: usize) -> Result<(usize, bool)> {
        let tip = tip(&self.shape.outline, i);
        if let Some(tip) = tip {
            self.try_tip(i, tip)?;
        }
        Ok((i + 1, tip.is_some()))
    }

    /// Takes a corner away at which the outline turns back on its own way or round for a short while, as long as the
    /// picture is explained as well as before or as the limits say. The next node, and whether it was tried.
    ///
    /// # Cost
    ///
    /// O(1), and O(length of the pieces beside it) for a fold that is tried.
    pub(super) fn unfold(&mut self, i: usize) -> Result<(usize, bool)> {
        if !is_fold(&self.shape.outline, i) {
            return Ok((i + 1, false));
        }
        let good = self.try_without(i)?;
        Ok((if good { i } else { i + 1 }, true))
    }

    /// One piece in place of the two at node i; if that is not good, all is as it was. Whether it was good.
    fn try_without(&mut self, i: usize) -> Result<bool> {
        let outline = &self.shape.outline;
        let (before, next) = (outline.before(i), outline.next(i));
        let [start, end] = [outline.nodes[before], outline.nodes[next]];
        let third = (end.point - start.point) / 3.0;
        let straight = outline.is_line(before) || outline.is_line(i);
        let piece = if straight && !start.smooth && !end.smooth {
            Piece::Line
        } else {
            let way = |node: Node, tangent: Vector| {
                if node.smooth { unit(tangent) * norm(third) } else { third }
            };
            let (leaving, arriving) = (outline.cubic(before).leaving, outline.cubic(i).arriving);
            Piece::Cubic { leaving: way(start, leaving), arriving: way(end, arriving) }
        };
        self.attempt(Stretch { first: before, count: 2, pieces: vec![piece], between: Vec::new() }, 0)
    }

    /// Refines a stretch; if it does not explain the picture as well as what was there or as the limits say, all is as
    /// it was. Whether it was good. With `ends` 1 the ends of the stretch stay, only what is between its first and last
    /// piece has to be good, and the outline begins with it then.
    pub(super) fn attempt(&mut self, stretch: Stretch, ends: usize) -> Result<bool> {
        // With ends that move the pieces beside it do.
        let around = |shape: &Shape, field: &Field, first: usize, count: usize| {
            let all = shape.outline.len();
            let mut left = Left::default();
            for k in 0..(count + 2 - 4 * ends).min(all) {
                left.add(&shape.parts[(first + 2 * ends + all - 1 + k) % all], field);
            }
            left
        };
        let mut old = around(self.shape, self.field, stretch.first, stretch.count);
        let mut window = Window::open(self.refiner, self.field, self.shape, stretch);
        let nodes: Vec<usize> = (ends..=window.fresh - ends).collect();
        self.refiner.refine(self.field, &mut window.shape, &nodes, STEPS[ends])?;
        let new = around(&window.shape, self.field, 0, window.fresh);
        old.square += self.limits.grain * self.limits.grain * new.count;
        let good = self.limits.allow(&new, &old, 1.0);
        if good {
            let first = window.keep(self.field, self.shape);
            self.shape.begin_at(if ends > 0 { first } else { 0 });
        } else {
            window.close(self.refiner, self.field);
        }
        Ok(good)
    }

    fn try_tip(&mut self, i: usize, tip: Point) -> Result<()> {
        let outline = &self.shape.outline;
        let (before, next) = (outline.before(i), outline.next(i));
        let side = |piece: usize, from: Point, to: Point| calm(outline.pieces[piece], norm(to - from) / 3.0);
        let pieces = vec![
            side(before, outline.nodes[before].point, tip),
            side(next, tip, outline.nodes[outline.next(next)].point),
        ];
        let between = vec![Node { point: tip, ..outline.nodes[next] }];
        self.attempt(Stretch { first: before, count: 3, pieces, between }, 0)?;
        Ok(())
    }

    /// Makes corner i, which hardly turns, a smooth joint, as long as the picture is explained as well as before or as
    /// the limits say. The next node, and whether it was tried.
    ///
    /// # Cost
    ///
    /// O(pieces of the outline), and O(length of the pieces beside it) for a joint that is tried.
    pub(super) fn even(&mut self, i: usize) -> Result<(usize, bool)> {
        let outline = &self.shape.outline;
        let before = outline.before(i);
        let kink = turn(outline.cubic(before).velocity(1.0), outline.cubic(i).velocity(0.0)).abs();
        let straight = outline.is_line(before) && outline.is_line(i);
        let most = KINKS[usize::from(self.limits.noise > 0.0)];
        if straight || outline.nodes[i].smooth || outline.len() < 3 || kink > most {
            return Ok((i + 1, false));
        }
        let mut even = outline.clone();
        even.nodes[i].smooth = true;
        even.align();
        let pieces = vec![even.pieces[before], even.pieces[i]];
        self.attempt(Stretch { first: before, count: 2, pieces, between: vec![even.nodes[i]] }, 0)?;
        Ok((i + 1, true))
    }
}

/// Whether the outline turns back at node i, where a short piece begins or ends, or goes round on that piece only to go
/// on as it came.
fn is_fold(outline: &Outline, i: usize) -> bool {
    let before = outline.before(i);
    if outline.len() < 4 || outline.nodes[i].smooth {
        return false;
    }
    let (first, second) = (outline.cubic(before), outline.cubic(i));
    let lengths = [norm(first.end - first.start), norm(second.end - second.start)];
    let length = lengths[0].min(lengths[1]);
    let joint = turn(first.velocity(1.0), second.velocity(0.0)).abs();
    let (short, far) = if lengths[0] < lengths[1] { (&first, 0.0) } else { (&second, 1.0) };
    let middle = short.velocity(0.5);
    let all = joint + turn(short.velocity(0.0), middle).abs() + turn(middle, short.velocity(1.0)).abs();
    let needed = turn(first.velocity(far), second.velocity(far)).abs();
    length < FOLD && joint > BACK || length < LOOP && all - needed > BACK
}

/// Where the pieces before and after piece i meet, if that is a tip that it cuts off.
fn tip(outline: &Outline, i: usize) -> Option<Point> {
    let (before, next) = (outline.before(i), outline.next(i));
    let [start, end] = [outline.nodes[i], outline.nodes[next]];
    if outline.len() < 4 || start.smooth || end.smooth || norm(end.point - start.point) > LONGEST {
        return None;
    }
    let (side, short, other) = (outline.cubic(before), outline.cubic(i), outline.cubic(next));
    let (there, back) = (unit(side.velocity(1.0)), unit(other.velocity(0.0)));
    let (first, second) = (turn(there, short.velocity(0.0)), turn(short.velocity(1.0), back));
    if first * second <= 0.0 || turn(there, back).abs() < LEAST {
        return None;
    }
    let (gap, across) = (end.point - start.point, cross(there, back));
    // start + ahead · there = end − behind · back; sides that run alongside meet nowhere near.
    let (ahead, behind) = (cross(gap, back) / across, cross(there, gap) / across);
    let near = |way: f64| way > 0.0 && way < FARTHEST;
    (near(ahead) && near(behind)).then(|| start.point + there * ahead)
}

/// Control points that went far to reach round a tip come back to a third of the way.
fn calm(piece: Piece, third: f64) -> Piece {
    let back = |way: Vector| if norm(way) > third { unit(way) * third } else { way };
    match piece {
        Piece::Line => Piece::Line,
        Piece::Cubic { leaving, arriving } => {
            Piece::Cubic { leaving: back(leaving), arriving: back(arriving) }
        }
    }
}
