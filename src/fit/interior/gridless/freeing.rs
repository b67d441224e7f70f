//! The way off the grid in rounds: each finds one optimum on given knots, takes one look at the dual curve, or makes
//! one system.

use super::gap::Measuring;
use super::newton::Newton;
use super::{Gridless, merge, on_knots, residual_forces, slide, solved, step_of, together, with_violators};
use crate::error::Result;
use crate::fit::convex::certificate::{Integral, Sweep};
use crate::fit::convex::problem::{Component, Norm, Problem};
use crate::fit::convex::solution::Solution;
use crate::numerics::Vector;

/// Past so many samples one round goes.
const SAMPLES: usize = 20_000;

/// How often a step is damped.
const MOST_TRIALS: usize = 4;
/// More knots than this do not slide: the system is dense.
const MOST_SLIDING: usize = 300;

/// What is done to the knots.
#[derive(Clone, Copy, Debug)]
enum Task {
    /// Neighbours of like jumps are joined.
    Join,
    /// All slide until the gap is `target`, at most so often.
    Slide { target: f64, most: usize },
}

/// A solution whose knots leave the grid, round by round.
#[derive(Clone, Debug)]
pub(in crate::fit) struct Freeing {
    task: Task,
    best: Gridless,
    /// What is to be done next.
    next: Next,
    damping: f64,
}

#[derive(Clone, Debug)]
enum Next {
    Begin,
    /// The model for a step of all knots.
    Build(Box<Newton>),
    /// A step of the knots, which was damped so often.
    Try(Box<Newton>, usize),
    /// A look at the dual curve for knots that are missing: its vector, places, how far it is.
    Add(Vec<Vector>, Vec<f64>, Box<Sweep>),
    /// Jumps measured by |x| + |y|: each coordinate for itself, on knots of its own.
    Apart(Box<Apart>),
    /// The gap of the best.
    Measure(Box<Measuring>),
    Done,
}

impl Next {
    fn measure() -> Self {
        Self::Measure(Box::new(Measuring::new()))
    }
}

/// One coordinate after the other. (D 12.15)
#[derive(Clone, Debug)]
struct Apart {
    found: Vec<Gridless>,
    /// The coordinate that is under way, alone.
    own: Option<(Problem, Freeing)>,
}

impl Freeing {
    /// Joins neighbours of like jumps: the optimum on what is left of the knots, where that costs little.
    pub(in crate::fit) fn joining(solution: &Solution) -> Self {
        let best = Gridless { gap: f64::INFINITY, solution: solution.clone(), slides: 0 };
        Self { task: Task::Join, best, next: Next::Begin, damping: 1e-9 }
    }

    /// Slides all knots until the gap is `target`, at most so often.
    pub(in crate::fit) fn sliding(best: Gridless, target: f64, most: usize) -> Self {
        Self { task: Task::Slide { target, most }, best, next: Next::Begin, damping: 1e-9 }
    }

    /// All rounds.
    pub(in crate::fit) fn run(mut self, problem: &Problem) -> Result<Gridless> {
        while !self.round(problem)? {}
        Ok(self.best)
    }

    /// What was found.
    pub(in crate::fit) fn found(self) -> Gridless {
        self.best
    }

    /// One round; answers whether it was the last.
    pub(in crate::fit) fn round(&mut self, problem: &Problem) -> Result<bool> {
        self.next = match core::mem::replace(&mut self.next, Next::Done) {
            Next::Begin => self.begin(problem)?,
            Next::Build(mut newton) => {
                let whole = newton.round(problem, &self.best.solution, SAMPLES)?;
                if whole { Next::Try(newton, 0) } else { Next::Build(newton) }
            }
            Next::Try(newton, trials) => self.attempt(problem, newton, trials)?,
            Next::Add(v, places, sweep) => self.add(problem, v, places, sweep)?,
            Next::Apart(apart) => self.apart(problem, apart)?,
            Next::Measure(mut measuring) => match measuring.round(problem, &self.best.solution, SAMPLES)? {
                None => Next::Measure(measuring),
                Some(gap) => {
                    self.best.gap = gap;
                    let slides = matches!(self.task, Task::Slide { .. }) && problem.norm == Norm::L2;
                    if slides { Next::Begin } else { Next::Done }
                }
            },
            Next::Done => Next::Done,
        };
        Ok(matches!(self.next, Next::Done))
    }

    /// Whether the knots may leave the grid.
    fn may_leave(&self, problem: &Problem) -> bool {
        let (degree, count) = (problem.components.first(), self.best.solution.components.first());
        problem.components.len() == 1
            && degree.is_some_and(|component| component.degree > 1)
            && count.is_some_and(|spline| spline.knots.len() <= MOST_SLIDING)
    }

    fn begin(&mut self, problem: &Problem) -> Result<Next> {
        if !self.may_leave(problem) {
            return Ok(if matches!(self.task, Task::Join) { Next::measure() } else { Next::Done });
        }
        if problem.norm == Norm::L1 {
            return Ok(Next::Apart(Box::new(Apart { found: Vec::new(), own: None })));
        }
        match self.task {
            Task::Join => self.join(problem),
            Task::Slide { target, most } if self.best.slides < most && self.best.gap > target => {
                self.best.slides += 1;
                if self.best.solution.components[0].knots.is_empty() {
                    return self.look(problem);
                }
                Ok(Next::Build(Box::new(Newton::new(problem, &self.best.solution))))
            }
            Task::Slide { .. } => Ok(Next::Done),
        }
    }

    fn join(&mut self, problem: &Problem) -> Result<Next> {
        let (component, spline) = (&problem.components[0], &self.best.solution.components[0]);
        let step = (problem.end - problem.start) / component.grid.len().max(1) as f64;
        let joined = on_knots(problem, &merge(&spline.knots, &spline.jumps, step))?;
        // Joining may cost a little, which sliding then wins back.
        if let Some(joined) = joined.filter(|joined| joined.objective <= 1.001 * self.best.solution.objective)
        {
            self.best.solution = joined;
        }
        Ok(Next::measure())
    }

    /// The knots a step further, or the step damped more; where nothing helps, more knots.
    fn attempt(&mut self, problem: &Problem, newton: Box<Newton>, trials: usize) -> Result<Next> {
        if let Some(slid) = slide(problem, &self.best.solution, &newton, self.damping)? {
            self.damping = (self.damping * 0.05).max(1e-12);
            self.best.solution = slid;
            return Ok(Next::measure());
        }
        self.damping = (self.damping * 100.0).max(1e-6);
        if trials + 1 < MOST_TRIALS { Ok(Next::Try(newton, trials + 1)) } else { self.look(problem) }
    }

    /// Begins to look for knots where the dual curve is too long.
    fn look(&self, problem: &Problem) -> Result<Next> {
        let count = problem.points.len() * 2;
        let step = step_of(problem, count);
        let places: Vec<f64> = (0..count).map(|i| problem.start + step * (i as f64 + 0.5)).collect();
        let v = residual_forces(problem, &self.best.solution)?;
        Ok(Next::Add(v, places, Box::new(Sweep::new(problem, count)?)))
    }

    /// Looks on; adds them, if there are any.
    fn add(
        &mut self,
        problem: &Problem,
        v: Vec<Vector>,
        places: Vec<f64>,
        mut sweep: Box<Sweep>,
    ) -> Result<Next> {
        let Component { degree, lambda, .. } = problem.components[0];
        if !sweep.round(&Integral { problem, degree, lambda, v: &v }, &places, SAMPLES) {
            return Ok(Next::Add(v, places, sweep));
        }
        let Some(more) = with_violators(problem, &self.best.solution, &places, sweep.values)? else {
            return Ok(Next::Done);
        };
        self.best.solution = more;
        Ok(Next::measure())
    }

    fn apart(&mut self, problem: &Problem, mut apart: Box<Apart>) -> Result<Next> {
        match &mut apart.own {
            Some((alone, own)) => {
                if own.round(alone)? {
                    apart.found.extend(apart.own.take().map(|(_, own)| own.found()));
                }
            }
            None if apart.found.len() < 2 => apart.own = Some(self.alone(problem, apart.found.len())?),
            None => {
                let [x, y] = [&apart.found[0], &apart.found[1]];
                self.best.solution = together(&x.solution, &y.solution)?;
                self.best.slides += x.slides.max(y.slides);
                return Ok(Next::measure());
            }
        }
        Ok(Next::Apart(apart))
    }

    /// The problem of one coordinate, and its optimum on the knots at which that jumps.
    fn alone(&self, problem: &Problem, axis: usize) -> Result<(Problem, Self)> {
        let mut alone = Problem { norm: Norm::L2, ..problem.clone() };
        alone.points.iter_mut().for_each(|point| point[1 - axis] = 0.0);
        let spline = &self.best.solution.components[0];
        let jumping = spline.knots.iter().zip(&spline.jumps).filter(|(_, jump)| jump[axis] != 0.0);
        let knots: Vec<f64> = jumping.map(|(knot, _)| *knot).collect();
        let own = match on_knots(&alone, &knots)? {
            Some(own) => own,
            // Too few for a problem of their own: that on the grid.
            None => solved(&alone)?,
        };
        let best = Gridless { gap: f64::INFINITY, solution: own, slides: 0 };
        let next = if matches!(self.task, Task::Join) { Next::Begin } else { Next::measure() };
        Ok((alone, Self { task: self.task, best, next, damping: 1e-9 }))
    }
}
