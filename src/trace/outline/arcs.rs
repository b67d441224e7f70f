//! Pieces that are arcs of circles.

use super::cubic::Cubic;
use super::{Outline, Piece};
use crate::numerics::plane::{cross, dot, norm};
use crate::numerics::{Point, Vector};
use crate::trace::samples::{turn, unit};

/// How far a piece may be from its arc, in pixels.
const MOST: f64 = 0.05;
/// How far an end may slide along a straight piece, along another curve, and at a corner.
const SLIDES: [f64; 3] = [1.5, 0.08, 0.02];
/// The share of a straight piece that its end may slide along it.
const ROOM: f64 = 0.45;
/// Arcs turn by so much, in radians: less is hardly seen, more has no corner between its tangents.
const TURNING: [f64; 2] = [0.3, 2.9];
/// The least radius, in pixels.
const LEAST: f64 = 1.5;

/// Makes exact arcs of the pieces that are arcs as far as pixels tell; the angle of each piece, 0 where it is none.
///
/// An arc has the tangents of its piece and takes as much of the corner between them: then it covers the same area
/// (D 14.22).
pub(in crate::trace) fn arcs(outline: &mut Outline, angles: &mut [f64], slack: f64) {
    let whole = angles.to_vec();
    for (i, angle) in angles.iter_mut().enumerate() {
        // Whole arcs stay where they are.
        let beside = [outline.before(i), outline.next(i)].map(|other| whole[other] > 0.0);
        let room =
            |start: bool| if beside[usize::from(!start)] { 0.0 } else { slide(outline, i, start, slack) };
        let slides = [room(true), room(false)];
        if !outline.is_line(i)
            && *angle == 0.0
            && let Some(arc) = arc(&outline.cubic(i), slides, slack * MOST)
        {
            let next = outline.next(i);
            outline.nodes[i].point = arc.ends[0];
            outline.nodes[next].point = arc.ends[1];
            let [leaving, arriving] = arc.handles();
            outline.pieces[i] = Piece::Cubic { leaving, arriving };
            *angle = arc.turning.abs();
        }
    }
}

/// How far an end of piece i may move along its tangent.
fn slide(outline: &Outline, i: usize, start: bool, slack: f64) -> f64 {
    let (node, other) = if start { (i, outline.before(i)) } else { (outline.next(i), outline.next(i)) };
    match (outline.nodes[node].smooth, outline.is_line(other)) {
        (true, true) => {
            (slack * SLIDES[0]).min(ROOM * norm(outline.cubic(other).end - outline.cubic(other).start))
        }
        (true, false) => SLIDES[1],
        _ => SLIDES[2],
    }
}

/// An arc of a circle between two tangents.
pub(in crate::trace) struct Arc {
    pub(in crate::trace) ends: [Point; 2],
    pub(super) tangents: [Vector; 2],
    pub(super) radius: f64,
    pub(super) turning: f64,
}

impl Arc {
    /// The arc that touches both sides of a corner and leaves so much area between them and it, if it turns neither too
    /// little nor too much.
    pub(in crate::trace) fn in_corner(corner: Point, tangents: [Vector; 2], lost: f64) -> Option<Self> {
        let turning = turn(tangents[0], tangents[1]);
        if !(TURNING[0]..=TURNING[1]).contains(&turning.abs()) {
            return None;
        }
        // Between the corner and an arc of tangent length d there is d²(1/k − θ/2k²), k = tan θ/2.
        let (sin, cos) = crate::numerics::angle::sin_cos(0.5 * turning.abs());
        let k = sin / cos;
        let share = 1.0 / k - 0.5 * turning.abs() / (k * k);
        if lost <= 0.0 || share <= 0.0 {
            return None;
        }
        let length = (lost / share).sqrt();
        let ends = [corner - tangents[0] * length, corner + tangents[1] * length];
        Some(Self { ends, tangents, radius: length / k, turning })
    }

    /// The ways to the control points of the arc as a segment that knows its angle.
    pub(super) fn handles(&self) -> [Vector; 2] {
        self.tangents.map(|tangent| tangent * (self.radius * self.turning.abs() / 3.0))
    }

    /// The same for the plain cubic that is nearest to the arc.
    pub(in crate::trace) fn cubic_handles(&self) -> [Vector; 2] {
        let (sin, cos) = crate::numerics::angle::sin_cos(0.25 * self.turning.abs());
        self.tangents.map(|tangent| tangent * (4.0 / 3.0 * self.radius * sin / cos))
    }

    /// How far a point is from the arc, which goes on straight beyond its ends.
    pub(in crate::trace) fn off(&self, p: Point) -> f64 {
        let [first, last] = self.tangents;
        if dot(p - self.ends[0], first) < 0.0 {
            return cross(first, p - self.ends[0]).abs();
        }
        if dot(p - self.ends[1], last) > 0.0 {
            return cross(last, p - self.ends[1]).abs();
        }
        let inward = Vector::new(-first.y, first.x) * self.turning.signum();
        (norm(p - self.ends[0] - inward * self.radius) - self.radius).abs()
    }
}

fn arc(cubic: &Cubic, slides: [f64; 2], most: f64) -> Option<Arc> {
    let tangents = [unit(cubic.leaving), unit(cubic.arriving)];
    // Where the tangents meet, and how far that is from both ends.
    let chord = cubic.end - cubic.start;
    let sine = cross(tangents[0], tangents[1]);
    let lengths = [cross(chord, tangents[1]) / sine, cross(tangents[0], chord) / sine];
    if lengths[0].is_nan() || lengths[0] <= 0.0 || lengths[1] <= 0.0 {
        return None;
    }
    let corner = cubic.start + tangents[0] * lengths[0];
    let lost = 0.5 * cross(corner - cubic.start, cubic.end - corner).abs() - under(cubic).abs();
    let arc = Arc::in_corner(corner, tangents, lost)?;
    let near = (0..2).all(|side| (norm(arc.ends[side] - corner) - lengths[side]).abs() <= slides[side]);
    if !near || arc.radius < LEAST {
        return None;
    }
    let off = (0..=16).fold(0.0_f64, |most, i| most.max(arc.off(cubic.point(f64::from(i) / 16.0))));
    (off <= most).then_some(arc)
}

/// The area between a cubic and its chord, positive where it turns from x to y.
pub(in crate::trace) fn under(cubic: &Cubic) -> f64 {
    let (chord, first) = (cubic.end - cubic.start, cubic.leaving);
    let second = chord - cubic.arriving;
    // Half the integral of the cross product with the velocity.
    0.15 * (cross(first, second) + cross(first, chord) + 2.0 * cross(second, chord))
}
