//! The solver: a run of the method, or one for each coordinate.
//!
//! Where jumps are measured by |x| + |y| nothing joins the coordinates: the objective is the sum of two, each with
//! knots of its own. So each is solved for itself, as points on a line, and what comes out is one curve on all of their
//! knots. (D 12.15)

use super::compress::compress;
use super::cone::norm;
use super::fixed_knots::Fixed;
use super::iterate::Measure;
use super::reduced::{Part, Reduced, transfer};
use super::run::Run;
use super::settings::{LEAST_LAMBDA, Settings};
use crate::error::{Error, Result};
use crate::fit::convex::problem::{Norm, Problem};
use crate::fit::convex::scaled::Scaled;
use crate::fit::convex::solution::{Solution, Spline, Status};
use crate::limits;
use crate::numerics::Vector;
use crate::numerics::order::sort_in_place;

/// Solves a [`Problem`] step by step; λ may be changed between runs, which then start warm.
///
/// Every iteration has a dual that is feasible on all places for knots once it is scaled, so that [`Solver::gap`]
/// bounds how far the objective is from the optimum. Not reaching the asked gap is a status. One iteration is O(M + N)
/// and O(K) for the K knots in play. (D 12.4), (D 12.6).
#[derive(Clone, Debug)]
pub struct Solver {
    /// One, or one for x and one for y.
    runs: Vec<Run>,
}

impl Solver {
    /// Starts a run.
    ///
    /// # Errors
    ///
    /// As for [`Problem::check`], and `OutOfMemory`.
    pub fn new(problem: &Problem, settings: Settings) -> Result<Self> {
        problem.check()?;
        let mut data = Scaled::new(problem)?;
        compress(&mut data)?;
        for component in &mut data.components {
            component.lambda = component.lambda.max(LEAST_LAMBDA);
        }
        let free = problem.components.iter().all(|component| component.lambda <= 0.0);
        let mut runs = limits::with_room(2)?;
        if problem.norm == Norm::L1 {
            let mut other = data.clone();
            other.x.fill(0.0);
            // What compression left out is that of both: it is counted once.
            other.beyond = 0.0;
            data.y.fill(0.0);
            runs.push(Run::new(data, settings, free)?);
            data = other;
        }
        runs.push(Run::new(data, settings, free)?);
        Ok(Self { runs })
    }

    /// One iteration; nothing when the run is over. Answers how it stands then.
    ///
    /// # Errors
    ///
    /// `OutOfMemory` only.
    pub fn step(&mut self) -> Result<Status> {
        for run in &mut self.runs {
            let _ = run.step()?;
        }
        Ok(self.status())
    }

    /// Iterates until the run is over.
    ///
    /// # Errors
    ///
    /// `OutOfMemory` only.
    pub fn run(&mut self) -> Result<Status> {
        while self.step()? == Status::Running {}
        Ok(self.status())
    }

    /// Starts a new run for other λ of the components. Where the last one ended on true knots and these, or few others,
    /// are near enough to the new optimum already, the run ends at once, after no iteration. Otherwise it is warm where
    /// the last one came far enough: from an iterate on its way, with the knots that mattered there and at its end.
    ///
    /// # Errors
    ///
    /// `WrongLength`, `OutOfRange` for a λ not in 0 … 1e60, `OutOfMemory`; the last run stays as it is then.
    pub fn set_lambdas(&mut self, lambdas: &[f64]) -> Result<()> {
        let needed = self.data().components.len();
        if lambdas.len() != needed {
            return Err(Error::wrong_length("lambda", lambdas.len(), needed));
        }
        for (i, &lambda) in lambdas.iter().enumerate() {
            limits::check("lambda", Some(i), lambda, 0.0, limits::LARGEST_LAMBDA)?;
        }
        self.runs.iter_mut().try_for_each(|run| run.set_lambdas(lambdas))
    }

    /// A run for other λ from nothing, as that of a new solver: only what was made of the points is kept.
    pub(crate) fn anew(self, lambdas: &[f64]) -> Result<Self> {
        let free = lambdas.iter().all(|lambda| *lambda <= 0.0);
        let again = |mut run: Run| {
            run.take_lambdas(lambdas);
            Run::new(run.data, run.settings, free)
        };
        Ok(Self { runs: self.runs.into_iter().map(again).collect::<Result<_>>()? })
    }

    /// How the run stands.
    pub fn status(&self) -> Status {
        match &self.runs[..] {
            [run] => run.status,
            runs => stands(runs.iter().map(|run| run.status), self.gap() <= runs[0].settings.gap),
        }
    }

    /// Iterations of this run.
    pub fn iterations(&self) -> usize {
        self.runs.iter().map(|run| run.iteration).fold(0, usize::max)
    }

    /// The relative duality gap: (objective − bound)/objective.
    pub fn gap(&self) -> f64 {
        self.measure().gap
    }

    /// The objective at the iterate, in the caller's units.
    pub fn objective(&self) -> f64 {
        self.measure().primal * self.data().objective_factor()
    }

    /// How many knots are in play.
    pub fn knots_in_play(&self) -> usize {
        self.runs.iter().map(Run::knots_in_play).sum()
    }

    /// The curve that the run has come to, on its true knots; the run can go on afterwards. Its gap is its own, and at
    /// most that of the run.
    ///
    /// # Errors
    ///
    /// `OutOfMemory` only.
    pub fn solution(&self) -> Result<Solution> {
        self.answer(Run::best)
    }

    /// The curve of [`Solver::solution`] after exchanges of jumps that change neither residuals nor objective: at most
    /// as many knots are left as the samples can tell apart. On a grid that is not finer than the samples the optimum
    /// is unique, and nothing changes. O(K) for each knot that goes. (D 12.12)
    ///
    /// # Errors
    ///
    /// `OutOfMemory` only.
    pub fn extreme(&self) -> Result<Solution> {
        self.answer(Run::extreme)
    }

    fn answer(&self, of_run: impl Fn(&Run) -> Result<Fixed>) -> Result<Solution> {
        let mut found = limits::with_room(2)?;
        for run in &self.runs {
            found.push(of_run(run)?);
        }
        let both = match &found[..] {
            [x, y] => Some(joined(self.data(), [x, y])?),
            _ => None,
        };
        Ok(self.in_units_of_the_caller(both.as_ref().unwrap_or(&found[0])))
    }

    /// Both runs are on the same places.
    fn data(&self) -> &Scaled {
        &self.runs[0].data
    }

    fn measure(&self) -> Measure {
        match &self.runs[..] {
            [x, y] => sum([&x.measure, &y.measure]),
            runs => runs[0].measure,
        }
    }

    fn in_units_of_the_caller(&self, fixed: &Fixed) -> Solution {
        let data = self.data();
        let factor = data.objective_factor();
        let free = self.runs[0].free;
        let alone = self.runs.len() == 1;
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
            let lambda = if free { 0.0 } else { component.lambda / data.lambda_factor(component.degree) };
            let size = |v: &Vector| if alone { norm(*v) } else { v.x.abs() + v.y.abs() };
            regularizers.push(lambda * jumps.iter().map(size).sum::<f64>());
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
        let status = self.status();
        let reached = fixed.measure.gap <= self.runs[0].settings.gap;
        Solution {
            components,
            domain: (data.start, data.start + data.length * data.step, data.closed),
            objective: fixed.measure.primal * factor,
            data_term: fixed.measure.data_term * factor,
            regularizers,
            gap: fixed.measure.gap.max(0.0),
            // A run that ended early may have come to a curve that, on its true knots, is near enough.
            status: if status != Status::Running && reached { Status::Converged } else { status },
            iterations: self.iterations(),
        }
    }
}

/// How two runs stand together, of which the sum is near the optimum or not.
fn stands(of: impl Iterator<Item = Status> + Clone, near: bool) -> Status {
    let any = |status: Status| of.clone().any(|own| own == status);
    if any(Status::Running) {
        Status::Running
    } else if near || of.clone().all(|own| own == Status::Converged) {
        Status::Converged
    } else if any(Status::IterationLimit) {
        Status::IterationLimit
    } else {
        Status::Stalled
    }
}

/// Objective and bound of two problems as one: both are sums.
fn sum([x, y]: [&Measure; 2]) -> Measure {
    let primal = x.primal + y.primal;
    // Of each its own, with what was added where a bound is in doubt.
    let missing = x.gap * x.primal + y.gap * y.primal;
    Measure {
        data_term: x.data_term + y.data_term,
        primal,
        dual: x.dual + y.dual,
        longest: x.longest.max(y.longest),
        gap: if primal > 0.0 { missing / primal } else { 0.0 },
    }
}

/// The curve whose coordinates are those of two: on the knots of both, where each jumps at its own only.
fn joined(data: &Scaled, [x, y]: [&Fixed; 2]) -> Result<Fixed> {
    let both = |(x, y): (&Part, &Part)| {
        let mut all = x.chosen.clone();
        all.extend_from_slice(&y.chosen);
        sort_in_place(&mut all);
        all.dedup();
        all
    };
    let chosen = x.reduced.parts.iter().zip(&y.reduced.parts).map(both).collect();
    let mut reduced = Reduced::new(data, chosen, &x.reduced.elements)?;
    let of_x = transfer(&x.reduced, &mut reduced, &x.unknowns);
    let of_y = transfer(&y.reduced, &mut reduced, &y.unknowns);
    let (mut jumps, mut from) = (Vec::new(), [0, 0]);
    for (i, part) in reduced.parts.iter().enumerate() {
        let own = [&x.reduced.parts[i].chosen, &y.reduced.parts[i].chosen];
        let at = |of: usize, place: &usize| own[of].binary_search(place).ok().map(|k| from[of] + k);
        for place in &part.chosen {
            jumps.push(Vector::new(
                at(0, place).map_or(0.0, |k| x.jumps[k].x),
                at(1, place).map_or(0.0, |k| y.jumps[k].y),
            ));
        }
        from = [from[0] + own[0].len(), from[1] + own[1].len()];
    }
    let unknowns = of_x.iter().zip(&of_y).map(|(x, y)| Vector::new(x.x, y.y)).collect();
    Ok(Fixed { reduced, unknowns, jumps, measure: sum([&x.measure, &y.measure]) })
}
