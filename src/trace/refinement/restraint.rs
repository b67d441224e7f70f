//! Outlines that went astray are led back: a picture of more than two tones draws them to where they explain nothing.

use super::Refinement;
use super::coverage::{Part, pieces};
use super::field::Field;
use super::left::Left;
use super::refine::{Refiner, Shape};
use super::settling::turning;
use super::trial::Limits;
use super::window::{Stretch, Window};
use crate::numerics::Point;
use crate::numerics::plane::{larger, norm, square, taxi};
use crate::trace::outline::cubic::Cubic;
use crate::trace::outline::{Node, Outline, Piece};

/// Places of a piece that are looked at, for each pixel of its length, and at most.
const LOOKS: f64 = 4.0;
const MOST_LOOKS: f64 = 65_536.0;
/// The way back may be twice as long as the way that is left, and so much longer, in pixels; else it leads round the
/// other side.
const DETOUR: f64 = 4.0;
/// An outline with more than this share of its pieces astray is given up as a whole.
const MOST: f64 = 0.4;
/// The way back begins and ends so near to the run, in pixels.
const FARTHEST: f64 = 3.0;
/// Pieces of the way back are at least so long, in pixels.
const SHORTEST: f64 = 0.1;
/// The way back may leave so many times as much of the squares, and so much more: a tip that was drawn leaves ten times
/// as much without it.
const WORSE: f64 = 1.5;
const LITTLE: f64 = 0.02;
/// The way back may leave so many times as much of the squares where nothing is explained.
const NO_MATTER: f64 = 6.0;
/// Nothing is explained near the contour, too, where so many pixels say it: there the way back has to turn less, by so
/// many radians, and may leave so many times as much.
const PIXELS: f64 = 4.0;
const CALMER: f64 = 0.35;
const HARDLY_MATTERS: f64 = 3.0;

/// Pieces in a row that are far from where they began, or explain nothing there.
#[derive(Clone, Copy, Debug)]
struct Run {
    at: usize,
    count: usize,
    far: bool,
}

/// A way along the first outline, between two places of another one.
struct Way {
    between: Vec<Node>,
    pieces: Vec<Piece>,
}

impl Refinement {
    /// Leads the outline back to what it was at first where it is far from its contour and explains no more by that, or
    /// where it turns to and fro though it explains nothing.
    ///
    /// # Cost
    ///
    /// O(length of the outline), and O(length of the first outline) for every run that is led back.
    pub(super) fn restrain(&mut self) {
        let at = self.place.at;
        let nothing = self.picture.nothing(self.noise);
        let (shape, first) = (&mut self.shapes[at], &self.first[at]);
        let mut back =
            Back { refiner: &mut self.refiner, field: &mut self.field, limits: &self.limits, nothing };
        let (runs, all) = (back.astray(shape), shape.outline.len());
        let (mut shift, whole) = (0, Run { at: 0, count: all, far: runs.iter().any(|run| run.far) });
        let count: usize = runs.iter().map(|run| run.count).sum();
        let mut lost = count as f64 > MOST * all as f64;
        for run in runs {
            if lost {
                break;
            }
            let led = back.lead(shape, first, Run { at: run.at - shift, ..run });
            (shift, lost) = (shift + led.unwrap_or(0), led.is_none());
        }
        if lost {
            back.start_again(shape, first, Run { count: shape.outline.len(), ..whole });
        }
        if !shape.outline.encloses(first.area(), self.share) {
            back.refiner.replace(back.field, shape, first.clone());
        }
    }
}

/// What leads back, and what has to hold.
struct Back<'a> {
    refiner: &'a mut Refiner,
    field: &'a mut Field,
    limits: &'a Limits,
    nothing: [f64; 2],
}

impl Back<'_> {
    /// The runs of an outline that are to be looked at, the last one first.
    fn astray(&self, shape: &Shape) -> Vec<Run> {
        let (outline, all) = (&shape.outline, shape.outline.len());
        let far: Vec<bool> = (0..all).map(|i| is_far(&outline.cubic(i), self.field)).collect();
        let is_astray = |i: usize| far[i] || self.explains_nothing(&shape.parts[i]);
        let astray: Vec<bool> = (0..all).map(is_astray).collect();
        let run = |at: usize| {
            let count = (0..all).take_while(|k| astray[(at + k) % all]).count();
            Run { at, count, far: (0..count).any(|k| far[(at + k) % all]) }
        };
        if !astray.contains(&false) {
            return vec![run(0)];
        }
        (0..all).rev().filter(|&i| astray[i] && !astray[outline.before(i)]).map(run).collect()
    }

    /// Whether a piece explains nothing, though it is where the contour is.
    fn explains_nothing(&self, parts: &[Part]) -> bool {
        let mut left = Left::default();
        left.add(parts, self.field);
        left.count >= PIXELS && left.rms() > self.nothing[1]
    }

    /// Puts the way that the first outline takes in the place of a run, if that is better. By how much that makes the
    /// numbers of the pieces before it smaller.
    fn lead(&mut self, shape: &mut Shape, first: &Outline, run: Run) -> Option<usize> {
        let (outline, all) = (&shape.outline, shape.outline.len());
        let ends = [outline.nodes[run.at].point, outline.nodes[(run.at + run.count) % all].point];
        let way = way_back(first, ends)?;
        let back = way.outline(ends);
        let length = |outline: &Outline, i: usize| looks(&outline.cubic(i)) as f64 / LOOKS;
        let long: f64 = (0..run.count).map(|k| length(outline, (run.at + k) % all)).sum();
        let count = way.pieces.len();
        if !run.far && turning(&back, 0, count) + CALMER > turning(outline, run.at, run.count) {
            return Some(0);
        }
        if (0..count).map(|i| length(&back, i)).sum::<f64>() > 2.0 * long + DETOUR {
            return None;
        }
        let (lists, before, own) = self.compare(shape, &back, (run, count));
        let returns = (0..count).all(|i| !is_far(&back.cubic(i), self.field));
        let Way { between, pieces } = way;
        let stretch = Stretch { first: run.at, count: run.count, pieces, between };
        let mut window = Window::open(self.refiner, self.field, shape, stretch);
        if !self.is_better(&Left::of(&lists, self.field), (&before, &own), run, returns) {
            window.close(self.refiner, self.field);
            return Some(0);
        }
        for node in [0, window.fresh] {
            (window.shape.outline.nodes[node].smooth, window.shape.outline.nodes[node].kept) = (false, false);
        }
        Some(run.at - window.keep(self.field, shape))
    }

    /// Puts the first outline in the place of one that is astray everywhere, if that is better.
    fn start_again(&mut self, shape: &mut Shape, first: &Outline, run: Run) {
        let (lists, before, own) = self.compare(shape, first, (run, first.len()));
        let returns = (0..first.len()).all(|i| !is_far(&first.cubic(i), self.field));
        let calmer = turning(first, 0, first.len()) + CALMER < turning(&shape.outline, 0, run.count);
        if !run.far && !calmer {
            return;
        }
        let old = shape.outline.clone();
        self.refiner.replace(self.field, shape, first.clone());
        if !self.is_better(&Left::of(&lists, self.field), (&before, &own), run, returns) {
            self.refiner.replace(self.field, shape, old);
        }
    }

    /// The pixels of a run and of the first pieces of the way back, what is left in them, and in those of the run.
    fn compare(
        &self,
        shape: &Shape,
        back: &Outline,
        (run, count): (Run, usize),
    ) -> (Vec<Vec<Part>>, Left, Left) {
        let all = shape.outline.len();
        let mut lists: Vec<Vec<Part>> =
            (0..run.count).map(|k| shape.parts[(run.at + k) % all].clone()).collect();
        let own = Left::of(&lists, self.field);
        lists.extend(pieces(back, count, self.field));
        let before = Left::of(&lists, self.field);
        (lists, before, own)
    }

    /// Whether the way back, which returns to the contour or not, explains the picture well enough.
    fn is_better(&self, now: &Left, (before, own): (&Left, &Left), run: Run, returns: bool) -> bool {
        if !run.far {
            return now.square <= HARDLY_MATTERS * before.square;
        }
        if own.rms() > self.nothing[0] {
            return now.square <= NO_MATTER * before.square;
        }
        let noise = self.limits.share * self.limits.noise * self.limits.noise;
        let more = if self.limits.noise > 0.0 { noise } else { (WORSE - 1.0) * before.square + LITTLE };
        returns && now.square <= before.square + more
    }
}

/// Whether a piece has places that are far from all contours.
fn is_far(cubic: &Cubic, field: &Field) -> bool {
    let steps = looks(cubic);
    (0..=steps).any(|k| !field.is_near(cubic.point(k as f64 / steps as f64)))
}

/// At how many places a piece is looked at.
fn looks(cubic: &Cubic) -> usize {
    (LOOKS * cubic.taxi_length()).ceil().clamp(2.0, MOST_LOOKS) as usize
}

/// The way along an outline between the places of it that are nearest to two points; straight where both are the same,
/// or the wrong way round.
fn way_back(outline: &Outline, ends: [Point; 2]) -> Option<Way> {
    let [(from, s, off), (to, t, other)] = ends.map(|end| nearest(outline, end));
    if larger(off, other) > FARTHEST {
        return None;
    }
    let mut way = Way { between: Vec::new(), pieces: Vec::new() };
    let near = norm(outline.cubic(to).point(t) - outline.cubic(from).point(s)) < DETOUR;
    let mut piece = from;
    for step in 0..=outline.len() {
        let last = piece == to && (step > 0 || s < t);
        if step == 0 && from == to && !last && near {
            break;
        }
        let range = [if step == 0 { s } else { 0.0 }, if last { t } else { 1.0 }];
        way.push(outline, piece, range);
        if last {
            break;
        }
        piece = outline.next(piece);
    }
    if way.pieces.is_empty() {
        way.pieces.push(Piece::Line);
    }
    Some(way)
}

impl Way {
    /// Appends a part of a piece, unless it is next to nothing, and the node before it.
    fn push(&mut self, outline: &Outline, piece: usize, [from, to]: [f64; 2]) {
        let Cubic { start, leaving, arriving, end } = outline.cubic(piece).part(from, to);
        if taxi(end - start) < SHORTEST {
            return;
        }
        if !self.pieces.is_empty() {
            self.between.push(Node { kept: false, ..outline.nodes[piece] });
        }
        let line = outline.is_line(piece);
        self.pieces.push(if line { Piece::Line } else { Piece::Cubic { leaving, arriving } });
    }

    /// It from one point to another, and straight back.
    fn outline(&self, [from, to]: [Point; 2]) -> Outline {
        let end = |point| Node { point, smooth: false, kept: false };
        let mut outline = Outline { nodes: vec![end(from)], pieces: self.pieces.clone() };
        outline.nodes.extend_from_slice(&self.between);
        outline.push(end(to), Piece::Line);
        outline
    }
}

/// The piece of an outline and the parameter whose place is nearest to a point, to an eighth of a pixel.
fn nearest(outline: &Outline, point: Point) -> (usize, f64, f64) {
    let (mut best, mut least) = ((0, 0.0), f64::MAX);
    for i in 0..outline.len() {
        let cubic = outline.cubic(i);
        let steps = looks(&cubic);
        // No place of it is farther from its start than it is long.
        if norm(cubic.start - point) > least.sqrt() + (steps + 1) as f64 / LOOKS {
            continue;
        }
        for k in 0..=steps {
            let t = k as f64 / steps as f64;
            let off = square(cubic.point(t) - point);
            if off < least {
                (best, least) = ((i, t), off);
            }
        }
    }
    (best.0, best.1, least.sqrt())
}
