//! A new run from what the last one left behind, for another λ.

use super::cold::start;
use super::cone::{Lorentz, Metric, Scaling, dot, norm, stretch};
use super::dual::maxima;
use super::iterate::{Iterate, Middle, Pair};
use super::reduced::Reduced;
use super::run::Run;
use super::settings::LEAST_LAMBDA;
use crate::error::Result;
use crate::numerics::Vector;
use crate::numerics::order::sort_in_place;
use crate::numerics::plane::{larger, smaller};

/// What a knot brings into a new run.
struct Seed {
    place: usize,
    jump: Vector,
    pull: Vector,
    metric: Metric,
}

impl Run {
    /// Starts a new run for other λ of the components. Where the last one ended on true knots and these, or few others,
    /// are near enough to the new optimum already, the run ends at once, after no iteration. Otherwise it is warm where
    /// the last one came far enough: from an iterate on its way, with the knots that mattered there and at its end.
    pub(crate) fn set_lambdas(&mut self, lambdas: &[f64]) -> Result<()> {
        self.take_lambdas(lambdas);
        let free = lambdas.iter().all(|lambda| *lambda <= 0.0);
        let followed = if free || self.free { None } else { self.followed()? };
        self.free = free;
        if let Some((fixed, eta)) = followed {
            self.iteration = 0;
            self.end_with(fixed, eta);
            self.doubt()?;
            if self.is_near() {
                return Ok(());
            }
        }
        self.iterate = match &self.middle {
            Some(middle) => self.warm(middle)?,
            None => start(&self.data)?,
        };
        let warm = self.middle.take().is_some();
        self.restart(warm);
        if self.free { self.solve_for_free() } else { Ok(()) }
    }

    /// λ of the components, in the units of the run.
    pub(super) fn take_lambdas(&mut self, lambdas: &[f64]) {
        for (i, &lambda) in lambdas.iter().enumerate() {
            let scaled = lambda * self.data.lambda_factor(self.data.components[i].degree);
            self.data.components[i].lambda = scaled.max(LEAST_LAMBDA);
        }
    }

    /// Goes on with the knots that still matter, where those are much fewer than the knots in play.
    pub(crate) fn leave_knots_out(&mut self) -> Result<()> {
        let Some(middle) = &self.middle else { return Ok(()) };
        let iterate = self.warm(middle)?;
        if 4 * iterate.cones.len() < 3 * self.iterate.cones.len() {
            self.iterate = iterate;
            self.look();
        }
        Ok(())
    }

    /// A stationary point on the knots that mattered: a step of the quadratic model from the iterate remembered.
    fn warm(&self, middle: &Middle) -> Result<Iterate> {
        let mut seeds: Vec<Vec<Seed>> = Vec::new();
        let mut knot = 0;
        for (i, component) in self.data.components.iter().enumerate() {
            seeds.push(self.seeds(middle, i, knot, component.lambda / middle.lambdas[i]));
            knot += middle.chosen[i].len();
        }
        let chosen = seeds.iter().map(|set| set.iter().map(|seed| seed.place).collect()).collect();
        let mut reduced = Reduced::new(&self.data, chosen, &self.iterate.reduced.elements)?;
        let all: Vec<&Seed> = seeds.iter().flatten().collect();
        let metrics: Vec<Metric> = all.iter().map(|seed| seed.metric).collect();
        let _ = reduced.factor(&metrics);
        let forces: Vec<Vector> =
            all.iter().map(|seed| seed.pull + stretch(&seed.metric, seed.jump)).collect();
        let mut unknowns = reduced.linear.clone();
        reduced.pull(&forces, &mut unknowns);
        reduced.solve(&mut unknowns, &mut Vec::new());
        let mut jumps = Vec::new();
        reduced.jumps(&unknowns, &mut jumps);
        // Stationary with the forces that the model leaves.
        let (mut total, mut count) = (0.0, 0.0_f64);
        let mut pulls = Vec::new();
        let mut knot = 0;
        for (i, set) in seeds.iter().enumerate() {
            for _ in set {
                let pull = forces[knot] - stretch(&metrics[knot], jumps[knot]);
                total += self.data.components[i].lambda * norm(jumps[knot]) + dot(pull, jumps[knot]);
                count += 1.0;
                pulls.push(pull);
                knot += 1;
            }
        }
        let mean = (total / count.max(1.0)).max(middle.slack / count.max(1.0)).max(f64::MIN_POSITIVE);
        let mut cones = Vec::new();
        let mut knot = 0;
        for (i, set) in seeds.iter().enumerate() {
            let lambda = self.data.components[i].lambda;
            for _ in set {
                cones.push(pair(lambda, pulls[knot], jumps[knot], mean));
                knot += 1;
            }
        }
        Ok(Iterate { reduced, unknowns, jumps, cones })
    }

    /// The number of the first knot in play of part i.
    fn first_knot(&self, i: usize) -> usize {
        self.iterate.reduced.parts[..i].iter().map(|part| part.chosen.len()).sum()
    }

    /// The knots of one component for a new run, with their jumps, forces and stiffnesses.
    fn seeds(&self, middle: &Middle, i: usize, from: usize, ratio: f64) -> Vec<Seed> {
        let (eta, old) = (&middle.eta[i], &middle.chosen[i]);
        let closed = self.data.closed;
        let mut set = maxima(eta, closed, 0.9);
        set.extend(maxima(&self.eta[i], closed, 0.9));
        match &self.finished {
            Some(fixed) => set.extend(&fixed.reduced.parts[i].chosen),
            None => set.extend(self.active(i, self.first_knot(i)).into_iter().map(|(place, _)| place)),
        }
        // A closed dual curve needs more known values than its degree; an open one is better with some.
        let least = self.data.components[i].degree + 3;
        let places = self.data.components[i].grid.len();
        if set.len() < 2 * least {
            set.extend((0..least.min(places)).map(|k| k * places / least.min(places)));
        }
        sort_in_place(&mut set);
        set.dedup();
        let lambda = middle.lambdas[i];
        let typical = middle.slack / middle.cones.len().max(1) as f64;
        let force_ratio = ratio.min(1.0);
        set.into_iter()
            .map(|place| {
                let pull = eta[place] * (-lambda * force_ratio);
                let known = old.binary_search(&place);
                let jump = known.map_or_else(|_| Vector::zeros(), |k| middle.jumps[from + k]);
                let pair = known.map_or_else(
                    |_| pair(lambda, pull, Vector::zeros(), typical),
                    |k| middle.cones[from + k],
                );
                Seed { place, jump, pull, metric: Scaling::new(pair.s, pair.z).metric() }
            })
            .collect()
    }
}

/// A point in both cones for a force, a jump and a complementarity to be near.
fn pair(lambda: f64, pull: Vector, jump: Vector, mean: f64) -> Pair {
    let length = norm(pull);
    let height = lambda.max(length / 0.97);
    let wish = mean * height / ((height - length) * (height + length));
    let square = dot(jump, jump);
    let reach = |times: f64| (square + (times * mean / height) * (times * mean / height)).sqrt();
    let s = Lorentz::new(smaller(larger(wish, reach(1.0)), reach(20.0)), jump);
    Pair { s, z: Lorentz::new(height, pull), lambda }
}
