//! The first point of a run that has nothing to start from.

use super::cone::{Lorentz, Metric, dot, norm};
use super::iterate::{Iterate, Pair};
use super::reduced::Reduced;
use crate::error::Result;
use crate::fit::convex::scaled::Scaled;

/// A first point: few knots at equal distances, a smoothing spline on them whose forces are half of what is allowed.
pub(crate) fn start(data: &Scaled) -> Result<Iterate> {
    let chosen = data
        .components
        .iter()
        .map(|component| {
            let places = component.grid.len();
            let count = 48.min(places);
            (0..count).map(|k| k * places / count).collect()
        })
        .collect();
    let mut reduced = Reduced::new(data, chosen, &[])?;
    let lambdas = reduced.lambdas(data);
    // Stiffnesses of the knots: all forces are at most half of λ when each is λ over twice its jump.
    let mut stiffness: Vec<f64> = lambdas.iter().map(|lambda| lambda * 1e-3).collect();
    let (mut unknowns, mut jumps, mut line) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..3 {
        let metrics: Vec<Metric> = stiffness.iter().map(|&k| [k, 0.0, k]).collect();
        let _ = reduced.factor(&metrics);
        unknowns = reduced.linear.clone();
        reduced.solve(&mut unknowns, &mut line);
        reduced.jumps(&unknowns, &mut jumps);
        let mut knot = 0;
        for part in &reduced.parts {
            let range = knot..knot + part.chosen.len();
            let largest = jumps[range.clone()].iter().fold(0.0_f64, |most, v| most.max(norm(*v)));
            // Points that are all one have no jumps, and any stiffness will do.
            for k in range.filter(|_| largest > 0.0) {
                stiffness[k] = 0.5 * lambdas[k] / largest.max(1e-300);
            }
            knot += part.chosen.len();
        }
    }
    let metrics: Vec<Metric> = stiffness.iter().map(|&k| [k, 0.0, k]).collect();
    let _ = reduced.factor(&metrics);
    unknowns.clone_from(&reduced.linear);
    reduced.solve(&mut unknowns, &mut line);
    reduced.jumps(&unknowns, &mut jumps);
    let mean =
        0.3 * jumps.iter().zip(&lambdas).map(|(v, l)| l * norm(*v)).sum::<f64>() / jumps.len().max(1) as f64;
    let mut cones = Vec::new();
    for (k, jump) in jumps.iter().enumerate() {
        let height = (dot(*jump, *jump) + (mean / lambdas[k]) * (mean / lambdas[k])).sqrt();
        let force = *jump * -stiffness[k];
        let z = Lorentz::new(lambdas[k].max(norm(force) / 0.9), force);
        cones.push(Pair { s: Lorentz::new(height, *jump), z, lambda: lambdas[k] });
    }
    Ok(Iterate { reduced, unknowns, jumps, cones })
}
