//! The one door to fits: points in, a curve out, in steps that a caller can show, hurry or stop.

mod asking;
mod description;
mod finishing;

use self::asking::Purpose;
use self::description::best_of;
use self::finishing::Finishing;
use super::convex::problem::{Component, Problem, interpolating_grid, uniform_grid};
use super::convex::solution::Status;
use super::corners::corners;
use super::interior::settings::{GLIMPSE, Settings};
use super::interior::solver::Solver;
use super::knots::free_knots::Located;
use super::knots::sparsest::{Aim, Plan, Sparsest};
use super::noise::levels;
use super::options::{Ask, Finish, Options};
use super::outcome::Fit;
use super::parametrise::Parametrisation;
use super::report;
use super::samples::{PER_POINT, Samples};
use super::smooth::is_smooth;
use crate::error::{Error, Result};
use crate::limits::{self, LARGEST_LAMBDA};
use crate::numerics::Point;
use crate::numerics::order::{sort_by_number, sort_numbers};

/// So many iterations the solver has, where nobody says how many.
const MOST_ITERATIONS: usize = 400;
/// More points than this are not fitted a second time with knots that all count twice.
const MOST_TWICE: usize = 2000;
/// More points than this have a curve through them only on a grid that is asked for.
const MOST_THROUGH: usize = 50_000;

/// Whether a mean square may be asked for: the bindings of the package never do.
const BY_SQUARES: bool = !cfg!(feature = "wasm-fit");

/// How far a run has come.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// Whether it has ended.
    pub done: bool,
    /// Iterations of the solver, or rounds of the search.
    pub iteration: usize,
    /// The relative duality gap; infinite while there is none.
    pub gap: f64,
}

/// What is being computed.
#[derive(Clone, Debug)]
enum Run {
    Idle,
    Convex(Box<Solver>),
    /// The convex problem is solved; its knots are being finished.
    Finish(Box<Finishing>),
    /// Searches of which the cheapest will be kept once their needless knots are gone, and others to go to their end.
    Choice(Vec<Sparsest>, Vec<Sparsest>),
    /// The search that is going on is the last one.
    Search(Vec<Sparsest>),
}

/// Fits the same points again and again: to other λ, another smoothing, another tolerance.
///
/// [`Fitter::ask`] starts a run, [`Fitter::step`] takes it further, [`Fitter::fit`] gives the best curve so far. What is asked
/// before changes no bit of what is found, unless a gap of 1e-3 or more is enough: then a run for λ or a smoothing starts where
/// the last one ended, and agrees within the gap.
#[derive(Clone, Debug)]
pub struct Fitter {
    options: Options,
    samples: Samples,
    /// By the parametrisation that the ask wants.
    located: Located,
    /// The numbers that the samples have there, where others are between them; else empty.
    own: Vec<u32>,
    /// What for; `None` before the first.
    located_for: Option<Purpose>,
    /// Whether points follow one another so evenly that their index is their parameter.
    even: bool,
    end: f64,
    /// One unit of the inner parameter in the caller's.
    unit: f64,
    noise: f64,
    /// The same as far as it is noise: corners look like it.
    level: f64,
    /// How far points scatter across and along the curve, where that has been looked at.
    levels: Option<[f64; 2]>,
    ask: Ask,
    lambdas: Vec<f64>,
    run: Run,
    /// Rounds of the search so far.
    rounds: usize,
    problem: Option<Problem>,
    /// Whether its grid lets the curve through the points.
    through: bool,
    /// The solver of the last λ, for the next one: for what is made of the points, or for its curve as well.
    warm: Option<Box<Solver>>,
}

/// Fits a curve to points; see [`Fitter`] for the same in steps.
///
/// # Errors
///
/// As [`Fitter::new`] and [`Fitter::ask`].
pub fn fit(points: &[Point], ask: Ask, options: &Options) -> Result<Fit> {
    let mut fitter = Fitter::new(points, options)?;
    fitter.ask(ask)?;
    while !fitter.step(1e6)?.done {}
    fitter.fit()
}

/// Fits several contours, with one noise level for all: the median of what each alone would say, unless given.
///
/// # Errors
///
/// As [`fit`], for the first contour that has one.
pub fn fit_all(contours: &[Vec<Point>], ask: &Ask, options: &Options) -> Result<Vec<Fit>> {
    let mut options = options.clone();
    if options.noise.is_none() {
        let mut levels = Vec::new();
        for points in contours {
            levels.push(Fitter::new(points, &options)?.noise());
        }
        sort_numbers(&mut levels);
        options.noise = levels.get(levels.len() / 2).copied();
    }
    contours.iter().map(|points| fit(points, ask.clone(), &options)).collect()
}

impl Fitter {
    /// Checks points and options, finds the noise; nothing is fitted yet. O(M log M).
    ///
    /// # Errors
    ///
    /// Those of [`Samples::new`]; degrees that are not one or two ascending numbers from 1 to 5; parameters that decrease;
    /// lists of the wrong length; numbers out of their range; `OutOfMemory`.
    pub fn new(points: &[Point], options: &Options) -> Result<Self> {
        options.check(points.len())?;
        limits::probe(points.len().saturating_mul(PER_POINT))?;
        let keep = !options.parameters.is_empty()
            || !options.weights.is_empty()
            || options.parametrisation == Parametrisation::Index;
        let mut samples = Samples::new(points, options.closed, keep)?;
        if !options.weights.is_empty() {
            samples.weights.clone_from(&options.weights);
        }
        let levels = options.noise.is_none().then(|| levels(&samples));
        let noise = match (options.noise, levels) {
            (Some(noise), _) => noise / samples.scale,
            (None, levels) => levels.map_or(0.0, |[across, _]| across),
        };
        Ok(Self {
            options: options.clone(),
            samples,
            located: Located::default(),
            own: Vec::new(),
            located_for: None,
            even: false,
            end: 0.0,
            unit: 1.0,
            noise,
            level: noise,
            levels,
            ask: Ask::Noise,
            lambdas: Vec::new(),
            run: Run::Idle,
            rounds: 0,
            problem: None,
            through: false,
            warm: None,
        })
    }

    /// The standard deviation of the noise, in the unit of the points: as given or as found.
    pub fn noise(&self) -> f64 {
        self.noise * self.samples.scale
    }

    /// Whether the curve is closed: as given or as found.
    pub fn is_closed(&self) -> bool {
        self.samples.closed
    }

    fn solve(&mut self) -> Result<()> {
        let factor = |degree: usize| libm::pow(self.unit, -(degree as f64)) / self.samples.scale;
        let degrees = &self.options.degrees;
        let closed = self.samples.closed;
        let count = self.located.points.len();
        // On a grid that is finer than the points nothing says where knots are to be that cost nothing.
        let coarse = self.options.grid_size.filter(|size| !(self.is_free() && *size > count));
        let through = self.is_free() && coarse.is_none() && count <= MOST_THROUGH;
        let size = |degree: usize| {
            let chosen = if degree == 1 { count.min(5000) } else { count.min(2000) };
            coarse.unwrap_or(chosen).max(degree + 2)
        };
        let lambdas: Vec<f64> =
            degrees.iter().zip(&self.lambdas).map(|(&d, l)| (l * factor(d)).min(LARGEST_LAMBDA)).collect();
        let grid = |degree: usize| {
            let places = if through {
                interpolating_grid(degree, &self.located.parameters, 0.0, self.end, closed)
            } else {
                Vec::new()
            };
            // Too few different parameters leave an even grid.
            if places.len() >= degree + 2 {
                places
            } else {
                uniform_grid(degree, size(degree), 0.0, self.end, closed)
            }
        };
        let same = through == self.through && !through;
        self.through = through;
        if let Some(mut solver) = self.warm.take()
            && same
        {
            // What is to be seen at once begins where the last curve ended; what is to stay is the same whatever came before.
            if self.options.gap >= GLIMPSE {
                solver.set_lambdas(&lambdas)?;
            } else {
                *solver = solver.anew(&lambdas)?;
            }
            if let Some(problem) = &mut self.problem {
                problem.components.iter_mut().zip(&lambdas).for_each(|(c, &lambda)| c.lambda = lambda);
            }
            self.run = Run::Convex(solver);
            return Ok(());
        }
        let components = degrees
            .iter()
            .zip(&lambdas)
            .map(|(&degree, &lambda)| Component { degree, lambda, grid: grid(degree) })
            .collect();
        let problem = Problem {
            points: self.located.points.clone(),
            parameters: self.located.parameters.clone(),
            weights: self.located.weights.clone(),
            start: 0.0,
            end: self.end,
            closed,
            components,
            norm: self.options.norm,
        };
        let most_iterations = self.options.most_iterations.unwrap_or(MOST_ITERATIONS);
        let settings = Settings { gap: self.options.gap, most_iterations };
        self.run = Run::Convex(Box::new(Solver::new(&problem, settings)?));
        self.problem = Some(problem);
        Ok(())
    }

    #[inline(never)]
    fn search(&mut self, aim: Aim, cornered: bool) -> Result<()> {
        let degree = self.options.degrees.last().copied().unwrap_or(3);
        let sharpest = match aim {
            Aim::Squares(_) => 1,
            _ if cornered => degree,
            _ => (degree - 1).max(1),
        };
        let plan = |smoothest: usize| Plan {
            degree,
            sharpest,
            smoothest,
            closed: self.samples.closed,
            least_turn: self.options.least_turn,
            end: self.end,
            spaced: self.even,
            free: false,
            timed: !self.options.parameters.is_empty(),
        };
        if self.own.is_empty() && self.located_for == Some(Purpose::Clicks) {
            let smooth = Plan { sharpest: degree - 1, ..plan(1) };
            let corners = corners(&self.samples);
            let search =
                Sparsest::between_corners(self.located.copied()?, smooth, aim, self.level, &corners)?;
            self.run = Run::Search(vec![search]);
            return Ok(());
        }
        let start = |located: &Located, smoothest| -> Result<Sparsest> {
            Ok(Sparsest::new(located.copied()?, plan(smoothest), aim, self.level))
        };
        // Knots that all count twice often get by with fewer of them.
        let mut others = Vec::new();
        if matches!(aim, Aim::Tolerance(_)) && sharpest > 1 && self.located.points.len() <= MOST_TWICE {
            others.push(start(&self.located, 2)?);
        }
        // Points are free to slide while smooth knots are thinned out; where they are even they are placed along the curve then.
        let free = degree > 1 && matches!(aim, Aim::Noise(_));
        let smooth = Plan { free, ..plan(1) };
        let mut rivals = vec![Sparsest::new(self.located.copied()?, smooth, aim, self.level)];
        if cornered {
            let corners = Sparsest::from_corners(self.located.copied()?, plan(1), aim, self.level)?;
            let few = self.located.points.len() <= MOST_TWICE || aim.is_fine();
            let apart = matches!(aim, Aim::Tolerance(_)) && few;
            if apart { others.extend(corners) } else { rivals.extend(corners) }
        }
        self.run = Run::Choice(rivals, others);
        Ok(())
    }

    /// Takes the run further by about `budget` microseconds' worth of work, at least by one round.
    ///
    /// A round is a few passes over the points: of 400,000 points of a noisy circle .15 s at most where λ is given, natively.
    /// Where a search ends with straight pieces the last round takes longer, .3 s for so many, and 1.3 s where a tolerance is
    /// far below the noise. [`Fitter::fit`] then takes as long as every point needs to find its foot, .1 to .7 s.
    ///
    /// # Errors
    ///
    /// `OutOfMemory` only.
    pub fn step(&mut self, budget: f64) -> Result<Progress> {
        let round = 0.05 * self.samples.points.len() as f64 + 20.0;
        let mut left = budget;
        loop {
            let progress = self.round()?;
            left -= round;
            if progress.done || left <= 0.0 {
                return Ok(progress);
            }
        }
    }

    /// Whether the search has made all the rounds that it may make.
    fn is_spent(&self) -> bool {
        self.options.most_iterations.is_some_and(|most| self.rounds >= most)
    }

    fn round(&mut self) -> Result<Progress> {
        let (mut done, mut iteration, mut gap) = (true, 0, f64::INFINITY);
        let spent = self.is_spent();
        match &mut self.run {
            Run::Idle => {}
            Run::Choice(..) | Run::Search(_) if spent => iteration = self.rounds,
            Run::Convex(solver) => {
                done = solver.step()? != Status::Running;
                (iteration, gap) = (solver.iterations(), solver.gap());
                let finish = self.options.finish != Finish::default();
                if done && finish && !self.lambdas.iter().all(|lambda| *lambda <= 0.0) {
                    self.run = Run::Finish(Box::new(Finishing::new(solver.clone())?));
                    done = false;
                }
            }
            Run::Finish(_) => {
                let run = core::mem::replace(&mut self.run, Run::Idle);
                if let Run::Finish(mut finishing) = run {
                    (iteration, gap) = (finishing.solver.iterations(), finishing.solver.gap());
                    let over = self.finish(&mut finishing);
                    self.run = Run::Finish(finishing);
                    done = over?;
                }
            }
            Run::Search(searches) => {
                if let Some(next) = searches.iter().position(|search| !search.is_done()) {
                    searches[next].step();
                    self.rounds += 1;
                    done = next + 1 == searches.len() && searches[next].is_done();
                }
                iteration = self.rounds;
                if done && searches.iter().all(|search| search.missed().is_some()) {
                    done = searches[0].resort_to_polyline()?;
                }
                if BY_SQUARES
                    && done
                    && searches.len() == 1
                    && let Some(search) = searches[0].through_all_points()?
                {
                    searches.push(search);
                    done = false;
                }
            }
            Run::Choice(rivals, others) => {
                done = false;
                match rivals.iter_mut().find(|search| !search.is_thinned()) {
                    Some(search) => {
                        search.step();
                        self.rounds += 1;
                    }
                    None => {
                        sort_by_number(rivals, &|rival| rival.cost());
                        rivals.truncate(1);
                        rivals.append(others);
                        self.run = Run::Search(core::mem::take(rivals));
                    }
                }
                iteration = self.rounds;
            }
        }
        if done
            && !spent
            && let Some(aim) = self.aim_without_corners()
        {
            self.search(aim, false)?;
            done = false;
        }
        Ok(Progress { done, iteration, gap })
    }

    /// What a search aimed at that found corners where few points show none: fewer knots are cheap between few points.
    #[inline(never)]
    fn aim_without_corners(&self) -> Option<Aim> {
        let Run::Search(searches) = &self.run else { return None };
        let seeming = best_of(searches).has_corners() && self.own.is_empty() && is_smooth(&self.samples);
        seeming.then(|| searches[0].aim())
    }

    /// The best curve so far, and what is known of it.
    ///
    /// # Errors
    ///
    /// Where nothing was asked for, and `OutOfMemory`. A curve that leaves the range of coordinates, which takes points near
    /// its limit or parameters that hardly grow, is replaced by the polygon of the points, `Stalled`.
    pub fn fit(&self) -> Result<Fit> {
        match self.described() {
            // A smooth curve swings beyond points near the limit, or as far as there is no number for it; the polygon of the
            // points does not.
            Err(error) if matches!(*error, Error::OutOfRange { .. } | Error::NotFinite { .. }) => {
                report::polygon(&self.frame())
            }
            result => result,
        }
    }
}
