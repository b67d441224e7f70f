//! The equations of one step of the refinement: what moves, what the pixels say to it, and the step that they ask for.

use super::coverage::Part;
use super::field::{BEYOND, Field};
use super::left::Left;
use super::skyline::Skyline;
use super::unknowns::{Term, Unknowns};
use crate::error::Result;
use crate::limits::refill;
use crate::numerics::plane::{dot, larger, norm};
use crate::numerics::{Point, Vector};
use crate::trace::outline::Outline;
use crate::trace::outline::cubic::Cubic;

/// How much of a pixel's side an outline crosses, in the mean by length: between 0.94 and 1 for straight ones.
const CROSSING: f64 = 0.95;
/// Gauss's rule for polynomials of degree 9 on [0, 1]: places and weights.
const RULE: [[f64; 2]; 5] = [
    [0.046_910_077_030_668, 0.118_463_442_528_095],
    [0.230_765_344_947_158, 0.239_314_335_249_683],
    [0.5, 0.284_444_444_444_444],
    [0.769_234_655_052_842, 0.239_314_335_249_683],
    [0.953_089_922_969_332, 0.118_463_442_528_095],
];
/// Pairs of what a cubic is made of: start, way leaving, way arriving, end.
const PAIRS: usize = 10;
/// Products of two of their polynomials at the rule's places, with the weights.
const PRODUCTS: [[f64; PAIRS]; 5] = {
    let mut products = [[0.0; PAIRS]; 5];
    let mut at = 0;
    while at < RULE.len() {
        let [a, b, c, d] = Cubic::bernstein(RULE[at][0]);
        let own = [a + b, b, -c, c + d];
        let (mut i, mut pair) = (0, 0);
        while i < 4 {
            let mut j = 0;
            while j <= i {
                products[at][pair] = RULE[at][1] * own[i] * own[j];
                (j, pair) = (j + 1, pair + 1);
            }
            i += 1;
        }
        at += 1;
    }
    products
};

/// The equations of the unknowns of some nodes, with room that is used for one step after another.
#[derive(Debug, Default)]
pub(super) struct Equations {
    pub(super) unknowns: Unknowns,
    /// The pieces that the unknowns change, in order.
    pub(super) pieces: Vec<usize>,
    terms: Vec<Term>,
    ends: Vec<usize>,
    factor: Skyline,
    scales: Vec<f64>,
    right: Vec<f64>,
    pub(super) step: Vec<f64>,
}

impl Equations {
    /// The unknowns of these nodes are what moves.
    pub(super) fn begin(&mut self, outline: &Outline, nodes: &[usize]) {
        self.unknowns.number(outline, nodes);
        self.unknowns.pieces(outline, &mut self.pieces);
    }

    /// Finds the step of the unknowns that the residuals ask for (D 14.4): what is left, and by how much the step
    /// promises to make that less.
    ///
    /// # Cost
    ///
    /// O(parts of the pieces + unknowns · band²).
    pub(super) fn solve(
        &mut self,
        field: &mut Field,
        outline: &Outline,
        parts: &[Vec<Part>],
        damping: f64,
    ) -> Result<(Left, f64)> {
        let count = self.unknowns.end;
        refill(&mut self.scales, 1.0, count)?;
        self.unknowns.scales(outline, &mut self.scales);
        self.lay_out(outline)?;
        refill(&mut self.right, 0.0, count)?;
        let stiffness = CROSSING * field.stiffness();
        let mut left = Left::default();
        let mut from = 0;
        for (&i, &end) in self.pieces.iter().zip(&self.ends) {
            let terms = &self.terms[from..end];
            from = end;
            field.hear(parts[i].iter().map(|part| part.pixel));
            let (pull, matrix) = if outline.is_line(i) {
                let cubic = outline.cubic(i);
                (pull(&parts[i], field, true, &mut left), line(cubic.start, cubic.end, stiffness))
            } else {
                (pull(&parts[i], field, false, &mut left), square(&outline.cubic(i), stiffness))
            };
            add(terms, &pull, &matrix, &mut self.right, &mut self.factor);
        }
        for (i, scale) in self.scales.iter().enumerate() {
            self.factor.add(i, i, damping * larger(*scale, 1e-6));
        }
        self.factor.factor();
        self.step.clear();
        self.step.extend_from_slice(&self.right);
        self.factor.solve(&mut self.step);
        let promised = self.step.iter().zip(&self.right).map(|(a, b)| a * b).sum();
        Ok((left, promised))
    }

    /// By how much the last step promised to make less what is left, node by node.
    pub(super) fn promises(&self) -> impl Iterator<Item = (usize, f64)> {
        self.unknowns.ranges().map(|(node, own)| {
            let both = self.step[own.clone()].iter().zip(&self.right[own]);
            (node, both.map(|(a, b)| a * b).sum())
        })
    }

    /// Finds the terms of all pieces, and which unknowns meet.
    fn lay_out(&mut self, outline: &Outline) -> Result<()> {
        self.terms.clear();
        self.ends.clear();
        let last = self.factor.begin(self.unknowns.end)?;
        for &i in &self.pieces {
            let from = self.terms.len();
            self.unknowns.terms(outline, i, &mut self.terms);
            let own = &self.terms[from..];
            let most = own
                .iter()
                .fold(0, |most, term| term.unknowns().iter().fold(most, |most, &own| most.max(own)));
            for term in own {
                term.unknowns().iter().for_each(|&unknown| last[unknown] = last[unknown].max(most));
            }
            self.ends.push(self.terms.len());
        }
        self.factor.lay_out()
    }
}

/// The part of a symmetric matrix that belongs to two of a piece's four vectors: xx, xy, yy for every pair.
struct Matrix([[f64; PAIRS]; 3]);

/// Adds what one piece says to its unknowns.
fn add(terms: &[Term], pull: &[Vector; 4], matrix: &Matrix, right: &mut [f64], factor: &mut Skyline) {
    let Matrix([xx, xy, yy]) = matrix;
    for (k, term) in terms.iter().enumerate() {
        let own = term.unknowns();
        for (way, &unknown) in term.ways.iter().zip(own) {
            right[unknown] += dot(*way, pull[term.slot]);
        }
        for (l, other) in terms[..=k].iter().enumerate() {
            let (high, low) = (term.slot.max(other.slot), term.slot.min(other.slot));
            let pair = high * (high + 1) / 2 + low;
            let (a, b, c) = (xx[pair], xy[pair], yy[pair]);
            let image = |way: Vector| Vector::new(a * way.x + b * way.y, b * way.x + c * way.y);
            for (i, &unknown) in own.iter().enumerate() {
                let image = image(term.ways[i]);
                let others = if k == l { &own[..=i] } else { other.unknowns() };
                for (way, &along) in other.ways.iter().zip(others) {
                    let value = dot(image, *way);
                    // Terms of one unknown meet twice on the diagonal.
                    let twice = k != l && unknown == along;
                    factor.add(unknown, along, if twice { value + value } else { value });
                }
            }
        }
    }
}

/// What the pixels say to the four vectors of a piece; `left` sees what is left in them.
fn pull(parts: &[Part], field: &Field, line: bool, left: &mut Left) -> [Vector; 4] {
    // Moments of the parameter: x and y in turn.
    let (mut moments, mut last) = ([[0.0_f64; 2]; 4], BEYOND);
    let lead = field.lead();
    let mut seen = *left;
    for part in parts {
        // No pixel is not among them.
        let Some(&value) = lead.get(part.pixel as usize) else { continue };
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
            seen.see(field.rest[part.pixel as usize]);
        }
    }
    *left = seen;
    let [a, b, c, d] = moments.map(|[x, y]| Vector::new(x, -y));
    if line {
        return [a - b, Vector::zeros(), Vector::zeros(), b];
    }
    // Bernstein's polynomials are 1 − 3t + 3t² − t³, 3t − 6t² + 3t³, 3t² − 3t³ and t³.
    let (second, third) = ((b - c * 2.0 + d) * 3.0, (c - d) * 3.0);
    [a - third - d, second, -third, third + d]
}

/// The normal matrix of one piece: the integral of n nᵀ B B over its length.
fn square(cubic: &Cubic, stiffness: f64) -> Matrix {
    let (mut xx, mut xy, mut yy) = ([0.0; PAIRS], [0.0; PAIRS], [0.0; PAIRS]);
    for ([t, _], products) in RULE.iter().zip(&PRODUCTS) {
        let velocity = cubic.velocity(*t);
        let scale = stiffness / larger(norm(velocity), 1e-9);
        let (x, y) = (velocity.y, -velocity.x);
        let (a, b, c) = (scale * x * x, scale * x * y, scale * y * y);
        for k in 0..PAIRS {
            xx[k] += a * products[k];
            xy[k] += b * products[k];
            yy[k] += c * products[k];
        }
    }
    Matrix([xx, xy, yy])
}

/// The same of a straight piece, which has but its ends: a third and a sixth of its length.
fn line(start: Point, end: Point, stiffness: f64) -> Matrix {
    let way = end - start;
    let scale = stiffness / larger(norm(way), 1e-9);
    let (x, y) = (way.y, -way.x);
    let both = |whole: f64| {
        let mut pairs = [0.0; PAIRS];
        (pairs[0], pairs[6], pairs[9]) = (whole / 3.0, whole / 6.0, whole / 3.0);
        pairs
    };
    Matrix([both(scale * x * x), both(scale * x * y), both(scale * y * y)])
}
