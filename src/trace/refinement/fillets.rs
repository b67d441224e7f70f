//! Rounded corners: what leads from one straight piece to the next becomes one arc where the picture asks for no more.

use super::refine::Left;
use super::trial::Trial;
use crate::error::Result;
use crate::numerics::Point;
use crate::numerics::plane::{cross, dot};
use crate::trace::outline::arcs::{Arc, under};
use crate::trace::outline::{Node, Outline, Piece};
use crate::trace::samples::{turn, unit};

/// How far the pieces may be from their arc before it is refined, in pixels.
const NEAR: f64 = 0.35;
/// The most pieces of one rounded corner: more are something else.
const MOST_PIECES: usize = 8;
/// Joints within a rounded corner turn by less, in radians.
const GENTLE: f64 = 0.35;
/// What is left of a straight piece is at least so long, in pixels.
const LEAST: f64 = 0.5;
const STEPS: (usize, f64) = (6, 0.01);

impl Trial<'_> {
    /// Makes one piece of a run of pieces without sharp corners between straight piece i and the next straight one, if that is an arc of a
    /// circle, as long as the picture is explained as well as before or as the limits say. The next piece, and whether it was tried.
    ///
    /// # Cost
    ///
    /// O(1), and O(length of the outline) for an arc that is tried.
    pub(super) fn round_off(&mut self, i: usize) -> Result<(usize, bool)> {
        let Some((count, arc)) = rounding(&self.shape.outline, i) else { return Ok((i + 1, false)) };
        // Where it is good, the straight piece is the first one now, and the arc the second.
        let good = self.try_arc(i, count, &arc)?;
        Ok((if good { 2 } else { i + 1 }, true))
    }

    /// Puts the arc in place of `count` pieces after straight piece i; if that is not good, all is as it was. Whether it was good.
    fn try_arc(&mut self, i: usize, count: usize, arc: &Arc) -> Result<bool> {
        let saved = self.shape.outline.clone();
        let mut old = Left::default();
        let mut piece = i;
        for _ in 0..count {
            piece = saved.next(piece);
            old.add(&self.shape.parts[piece], self.field);
        }
        let smooth = |point: Point| Node { point, smooth: true, kept: false };
        let [leaving, arriving] = arc.cubic_handles();
        let mut rounded = Outline {
            nodes: vec![saved.nodes[i], smooth(arc.ends[0]), smooth(arc.ends[1])],
            pieces: vec![Piece::Line, Piece::Cubic { leaving, arriving }, Piece::Line],
        };
        let mut at = saved.next(saved.next(piece));
        while at != i {
            rounded.nodes.push(saved.nodes[at]);
            rounded.pieces.push(saved.pieces[at]);
            at = saved.next(at);
        }
        self.refiner.replace(self.field, self.shape, rounded);
        self.refiner.refine(self.field, self.shape, &[1, 2], STEPS)?;
        let mut new = Left::default();
        new.add(&self.shape.parts[1], self.field);
        old.square += self.limits.grain * self.limits.grain * new.count;
        let good = self.limits.allow(&new, &old, 1.0);
        if !good {
            self.refiner.replace(self.field, self.shape, saved);
        }
        Ok(good)
    }
}

/// How many pieces after straight piece i lead to the next straight one, and the arc in their place; nothing if it is one piece or no arc.
fn rounding(outline: &Outline, i: usize) -> Option<(usize, Arc)> {
    let first = outline.next(i);
    let (mut at, mut count, mut area) = (first, 0, 0.0);
    let start = outline.nodes[first].point;
    while !outline.is_line(at) && is_gentle(outline, at) && count < MOST_PIECES {
        let cubic = outline.cubic(at);
        area += under(&cubic) + 0.5 * cross(cubic.start - start, cubic.end - start);
        at = outline.next(at);
        count += 1;
    }
    if !outline.is_line(i) || !outline.is_line(at) || !is_gentle(outline, at) || count < 2 || at == i {
        return None;
    }
    let (before, after) = (outline.nodes[i].point, outline.nodes[outline.next(at)].point);
    let end = outline.nodes[at].point;
    let tangents = [unit(start - before), unit(after - end)];
    let ahead = cross(end - start, tangents[1]) / cross(tangents[0], tangents[1]);
    if !ahead.is_finite() || ahead <= 0.0 {
        return None;
    }
    let corner = start + tangents[0] * ahead;
    let triangle = 0.5 * cross(corner - start, end - start);
    let arc = Arc::in_corner(corner, tangents, (triangle - area) * triangle.signum())?;
    let room = [dot(arc.ends[0] - before, tangents[0]), dot(after - arc.ends[1], tangents[1])];
    let near = |p: Point| arc.off(p) <= NEAR;
    let mut piece = first;
    for _ in 0..count {
        let cubic = outline.cubic(piece);
        if !(0..4).all(|k| near(cubic.point(f64::from(k) * 0.25))) {
            return None;
        }
        piece = outline.next(piece);
    }
    (room[0] >= LEAST && room[1] >= LEAST).then_some((count, arc))
}

/// Whether the outline turns by little at joint i.
fn is_gentle(outline: &Outline, i: usize) -> bool {
    let ways = (outline.cubic(outline.before(i)).velocity(1.0), outline.cubic(i).velocity(0.0));
    outline.nodes[i].smooth || turn(ways.0, ways.1).abs() < GENTLE
}
