//! Outlines moved until the coverage that they have is the coverage that the picture shows.

use super::coverage::{Part, Sweep, parts};
use super::cubic::Cubic;
use super::field::{Field, NONE};
use super::outline::Outline;
use super::skyline::Skyline;
use super::unknowns::{Column, Unknowns};
use crate::error::Result;
use crate::limits::filled;
use crate::numerics::plane::larger;

/// Weight of staying where it is, in coverage per pixel, squared.
const DAMPING: f64 = 5e-3;
/// How damping falls: after a good step by `factor`, and never below `least`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Relaxing {
    factor: f64,
    least: f64,
}

impl Relaxing {
    /// Where the picture is of exact coverage, the nearer the better.
    pub(super) const BOLD: Self = Self { factor: 0.25, least: 1e-4 };
    /// Where it is not, long steps follow what is noise.
    pub(super) const CAREFUL: Self = Self { factor: 0.5, least: 1e-3 };
}

/// The square of what a byte leaves of coverage, with a little more: 1/255 over √12 is 0.0011.
const ROUNDING: f64 = 2e-6;
/// Nothing moves farther in one step, in pixels.
const LONGEST_STEP: f64 = 0.6;
/// How much of a pixel's side an outline crosses, in the mean by length: between 0.94 and 1 for straight ones.
const CROSSING: f64 = 0.95;
/// The share of what is left that a step has to take away for another where most of it is noise.
pub(super) const NOISY_SHARE: f64 = 5e-4;
/// The share of what bytes round that a step has to promise.
const WORTH: f64 = 0.3;
/// A step is tried if the equations promise this share of what would be enough: they know what they promise to a third or so.
const PROMISE: f64 = 0.5;
/// Gauss's rule for polynomials of degree 9 on [0, 1]: places and weights.
const RULE: [[f64; 2]; 5] = [
    [0.046_910_077_030_668, 0.118_463_442_528_095],
    [0.230_765_344_947_158, 0.239_314_335_249_683],
    [0.5, 0.284_444_444_444_444],
    [0.769_234_655_052_842, 0.239_314_335_249_683],
    [0.953_089_922_969_332, 0.118_463_442_528_095],
];
/// Products of two of Bernstein's polynomials at the rule's places, with their weights.
const PRODUCTS: [[f64; 10]; 5] = {
    let mut products = [[0.0; 10]; 5];
    let mut at = 0;
    while at < RULE.len() {
        let b = Cubic::bernstein(RULE[at][0]);
        let (mut i, mut pair) = (0, 0);
        while i < 4 {
            let mut j = 0;
            while j <= i {
                products[at][pair] = RULE[at][1] * b[i] * b[j];
                (j, pair) = (j + 1, pair + 1);
            }
            i += 1;
        }
        at += 1;
    }
    products
};

/// Places of a piece that are looked at to know whether it leaves the picture.
const LOOKS: u8 = 16;

/// An outline and the parts of its pieces, which the field knows.
#[derive(Debug)]
pub(super) struct Shape {
    pub(super) outline: Outline,
    pub(super) parts: Vec<Vec<Part>>,
}

/// What is left of the picture in the pixels of some pieces.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Left {
    pub(super) square: f64,
    pub(super) count: f64,
    pub(super) most: f64,
}

impl Left {
    pub(super) fn add(&mut self, parts: &[Part], field: &Field) {
        self.add_some(parts.iter(), field);
    }

    /// Only some parts.
    pub(super) fn add_some<'a>(&mut self, parts: impl Iterator<Item = &'a Part>, field: &Field) {
        let mut last = NONE;
        for part in parts {
            if part.pixel == last || part.pixel == NONE {
                continue;
            }
            last = part.pixel;
            self.see(field.rest[last as usize]);
        }
    }

    pub(super) fn join(&mut self, other: &Self) {
        self.square += other.square;
        self.count += other.count;
        self.most = larger(self.most, other.most);
    }

    /// One pixel more.
    fn see(&mut self, rest: f32) {
        let value = f64::from(rest).abs();
        self.square += value * value;
        self.count += 1.0;
        self.most = larger(self.most, value);
    }

    pub(super) fn rms(&self) -> f64 {
        (self.square / self.count.max(1.0)).sqrt()
    }
}

impl Shape {
    /// The outline, not yet in the field.
    pub(super) fn new(outline: Outline, field: &Field) -> Self {
        let mut shape = Self { parts: Vec::new(), outline };
        shape.walk(field);
        shape
    }

    fn walk(&mut self, field: &Field) {
        self.parts.resize(self.outline.len(), Vec::new());
        for (i, own) in self.parts.iter_mut().enumerate() {
            parts(&self.outline.cubic(i), field, own);
        }
    }

    /// The same outline from another node on.
    pub(super) fn begin_at(&mut self, first: usize) {
        self.outline.nodes.rotate_left(first);
        self.outline.pieces.rotate_left(first);
        self.parts.rotate_left(first);
    }

    /// All nodes, from both ends of the list in turn: what is near around the outline is near in the list.
    pub(super) fn nodes(&self) -> Vec<usize> {
        let count = self.outline.len();
        (0..count).map(|step| if step % 2 == 0 { step / 2 } else { count - 1 - step / 2 }).collect()
    }

    pub(super) fn left(&self, field: &Field) -> Left {
        let mut left = Left::default();
        self.parts.iter().for_each(|parts| left.add(parts, field));
        left
    }
}

/// Room for one step after another.
#[derive(Debug)]
pub(super) struct Refiner {
    relaxing: Relaxing,
    pub(super) sweep: Sweep,
    unknowns: Unknowns,
    pieces: Vec<usize>,
    columns: Vec<Column>,
    ends: Vec<usize>,
    fresh: Vec<Vec<Part>>,
}

impl Refiner {
    pub(super) fn new(relaxing: Relaxing) -> Self {
        Self {
            relaxing,
            sweep: Sweep::default(),
            unknowns: Unknowns::default(),
            pieces: Vec::new(),
            columns: Vec::new(),
            ends: Vec::new(),
            fresh: Vec::new(),
        }
    }

    /// Puts a shape into the field.
    pub(super) fn show(&mut self, field: &mut Field, shape: &Shape) {
        shape.parts.iter().for_each(|parts| self.sweep.note(field, parts, 1.0));
        self.sweep.cover(field);
    }

    /// Replaces an outline by another.
    pub(super) fn replace(&mut self, field: &mut Field, shape: &mut Shape, outline: Outline) {
        shape.parts.iter().for_each(|parts| self.sweep.note(field, parts, -1.0));
        shape.outline = outline;
        shape.walk(field);
        self.show(field, shape);
        field.settle();
    }

    /// Moves nodes by at most so many steps, until a step takes no more than the share `enough` of what is left, or nothing but what bytes round.
    ///
    /// # Cost
    ///
    /// O(length of the pieces beside the nodes) for each step.
    pub(super) fn refine(
        &mut self,
        field: &mut Field,
        shape: &mut Shape,
        nodes: &[usize],
        (most, enough): (usize, f64),
    ) -> Result<()> {
        let mut damping = DAMPING;
        for _ in 0..most {
            let Some((left, growth)) = self.step(field, shape, nodes, (damping, enough))? else { break };
            if growth < 0.0 {
                damping = (self.relaxing.factor * damping).max(self.relaxing.least);
                if -growth < enough * left.square || left.square + growth < ROUNDING * left.count {
                    break;
                }
            } else {
                damping *= 8.0;
                if damping > 1e3 * DAMPING {
                    break;
                }
            }
        }
        Ok(())
    }

    /// One step: what was left before it and how much it has grown; if it would grow, nothing moves. `None` where no step promises
    /// enough to be tried.
    fn step(
        &mut self,
        field: &mut Field,
        shape: &mut Shape,
        nodes: &[usize],
        (damping, enough): (f64, f64),
    ) -> Result<Option<(Left, f64)>> {
        self.unknowns.number(&shape.outline, nodes);
        self.unknowns.pieces(&shape.outline, &mut self.pieces);
        let (step, left, promised) = self.solve(field, shape, damping)?;
        let noise = ROUNDING * left.count;
        if promised < larger(PROMISE * enough * left.square, WORTH * noise) || left.square < noise {
            return Ok(None);
        }
        let saved = self.save(&shape.outline);
        self.unknowns.apply(&mut shape.outline, &step, LONGEST_STEP);
        if self.pieces.iter().any(|&i| leaves(&shape.outline.cubic(i), field)) {
            self.restore(&mut shape.outline, &saved);
            return Ok(Some((left, f64::INFINITY)));
        }
        self.fresh.resize(self.pieces.len().max(self.fresh.len()), Vec::new());
        for (&i, fresh) in self.pieces.iter().zip(&mut self.fresh) {
            parts(&shape.outline.cubic(i), field, fresh);
            self.sweep.note(field, &shape.parts[i], -1.0);
            self.sweep.note(field, fresh, 1.0);
        }
        let growth = self.sweep.cover(field) + field.settle();
        if growth < 0.0 {
            for (&i, fresh) in self.pieces.iter().zip(&mut self.fresh) {
                core::mem::swap(&mut shape.parts[i], fresh);
            }
        } else {
            for (&i, fresh) in self.pieces.iter().zip(&self.fresh) {
                self.sweep.note(field, fresh, -1.0);
                self.sweep.note(field, &shape.parts[i], 1.0);
            }
            self.sweep.cover(field);
            field.settle();
            self.restore(&mut shape.outline, &saved);
        }
        Ok(Some((left, growth)))
    }

    fn save(&self, outline: &Outline) -> Outline {
        // Ends of touched pieces are all that moves.
        let nodes = self.pieces.iter().map(|&i| outline.nodes[i]).collect();
        let mut saved = Outline { nodes, pieces: self.pieces.iter().map(|&i| outline.pieces[i]).collect() };
        saved.nodes.extend(self.pieces.iter().map(|&i| outline.nodes[outline.next(i)]));
        saved
    }

    fn restore(&self, outline: &mut Outline, saved: &Outline) {
        let count = self.pieces.len();
        for (k, &i) in self.pieces.iter().enumerate() {
            let next = outline.next(i);
            outline.nodes[i] = saved.nodes[k];
            outline.nodes[next] = saved.nodes[count + k];
            outline.pieces[i] = saved.pieces[k];
        }
    }

    /// The step of the unknowns that the residuals ask for (D 14.4), what is left, and by how much the step promises to make that less.
    fn solve(&mut self, field: &Field, shape: &Shape, damping: f64) -> Result<(Vec<f64>, Left, f64)> {
        let count = self.unknowns.end;
        let mut scales = filled(1.0, count)?;
        self.unknowns.scales(&shape.outline, &mut scales);
        let mut first: Vec<usize> = (0..count).collect();
        let mut local = Vec::new();
        self.columns.clear();
        self.ends.clear();
        for &i in &self.pieces {
            self.unknowns.columns(&shape.outline, i, &mut local);
            let least = local.iter().fold(usize::MAX, |least, column| least.min(column.0));
            for (unknown, _) in &local {
                first[*unknown] = first[*unknown].min(least);
            }
            self.columns.extend_from_slice(&local);
            self.ends.push(self.columns.len());
        }
        let mut factor = Skyline::new(first)?;
        let mut right = filled(0.0, count)?;
        let stiffness = CROSSING * field.stiffness();
        let mut left = Left::default();
        let mut from = 0;
        for (&i, &end) in self.pieces.iter().zip(&self.ends) {
            let columns = &self.columns[from..end];
            from = end;
            let pull = pull(&shape.parts[i], field, &mut left);
            let square = square(&shape.outline.cubic(i), stiffness);
            for (k, (unknown, column)) in columns.iter().enumerate() {
                right[*unknown] += product(column, &pull);
                let image = image(&square, column);
                for (other, along) in &columns[..=k] {
                    factor.add((*unknown).max(*other), (*unknown).min(*other), product(&image, along));
                }
            }
        }
        for (i, scale) in scales.iter().enumerate() {
            factor.add(i, i, damping * scale.max(1e-6));
        }
        factor.factor();
        let mut step = right.clone();
        factor.solve(&mut step);
        let promised = step.iter().zip(&right).map(|(a, b)| a * b).sum();
        Ok((step, left, promised))
    }
}

fn product(a: &[f64; 8], b: &[f64; 8]) -> f64 {
    // In pairs, as two of them fit into one register.
    let mut sums = [0.0; 2];
    for k in 0..4 {
        sums[0] += a[2 * k] * b[2 * k];
        sums[1] += a[2 * k + 1] * b[2 * k + 1];
    }
    sums[0] + sums[1]
}

/// The matrix times a column, most of which is 0.
fn image(square: &[[f64; 8]; 8], column: &[f64; 8]) -> [f64; 8] {
    let mut image = [0.0; 8];
    for (row, &amount) in square.iter().zip(column) {
        if amount != 0.0 {
            for k in 0..8 {
                image[k] += amount * row[k];
            }
        }
    }
    image
}

/// Whether a piece goes where no pixel would call it back.
pub(super) fn leaves(cubic: &Cubic, field: &Field) -> bool {
    let corners = [cubic.start, cubic.start + cubic.leaving, cubic.end - cubic.arriving, cubic.end];
    if !corners.iter().any(|&corner| field.is_beyond(corner)) {
        return false;
    }
    (0..=LOOKS).any(|k| field.is_beyond(cubic.point(f64::from(k) / f64::from(LOOKS))))
}

/// What the pixels say to the control points of one piece; `left` sees what is left in them.
fn pull(parts: &[Part], field: &Field, left: &mut Left) -> [f64; 8] {
    // Moments of the parameter: x and y in turn.
    let (mut moments, mut last) = ([[0.0_f64; 2]; 4], NONE);
    let lead = field.lead();
    for part in parts.iter().filter(|part| part.pixel != NONE) {
        let value = lead[part.pixel as usize];
        let t = f64::from(part.t);
        let mut moment = [f64::from(part.dy * value), f64::from(part.dx * value)];
        for sum in &mut moments {
            for k in 0..2 {
                sum[k] += moment[k];
                moment[k] *= t;
            }
        }
        if part.pixel != last {
            last = part.pixel;
            left.see(field.rest[part.pixel as usize]);
        }
    }
    let [a, b, c, d] = moments;
    let weights = |k: usize| {
        let last = 3.0 * (c[k] - d[k]);
        [a[k] - d[k] - 3.0 * (b[k] - c[k]), 3.0 * (b[k] - c[k]) - last, last, d[k]]
    };
    let (up, along) = (weights(0), weights(1));
    core::array::from_fn(|i| if i % 2 == 0 { up[i / 2] } else { -along[i / 2] })
}

/// The normal matrix of one piece's control points: the integral of n nᵀ B B over its length.
fn square(cubic: &Cubic, stiffness: f64) -> [[f64; 8]; 8] {
    // For each pair of control points xx, xy and yy.
    let (mut xx, mut xy, mut yy) = ([0.0; 10], [0.0; 10], [0.0; 10]);
    for ([t, _], products) in RULE.iter().zip(&PRODUCTS) {
        let velocity = cubic.velocity(*t);
        let scale = stiffness / larger(velocity.norm(), 1e-9);
        let (x, y) = (velocity.y, -velocity.x);
        let (a, b, c) = (scale * x * x, scale * x * y, scale * y * y);
        for k in 0..10 {
            xx[k] += a * products[k];
            xy[k] += b * products[k];
            yy[k] += c * products[k];
        }
    }
    let mut square = [[0.0; 8]; 8];
    let mut at = 0;
    for i in 0..4 {
        for j in 0..=i {
            for (i, j) in [(2 * i, 2 * j), (2 * j, 2 * i)] {
                (square[i][j], square[i][j + 1]) = (xx[at], xy[at]);
                (square[i + 1][j], square[i + 1][j + 1]) = (xy[at], yy[at]);
            }
            at += 1;
        }
    }
    square
}
