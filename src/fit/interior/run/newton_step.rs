//! One step of the method: a predictor, and a corrector that keeps to the middle.

use super::{Buffers, Run};
use crate::fit::interior::cone::{Lorentz, Scaling, dot, norm, stretch};
use crate::fit::interior::iterate::{Iterate, Pair};

impl Run {
    /// One predictor and one corrector step. Answers whether there was a step.
    pub(super) fn advance(&mut self) -> bool {
        let iterate = &mut self.iterate;
        let b = &mut self.buffers;
        let rank = iterate.cones.len() as f64;
        if iterate.cones.is_empty() {
            return false;
        }
        let mean = iterate.cones.iter().map(|pair| pair.s.dot(pair.z)).sum::<f64>() / rank;
        b.scalings.clear();
        b.scalings.extend(iterate.cones.iter().map(|pair| Scaling::new(pair.s, pair.z)));
        b.metrics.clear();
        b.metrics.extend(b.scalings.iter().map(Scaling::metric));
        let _ = iterate.reduced.factor(&b.metrics);
        // Stationarity: Q c − b − L′ z.
        iterate.reduced.gradient(&b.element_forces, &mut b.residual);
        b.forces.clear();
        b.forces.extend(iterate.cones.iter().map(|pair| -pair.z.plane));
        iterate.reduced.pull(&b.forces, &mut b.residual);
        b.complements.clear();
        b.complements.extend(iterate.cones.iter().map(|pair| pair.s));
        direction(iterate, b);
        let affine = longest_step(&iterate.cones, &b.steps, 1.0);
        let centring = (1.0 - affine) * (1.0 - affine) * (1.0 - affine);
        for (k, pair) in iterate.cones.iter().enumerate() {
            let (ds, dz) = b.steps[k];
            b.complements[k] = b.scalings[k].corrector(pair.s, ds, dz, centring * mean);
        }
        direction(iterate, b);
        let step = (0.99 * longest_step(&iterate.cones, &b.steps, 1.0 / 0.99)).min(1.0);
        if !(step > 1e-9 && step.is_finite()) {
            return false;
        }
        self.before.clear();
        if step > 0.5 {
            self.before.extend(iterate.cones.iter().map(Pair::sizes));
        }
        for (unknown, by) in iterate.unknowns.iter_mut().zip(&b.direction) {
            *unknown += by * step;
        }
        iterate.reduced.jumps(&iterate.unknowns, &mut iterate.jumps);
        for (k, pair) in iterate.cones.iter_mut().enumerate() {
            pair.s.height += step * b.steps[k].0.height;
            pair.s.plane = iterate.jumps[k];
            pair.z = pair.z.advanced(b.steps[k].1, step);
        }
        iterate
            .cones
            .iter()
            .all(|pair| pair.s.height > norm(pair.s.plane) && pair.z.height > norm(pair.z.plane))
    }
}

/// Solves one Newton system for the given complementarity residuals; leaves directions of everything in the buffers.
fn direction(iterate: &Iterate, b: &mut Buffers) {
    b.constants.clear();
    for (k, pair) in iterate.cones.iter().enumerate() {
        let missing = pair.lambda - pair.z.height;
        b.constants.push(b.scalings[k].slope() * missing - stretch(&b.metrics[k], b.complements[k].plane));
    }
    b.direction.clear();
    b.direction.extend(b.residual.iter().map(|v| -v));
    iterate.reduced.pull(&b.constants, &mut b.direction);
    iterate.reduced.solve(&mut b.direction, &mut b.line);
    iterate.reduced.jumps(&b.direction, &mut b.jump_direction);
    b.steps.clear();
    for (k, pair) in iterate.cones.iter().enumerate() {
        let (scaling, complement) = (&b.scalings[k], b.complements[k]);
        let missing = pair.lambda - pair.z.height;
        let dw = b.jump_direction[k];
        let moved = dw + complement.plane;
        let height = -complement.height - (missing * scaling.compliance() + dot(scaling.slope(), moved));
        let plane = scaling.slope() * missing - stretch(&b.metrics[k], moved);
        b.steps.push((Lorentz::new(height, dw), Lorentz::new(missing, plane)));
    }
}

fn longest_step(cones: &[Pair], steps: &[(Lorentz, Lorentz)], most: f64) -> f64 {
    cones.iter().zip(steps).fold(most, |step, (pair, (ds, dz))| pair.z.reach(*dz, pair.s.reach(*ds, step)))
}
