//! Sharp corners of a contour, and only those.

use super::samples::{Line, Samples, line_through, turn, unit};
use crate::numerics::order::sort_by_keys;
use crate::numerics::plane::{dot, norm, square};
use crate::numerics::{Point, Vector};

/// What a corner is, in pixels and radians.
#[derive(Clone, Copy, Debug)]
pub(super) struct CornerRule {
    /// How much of both sides next to the place is not looked at: the pixels round it.
    pub(super) gap: f64,
    /// How much of both sides is looked at.
    pub(super) window: f64,
    /// The least turning.
    pub(super) angle: f64,
    /// How far the corner may be from the contour.
    pub(super) reach: f64,
}

/// A corner between places of a contour.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    /// The index of the place nearest to it.
    pub(super) index: isize,
    /// Where both sides meet.
    pub(super) point: Point,
}

/// All corners in the order of the places: those by the first rule, then those that another rule finds between them.
/// O(places).
///
/// Both sides of a place are followed by a line and by a parabola, from the gap on. The turning between the lines is that of a
/// corner or of an arc; the turning between the parabolas' tangents at the place is small for arcs (D 14.5).
pub(super) fn corners(samples: &Samples, rules: &[CornerRule]) -> Vec<Corner> {
    let count = samples.len() as isize;
    let around = |i: isize| i.rem_euclid(count) as usize;
    let mut found: Vec<Corner> = Vec::new();
    // Places near corners of the rules before.
    let mut taken = vec![false; samples.len()];
    for rule in rules {
        // What pixels cut off belongs to the corner, by this rule and by those after it.
        let apart = samples.steps((1.8 * rule.gap - 0.7).max(2.2)).max(1);
        let cosines = [0.6 * rule.angle, rule.angle].map(|angle| crate::numerics::angle::sin_cos(angle).1);
        let scores: Vec<f64> = (0..count).map(|i| score(samples, i, rule, cosines)).collect();
        let known = found.len();
        for i in 0..count {
            let own = scores[i as usize];
            if own < rule.angle || taken[i as usize] {
                continue;
            }
            let highest = (1..=apart).all(|d| own > scores[around(i - d)] && own >= scores[around(i + d)]);
            if highest && let Some(point) = place(samples, i, rule) {
                found.push(Corner { index: i, point });
            }
        }
        for corner in &found[known..] {
            (1 - apart..apart).for_each(|d| taken[around(corner.index + d)] = true);
        }
    }
    sort_by_keys(&mut found, &|corner| [corner.index as u64, 0]);
    found
}

fn sides<'a>(samples: &'a Samples, i: isize, rule: &CornerRule) -> [&'a [Point]; 2] {
    let (near, far) = (samples.steps(rule.gap), samples.steps(rule.gap + rule.window));
    [samples.stretch(i - far, i - near), samples.stretch(i + near, i + far)]
}

/// How much of a corner a place is; nothing where the cosine of the turning is larger than one of two: between chords, between lines.
fn score(samples: &Samples, i: isize, rule: &CornerRule, [cosine, least]: [f64; 2]) -> f64 {
    let far = samples.steps(rule.gap + rule.window);
    if 2 * far > samples.len() as isize {
        return 0.0;
    }
    if !samples.closed && (i < far || i + far >= samples.len() as isize) {
        return 0.0;
    }
    let here = samples.at(i);
    let (before, after) = (here - samples.at(i - far), samples.at(i + far) - here);
    let along = dot(before, after);
    // Of two sides of the inequality with equal signs the squares are compared.
    let (ours, theirs) = (along * along.abs(), cosine * cosine.abs() * square(before) * square(after));
    if ours > theirs {
        return 0.0;
    }
    let [before, after] = sides(samples, i, rule);
    let (first, second) = (line_through(before), line_through(after));
    // Less than a corner is nothing: most curves end here.
    if dot(first.direction, second.direction) > least {
        return 0.0;
    }
    let lines = turn(first.direction, second.direction);
    let tangents = turn(end_tangent(before, &first, here, 1.0), end_tangent(after, &second, here, -1.0));
    if lines * tangents < 0.0 && lines.abs() < 2.0 {
        return 0.0;
    }
    lines.abs().min(1.6 * tangents.abs())
}

/// The tangent at the place that a side leads to, by a parabola over the side's own axis, the line through it.
fn end_tangent(side: &[Point], line: &Line, here: Point, sign: f64) -> Vector {
    let normal = Vector::new(-line.direction.y, line.direction.x);
    // Least squares of y = a + bx + cx² about the middle, where Σx = 0.
    let (mut x2, mut x3, mut x4, mut y0, mut y1, mut y2) = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    for p in side {
        let (x, y) = (dot(p - line.middle, line.direction), dot(p - line.middle, normal));
        x2 += x * x;
        x3 += x * x * x;
        x4 += x * x * x * x;
        y0 += y;
        y1 += x * y;
        y2 += x * x * y;
    }
    let n = side.len() as f64;
    // From a = (y0 − c·x2)/n: [x2 x3; x3 x4 − x2²/n]·(b, c) = (y1, y2 − x2·y0/n).
    let (d, e) = (x4 - x2 * x2 / n, y2 - x2 * y0 / n);
    let determinant = x2 * d - x3 * x3;
    if determinant.abs() < 1e-9 {
        return line.direction;
    }
    let (b, c) = ((y1 * d - e * x3) / determinant, (x2 * e - x3 * y1) / determinant);
    // Extrapolated to the place, which is no farther than the side is long.
    let reach = norm(side[side.len() - 1] - side[0]);
    let x = sign * (sign * dot(here - line.middle, line.direction)).max(0.0).min(1.2 * reach);
    unit(line.direction + normal * (b + 2.0 * c * x))
}

fn place(samples: &Samples, i: isize, rule: &CornerRule) -> Option<Point> {
    let [before, after] = sides(samples, i, rule);
    let (first, second): (Line, Line) = (line_through(before), line_through(after));
    let point = first.meets(&second)?;
    // The pixels cut more off a sharp tip than off a right angle.
    let half = 0.5 * turn(first.direction, second.direction).abs();
    let (sine, cosine) = crate::numerics::angle::sin_cos(half);
    let reach = rule.reach * (0.5 + 0.5 * sine / cosine.max(0.15));
    (norm(point - samples.at(i)) <= reach).then_some(point)
}
