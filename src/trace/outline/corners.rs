//! Sharp corners of a contour, and only those.

mod sides;

use self::sides::Sides;
use crate::numerics::order::sort_by_keys;
use crate::numerics::plane::{dot, norm, square};
use crate::numerics::{Point, Vector};
use crate::trace::samples::{Line, Samples, line_through, turn, unit};

/// Corners this near each other, in pixels, may be one.
const DOUBLE: f64 = 1.5;
const DETOUR: f64 = 1.8;

/// The cosine of the least turning at a narrow end, its least and largest width and how far its corners may be from the
/// contour, in pixels.
const BACK: f64 = -0.75;
const BLUNT: f64 = 1.4;
/// How far from a tip, in pixels, its sides may meet for it to be one.
const ELSEWHERE: f64 = 2.0;
const WIDEST: f64 = 5.0;
const CUT: f64 = 0.6;

/// How many times the turning between tangents a corner may turn.
const STEEP: f64 = 1.6;

/// What a corner is, in pixels and radians.
#[derive(Clone, Copy, Debug)]
pub(in crate::trace) struct CornerRule {
    /// How much of both sides next to the place is not looked at: the pixels round it.
    pub(in crate::trace) gap: f64,
    /// How much of both sides is looked at.
    pub(in crate::trace) window: f64,
    /// The least turning.
    pub(in crate::trace) angle: f64,
    /// How far the corner may be from the contour.
    pub(in crate::trace) reach: f64,
}

/// A corner between places of a contour.
#[derive(Clone, Copy, Debug)]
pub(in crate::trace) struct Corner {
    /// The index of the place nearest to it.
    pub(super) index: isize,
    /// Where both sides meet.
    pub(in crate::trace) point: Point,
}

/// All corners in the order of the places: those by the first rule, then those that another rule finds between them.
/// O(places).
///
/// Both sides of a place are followed by a line and by a parabola, from the gap on. The turning between the lines is
/// that of a corner or of an arc; the turning between the parabolas' tangents at the place is small for arcs (D 14.5).
pub(in crate::trace) fn corners(samples: &Samples, rules: &[CornerRule]) -> Vec<Corner> {
    let count = samples.len() as isize;
    let mut found: Vec<Corner> = Vec::new();
    // Places near corners of the rules before.
    let mut taken = vec![false; samples.len()];
    for rule in rules {
        // What pixels cut off belongs to the corner, by this rule and by those after it.
        let apart = samples.steps((1.8 * rule.gap - 0.7).max(2.2)).max(1);
        let mut scores = Scores::new(samples, rule);
        let known = found.len();
        for i in 0..count {
            if taken[i as usize] {
                continue;
            }
            let own = scores.of(i);
            if own < rule.angle {
                continue;
            }
            let highest = (1..=apart).all(|d| own > scores.of(i - d) && own >= scores.of(i + d));
            if !highest {
                continue;
            }
            if let Some(ends) = blunt(samples, i, rule) {
                found.extend(ends);
            } else if let Some(point) = place(samples, i, rule) {
                match rules.first().and_then(|wide| rounded_end(samples, i, wide, point)) {
                    Some(ends) => found.extend(ends),
                    None => found.push(Corner { index: i, point }),
                }
            }
        }
        for corner in &found[known..] {
            (1 - apart..apart).for_each(|d| taken[(corner.index + d).rem_euclid(count) as usize] = true);
        }
    }
    sort_by_keys(&mut found, &|corner| [corner.index as u64, 0]);
    without_doubles(found, samples)
}

/// Corners less those that are near the one before, though the contour goes a long way from one to the other: round a
/// tip that pixels cut off both sides of it meet twice.
fn without_doubles(found: Vec<Corner>, samples: &Samples) -> Vec<Corner> {
    let mut kept: Vec<Corner> = Vec::with_capacity(found.len());
    for corner in found {
        let twice = kept.last().is_some_and(|last| {
            let apart = norm(corner.point - last.point);
            apart < DOUBLE && corner.index - last.index > samples.steps(DETOUR * apart)
        });
        if !twice {
            kept.push(corner);
        }
    }
    kept
}

/// Where a side begins and where it ends, in places from a corner.
fn reach(samples: &Samples, rule: &CornerRule) -> [usize; 2] {
    [rule.gap, rule.gap + rule.window].map(|far| samples.steps(far) as usize)
}

/// How much of a corner each place is, found when it is asked for: hardly anybody asks near corners of the rules
/// before.
struct Scores<'a> {
    samples: &'a Samples,
    reach: [usize; 2],
    cosines: [f64; 3],
    /// Not a number where nobody asked.
    known: Vec<f64>,
}

impl<'a> Scores<'a> {
    fn new(samples: &'a Samples, rule: &CornerRule) -> Self {
        let least = [0.6 * rule.angle, rule.angle, rule.angle / STEEP];
        let cosines = least.map(|angle| crate::numerics::angle::sin_cos(angle).1);
        let reach = reach(samples, rule);
        let [before, here, after] = samples.surroundings(reach[1]);
        let mut known = vec![0.0; samples.len()];
        // The first surroundings are those of the place that is so far from the first.
        let (last, first) = known.split_at_mut(reach[1].min(samples.len()));
        let places = before.iter().zip(here).zip(after);
        first.iter_mut().chain(last).zip(places).for_each(|(score, ((&a, &b), &c))| {
            if bends(a, b, c, cosines[0]) {
                *score = f64::NAN;
            }
        });
        Self { samples, reach, cosines, known }
    }

    /// The score of a place, around the contour.
    fn of(&mut self, i: isize) -> f64 {
        let count = self.known.len();
        let i = if (i as usize) < count { i as usize } else { i.rem_euclid(count as isize) as usize };
        if self.known[i].is_nan() {
            let far = self.reach[1] as isize;
            let around = self.samples.stretch(i as isize - far, i as isize + far);
            self.known[i] = score(around, self.reach, self.cosines);
        }
        self.known[i]
    }
}

/// Whether the way from one place to another and the way on to a third turn by an angle of no larger cosine.
#[inline]
fn bends(before: Point, here: Point, after: Point, cosine: f64) -> bool {
    let (before, after) = (here - before, after - here);
    let along = dot(before, after);
    // Of two sides of the inequality with equal signs the squares are compared.
    along * along.abs() <= cosine * cosine.abs() * square(before) * square(after)
}

/// How much of a corner the place in the middle is; nothing where the cosine of the turning is larger than one of two:
/// between lines and between tangents.
fn score(around: &[Point], [near, far]: [usize; 2], [_, least, soft]: [f64; 3]) -> f64 {
    let here = around[far];
    let sides = Sides::new(&around[..=far - near], &around[far + near..]);
    let lines = sides.directions();
    // Less than a corner is nothing: most curves end here.
    if dot(lines[0], lines[1]) > least {
        return 0.0;
    }
    let ends = sides.end_tangents(lines, here);
    // What is less than a corner by its tangents is nothing, too, and no angle has to be known.
    if dot(ends[0], ends[1]) > soft {
        return 0.0;
    }
    let (lines, tangents) = (turn(lines[0], lines[1]), turn(ends[0], ends[1]));
    if lines * tangents < 0.0 && lines.abs() < 2.0 {
        return 0.0;
    }
    lines.abs().min(STEEP * tangents.abs())
}

fn place(samples: &Samples, i: isize, rule: &CornerRule) -> Option<Point> {
    let [near, far] = reach(samples, rule).map(|steps| steps as isize);
    let first = line_through(samples.stretch(i - far, i - near));
    let second = line_through(samples.stretch(i + near, i + far));
    let point = first.meets(&second)?;
    // The pixels cut more off a sharp tip than off a right angle.
    let half = 0.5 * turn(first.direction, second.direction).abs();
    let (sine, cosine) = crate::numerics::angle::sin_cos(half);
    let reach = rule.reach * (0.5 + 0.5 * sine / cosine.max(0.15));
    (norm(point - samples.at(i)) <= reach).then_some(point)
}

/// The two corners of a narrow end that looks like a tip from near by, where pixels round it, though its sides do not
/// lead there when more of them is looked at: both would become one line, with nothing inside. Nothing where it is a
/// tip.
fn rounded_end(samples: &Samples, i: isize, wide: &CornerRule, tip: Point) -> Option<[Corner; 2]> {
    let here = samples.at(i);
    if norm(tip - here) <= wide.reach {
        return None;
    }
    let [near, far] = reach(samples, wide).map(|steps| steps as isize);
    let first = line_through(samples.stretch(i - far, i - near));
    let second = line_through(samples.stretch(i + near, i + far));
    let is_tip = first.meets(&second).is_some_and(|point| norm(point - tip) < ELSEWHERE);
    if is_tip || dot(first.direction, second.direction) > BACK {
        return None;
    }
    let back = unit(second.direction - first.direction);
    let end = Line { middle: here, direction: Vector::new(back.y, -back.x) };
    let half = samples.steps(0.5 * (first.offset(here).abs() + second.offset(here).abs())).max(2);
    let corner = |d: isize, point| Corner { index: (i + d).rem_euclid(samples.len() as isize), point };
    Some([corner(-half, first.meets(&end)?), corner(half, end.meets(&second)?)])
}

/// The two corners of a narrow end that is cut off straight, where the contour turns back at place i.
fn blunt(samples: &Samples, i: isize, rule: &CornerRule) -> Option<[Corner; 2]> {
    let near = samples.steps(rule.gap);
    let (mut gap, mut width) = (near, 0.0);
    let mut lines = None;
    for _ in 0..2 {
        let far = gap + samples.steps(rule.window);
        if 2 * far > samples.len() as isize || !samples.closed {
            return None;
        }
        let first = line_through(samples.stretch(i - far, i - gap));
        let second = line_through(samples.stretch(i + gap, i + far));
        if dot(first.direction, second.direction) > BACK {
            return None;
        }
        let here = samples.at(i);
        width = first.offset(here).abs() + second.offset(here).abs();
        if !(BLUNT..=WIDEST).contains(&width) {
            return None;
        }
        gap = near + samples.steps(0.5 * width);
        lines = Some((first, second));
    }
    let (first, second) = lines?;
    let middle = samples.steps(0.25 * width).max(1);
    let end = line_through(samples.stretch(i - middle, i + middle));
    let points = [first.meets(&end)?, end.meets(&second)?];
    let half = samples.steps(0.5 * width).max(2);
    // A round end keeps away from such corners.
    let off = |point: Point| {
        (-2 * half..=2 * half).fold(f64::MAX, |least, d| least.min(square(point - samples.at(i + d)))).sqrt()
    };
    let count = samples.len() as isize;
    (off(points[0]) < CUT && off(points[1]) < CUT).then(|| {
        let corner = |index: isize, point| Corner { index: index.rem_euclid(count), point };
        [corner(i - half, points[0]), corner(i + half, points[1])]
    })
}
