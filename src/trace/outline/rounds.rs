//! Runs of pieces that are one arc of a circle together.

use super::cubic::Cubic;
use super::{Node, Outline, Piece};
use crate::numerics::angle::sin_cos;
use crate::numerics::order::sort_by_number;
use crate::numerics::plane::{cross, dot, larger, norm, square};
use crate::numerics::{Point, Vector};
use crate::trace::samples::{turn, unit};

/// The root mean square of how far pieces may be from their arc, as a share of the most.
const SQUARE: f64 = 0.5;
/// How many times that an arc bends away from its chord at least, and how much it turns, in radians.
const BENDS: f64 = 4.0;
const TURNING: [f64; 2] = [0.3, 6.0];
/// A single piece that turns by less, in radians, is looked at by itself.
const SINGLE: f64 = 2.9;
/// What turns by more, in radians, is two segments: a little more than half a circle.
const WIDEST: f64 = 3.3;
/// The least radius, in pixels.
const LEAST: f64 = 1.5;
/// An arc may have straight pieces among others where pieces may be so far from it, in pixels.
const CHORDED: f64 = 0.05;
/// Joints within an arc turn by less, in radians.
const GENTLE: f64 = 0.3;
/// The most pieces of an arc, and how many more are looked at where some are off.
const PIECES: usize = 40;
const MISSES: usize = 2;
/// Pieces that are looked at in one step for runs that begin there.
const STARTS: usize = 2048;
/// How many times farther away one piece may be at a glance.
const GLANCE: f64 = 3.0;
/// Places that are looked at on each piece.
const PLACES: usize = 8;
/// How far an end may slide along a straight piece, in pixels, and the share of it.
const SLIDE: f64 = 1.5;
const ROOM: f64 = 0.45;
/// Steps of the fit of a circle, and how often ends are moved to where arcs and what is beside them meet.
const STEPS: usize = 4;
const MEETINGS: usize = 6;

/// An arc in place of some pieces.
#[derive(Clone, Copy, Debug)]
struct Round {
    first: usize,
    count: usize,
    circle: Circle,
    /// Positive from x to y.
    turning: f64,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Circle {
    pub(super) center: Point,
    pub(super) radius: f64,
}

/// Runs of pieces of an outline that are being looked for.
#[derive(Debug, Default)]
pub(in crate::trace) struct Rounding {
    /// The longest from each piece on.
    found: Vec<Option<Round>>,
}

impl Rounding {
    /// Looks for runs that begin with the next pieces and are nowhere farther than `most` from an arc; whether these
    /// were the last.
    ///
    /// # Cost
    ///
    /// O(1).
    pub(in crate::trace) fn step(&mut self, outline: &Outline, most: f64) -> bool {
        let next = self.found.len();
        let end = (next + STARTS).min(outline.len());
        self.found.extend((next..end).map(|i| longest(outline, i, most)));
        end == outline.len()
    }

    /// Makes exact arcs of the runs, once all have been looked for; the angle of each piece, 0 where it is none.
    ///
    /// # Cost
    ///
    /// O(pieces).
    pub(in crate::trace) fn finish(self, outline: &mut Outline) -> Vec<f64> {
        let found = apart(outline, self.found);
        for _ in 0..MEETINGS {
            found.iter().flatten().for_each(|round| meet(outline, round));
        }
        match found.iter().position(Option::is_some) {
            Some(start) => {
                outline.align();
                rebuilt(outline, &found, start)
            }
            None => vec![0.0; outline.len()],
        }
    }
}

/// Of runs, each where its first piece is, the longest that have neither a piece nor a smooth joint in common.
#[inline(never)]
fn apart(outline: &Outline, mut found: Vec<Option<Round>>) -> Vec<Option<Round>> {
    let mut order: Vec<usize> = (0..outline.len()).collect();
    sort_by_number(&mut order, &|&i| found[i].as_ref().map_or(0.0, Round::shortness));
    let mut taken = vec![false; outline.len()];
    for i in order {
        let Some(Round { first, count, .. }) = found[i] else { break };
        let end = (first + count) % outline.len();
        let beside = |piece: usize, joint: usize| taken[piece] && outline.nodes[joint].smooth;
        let crowded = beside(outline.before(first), first) || beside(end, end);
        let own = (0..count).map(|k| (first + k) % outline.len());
        if crowded || own.clone().any(|piece| taken[piece]) {
            found[first] = None;
        } else {
            own.for_each(|piece| taken[piece] = true);
        }
    }
    found
}

/// The longest run from a piece on.
#[inline(never)]
fn longest(outline: &Outline, first: usize, most: f64) -> Option<Round> {
    let (mut places, mut good, mut misses) = (Vec::new(), None, 0);
    let mut piece = first;
    for count in 1..=PIECES.min(outline.len().saturating_sub(1)) {
        let line = outline.is_line(piece);
        // Chords may look straight, but arcs neither begin nor end with a straight piece.
        if line && (count == 1 || most < CHORDED) || count > 1 && !is_gentle(outline, piece) {
            break;
        }
        let cubic = outline.cubic(piece);
        if !line && !is_bow(&cubic, most) {
            break;
        }
        for k in 0..=PLACES {
            places.push(cubic.point(k as f64 / PLACES as f64));
        }
        piece = outline.next(piece);
        if line {
            continue;
        }
        match round(outline, &places, (first, count), most) {
            Some(round) if round.reaches(outline, first, most) && round.reaches(outline, piece, most) => {
                (good, misses) = (Some(round), 0);
            }
            _ => misses += 1,
        }
        if misses > MISSES {
            break;
        }
    }
    good
}

/// Whether a piece may be of an arc, at a glance: its quarters are near the circle through its ends and its middle.
fn is_bow(cubic: &Cubic, most: f64) -> bool {
    let place = |t: f64| cubic.point(t) - cubic.start;
    let (middle, end) = (place(0.5), place(1.0));
    let twice = 2.0 * cross(middle, end);
    let (a, b) = (square(middle), square(end));
    let center = Vector::new(a * end.y - b * middle.y, b * middle.x - a * end.x) / twice;
    let radius = norm(center);
    // Not where there is no circle.
    [0.25, 0.75].into_iter().all(|t| (norm(place(t) - center) - radius).abs() <= GLANCE * most)
}

/// Whether the outline turns by little at a joint.
fn is_gentle(outline: &Outline, i: usize) -> bool {
    let ways = (outline.cubic(outline.before(i)).velocity(1.0), outline.cubic(i).velocity(0.0));
    outline.nodes[i].smooth || turn(ways.0, ways.1).abs() < GENTLE
}

/// The arc that some places of an outline are on, if it is one.
fn round(outline: &Outline, places: &[Point], (first, count): (usize, usize), most: f64) -> Option<Round> {
    let Arc { circle, turning } = Arc::near(places, (most, SQUARE * most))?;
    let last = (first + count) % outline.len();
    let ends = [first, last].into_iter().any(|node| !outline.nodes[node].smooth);
    let alone = count > 1 || ends || turning.abs() > SINGLE;
    alone.then_some(Round { first, count, circle, turning })
}

/// A circle, and by how much places on it turn round its centre.
pub(super) struct Arc {
    pub(super) circle: Circle,
    pub(super) turning: f64,
}

impl Arc {
    /// The arc that places follow, none of them farther from it than `most` and the root mean square no larger than
    /// `rms`.
    pub(super) fn near(places: &[Point], (most, rms): (f64, f64)) -> Option<Self> {
        let circle = Circle::through(places)?;
        let Circle { center, radius } = circle;
        let (mut sum, mut far, mut turning, mut way) = (0.0, 0.0, 0.0, 0.0);
        let mut last = places[0];
        for &place in places {
            let off = (norm(place - center) - radius).abs();
            let step = turn(last - center, place - center);
            (sum, far, last) = (sum + off * off, larger(far, off), place);
            (turning, way) = (turning + step, way + step.abs());
        }
        let (_, cos) = sin_cos((0.5 * turning.abs()).min(core::f64::consts::PI));
        let good = far <= most
            && sum <= rms * rms * places.len() as f64
            && radius >= LEAST
            && radius * (1.0 - cos) >= BENDS * most
            && (TURNING[0]..=TURNING[1]).contains(&turning.abs())
            // What turns back goes over the same places twice.
            && (way - turning.abs()) * radius <= most;
        good.then_some(Self { circle, turning })
    }
}

impl Circle {
    /// The circle that is nearest to some places, by the squares of their distances.
    fn through(places: &[Point]) -> Option<Self> {
        let share = 1.0 / places.len() as f64;
        let middle = places.iter().fold(Vector::zeros(), |sum, place| sum + place) * share;
        let (mut xx, mut xy, mut yy, mut cubes) = (0.0, 0.0, 0.0, Vector::zeros());
        for place in places {
            let off = place - middle;
            (xx, xy, yy) = (xx + off.x * off.x, xy + off.x * off.y, yy + off.y * off.y);
            cubes += off * (0.5 * square(off));
        }
        let mut center = middle + solved([xx, xy, yy], cubes)?;
        let mut radius = 0.0;
        for _ in 0..STEPS {
            let (mut far, mut mean) = (0.0, Vector::zeros());
            for way in places.iter().map(|&place| place - center) {
                far += norm(way);
                mean += unit(way);
            }
            (radius, mean) = (far * share, mean * share);
            let (mut xx, mut xy, mut yy, mut right) = (0.0, 0.0, 0.0, Vector::zeros());
            for way in places.iter().map(|&place| place - center) {
                let along = unit(way) - mean;
                (xx, xy, yy) = (xx + along.x * along.x, xy + along.x * along.y, yy + along.y * along.y);
                right += along * (norm(way) - radius);
            }
            center += solved([xx, xy, yy], right)?;
        }
        (radius.is_finite() && radius < 1e6).then_some(Self { center, radius })
    }

    /// The place on the circle that is nearest to another.
    fn nearest(&self, place: Point) -> Point {
        self.center + unit(place - self.center) * self.radius
    }

    /// Where a straight line from a place touches the circle, nearest to another place.
    fn touched(&self, from: Point, near: Point) -> Point {
        let way = from - self.center;
        let (far, radius) = (norm(way), self.radius);
        if far <= radius {
            return self.nearest(near);
        }
        let (along, share) = (way / far, radius / far);
        let across = Vector::new(-along.y, along.x) * (radius * (1.0 - share * share).sqrt());
        nearer(self.center + along * (share * radius), across, near)
    }

    /// Where a straight line from a place to another crosses the circle, nearest to the other.
    fn crossed(&self, from: Point, near: Point) -> Point {
        let along = unit(near - from);
        let foot = near - along * dot(near - self.center, along);
        let room = self.radius * self.radius - square(foot - self.center);
        // Where it crosses at a small angle, it says little.
        if room < 0.25 * self.radius * self.radius {
            return self.nearest(near);
        }
        nearer(foot, along * room.sqrt(), near)
    }

    /// Goes on by equal parts of an arc from a node on, which is some way from the centre; handles are `handle` times
    /// as long as the radius.
    pub(super) fn follow(
        &self,
        outline: &mut Outline,
        mut node: Node,
        mut way: Vector,
        (angle, count): (f64, usize),
        handle: f64,
    ) {
        let (sin, cos) = sin_cos(angle);
        let along = |way: Vector| Vector::new(-way.y, way.x) * handle;
        for _ in 0..count {
            let next = Vector::new(way.x * cos - way.y * sin, way.x * sin + way.y * cos);
            outline.push(node, Piece::Cubic { leaving: along(way), arriving: along(next) });
            node = Node { point: self.center + next, smooth: true, kept: false };
            way = next;
        }
    }
}

/// The one of two places as far to both sides of a third that is nearer to a fourth.
fn nearer(middle: Point, reach: Vector, near: Point) -> Point {
    if dot(reach, near - middle) < 0.0 { middle - reach } else { middle + reach }
}

/// The solution of a symmetric system.
fn solved([xx, xy, yy]: [f64; 3], right: Vector) -> Option<Vector> {
    let determinant = xx * yy - xy * xy;
    let x = (yy * right.x - xy * right.y) / determinant;
    let y = (xx * right.y - xy * right.x) / determinant;
    (x.is_finite() && y.is_finite()).then_some(Vector::new(x, y))
}

impl Round {
    /// Less for longer arcs, and less than nothing.
    fn shortness(&self) -> f64 {
        -self.circle.radius * self.turning.abs()
    }

    /// The piece beside the arc at an end of it, and the far node of that.
    fn beside(&self, outline: &Outline, node: usize) -> (usize, usize) {
        let before = outline.before(node);
        if node == self.first { (before, before) } else { (node, outline.next(node)) }
    }

    /// Where the arc begins or ends, at a node of the outline.
    #[inline(never)]
    fn end(&self, outline: &Outline, node: usize) -> Point {
        let here = outline.nodes[node].point;
        let (other, far) = self.beside(outline, node);
        let from = outline.nodes[far].point;
        match (outline.is_line(other), outline.nodes[node].smooth) {
            (true, true) => self.circle.touched(from, here),
            (true, false) => self.circle.crossed(from, here),
            _ => self.circle.nearest(here),
        }
    }

    /// Whether that is near enough: also the control points of cubics that turn with the arc.
    #[inline(never)]
    fn reaches(&self, outline: &Outline, node: usize, most: f64) -> bool {
        let smooth = outline.nodes[node].smooth;
        if !smooth && is_gentle(outline, node) {
            // Hardly a corner, but who turns it a little makes it one.
            return false;
        }
        let here = outline.nodes[node].point;
        let end = self.end(outline, node);
        let (moved, out) = (end - here, end - self.circle.center);
        let (other, far) = self.beside(outline, node);
        if let Piece::Cubic { leaving, arriving } = outline.pieces[other] {
            let handle = if node == self.first { arriving } else { leaving };
            return norm(moved) <= most && (!smooth || dot(handle, unit(out)).abs() <= most);
        }
        let side = here - outline.nodes[far].point;
        let room = if smooth { SLIDE.min(ROOM * norm(side)) } else { most };
        cross(moved, unit(side)).abs() <= most && dot(moved, unit(side)).abs() <= room
    }
}

/// Moves the ends of an arc onto its circle.
fn meet(outline: &mut Outline, round: &Round) {
    for node in [round.first, (round.first + round.count) % outline.len()] {
        outline.nodes[node].point = round.end(outline, node);
    }
}

/// Puts arcs in place of their pieces, each found where its first piece is, the first of all at `start`; the angle of
/// each piece.
#[inline(never)]
fn rebuilt(outline: &mut Outline, found: &[Option<Round>], start: usize) -> Vec<f64> {
    found.iter().flatten().for_each(|round| turn_beside(outline, round));
    let mut new = Outline::default();
    let (mut angles, mut done) = (Vec::new(), 0);
    while done < outline.len() {
        let at = (start + done) % outline.len();
        let Some(Round { count, circle, turning, .. }) = found[at] else {
            new.push(outline.nodes[at], outline.pieces[at]);
            angles.push(0.0);
            done += 1;
            continue;
        };
        done += count;
        let [from, to] = [at, (at + count) % outline.len()].map(|i| outline.nodes[i].point - circle.center);
        let sign = turning.signum();
        let mut turning = sign * turn(from, to);
        if turning <= 0.0 {
            turning += core::f64::consts::TAU;
        }
        let parts = if turning > WIDEST { 2 } else { 1 };
        let angle = turning / parts as f64;
        circle.follow(&mut new, outline.nodes[at], from, (sign * angle, parts), sign * angle / 3.0);
        angles.resize(new.len(), angle);
    }
    *outline = new;
    angles
}

/// Turns cubics beside an arc with its ends.
fn turn_beside(outline: &mut Outline, round: &Round) {
    for node in [round.first, (round.first + round.count) % outline.len()] {
        let out = (outline.nodes[node].point - round.circle.center) * round.turning.signum();
        let along = unit(Vector::new(-out.y, out.x));
        let (other, _) = round.beside(outline, node);
        if outline.nodes[node].smooth
            && let Piece::Cubic { leaving, arriving } = &mut outline.pieces[other]
        {
            let handle = if node == round.first { arriving } else { leaving };
            *handle = along * norm(*handle);
        }
    }
}
