//! From an iterate, in which every jump in play is a little off zero, to the curve on its true knots.
//!
//! A knot is one where the jump is larger, by its scale, than the dual vector is short of one: at the optimum exactly
//! one of the two is zero. On those knots alone the objective is smooth, and Newton's method ends at its least value.
//! (D 12.7)

use super::cone::{Metric, dot, norm};
use super::reduced::Reduced;
use super::scaled::Scaled;
use super::solution::{Solution, Spline};
use super::solver::{Iterate, Solver, jump_length, lanes, seen};
use crate::error::Result;
use crate::numerics::Vector;

/// A stiffness against coordinates of a jump that have to stay zero, in units of λ over the largest jump.
const STIFF: f64 = 1e9;

/// A curve on chosen knots.
struct Fixed {
    reduced: Reduced,
    unknowns: Vec<Vector>,
    jumps: Vec<Vector>,
    objective: f64,
    data_term: f64,
}

impl Solver {
    /// The curve that the run has come to, on its true knots; the run can go on afterwards.
    ///
    /// # Errors
    ///
    /// `OutOfMemory` only.
    pub fn solution(&self) -> Result<Solution> {
        let most = self.measure.primal + self.measure.gap.max(1e-12) * self.measure.primal;
        let fixed = match self.polished()? {
            Some(fixed) if fixed.objective <= most => fixed,
            _ => Fixed {
                reduced: self.iterate.reduced.clone(),
                unknowns: self.iterate.unknowns.clone(),
                jumps: self.iterate.jumps.clone(),
                objective: self.measure.primal,
                data_term: self.measure.data_term,
            },
        };
        Ok(self.in_units_of_the_caller(&fixed))
    }

    /// The least objective on the knots that the iterate singles out; `None` where that fails.
    fn polished(&self) -> Result<Option<Fixed>> {
        let lanes = lanes(self.data.norm);
        let mut jumps = Vec::new();
        let mut chosen = Vec::new();
        let mut knot = 0;
        for (i, part) in self.iterate.reduced.parts.iter().enumerate() {
            let mut set = Vec::new();
            for (k, jump) in
                active(&self.iterate, knot, part.chosen.len(), self.data.components[i].lambda, lanes)
            {
                set.push(part.chosen[k]);
                jumps.push(jump);
            }
            // The jumps of a closed curve sum to zero: one alone is none.
            if self.data.closed && set.len() == 1 {
                set.clear();
                jumps.pop();
            }
            chosen.push(set);
            knot += part.chosen.len();
        }
        for _ in 0..4 {
            let reduced = Reduced::new(&self.data, chosen.clone())?;
            let Some(fixed) = newton(&self.data, reduced, &jumps, lanes) else { return Ok(None) };
            let Some(keep) = turned(&fixed.jumps, &jumps) else { return Ok(Some(fixed)) };
            let mut keep = keep.into_iter();
            let mut kept = Vec::new();
            for (set, part) in chosen.iter_mut().zip(&fixed.reduced.parts) {
                let from = kept.len();
                set.clear();
                for &place in &part.chosen {
                    if let Some(Some(jump)) = keep.next() {
                        set.push(place);
                        kept.push(jump);
                    }
                }
                if self.data.closed && set.len() == 1 {
                    set.clear();
                    kept.truncate(from);
                }
            }
            jumps = kept;
        }
        Ok(None)
    }

    fn in_units_of_the_caller(&self, fixed: &Fixed) -> Solution {
        let data = &self.data;
        let (factor, lanes) = (data.objective_factor(), lanes(data.norm));
        let mut knot = 0;
        let mut regularizers = Vec::new();
        let last = fixed.reduced.parts.len() - 1;
        let components = fixed.reduced.parts.iter().enumerate().map(|(i, part)| {
            let component = &data.components[i];
            let mut jump_factor = data.size;
            for _ in 0..component.degree {
                jump_factor /= data.step;
            }
            let jumps: Vec<Vector> =
                fixed.jumps[knot..knot + part.chosen.len()].iter().map(|v| v * jump_factor).collect();
            knot += part.chosen.len();
            let lambda = component.lambda / data.lambda_factor(component.degree);
            regularizers.push(lambda * jumps.iter().map(|v| jump_length(*v, lanes)).sum::<f64>());
            // The centre of the points belongs to the last component, which has the constants.
            let centre = if i == last { data.centre } else { Vector::zeros() };
            Spline {
                degree: component.degree,
                lambda,
                knots: part.chosen.iter().map(|&k| component.grid[k] * data.step + data.start).collect(),
                jumps,
                coefficients: part.order.iter().map(|&k| fixed.unknowns[k] * data.size + centre).collect(),
            }
        });
        let components = components.collect();
        Solution {
            components,
            domain: (data.start, data.start + data.length * data.step, data.closed),
            objective: fixed.objective * factor,
            data_term: fixed.data_term * factor,
            regularizers,
            gap: self.measure.gap.max(0.0),
            status: self.status,
            iterations: self.iteration,
        }
    }
}

/// The knots of one part whose jump is larger than their dual vector is short of one, with these jumps.
fn active(iterate: &Iterate, from: usize, count: usize, lambda: f64, lanes: usize) -> Vec<(usize, Vector)> {
    let jumps = &iterate.jumps[from..from + count];
    let largest = jumps.iter().fold(0.0_f64, |most, v| most.max(norm(*v)));
    let mut found = Vec::new();
    for (k, jump) in jumps.iter().enumerate() {
        let mut kept = Vector::zeros();
        for lane in 0..lanes {
            let own = seen(*jump, lane, lanes);
            let pair = &iterate.cones[(from + k) * lanes + lane];
            let short = 1.0 - norm(pair.z.plane) / lambda;
            if norm(own) > short * largest {
                kept += own;
            }
        }
        if norm(kept) > 0.0 {
            found.push((k, kept));
        }
    }
    found
}

/// The jumps to keep where some have turned round or vanished; `None` where none has.
fn turned(after: &[Vector], before: &[Vector]) -> Option<Vec<Option<Vector>>> {
    let good = |(a, b): (&Vector, &Vector)| dot(*a, *b) > 0.0;
    if after.iter().zip(before).all(good) {
        return None;
    }
    Some(after.iter().zip(before).map(|pair| good(pair).then_some(*pair.1)).collect())
}

/// Newton's method for the objective on fixed knots, from directions and lengths of their jumps.
fn newton(data: &Scaled, mut reduced: Reduced, start: &[Vector], lanes: usize) -> Option<Fixed> {
    let lambdas: Vec<f64> = reduced
        .parts
        .iter()
        .enumerate()
        .flat_map(|(i, part)| core::iter::repeat_n(data.components[i].lambda, part.chosen.len()))
        .collect();
    let largest = start.iter().fold(f64::MIN_POSITIVE, |most, v| most.max(norm(*v)));
    let mut jumps = start.to_vec();
    let (mut unknowns, mut line, mut forces, mut metrics) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for round in 0..20 {
        forces.clear();
        metrics.clear();
        for (jump, lambda) in jumps.iter().zip(&lambdas) {
            let (force, metric) =
                if lanes == 1 { bent(*jump, *lambda) } else { boxed(*jump, *lambda, largest) };
            forces.push(force);
            metrics.push(metric);
        }
        let _ = reduced.factor(&metrics);
        unknowns = reduced.linear.clone();
        reduced.pull(&forces, &mut unknowns);
        reduced.solve(&mut unknowns, &mut line);
        let mut next = Vec::new();
        reduced.jumps(&unknowns, &mut next);
        if next.iter().any(|v| !(v.x.is_finite() && v.y.is_finite())) {
            return None;
        }
        if turned(&next, start).is_some() {
            jumps = next;
            break;
        }
        let change = next.iter().zip(&jumps).fold(0.0_f64, |most, (a, b)| most.max(norm(a - b) / norm(*a)));
        jumps = next;
        if change < 1e-12 || (lanes == 2 && round > 0) {
            break;
        }
    }
    if lanes == 2 {
        for (jump, own) in jumps.iter_mut().zip(start) {
            // What had to stay zero is zero.
            *jump =
                Vector::new(if own.x == 0.0 { 0.0 } else { jump.x }, if own.y == 0.0 { 0.0 } else { jump.y });
        }
    }
    let mut weighted = vec![Vector::zeros(); data.t.len()];
    let data_term = reduced.residuals(data, &unknowns, &mut weighted);
    let regularizer: f64 = jumps.iter().zip(&lambdas).map(|(v, l)| l * jump_length(*v, lanes)).sum();
    Some(Fixed { reduced, unknowns, jumps, objective: data_term + regularizer, data_term })
}

/// −λU and λ(1 − UU′)/ρ for a jump ρU: gradient and curvature of λ|w|.
fn bent(jump: Vector, lambda: f64) -> (Vector, Metric) {
    let length = norm(jump);
    let (unit, stiffness) = (jump / length, lambda / length);
    let metric = [stiffness * unit.y * unit.y, -stiffness * unit.x * unit.y, stiffness * unit.x * unit.x];
    (unit * -lambda, metric)
}

/// The same for λ(|x| + |y|), with coordinates that are zero held there.
fn boxed(jump: Vector, lambda: f64, largest: f64) -> (Vector, Metric) {
    let sign = |v: f64| if v == 0.0 { 0.0 } else { v.signum() };
    let hold = |v: f64| if v == 0.0 { STIFF * lambda / largest } else { 0.0 };
    (Vector::new(sign(jump.x), sign(jump.y)) * -lambda, [hold(jump.x), 0.0, hold(jump.y)])
}
