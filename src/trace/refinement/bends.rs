//! Tight bends of an outline.

use crate::numerics::plane::{cross, dot, norm};
use crate::numerics::{Point, Vector};
use crate::trace::outline::Outline;
use crate::trace::outline::cubic::Cubic;
use crate::trace::quality::Quality;

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

impl BendRule {
    /// How bends are looked for in a picture of a quality.
    pub(super) fn of(quality: Quality) -> Self {
        let (window, margin) = match quality {
            Quality::Clean | Quality::Rough => (3.0, 0.5),
            Quality::Sampled | Quality::Soft | Quality::Noisy => (5.0, 1.0),
        };
        // What compression leaves looks like corners more often than noise of single pixels does.
        let evidence = if matches!(quality, Quality::Soft | Quality::Noisy) { 0.0 } else { 6.0 };
        Self { window, margin, corner: 0.49, evidence }
    }
}

/// The least turning of a bend, in radians.
const LEAST: f64 = 0.45;
/// The share of the turning that may lie outside of what is called the bend.
const OUTSIDE: f64 = 0.1;
/// About how far places are from each other, in pixels.
const SPACING: f64 = 0.35;
/// About how many places are found in one step, and how many windows that begin with one are looked at.
const PLACES: usize = 131_072;

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

/// Places all around an outline that are being found, close enough to see every bend.
#[derive(Clone, Debug, Default)]
pub(super) struct Looking {
    places: Vec<Place>,
    /// The piece that is next.
    piece: usize,
}

impl Looking {
    /// Finds those of the next pieces; all places, when these were the last.
    ///
    /// # Cost
    ///
    /// O(1).
    pub(super) fn step(&mut self, outline: &Outline) -> Option<Vec<Place>> {
        let enough = self.places.len() + PLACES;
        while self.piece < outline.len() {
            if self.places.len() >= enough {
                return None;
            }
            self.follow(&outline.cubic(self.piece), outline.is_line(self.piece));
            self.piece += 1;
        }
        let count = self.places.len();
        for i in [0, count - 1] {
            self.turn(if i == 0 { count - 1 } else { i - 1 }, i, if i + 1 == count { 0 } else { i + 1 });
        }
        Some(core::mem::take(&mut self.places))
    }

    /// Places on the next piece.
    fn follow(&mut self, cubic: &Cubic, straight: bool) {
        let length = norm(cubic.leaving)
            + norm(cubic.arriving)
            + norm(cubic.end - cubic.start - cubic.leaving - cubic.arriving);
        let count = if straight { 1.0 } else { (length / SPACING).ceil().clamp(4.0, 4000.0) };
        for k in 0..count as usize {
            let t = k as f64 / count;
            let point = if k == 0 { cubic.start } else { cubic.point(t) };
            let along = self.places.last().map_or(0.0, |last| last.along + norm(point - last.point));
            self.places.push(Place { piece: self.piece, t, point, along, turning: 0.0 });
            if let Some(before) = self.places.len().checked_sub(3) {
                self.turn(before, before + 1, before + 2);
            }
        }
    }

    /// How much the chords turn at a place.
    fn turn(&mut self, before: usize, i: usize, after: usize) {
        let here = self.places[i].point;
        self.places[i].turning = angle(here - self.places[before].point, self.places[after].point - here);
    }
}

/// The angle between directions: small ones by their tangent.
fn angle(from: Vector, to: Vector) -> f64 {
    let (sine, cosine) = (cross(from, to), dot(from, to));
    if sine.abs() < 0.1 * cosine { sine / cosine } else { libm::atan2(sine, cosine) }
}

/// Bends that are being found among the places of an outline.
#[derive(Clone, Debug, Default)]
pub(super) struct Sweeping {
    /// How much the outline turns from place 0 to each place, and once more around, as far as that has been needed.
    sums: Vec<f64>,
    /// The window that is next, and the end of the one before it.
    start: usize,
    end: usize,
    /// The best window of this run of windows with enough turning: its turning, where it begins and where it ends.
    best: Option<(f64, usize, usize)>,
    found: Vec<Bend>,
}

impl Sweeping {
    /// Looks at some windows more; all bends, when they were the last.
    ///
    /// # Cost
    ///
    /// O(1).
    pub(super) fn step(&mut self, outline: &Outline, places: &[Place], rule: &BendRule) -> Option<Vec<Bend>> {
        let count = places.len();
        let round = places[count - 1].along + norm(places[0].point - places[count - 1].point);
        if outline.len() < 3 || round < 4.0 * rule.window {
            return Some(Vec::new());
        }
        let at = |i: usize| if i < count { places[i].along } else { places[i - count].along + round };
        if self.sums.is_empty() {
            self.sums.reserve_exact(2 * count + 1);
        }
        let last = (self.start + PLACES).min(count);
        for start in self.start..last {
            self.end = self.end.max(start);
            while self.end + 1 < start + count && at(self.end + 1) - at(start) <= rule.window {
                self.end += 1;
            }
            let turning = self.sum(self.end + 1, places) - self.sum(start, places);
            let left = turning < LEAST || self.best.is_some_and(|(_, _, last)| start > last);
            if left && let Some((_, first, last)) = self.best.take() {
                self.found.push(bend(places, (first, last), round, rule));
            }
            if turning >= LEAST && self.best.is_none_or(|(most, _, _)| turning > most) {
                self.best = Some((turning, start, self.end));
            }
        }
        self.start = last;
        if last < count {
            return None;
        }
        if let Some((_, first, last)) = self.best {
            self.found.push(bend(places, (first, last), round, rule));
        }
        Some(core::mem::take(&mut self.found))
    }

    /// How much the outline turns up to a place.
    fn sum(&mut self, i: usize, places: &[Place]) -> f64 {
        while self.sums.len() <= i {
            let before = self.sums.len().checked_sub(1).map(|last| {
                let place = if last < places.len() { last } else { last - places.len() };
                self.sums[last] + places[place].turning.abs()
            });
            self.sums.push(before.unwrap_or(0.0));
        }
        self.sums[i]
    }
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
