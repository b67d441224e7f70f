//! The problem on the knots that are in play: its spaces, its quadratic form, its linear systems.

mod arrangement;
mod squares;

use self::arrangement::Shape;
pub(crate) use self::squares::Element;
use self::squares::elements;
use super::cone::Metric;
use crate::error::Result;
use crate::fit::convex::interval::Local;
use crate::fit::convex::scaled::{Scaled, ScaledComponent};
use crate::fit::convex::spline_space::{KnotSpace, ROOM};
use crate::limits;
use crate::numerics::Vector;
use crate::numerics::banded::Bordered;

/// The jump of the highest derivative at one knot: weights of its coefficients, and where these stand.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    pub(crate) weights: [f64; ROOM],
    /// The first of them.
    first: usize,
    /// Their places among the unknown points, in the order of the linear system.
    pub(crate) unknowns: [usize; ROOM],
}

/// One spline of the sum on its knots in play.
#[derive(Clone, Debug)]
pub(crate) struct Part {
    pub(crate) space: KnotSpace,
    /// The knots in play, as indices of the grid, ascending.
    pub(crate) chosen: Vec<usize>,
    pub(crate) rows: Vec<Row>,
    /// Place of each coefficient among the unknown points.
    pub(crate) order: Vec<usize>,
}

/// The least-squares part of the problem on the knots in play.
#[derive(Clone, Debug)]
pub(crate) struct Reduced {
    pub(crate) parts: Vec<Part>,
    pub(crate) elements: Vec<Element>,
    /// For each element and each part, in turn, its interval and its basis functions in the element's variable.
    locals: Vec<(usize, Local)>,
    /// How many unknown points there are.
    pub(crate) unknowns: usize,
    shape: Shape,
    /// 2 Σ w B B′ and the gauge: the same for both coordinates.
    pub(crate) quadratic: Bordered,
    /// 2 Σ w B p.
    pub(crate) linear: Vec<Vector>,
    /// The system of one iteration.
    pub(crate) system: Bordered,
}

impl Reduced {
    /// The problem on these knots; `chosen` names places of each component's grid. `known` are elements of the same
    /// data on other knots: what they have in common is not summed again.
    pub(crate) fn new(data: &Scaled, chosen: Vec<Vec<usize>>, known: &[Element]) -> Result<Self> {
        let mut parts = Vec::new();
        for (component, chosen) in data.components.iter().zip(chosen) {
            let mut knots = limits::with_room(chosen.len())?;
            knots.extend(chosen.iter().map(|&k| component.grid[k]));
            let space = KnotSpace::new(component.degree, &knots, 0.0, data.length, data.closed)?;
            let order = vec![0; space.dimension()];
            parts.push(Part { space, chosen, rows: Vec::new(), order });
        }
        let unknowns = parts.iter().map(|part| part.space.dimension()).sum();
        let (elements, locals) = elements(data, &parts, known);
        let mut reduced = Self {
            parts,
            elements,
            locals,
            unknowns,
            shape: Shape::default(),
            quadratic: Bordered::default(),
            linear: Vec::new(),
            system: Bordered::default(),
        };
        reduced.make_rows();
        reduced.arrange()?;
        reduced.assemble(data);
        Ok(reduced)
    }

    /// About how many products one factorisation takes.
    pub(crate) fn work(&self) -> f64 {
        self.shape.work()
    }

    /// λ of every knot in play.
    pub(crate) fn lambdas(&self, data: &Scaled) -> Vec<f64> {
        let one = |(part, component): (&Part, &ScaledComponent)| {
            core::iter::repeat_n(component.lambda, part.chosen.len())
        };
        self.parts.iter().zip(&data.components).flat_map(one).collect()
    }

    fn make_rows(&mut self) {
        for part in &mut self.parts {
            let degree = part.space.degree();
            part.rows.clear();
            for k in 0..part.chosen.len() {
                let (first, weights) = part.space.jump_weights(k, degree);
                part.rows.push(Row { weights, first, unknowns: [0; ROOM] });
            }
        }
    }

    /// Quadratic form plus Σ (row)′ metric (row), factored. `metrics` run through the knots of the parts.
    pub(crate) fn factor(&mut self, metrics: &[Metric]) -> usize {
        self.factor_above(metrics, 1e-14)
    }

    /// The same, with pivots of at most `floor` of their diagonal held at zero; answers how many those are.
    pub(crate) fn factor_above(&mut self, metrics: &[Metric], floor: f64) -> usize {
        self.quadratic.copy_to_points(&mut self.system);
        let mut metrics = metrics.iter();
        for part in &self.parts {
            let count = part.space.degree() + 2;
            for row in &part.rows {
                let Some(metric) = metrics.next() else { break };
                // Where the coefficients stand in a row, so do their columns.
                let first = row.unknowns[0];
                let straight = row.unknowns[..count].iter().enumerate().all(|(i, at)| *at == first + i);
                if straight && self.system.add_outer(first, &row.weights[..count], *metric) {
                    continue;
                }
                for i in 0..count {
                    for j in 0..=i {
                        let (a, b) = (row.unknowns[i], row.unknowns[j]);
                        let twice = if a == b && i != j { 2.0 } else { 1.0 };
                        let product = row.weights[i] * row.weights[j] * twice;
                        let block = [product * metric[0], product * metric[1], product * metric[2]];
                        self.system.add_block(a, b, block);
                    }
                }
            }
        }
        self.system.factor(floor)
    }

    /// Solves the system that was factored last, in place.
    pub(crate) fn solve(&self, right: &mut [Vector], buffer: &mut Vec<f64>) {
        buffer.clear();
        buffer.extend(right.iter().flat_map(|v| [v.x, v.y]));
        self.system.solve(buffer);
        for (v, pair) in right.iter_mut().zip(buffer.chunks_exact(2)) {
            *v = Vector::new(pair[0], pair[1]);
        }
    }

    /// The jumps at all knots in play.
    pub(crate) fn jumps(&self, unknowns: &[Vector], jumps: &mut Vec<Vector>) {
        jumps.clear();
        for part in &self.parts {
            let count = part.space.degree() + 2;
            jumps.extend(part.rows.iter().map(|row| {
                let mut jump = Vector::zeros();
                for (weight, unknown) in row.weights.iter().zip(row.unknowns).take(count) {
                    jump += unknowns[unknown] * *weight;
                }
                jump
            }));
        }
    }

    /// Adds the transpose of the jumps: forces at knots become forces at coefficients.
    pub(crate) fn pull(&self, forces: &[Vector], sum: &mut [Vector]) {
        let mut forces = forces.iter();
        for part in &self.parts {
            let count = part.space.degree() + 2;
            for row in &part.rows {
                let Some(force) = forces.next() else { break };
                for (weight, unknown) in row.weights.iter().zip(row.unknowns).take(count) {
                    sum[unknown] += force * *weight;
                }
            }
        }
    }
}

/// The same functions on more knots.
pub(crate) fn transfer(from: &Reduced, to: &mut Reduced, unknowns: &[Vector]) -> Vec<Vector> {
    let mut result = vec![Vector::zeros(); to.unknowns];
    let mut fine = Vec::new();
    for (old, new) in from.parts.iter().zip(&to.parts) {
        let coefficients: Vec<Vector> = old.order.iter().map(|&place| unknowns[place]).collect();
        old.space.refine_into(&coefficients, &new.space, &mut fine);
        for (&place, value) in new.order.iter().zip(&fine) {
            result[place] = *value;
        }
    }
    result
}
