//! The sparse extreme point: of all optima one that has no two knots where one would do.
//!
//! Two optima differ by a curve that vanishes at all samples and whose jumps lie along those of the optimum. Such
//! curves are the kernel of a matrix; along one of them jumps grow and shrink, residuals and objective stay, until the
//! first jump is zero. (D 12.12)

use super::cone::{Metric, dot, norm, stretch};
use super::fixed_knots::Fixed;
use super::reduced::{Part, Reduced, transfer};
use super::run::Run;
use crate::error::Result;
use crate::fit::convex::scaled::Scaled;
use crate::numerics::Vector;

/// A pivot of this share of its diagonal is zero: curves that the samples tell apart have larger ones.
const KERNEL: f64 = 1e-11;
/// What a curve of the kernel may be at the samples, by its own size.
const FLAT: f64 = 1e-8;
/// A jump of this share of the largest is zero.
const NOTHING: f64 = 1e-10;
/// What the objective may grow by rounding, all in all.
const ROUNDING: f64 = 1e-9;

impl Run {
    /// The curve of [`Run::best`] after exchanges of jumps that change neither residuals nor objective: at most as many
    /// knots are left as the samples can tell apart. On a grid that is not finer than the samples the optimum is
    /// unique, and nothing changes. O(K) for each knot that goes. (D 12.12)
    ///
    /// # Errors
    ///
    /// `OutOfMemory` only.
    pub(crate) fn extreme(&self) -> Result<Fixed> {
        let first = self.best()?;
        let most = first.measure.primal * (1.0 + ROUNDING);
        let mut fixed = first;
        for _ in 0..fixed.jumps.len() {
            match exchanged(&self.data, &mut fixed)? {
                Some(next) if next.measure.primal <= most => fixed = next,
                _ => break,
            }
        }
        Ok(fixed)
    }
}

/// One exchange, after which at least one jump more is zero; `None` where the optimum is an extreme point already.
fn exchanged(data: &Scaled, fixed: &mut Fixed) -> Result<Option<Fixed>> {
    let largest = fixed.jumps.iter().fold(0.0_f64, |most, v| most.max(norm(*v)));
    let Some(kernel) = kernel(data, &mut fixed.reduced, &fixed.jumps) else { return Ok(None) };
    let mut rates = Vec::new();
    fixed.reduced.jumps(&kernel, &mut rates);
    // The shortest way to where a jump is zero, forwards or backwards.
    let mut step = f64::INFINITY;
    for (jump, rate) in fixed.jumps.iter().zip(&rates) {
        let (size, along) = (norm(*jump), dot(*jump, *rate));
        if size > NOTHING * largest && along.abs() > NOTHING * size * norm(*rate) {
            let to_zero = -size * size / along;
            step = if to_zero.abs() < step.abs() { to_zero } else { step };
        }
    }
    if !step.is_finite() {
        return Ok(None);
    }
    let unknowns: Vec<Vector> = fixed.unknowns.iter().zip(&kernel).map(|(c, by)| c + by * step).collect();
    let mut after = Vec::new();
    fixed.reduced.jumps(&unknowns, &mut after);
    let kept = |k: usize| norm(after[k]) > NOTHING * largest;
    let mut knot = 0;
    let chosen = fixed.reduced.parts.iter().map(|part| {
        let first = knot;
        knot += part.chosen.len();
        part.chosen.iter().enumerate().filter(|(k, _)| kept(first + k)).map(|(_, &place)| place).collect()
    });
    let mut reduced = Reduced::new(data, chosen.collect(), &[])?;
    let unknowns = transfer(&fixed.reduced, &mut reduced, &unknowns);
    let mut jumps = Vec::new();
    reduced.jumps(&unknowns, &mut jumps);
    let mut measure = fixed.measure;
    let mut weighted = vec![Vector::zeros(); data.t.len()];
    measure.data_term = reduced.residuals(data, &unknowns, &mut weighted, &mut Vec::new());
    let prices = reduced.lambdas(data);
    let price: f64 = jumps.iter().zip(&prices).map(|(jump, lambda)| lambda * norm(*jump)).sum();
    measure.primal = measure.data_term + price;
    measure.gap = if measure.primal > 0.0 { (measure.primal - measure.dual) / measure.primal } else { 0.0 };
    let fewer = |part: &Part| part.chosen.len();
    let (before, now) = (fixed.reduced.parts.iter().map(fewer), reduced.parts.iter().map(fewer));
    if now.sum::<usize>() == before.sum::<usize>() {
        return Ok(None);
    }
    Ok(Some(Fixed { reduced, unknowns, jumps, measure }))
}

/// A curve that no sample sees and whose jumps lie along the given ones; `None` where there is none but zero.
fn kernel(data: &Scaled, reduced: &mut Reduced, jumps: &[Vector]) -> Option<Vec<Vector>> {
    // Any positive price of jumps across gives the same kernel; this one is about as stiff as the samples.
    let stiffness = 2.0 * data.w.iter().sum::<f64>() / reduced.unknowns.max(1) as f64;
    let rows = reduced.parts.iter().flat_map(|part| &part.rows);
    let metrics: Vec<Metric> = rows
        .zip(jumps)
        .map(|(row, jump)| {
            let price = stiffness / row.weights.iter().map(|weight| weight * weight).sum::<f64>();
            let unit = jump / norm(*jump).max(f64::MIN_POSITIVE);
            let across = 1.0 - dot(unit, unit);
            [price * (unit.y * unit.y + across), -price * unit.x * unit.y, price * (unit.x * unit.x + across)]
        })
        .collect();
    if reduced.factor_above(&metrics, KERNEL) == 0 {
        return None;
    }
    // An unknown that nothing determines is held at zero: it shows in any solution.
    let mut line = Vec::new();
    let mut curve = vec![Vector::new(1.0, 1.0); reduced.unknowns];
    reduced.solve(&mut curve, &mut line);
    let place = curve.iter().position(|v| v.x.abs() < 1e-100 || v.y.abs() < 1e-100)?;
    let axis = usize::from(curve[place].x.abs() >= 1e-100);
    curve.fill(Vector::zeros());
    curve[place][axis] = 1.0;
    let mut image = Vec::new();
    for _ in 0..3 {
        times(reduced, &metrics, &curve, &mut image);
        reduced.solve(&mut image, &mut line);
        for (value, by) in curve.iter_mut().zip(&image) {
            *value -= by;
        }
    }
    times(reduced, &metrics, &curve, &mut image);
    let most = |list: &[Vector]| list.iter().fold(0.0_f64, |most, v| most.max(norm(*v)));
    (most(&image) <= FLAT * stiffness * most(&curve)).then_some(curve)
}

/// The matrix of the system with these metrics, times a curve.
fn times(reduced: &Reduced, metrics: &[Metric], curve: &[Vector], image: &mut Vec<Vector>) {
    image.clear();
    image.resize(curve.len(), Vector::zeros());
    reduced.quadratic.times(curve, image);
    let mut forces = Vec::new();
    reduced.jumps(curve, &mut forces);
    for (force, metric) in forces.iter_mut().zip(metrics) {
        *force = stretch(metric, *force);
    }
    reduced.pull(&forces, image);
}
