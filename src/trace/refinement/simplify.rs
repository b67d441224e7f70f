//! Fewer pieces: joints that the picture does not ask for are taken away.

use super::left::Left;
use super::refine::{NOISY_SHARE, Shape};
use super::trial::{Limits, Trial};
use super::window::{Stretch, Window};
use crate::error::Result;
use crate::numerics::order::sort_by_number;
use crate::numerics::plane::{dot, norm};
use crate::trace::outline::cubic::{Cubic, Tangent};
use crate::trace::outline::{Outline, Piece};
use crate::trace::samples::{turn, unit};

/// A piece beside a longer straight one that turns by no more, in radians, may be merged with it; beside one shorter
/// than this any piece may.
const STUB: f64 = 0.25;
const LONG: f64 = 16.0;
/// A joint that is not smooth may go where the outline turns there by no more, in radians; between two lines it has to
/// turn by less for them to be one.
const CORNER: f64 = 0.2;
const ONE_LINE: f64 = 0.1;
/// One piece does not take the place of two that turn by more together, in radians.
const MOST_TURNING: f64 = 2.6;
/// Rounds of merging.
const MOST_ROUNDS: usize = 12;
/// Joints that are looked at in one step.
const NODES: usize = 2048;
/// Steps of refinement after which a merged piece is looked at, and after which it has to be good.
const FIRST_STEPS: usize = 2;
const LAST_STEPS: usize = 6;
/// The share of what is left that a step has to take away for another.
const ENOUGH: f64 = 0.01;
/// A merged piece that crosses more pixels than this may leave more in each, in proportion, but at most so many times
/// as much: over a long way a joint is more than a fiftieth of a pixel.
const LONG_WAY: f64 = 100.0;
const MOST_EASE: f64 = 2.0;
/// Joints that slid past each other hide their own cost: what takes their place may be so many times as far, and leave
/// so many times as much.
const SLID: f64 = 3.0;
/// A merged piece that leaves so many times as much as it may will not get good.
const HOPELESS: f64 = 3.0;
/// How many times as much as usual may be left where the two were: what neither lacked the new piece may no longer
/// cross, a notch that it passes by.
const PASSED: f64 = 4.0;

/// A round of taking joints away, one by one, while the picture stays as well explained as `limits` say. Only what is
/// next to a joint moves.
#[derive(Debug)]
pub(super) struct Merging {
    /// How many joints have been looked at.
    looked: usize,
    /// Joints and how far what would take the place of their pieces is from them; the nearest first.
    candidates: Vec<(usize, f64)>,
    at: usize,
    /// Nodes keep their names while others go.
    names: Vec<usize>,
    moved: Vec<bool>,
    /// Whether anything was taken away: then there may be more.
    pub(super) any: bool,
}

impl Merging {
    /// Begins; no joint has been looked at.
    pub(super) fn new(outline: &Outline) -> Self {
        let count = outline.len();
        let names = (0..count).collect();
        Self { looked: 0, candidates: Vec::new(), at: 0, names, moved: vec![false; count], any: false }
    }

    /// Looks for joints that may go, some nodes at a time; whether there were any to look at.
    fn look(&mut self, outline: &Outline, limits: &Limits) -> bool {
        let count = self.moved.len();
        if self.looked == count {
            return false;
        }
        let end = (self.looked + NODES).min(count);
        for i in self.looked..end {
            if let Some((_, off)) = candidate(outline, i, limits) {
                self.candidates.push((i, off));
            }
        }
        self.looked = end;
        if end == count {
            sort_by_number(&mut self.candidates, &|one| one.1);
        }
        true
    }

    /// Looks at some joints or, when all have been looked at, tries the next; whether there was one.
    ///
    /// # Cost
    ///
    /// O(length of the pieces beside the joint), and O(nodes of the outline) where one goes.
    pub(super) fn step(&mut self, trial: &mut Trial) -> Result<bool> {
        if self.look(&trial.shape.outline, trial.limits) {
            return Ok(true);
        }
        while let Some(&(name, _)) = self.candidates.get(self.at) {
            self.at += 1;
            let Ok(i) = self.names.binary_search(&name) else { continue };
            let outline = &trial.shape.outline;
            let around = [outline.before(i), i, outline.next(i)];
            if around.iter().any(|&j| self.moved[self.names[j]]) {
                continue;
            }
            let Some((piece, _)) = candidate(outline, i, trial.limits) else { continue };
            if trial.merge(i, piece)? {
                self.any = true;
                around.iter().for_each(|&j| self.moved[self.names[j]] = true);
                self.names.remove(i);
            } else {
                trial.shape.outline.nodes[i].kept = true;
            }
            return Ok(true);
        }
        Ok(false)
    }
}

/// Whether there may be another round.
pub(super) fn may_go_on(round: usize) -> bool {
    round < MOST_ROUNDS
}

impl Trial<'_> {
    /// Merges the pieces at node i; if that is not good, all is as it was. Whether it was good.
    fn merge(&mut self, i: usize, piece: Piece) -> Result<bool> {
        let before = self.shape.outline.before(i);
        let forced = stunted(&self.shape.outline, before) || stunted(&self.shape.outline, i);
        let left = self.beside(i);
        let stretch = Stretch { first: before, count: 2, pieces: vec![piece], between: Vec::new() };
        let mut window = Window::open(self.refiner, self.field, self.shape, stretch);
        let good = self.settles(&mut window.shape, &left, forced)?
            && self.limits.allow(&self.beside(i), &left, PASSED);
        if good {
            for node in 0..2 {
                // What is longer now may grow further.
                window.shape.outline.nodes[node].kept = false;
            }
            window.keep(self.field, self.shape);
        } else {
            window.close(self.refiner, self.field);
        }
        Ok(good)
    }

    /// What is left where the pieces at node i are, or were.
    fn beside(&self, i: usize) -> Left {
        let mut left = Left::default();
        for piece in [self.shape.outline.before(i), i] {
            left.add(&self.shape.parts[piece], self.field);
        }
        left
    }

    /// Refines the merged piece, the first of some; whether it explains the picture as well as the two did.
    fn settles(&mut self, shape: &mut Shape, before: &Left, forced: bool) -> Result<bool> {
        let clean = self.limits.noise == 0.0;
        let enough = if clean { ENOUGH } else { NOISY_SHARE };
        let ease = if forced { SLID } else { 1.0 };
        let mut steps = 0;
        loop {
            self.refiner.refine(self.field, shape, &[0, 1], (FIRST_STEPS, enough))?;
            steps += FIRST_STEPS;
            let mut now = Left::default();
            now.add(&shape.parts[0], self.field);
            let long = if clean { (now.count / LONG_WAY).clamp(1.0, MOST_EASE) } else { 1.0 };
            if self.limits.allow(&now, before, ease * long) {
                return Ok(true);
            }
            let hopeless = clean && !forced && now.rms() > HOPELESS * long * self.limits.rms;
            if hopeless || steps >= LAST_STEPS {
                return Ok(false);
            }
        }
    }
}

/// Whether a piece runs against its own tangents: its joints slid past each other, or it is more than half a turn,
/// which may not be all that there was to be said by one piece.
fn stunted(outline: &Outline, i: usize) -> bool {
    let Cubic { start, leaving, arriving, end } = outline.cubic(i);
    let chord = end - start;
    let smooth = outline.nodes[i].smooth && outline.nodes[outline.next(i)].smooth;
    smooth && dot(chord, leaving) < 0.0 && dot(chord, arriving) < 0.0
}

/// Whether a piece goes back on its way: its control points are past each other, far beyond its ends.
fn folded(outline: &Outline, i: usize) -> bool {
    let cubic = outline.cubic(i);
    dot(cubic.velocity(0.5), cubic.end - cubic.start) < 0.0
}

/// How much two pieces turn together, from tangents at their ends and in their middles.
fn turning(first: &Cubic, second: &Cubic) -> f64 {
    turn(unit(first.velocity(0.0)), unit(first.velocity(0.5))).abs()
        + turn(unit(first.velocity(0.5)), unit(second.velocity(0.5))).abs()
        + turn(unit(second.velocity(0.5)), unit(second.velocity(1.0))).abs()
}

/// Whether joint i is between a side and a shorter bend: what is mostly straight stays so, unless the rest is a stub or
/// leads to a corner.
fn ends_a_side(outline: &Outline, i: usize, limits: &Limits) -> bool {
    let before = outline.before(i);
    let (first, second) = (outline.cubic(before), outline.cubic(i));
    let lengths = [norm(first.end - first.start), norm(second.end - second.start)];
    let side = usize::from(outline.is_line(i));
    if outline.is_line(before) == outline.is_line(i) || lengths[side] <= lengths[1 - side].max(LONG) {
        return false;
    }
    let (bend, far) = if side == 1 { (&first, before) } else { (&second, outline.next(i)) };
    let middle = bend.velocity(0.5);
    let turned = turn(bend.velocity(0.0), middle).abs() + turn(middle, bend.velocity(1.0)).abs();
    turned > STUB && outline.nodes[far].smooth && (limits.noise == 0.0 || limits.grain > 0.0)
}

/// The piece in place of the two at joint i, and how far it is from them.
fn candidate(outline: &Outline, i: usize, limits: &Limits) -> Option<(Piece, f64)> {
    let node = outline.nodes[i];
    let before = outline.before(i);
    let wrong = |piece: usize| stunted(outline, piece) || folded(outline, piece);
    let stunted = node.smooth && (wrong(before) || wrong(i));
    if (node.kept && !stunted) || outline.len() <= 2 {
        return None;
    }
    let (first, second) = (outline.cubic(before), outline.cubic(i));
    let bend = turn(first.velocity(1.0), second.velocity(0.0)).abs();
    if !node.smooth && bend > CORNER {
        return None;
    }
    if turning(&first, &second) > MOST_TURNING && !stunted {
        return None;
    }
    let mut places = [node.point; 32];
    for (k, place) in places.iter_mut().enumerate() {
        let cubic = if k < 16 { &first } else { &second };
        *place = cubic.point(((k % 16) as f64 + 0.5) / 16.0);
    }
    let tangent = |at: usize, line: bool, direction| {
        if outline.nodes[at].smooth && !line { Tangent::Along(unit(direction)) } else { Tangent::Free }
    };
    if ends_a_side(outline, i, limits) {
        return None;
    }
    if outline.is_line(before) && outline.is_line(i) {
        let fitted = Cubic::fit(first.start, second.end, &places, [Tangent::Free; 2]);
        return (bend < ONE_LINE).then_some((Piece::Line, fitted.rms));
    }
    let tangents = [
        tangent(before, outline.is_line(before), first.velocity(0.0)),
        tangent(outline.next(i), outline.is_line(i), second.velocity(1.0)),
    ];
    let fitted = Cubic::fit(first.start, second.end, &places, tangents);
    let Cubic { leaving, arriving, .. } = fitted.cubic;
    let ease = if stunted { SLID } else { 1.0 };
    (fitted.rms < ease * limits.off).then_some((Piece::Cubic { leaving, arriving }, fitted.rms))
}

#[cfg(test)]
mod tests {
    use super::Merging;
    use crate::curve::Curve;
    use crate::numerics::{Point, Vector};
    use crate::trace::outline::{Node, Outline, Piece};
    use crate::trace::refinement::field::{Field, Shading};
    use crate::trace::refinement::refine::{Refiner, Relaxing, Shape};
    use crate::trace::refinement::trial::{Limits, Trial};
    use crate::trace::{Gray, contours};
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    const SIDE: usize = 64;

    /// An oval of quadratics that is no ellipse: where each ends, after its control point; the first begins where the
    /// last ends.
    const OVAL: [[f64; 4]; 10] = [
        [40.563, 15.401, 38.164, 12.451],
        [35.766, 9.501, 31.976, 9.501],
        [28.33, 9.501, 25.476, 11.827],
        [22.621, 14.154, 21.038, 18.232],
        [19.455, 22.31, 19.455, 27.491],
        [19.455, 33.199, 21.854, 36.15],
        [24.252, 39.1, 28.042, 39.1],
        [31.784, 39.1, 34.639, 36.797],
        [37.493, 34.495, 39.028, 30.393],
        [40.563, 26.291, 40.563, 21.11],
    ];

    /// Coverage of a pixel by the oval, by four rows of sixteen samples.
    fn coverage(chords: &[Point], column: usize, row: usize) -> f64 {
        let inside = |x: f64, y: f64| {
            let next = chords.iter().cycle().skip(1);
            let crosses = |a: &Point, b: &Point| {
                (a.y > y) != (b.y > y) && x < a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x)
            };
            chords.iter().zip(next).filter(|(a, b)| crosses(a, b)).count() % 2 == 1
        };
        let at = |pixel: usize, k: usize, count: usize| pixel as f64 + (k as f64 + 0.5) / count as f64;
        (0..64).filter(|k| inside(at(column, k % 16, 16), at(row, k / 16, 4))).count() as f64 / 64.0
    }

    /// The oval by two pieces, each of which is a little more than half a turn, and a short one between them, which has
    /// been tried.
    fn outline() -> Outline {
        let node = |x: f64, y: f64, kept: bool| Node { point: Point::new(x, y), smooth: true, kept };
        let piece = |leaving: (f64, f64), arriving: (f64, f64)| Piece::Cubic {
            leaving: Vector::new(leaving.0, leaving.1),
            arriving: Vector::new(arriving.0, arriving.1),
        };
        Outline {
            nodes: vec![
                node(19.850_805_5, 22.912_045_8, true),
                node(40.221_363_8, 25.912_024_1, false),
                node(19.776_336_2, 23.652_730_8, false),
            ],
            pieces: vec![
                piece((2.017_080_8, -17.393_838_8), (-3.537_860_2, 22.635_278_1)),
                piece((-2.856_368_4, 18.275_084_6), (3.396_208_5, -19.947_595_9)),
                piece((0.017_995_4, -0.105_696_0), (0.015_293_0, -0.131_875_3)),
            ],
        }
    }

    /// An outline after a round of merging, against the picture of the oval.
    fn merged(outline: Outline) -> Outline {
        let (mut chords, mut from) = (Vec::new(), Point::new(40.563, 21.11));
        for [x, y, to_x, to_y] in OVAL {
            let (control, to) = (Point::new(x, y), Point::new(to_x, to_y));
            chords.extend((0..32).map(|k| {
                let t = f64::from(k) / 32.0;
                (from * (1.0 - t) + control * t) * (1.0 - t) + (control * (1.0 - t) + to * t) * t
            }));
            from = to;
        }
        let shade = |i: usize| (255.0 - 255.0 * coverage(&chords, i % SIDE, i / SIDE)).round() as u8;
        let bytes: Vec<u8> = (0..SIDE * SIDE).map(shade).collect();
        let gray = Gray::from_bytes(SIDE, SIDE, &bytes).expect("a picture");
        let found = contours(&gray, 32_640.0, false, 2.0).expect("a contour");
        let shading = Shading { ink: 0.0, paper: 65_280.0, level: 32_640.0, inverted: false };
        let points = found.iter().map(|contour| contour.points.as_slice());
        let mut field = Field::new(&gray, &shading, points, 2.5).expect("room");
        let (mut refiner, mut shape) = (Refiner::new(Relaxing::CAREFUL), Shape::new(outline));
        let all = shape.outline.len();
        refiner.show(&field, &mut shape, 0..all);
        refiner.sweep.cover(&mut field);
        let limits = Limits { rms: 0.012, most: 0.055, off: 0.4, noise: 0.0492, share: 12.0, grain: 0.0283 };
        let mut merging = Merging::new(&shape.outline);
        let trial =
            &mut Trial { refiner: &mut refiner, field: &mut field, shape: &mut shape, limits: &limits };
        while merging.step(trial).expect("numbers") {}
        shape.outline
    }

    #[test]
    fn what_takes_the_place_of_two_pieces_stays_near_them_even_where_joints_slid_past_each_other() {
        let before = outline();
        let area = |outline: &Outline| {
            outline.to_curve(vec![0.0; outline.len()]).and_then(|curve| curve.area()).expect("it is closed")
        };
        let after = merged(before.clone());
        assert!((area(&after) / area(&before) - 1.0).abs() < 0.01, "{after:?}");
    }
}
