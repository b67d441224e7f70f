//! Tight bends of an outline.

use crate::numerics::plane::{cross, dot, norm};
use crate::numerics::{Point, Vector};
use crate::trace::outline::Outline;

/// Where bends are looked for, in pixels and radians.
#[derive(Clone, Copy, Debug)]
pub(super) struct BendRule {
    /// How much of the outline a bend takes at most.
    pub(super) window: f64,
    /// How far from a bend its sides are taken.
    pub(super) margin: f64,
    /// The least turning of a corner.
    pub(super) corner: f64,
    /// By how many squares of the noise a new corner has to explain more.
    pub(super) evidence: f64,
}

/// The least turning of a bend, in radians.
const LEAST: f64 = 0.45;
/// The share of the turning that may lie outside of what is called the bend.
const OUTSIDE: f64 = 0.1;
/// About how far places are from each other, in pixels.
const SPACING: f64 = 0.35;

/// A place of an outline.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    piece: usize,
    t: f64,
    point: Point,
    /// How far it is along the outline.
    along: f64,
    /// How much the chords turn here.
    turning: f64,
}

/// A bend: where its sides end and begin, and what lies between.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bend {
    pub(super) sides: [(usize, f64); 2],
    pub(super) middle: Point,
    /// From one side to the other, and of all places without sign.
    pub(super) net: f64,
    pub(super) total: f64,
}

/// Places all around, close enough to see every bend.
pub(super) fn places(outline: &Outline) -> Vec<Place> {
    let mut places: Vec<Place> = Vec::new();
    let mut along = 0.0;
    for piece in 0..outline.len() {
        let cubic = outline.cubic(piece);
        let length = norm(cubic.leaving)
            + norm(cubic.arriving)
            + norm(cubic.end - cubic.start - cubic.leaving - cubic.arriving);
        let count = if outline.is_line(piece) { 1.0 } else { (length / SPACING).ceil().clamp(4.0, 4000.0) };
        for k in 0..count as usize {
            let t = k as f64 / count;
            let point = if k == 0 { cubic.start } else { cubic.point(t) };
            if let Some(last) = places.last() {
                along += norm(point - last.point);
            }
            places.push(Place { piece, t, point, along, turning: 0.0 });
        }
    }
    let count = places.len();
    for i in 0..count {
        let (before, after) =
            (if i == 0 { count - 1 } else { i - 1 }, if i + 1 == count { 0 } else { i + 1 });
        let here = places[i].point;
        places[i].turning = angle(here - places[before].point, places[after].point - here);
    }
    places
}

/// The angle between directions: small ones by their tangent.
fn angle(from: Vector, to: Vector) -> f64 {
    let (sine, cosine) = (cross(from, to), dot(from, to));
    if sine.abs() < 0.1 * cosine { sine / cosine } else { libm::atan2(sine, cosine) }
}

/// All bends of an outline with these places.
pub(super) fn bends(outline: &Outline, places: &[Place], rule: &BendRule) -> Vec<Bend> {
    let count = places.len();
    let round = places[count - 1].along + norm(places[0].point - places[count - 1].point);
    if outline.len() < 3 || round < 4.0 * rule.window {
        return Vec::new();
    }
    // Turning from place 0 to each place, and once more around.
    let at = |i: usize| if i < count { places[i].along } else { places[i - count].along + round };
    let mut sums = Vec::with_capacity(2 * count + 1);
    let mut sum = 0.0;
    for i in 0..2 * count {
        sums.push(sum);
        sum += places[if i < count { i } else { i - count }].turning.abs();
    }
    sums.push(sum);
    let mut found = Vec::new();
    // The best window of each run of windows with enough turning.
    let (mut end, mut best): (usize, Option<(f64, usize, usize)>) = (0, None);
    for start in 0..count {
        end = end.max(start);
        while end + 1 < start + count && at(end + 1) - at(start) <= rule.window {
            end += 1;
        }
        let turning = sums[end + 1] - sums[start];
        let left = turning < LEAST || best.is_some_and(|(_, _, last)| start > last);
        if left && let Some((_, first, last)) = best.take() {
            found.push(bend(places, (first, last), round, rule));
        }
        if turning >= LEAST && best.is_none_or(|(most, _, _)| turning > most) {
            best = Some((turning, start, end));
        }
    }
    if let Some((_, first, last)) = best {
        found.push(bend(places, (first, last), round, rule));
    }
    found
}

/// The bend between two places, without what hardly turns at its ends.
fn bend(places: &[Place], (mut first, mut last): (usize, usize), round: f64, rule: &BendRule) -> Bend {
    let count = places.len();
    let place = |i: usize| &places[i % count];
    let total: f64 = (first..=last).map(|i| place(i).turning.abs()).sum();
    let mut outside = 0.0;
    while first < last {
        let ends = [place(first).turning.abs(), place(last).turning.abs()];
        let less = ends[0].min(ends[1]);
        if outside + less > OUTSIDE * total {
            break;
        }
        outside += less;
        if ends[0] <= ends[1] { first += 1 } else { last -= 1 }
    }
    let net = (first..=last).map(|i| place(i).turning).sum();
    let sides = [
        side(places, place(first).along - rule.margin, round),
        side(places, place(last).along + rule.margin, round),
    ];
    let middle = (place(first).point + place(last).point) * 0.5;
    Bend { sides, middle, net, total }
}

/// The piece and the parameter at a distance along the outline.
fn side(places: &[Place], along: f64, round: f64) -> (usize, f64) {
    let along = if along < 0.0 {
        along + round
    } else if along >= round {
        along - round
    } else {
        along
    };
    let next = places.partition_point(|place| place.along <= along);
    let here = &places[next.max(1) - 1];
    let end = places.get(next).map_or(round, |place| place.along);
    let until = places.get(next).filter(|place| place.piece == here.piece).map_or(1.0, |place| place.t);
    let share = (along - here.along) / (end - here.along).max(1e-9);
    (here.piece, here.t + (until - here.t) * share.min(1.0))
}
