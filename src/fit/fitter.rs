//! The one door to fits: points in, a curve out, in steps that a caller can show, hurry or stop.

mod description;
mod finishing;

use self::finishing::Finishing;
use super::free_knots::Located;
use super::noise::{is_regular_at, levels, sober_weights};
use super::options::{Ask, Finish, Options};
use super::outcome::Fit;
use super::parametrise::{Parametrisation, given, parametrise};
use super::problem::{Component, Problem, interpolating_grid, uniform_grid};
use super::report;
use super::samples::Samples;
use super::solver::{Settings, Solver, Status};
use super::sparsest::{Aim, Plan, Sparsest};
use crate::error::{Error, Result};
use crate::limits::{LARGEST_COORDINATE, LARGEST_LAMBDA, check};
use crate::numerics::Point;
use crate::numerics::order::{sort_by_number, sort_numbers};

/// More points than this are not fitted a second time with knots that all count twice.
const MOST_TWICE: usize = 2000;
/// More points than this have a curve through them only on a grid that is asked for.
const MOST_THROUGH: usize = 50_000;

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
/// [`Fitter::ask`] starts a run, [`Fitter::step`] takes it further, [`Fitter::fit`] gives the best curve so far.
#[derive(Clone, Debug)]
pub struct Fitter {
    options: Options,
    samples: Samples,
    /// By the parametrisation that the ask wants.
    located: Located,
    /// Whether that was an ask for λ; `None` before the first.
    located_by: Option<bool>,
    /// Whether points follow one another so evenly that their index is their parameter.
    even: bool,
    end: f64,
    /// One unit of the inner parameter in the caller's.
    unit: f64,
    noise: f64,
    /// How far points scatter across and along the curve, where that has been looked at.
    levels: Option<[f64; 2]>,
    ask: Ask,
    lambdas: Vec<f64>,
    run: Run,
    problem: Option<Problem>,
    /// Whether its grid lets the curve through the points.
    through: bool,
    /// The solver of the last λ, for the next one.
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
    /// lists of the wrong length; numbers out of their range.
    pub fn new(points: &[Point], options: &Options) -> Result<Self> {
        options.check(points.len())?;
        let keep = !options.parameters.is_empty()
            || !options.weights.is_empty()
            || options.parametrisation == Parametrisation::Index;
        let samples = Samples::new(points, options.closed, keep)?;
        let levels = options.noise.is_none().then(|| levels(&samples));
        let noise = match (options.noise, levels) {
            (Some(noise), _) => noise / samples.scale,
            (None, levels) => levels.map_or(0.0, |[across, _]| across),
        };
        Ok(Self {
            options: options.clone(),
            samples,
            located: Located::default(),
            located_by: None,
            even: false,
            end: 0.0,
            unit: 1.0,
            noise,
            levels,
            ask: Ask::Noise,
            lambdas: Vec::new(),
            run: Run::Idle,
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

    /// Starts a run; what an earlier one knew is used.
    ///
    /// # Errors
    ///
    /// λ not from 0 to 1e12 or not one per degree (all 0 for two), smoothing not from 0 to 1, a tolerance that is negative.
    pub fn ask(&mut self, ask: Ask) -> Result<()> {
        match core::mem::replace(&mut self.run, Run::Idle) {
            Run::Convex(solver) => self.warm = Some(solver),
            Run::Finish(finishing) => self.warm = Some(finishing.solver),
            _ => {}
        }
        match &ask {
            Ask::Lambda(lambdas) => {
                if lambdas.len() != self.options.degrees.len() {
                    let (got, needed) = (lambdas.len(), self.options.degrees.len());
                    return Err(Error::wrong_length("lambda", got, needed));
                }
                for (i, &lambda) in lambdas.iter().enumerate() {
                    check("lambda", Some(i), lambda, 0.0, 1e12)?;
                }
                if lambdas.len() == 2 && lambdas.iter().sum::<f64>() <= 0.0 {
                    return Err(Error::out_of_range("lambda", Some(0), 0.0, f64::MIN_POSITIVE, 1e12));
                }
                self.locate(true)?;
                self.lambdas.clone_from(lambdas);
                self.solve()?;
            }
            Ask::Smoothing(smoothing) => {
                check("smoothing", None, *smoothing, 0.0, 1.0)?;
                self.locate(false)?;
                self.lambdas = self.lambdas_of(*smoothing);
                self.solve()?;
            }
            Ask::Tolerance(tolerance) => {
                check("tolerance", None, *tolerance, 0.0, LARGEST_COORDINATE)?;
                self.locate(false)?;
                self.search(Aim::Tolerance(tolerance / self.samples.scale));
            }
            Ask::MeanSquare(square) => {
                check("meanSquare", None, *square, 0.0, LARGEST_COORDINATE * LARGEST_COORDINATE)?;
                self.locate(true)?;
                let unit = self.samples.scale * self.samples.scale;
                self.search(Aim::Squares(square * report::weight(&self.located) / unit));
            }
            Ask::Noise => {
                self.locate(false)?;
                // What is less than a ten-thousandth of the drawing is not worth a knot.
                self.search(Aim::Noise(self.noise.max(1e-4)));
            }
        }
        self.ask = ask;
        Ok(())
    }

    /// Gives the points their parameters; λ alone means the papers' own, the index.
    fn locate(&mut self, by_lambda: bool) -> Result<()> {
        if self.located_by == Some(by_lambda) {
            return Ok(());
        }
        if self.located_by.is_some() {
            // Other parameters are another problem.
            self.warm = None;
        }
        let samples = &self.samples;
        let weights = if !self.options.weights.is_empty() {
            self.options.weights.clone()
        } else if samples.is_weighted() {
            samples.weights.clone()
        } else {
            Vec::new()
        };
        let mut weights = weights;
        if self.options.robust {
            let sober = sober_weights(samples, self.noise);
            let given = weights.clone();
            weights =
                sober.iter().enumerate().map(|(m, w)| w * given.get(m).copied().unwrap_or(1.0)).collect();
        }
        let automatic = self.options.parametrisation == Parametrisation::Auto;
        self.even = automatic && !by_lambda && self.options.parameters.is_empty() && {
            let known = self.levels.unwrap_or_else(|| levels(samples));
            is_regular_at(samples, known)
        };
        let kind = match self.options.parametrisation {
            Parametrisation::Auto if by_lambda || self.even => Parametrisation::Index,
            kind => kind,
        };
        let (parameters, end) = if self.options.parameters.is_empty() {
            self.unit = 1.0;
            parametrise(samples, kind, self.noise)
        } else {
            let (parameters, end) =
                given(&self.options.parameters, samples.points.len(), samples.closed, self.options.period)?;
            // Inside, one step is about 1.
            self.unit = end / samples.points.len() as f64;
            let unit = self.unit;
            (parameters.iter().map(|t| t / unit).collect(), end / unit)
        };
        self.located = Located { points: samples.points.clone(), parameters, weights };
        self.end = end;
        self.located_by = Some(by_lambda);
        Ok(())
    }

    /// λ for each degree from the slider: ℓ from 2 points to all of them, the first of two degrees a part of it.
    fn lambdas_of(&self, smoothing: f64) -> Vec<f64> {
        let count = self.samples.points.len() as f64;
        let detail = 2.0 * libm::pow((0.5 * count).max(1.0), smoothing);
        let size = report::size(&self.samples);
        let ratio = 6.0 - 3.5 * self.options.mix;
        let degrees = &self.options.degrees;
        let part = |i: usize| if degrees.len() == 2 && i == 0 { detail / ratio } else { detail };
        degrees.iter().enumerate().map(|(i, &degree)| size * report::power(part(i), degree)).collect()
    }

    /// The slider's place of the last degree's λ.
    fn smoothing_of(&self) -> Option<f64> {
        let (degree, lambda) = (*self.options.degrees.last()?, *self.lambdas.last()?);
        let count = self.samples.points.len() as f64;
        if lambda <= 0.0 || count <= 2.0 {
            return None;
        }
        let root = libm::log(lambda / report::size(&self.samples)) / (degree + 1) as f64;
        let detail = libm::exp(root) * core::f64::consts::TAU;
        Some((libm::log(0.5 * detail) / libm::log(0.5 * count)).clamp(0.0, 1.0))
    }

    /// Whether nothing is paid for knots: the curve goes through the points.
    fn is_free(&self) -> bool {
        self.lambdas.iter().all(|lambda| *lambda <= 0.0)
    }

    fn solve(&mut self) -> Result<()> {
        let factor = |degree: usize| libm::pow(self.unit, -(degree as f64)) / self.samples.scale;
        let degrees = &self.options.degrees;
        let closed = self.samples.closed;
        let count = self.located.points.len();
        let through = self.is_free() && self.options.grid_size.is_none() && count <= MOST_THROUGH;
        let size = |degree: usize| {
            let chosen = if degree == 1 { count.min(5000) } else { count.min(2000) };
            self.options.grid_size.unwrap_or(chosen).max(degree + 2)
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
            solver.set_lambdas(&lambdas)?;
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
        let settings = Settings { gap: self.options.gap, most_iterations: self.options.most_iterations };
        self.run = Run::Convex(Box::new(Solver::new(&problem, settings)?));
        self.problem = Some(problem);
        Ok(())
    }

    fn search(&mut self, aim: Aim) {
        let degree = self.options.degrees.last().copied().unwrap_or(3);
        let sharpest = match aim {
            Aim::Squares(_) => 1,
            _ if self.options.corners => degree,
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
            even: false,
        };
        let start =
            |located: &Located, smoothest| Sparsest::new(located.clone(), plan(smoothest), aim, self.noise);
        // Knots that all count twice often get by with fewer of them.
        let mut others = Vec::new();
        if matches!(aim, Aim::Tolerance(_)) && sharpest > 1 && self.located.points.len() <= MOST_TWICE {
            others.push(start(&self.located, 2));
        }
        // Points that follow one another evenly are placed along the curve once smooth knots are thinned out.
        let even = self.even && degree > 1 && matches!(aim, Aim::Noise(_));
        let smooth = Plan { even, ..plan(1) };
        let mut rivals = vec![Sparsest::new(self.located.clone(), smooth, aim, self.noise)];
        if self.options.corners {
            let corners = Sparsest::from_corners(self.located.clone(), plan(1), aim, self.noise);
            let apart = matches!(aim, Aim::Tolerance(_)) && self.located.points.len() <= MOST_TWICE;
            if apart { others.extend(corners) } else { rivals.extend(corners) }
        }
        self.run = Run::Choice(rivals, others);
    }

    /// Takes the run further by about `budget` microseconds' worth of work, at least by one round.
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

    fn round(&mut self) -> Result<Progress> {
        let (mut done, mut iteration, mut gap) = (true, 0, f64::INFINITY);
        match &mut self.run {
            Run::Idle => {}
            Run::Convex(solver) => {
                done = solver.step()? != Status::Running;
                (iteration, gap) = (solver.iterations(), solver.gap());
                let finish = self.options.finish != Finish::default();
                if done && finish && !self.lambdas.iter().all(|lambda| *lambda <= 0.0) {
                    let solver = solver.clone();
                    self.run = Run::Finish(Box::new(self.finishing(solver)?));
                    done = false;
                }
            }
            Run::Finish(finishing) => {
                (iteration, gap) = (finishing.solver.iterations(), finishing.solver.gap());
                done = finishing.round();
            }
            Run::Search(searches) => match searches.iter().position(|search| !search.is_done()) {
                Some(next) => {
                    searches[next].step();
                    iteration = searches.iter().map(Sparsest::rounds).sum();
                    done = next + 1 == searches.len() && searches[next].is_done();
                }
                None => done = true,
            },
            Run::Choice(rivals, others) => {
                done = false;
                match rivals.iter_mut().find(|search| !search.is_thinned()) {
                    Some(search) => search.step(),
                    None => {
                        sort_by_number(rivals, &|rival| rival.cost());
                        rivals.truncate(1);
                        rivals.append(others);
                        self.run = Run::Search(core::mem::take(rivals));
                    }
                }
            }
        }
        Ok(Progress { done, iteration, gap })
    }

    /// The best curve so far, and what is known of it.
    ///
    /// # Errors
    ///
    /// Where nothing was asked for, and `OutOfMemory`. A curve that leaves the range of coordinates, which takes points near
    /// its limit, is replaced by the polygon of the points, `Stalled`.
    pub fn fit(&self) -> Result<Fit> {
        match self.described() {
            // A smooth curve swings beyond points near the limit; the polygon of the points does not.
            Err(error) if matches!(*error, Error::OutOfRange { .. }) => report::polygon(&self.frame()),
            result => result,
        }
    }
}
