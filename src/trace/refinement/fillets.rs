//! Rounded corners: what leads from one straight piece to the next becomes one arc where the picture asks for no more.

use super::trial::Trial;
use super::window::Stretch;
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

impl Trial<'_> {
    /// Makes one piece of a run of pieces without sharp corners between straight piece i and the next straight one, if
    /// that is an arc of a circle, as long as the picture is explained as well as before or as the limits say. The next
    /// piece, and whether it was tried.
    ///
    /// # Cost
    ///
    /// O(pieces of the run), and O(length of the pieces beside it) for an arc that is tried.
    pub(super) fn round_off(&mut self, i: usize) -> Result<(usize, bool)> {
        let Some((count, arc)) = rounding(&self.shape.outline, i) else { return Ok((i + 1, false)) };
        let smooth = |point: Point| Node { point, smooth: true, kept: false };
        let [leaving, arriving] = arc.cubic_handles();
        let stretch = Stretch {
            first: i,
            count: count + 2,
            pieces: vec![Piece::Line, Piece::Cubic { leaving, arriving }, Piece::Line],
            between: arc.ends.map(smooth).to_vec(),
        };
        // Where it is good, the straight piece is the first one now, and the arc the second.
        let good = self.attempt(stretch, 1)?;
        Ok((if good { 2 } else { i + 1 }, true))
    }
}

/// How many pieces after straight piece i lead to the next straight one, and the arc in their place; nothing if it is
/// one piece or no arc.
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
