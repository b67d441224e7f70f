//! Pieces that are arcs of circles.

use super::cubic::Cubic;
use super::outline::{Outline, Piece};
use super::samples::{turn, unit};
use crate::numerics::plane::{cross, dot, norm};
use crate::numerics::{Point, Vector};

/// How far a piece may be from its arc, in pixels.
const MOST: f64 = 0.05;
/// How far an end may slide along a straight piece, along another curve, and at a corner.
const SLIDES: [f64; 3] = [1.5, 0.08, 0.02];
/// Arcs turn by so much, in radians: less is hardly seen, more has no corner between its tangents.
const TURNING: [f64; 2] = [0.3, 2.9];
/// The least radius, in pixels.
const LEAST: f64 = 1.5;

/// Makes exact arcs of the pieces that are arcs as far as pixels tell; the angle of each piece, 0 where it is none.
///
/// An arc has the tangents of its piece and takes as much of the corner between them: then it covers the same area (D 14.20).
pub(super) fn arcs(outline: &mut Outline) -> Vec<f64> {
    let mut angles = vec![0.0; outline.len()];
    for (i, angle) in angles.iter_mut().enumerate() {
        let slides = [slide(outline, i, true), slide(outline, i, false)];
        if !outline.is_line(i)
            && let Some(arc) = arc(&outline.cubic(i), slides)
        {
            let next = outline.next(i);
            let handle = arc.radius * arc.turning.abs() / 3.0;
            outline.nodes[i].point = arc.ends[0];
            outline.nodes[next].point = arc.ends[1];
            let [leaving, arriving] = arc.tangents.map(|tangent| tangent * handle);
            outline.pieces[i] = Piece::Cubic { leaving, arriving };
            *angle = arc.turning.abs();
        }
    }
    angles
}

/// How far an end of piece i may move along its tangent.
fn slide(outline: &Outline, i: usize, start: bool) -> f64 {
    let (node, other) = if start { (i, outline.before(i)) } else { (outline.next(i), outline.next(i)) };
    match (outline.nodes[node].smooth, outline.is_line(other)) {
        (true, true) => SLIDES[0],
        (true, false) => SLIDES[1],
        _ => SLIDES[2],
    }
}

struct Arc {
    ends: [Point; 2],
    tangents: [Vector; 2],
    radius: f64,
    turning: f64,
}

fn arc(cubic: &Cubic, slides: [f64; 2]) -> Option<Arc> {
    let tangents = [unit(cubic.leaving), unit(cubic.arriving)];
    let turning = turn(tangents[0], tangents[1]);
    if !(TURNING[0]..=TURNING[1]).contains(&turning.abs()) {
        return None;
    }
    // Where the tangents meet, and how far that is from both ends.
    let chord = cubic.end - cubic.start;
    let sine = cross(tangents[0], tangents[1]);
    let lengths = [cross(chord, tangents[1]) / sine, cross(tangents[0], chord) / sine];
    if lengths[0] <= 0.0 || lengths[1] <= 0.0 {
        return None;
    }
    let corner = cubic.start + tangents[0] * lengths[0];
    // Between the corner and an arc of tangent length d there is d²(1/k − θ/2k²), k = tan θ/2.
    let (sin, cos) = crate::numerics::angle::sin_cos(0.5 * turning.abs());
    let k = sin / cos;
    let lost = 0.5 * cross(corner - cubic.start, cubic.end - corner).abs() - under(cubic).abs();
    let share = 1.0 / k - 0.5 * turning.abs() / (k * k);
    if lost <= 0.0 || share <= 0.0 {
        return None;
    }
    let length = (lost / share).sqrt();
    let radius = length / k;
    let near = (0..2).all(|side| (length - lengths[side]).abs() <= slides[side]);
    if !near || radius < LEAST {
        return None;
    }
    let ends = [corner - tangents[0] * length, corner + tangents[1] * length];
    let inward = Vector::new(-tangents[0].y, tangents[0].x) * turning.signum();
    let center = ends[0] + inward * radius;
    let off = (0..=16).fold(0.0_f64, |most, i| {
        let p = cubic.point(f64::from(i) / 16.0);
        // Beyond its ends the arc goes on straight.
        let off = if dot(p - ends[0], tangents[0]) < 0.0 {
            cross(tangents[0], p - ends[0])
        } else if dot(p - ends[1], tangents[1]) > 0.0 {
            cross(tangents[1], p - ends[1])
        } else {
            norm(p - center) - radius
        };
        most.max(off.abs())
    });
    (off <= MOST).then_some(Arc { ends, tangents, radius, turning })
}

/// The area between a cubic and its chord.
fn under(cubic: &Cubic) -> f64 {
    let (chord, first) = (cubic.end - cubic.start, cubic.leaving);
    let second = chord - cubic.arriving;
    // Half the integral of the cross product with the velocity.
    0.15 * (cross(first, second) + cross(first, chord) + 2.0 * cross(second, chord))
}
