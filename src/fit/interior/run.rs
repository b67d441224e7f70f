//! The interior-point method on the knots in play, which are found on the way.

mod descent;
mod newton_step;

use self::descent::Descent;
use super::cold::start;
use super::cone::{Lorentz, Metric, Scaling, dot, norm};
use super::dual::dual_curve;
use super::fixed_knots::Fixed;
use super::iterate::{Iterate, Measure, Middle, measure};
use super::settings::{GLIMPSE, Settings};
use crate::error::Result;
use crate::fit::convex::interval::TERMS;
use crate::fit::convex::scaled::Scaled;
use crate::fit::convex::solution::Status;
use crate::limits;
use crate::numerics::Vector;

/// The gap from which on the knots are looked for that stay.
const FIRST_FINISH: f64 = 1e-3;
/// The same for smooth splines on a grid that is finer than their knots: neighbours are told apart late.
const FIRST_FINE: f64 = 1e-5;
/// So many iterations more than the gap needs are made for true knots.
const MOST_FOR_KNOTS: usize = 4;
/// Below this share of the asked gap more iterations would tell no more.
const LEAST_FOR_KNOTS: f64 = 1e-4;

/// One run of the method, for jumps whose length is their price. Every iteration has a dual that is feasible on all
/// places for knots once it is scaled, so that the gap bounds how far the objective is from the optimum. One iteration
/// is O(M + N) and O(K) for the K knots in play. (D 12.4), (D 12.6).
#[derive(Clone, Debug)]
pub(crate) struct Run {
    pub(crate) data: Scaled,
    pub(crate) settings: Settings,
    pub(crate) iterate: Iterate,
    pub(crate) eta: Vec<Vec<Vector>>,
    pub(crate) weighted: Vec<Vector>,
    pub(crate) measure: Measure,
    pub(crate) middle: Option<Middle>,
    pub(crate) status: Status,
    pub(crate) iteration: usize,
    /// Whether every λ is 0.
    pub(crate) free: bool,
    /// The optimum on true knots, where the run has found it.
    pub(crate) finished: Option<Fixed>,
    /// Whether it was looked for at the iterate as it is, and not found.
    pub(crate) tried: bool,
    /// The gap below which to look for it again.
    next_finish: f64,
    /// Iterations since the asked gap was reached, on the way to true knots.
    beyond: usize,
    /// Whether this run has left out the knots that its first iterations brought in vain.
    thinned: bool,
    /// Jump and slack of every cone before the last step, when that was a long one.
    pub(crate) before: Vec<(f64, f64)>,
    /// Iterations since the gap last fell by a tenth, and the gap then.
    idle: (usize, f64),
    /// What goes on where rounding ended the iterations.
    pub(crate) descent: Option<Descent>,
    pub(crate) buffers: Buffers,
}

/// Memory that iterations share.
#[derive(Clone, Debug, Default)]
pub(crate) struct Buffers {
    scalings: Vec<Scaling>,
    metrics: Vec<Metric>,
    residual: Vec<Vector>,
    constants: Vec<Vector>,
    forces: Vec<Vector>,
    direction: Vec<Vector>,
    jump_direction: Vec<Vector>,
    steps: Vec<(Lorentz, Lorentz)>,
    complements: Vec<Lorentz>,
    line: Vec<f64>,
    known: Vec<Vector>,
    pub(crate) element_forces: Vec<[Vector; TERMS]>,
}

impl Run {
    /// Starts a run; `free` where every λ is 0.
    pub(super) fn new(data: Scaled, settings: Settings, free: bool) -> Result<Self> {
        let mut weighted = limits::with_room(data.t.len())?;
        weighted.resize(data.t.len(), Vector::zeros());
        let iterate = start(&data)?;
        let mut run = Self {
            eta: vec![Vec::new(); data.components.len()],
            data,
            settings,
            iterate,
            weighted,
            measure: Measure::default(),
            middle: None,
            status: Status::Running,
            iteration: 0,
            free,
            finished: None,
            tried: false,
            next_finish: FIRST_FINISH,
            beyond: 0,
            thinned: false,
            before: Vec::new(),
            idle: (0, f64::INFINITY),
            descent: None,
            buffers: Buffers::default(),
        };
        run.restart(false);
        if run.free {
            run.solve_for_free()?;
        }
        Ok(run)
    }

    /// A new run from the iterate as it is.
    pub(crate) fn restart(&mut self, warm: bool) {
        self.status = Status::Running;
        self.iteration = 0;
        // A warm start is thin already.
        self.thinned = warm;
        self.finished = None;
        self.tried = false;
        self.next_finish = FIRST_FINISH;
        self.beyond = 0;
        self.before.clear();
        self.idle = (0, f64::INFINITY);
        self.descent = None;
        self.look();
        self.settle();
    }

    /// One iteration; nothing when the run is over. Answers how it stands then.
    pub(super) fn step(&mut self) -> Result<Status> {
        if self.status != Status::Running {
            return Ok(self.status);
        }
        if let Some(descent) = self.descent.take() {
            return self.descend(descent);
        }
        if self.iteration >= self.settings.most_iterations {
            self.status = self.given_up(Status::IterationLimit);
            return Ok(self.status);
        }
        if !self.thinned && self.middle.is_some() {
            self.thinned = true;
            self.leave_knots_out()?;
        }
        self.tried = false;
        self.insert_knots()?;
        self.iteration += 1;
        let before = (self.iterate.unknowns.clone(), self.iterate.cones.clone(), self.measure);
        let moved = self.advance();
        self.look();
        if !moved || !self.measure.gap.is_finite() {
            // Rounding has the last word: back to the last good point.
            (self.iterate.unknowns, self.iterate.cones, self.measure) = before;
            self.iterate.reduced.jumps(&self.iterate.unknowns, &mut self.iterate.jumps);
            self.look();
            self.status = self.given_up(Status::Stalled);
        } else {
            self.settle();
            self.try_to_finish()?;
        }
        if self.status == Status::Converged {
            self.doubt()?;
        }
        if self.status == Status::Stalled || self.status == Status::Converged && !self.is_near() {
            self.begin_descent()?;
        }
        Ok(self.status)
    }

    /// How a run stands that ends before its knots are told apart.
    fn given_up(&self, why: Status) -> Status {
        if self.is_near() { Status::Converged } else { why }
    }

    /// Whether the gap is what was asked for.
    pub(super) fn is_near(&self) -> bool {
        self.measure.gap <= self.settings.gap
    }

    /// Whether there is one spline, without corners.
    fn is_smooth(&self) -> bool {
        matches!(&self.data.components[..], [component] if component.degree > 1)
    }

    /// Whether splines without corners could have their knots in many more places than there are some.
    pub(crate) fn is_fine(&self) -> bool {
        let smooth = self.data.components.iter().filter(|component| component.degree > 1);
        2 * self.knots_in_play() < smooth.map(|component| component.grid.len()).sum()
    }

    /// Whether the knots are not told apart: on fine grids that takes longer than a glimpse of the curve may.
    pub(crate) fn is_hurried(&self) -> bool {
        self.settings.gap >= GLIMPSE && self.data.components.iter().any(|component| component.degree > 1)
    }

    /// Where the knots may already be told apart, finds the optimum on them: when its own gap is small, that is the
    /// end.
    fn try_to_finish(&mut self) -> Result<()> {
        if self.is_hurried() {
            return Ok(());
        }
        // Two components couple widely on few knots: there it costs more than an iteration, and is tried later.
        let dear = if self.data.components.len() > 1 { 0.1 } else { 1.0 };
        let late = if self.is_smooth() && self.is_fine() {
            FIRST_FINE.max(self.settings.gap)
        } else {
            f64::INFINITY
        };
        if self.measure.gap > (dear * self.next_finish).min(late) || self.iteration == 0 {
            return Ok(());
        }
        // Beyond the asked gap nothing else is waited for.
        self.next_finish = if self.beyond > 0 { 0.7 } else { 0.1 } * self.measure.gap / dear;
        match self.polished(true)? {
            Some((fixed, eta)) if fixed.measure.gap <= self.settings.gap => self.end_with(fixed, eta),
            Some((fixed, _)) => self.tried = fixed.measure.gap > self.measure.gap,
            // Of two splines a trial ends early here; the last one, for the curve that is asked for, does not.
            None => self.tried = self.data.components.len() == 1,
        }
        Ok(())
    }

    /// The run is over with the optimum on true knots.
    pub(crate) fn end_with(&mut self, fixed: Fixed, eta: Vec<Vec<Vector>>) {
        self.measure = fixed.measure;
        self.eta = eta;
        self.finished = Some(fixed);
        self.status = Status::Converged;
    }

    /// How many knots are in play.
    pub(super) fn knots_in_play(&self) -> usize {
        self.iterate.reduced.parts.iter().map(|part| part.chosen.len()).sum()
    }

    /// Decides whether the run goes on, and remembers what a warm start will need.
    fn settle(&mut self) {
        let gap = self.measure.gap;
        if gap < 3e-2 && self.measure.longest < 1.02 && self.middle.is_none() {
            let parts = &self.iterate.reduced.parts;
            self.middle = Some(Middle {
                chosen: parts.iter().map(|part| part.chosen.clone()).collect(),
                jumps: self.iterate.jumps.clone(),
                cones: self.iterate.cones.clone(),
                eta: self.eta.clone(),
                lambdas: self.data.components.iter().map(|c| c.lambda).collect(),
                slack: self.measure.primal - self.measure.dual,
            });
        }
        if gap <= self.settings.gap {
            // The curve is good enough; its knots may still stand beside the true ones.
            let enough = self.beyond >= MOST_FOR_KNOTS || gap <= LEAST_FOR_KNOTS * self.settings.gap;
            let over = enough || self.is_hurried() || !self.is_smooth() || self.iteration == 0;
            self.beyond += 1;
            if over {
                self.status = Status::Converged;
            }
        } else if gap < 0.9 * self.idle.1 {
            self.idle = (0, gap);
        } else {
            self.idle.0 += 1;
            if self.idle.0 > 25 {
                self.status = Status::Stalled;
            }
        }
    }

    /// Residuals, dual curves, objective and bound at the iterate.
    pub(crate) fn look(&mut self) {
        let iterate = &self.iterate;
        let data_term = iterate.reduced.residuals(
            &self.data,
            &iterate.unknowns,
            &mut self.weighted,
            &mut self.buffers.element_forces,
        );
        let (mut regularizer, mut work, mut longest) = (0.0, 0.0, 0.0_f64);
        let mut knot = 0;
        for (i, part) in iterate.reduced.parts.iter().enumerate() {
            let component = &self.data.components[i];
            self.buffers.known.clear();
            for jump in &iterate.jumps[knot..knot + part.chosen.len()] {
                let pull = -iterate.cones[knot].z.plane;
                regularizer += component.lambda * norm(*jump);
                work += dot(pull, *jump);
                self.buffers.known.push(pull / component.lambda);
                knot += 1;
            }
            let known = &self.buffers.known;
            dual_curve(&self.data, component, &part.chosen, &self.weighted, known, &mut self.eta[i]);
            longest = self.eta[i].iter().fold(longest, |most, v| most.max(norm(*v)));
        }
        self.measure = measure(data_term, regularizer, work, longest);
    }
}
