//! The one door to fits: points in, a curve out, in steps that a caller can show, hurry or stop.

mod asking;
mod description;
mod finishing;
mod starting;

use self::asking::Purpose;
use self::description::best_of;
use self::finishing::Finishing;
use super::convex::problem::Problem;
use super::convex::solution::Status;
use super::interior::solver::Solver;
use super::knots::free_knots::Located;
use super::knots::sparsest::{Aim, Resorted, Sparsest};
use super::noise::levels;
use super::options::{Ask, Finish, Options};
use super::outcome::Fit;
use super::parametrise::Parametrisation;
use super::report;
use super::samples::{PER_POINT, Samples};
use super::smooth::is_smooth;
use crate::error::{Error, Result};
use crate::limits;
use crate::numerics::Point;
use crate::numerics::order::{sort_by_number, sort_numbers};

/// Whether a mean square may be asked for: the bindings of the package never do.
const BY_SQUARES: bool = !cfg!(feature = "wasm-fit");

/// How far a run has come.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
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
/// [`Fitter::ask`] starts a run, [`Fitter::step`] takes it further, [`Fitter::fit`] gives the best curve so far. What
/// is asked before changes no bit of what is found, unless a gap of 1e-3 or more is enough: then a run for λ or a
/// smoothing starts where the last one ended, and agrees within the gap.
///
/// Between two steps progress can be shown, and the work ended: whoever wants no more asks for no further step.
///
/// ```
/// use expline::fit::{Ask, FitStatus, Fitter, Options};
/// use expline::numerics::Point;
/// use std::time::{Duration, Instant};
///
/// let noisy: Vec<Point> = (0..2000)
///     .map(f64::from)
///     .map(|i| Point::new(100.0 * (i / 318.0).cos() + (97.0 * i).sin(), 80.0 * (i / 318.0).sin()))
///     .collect();
/// let mut fitter = Fitter::new(&noisy, &Options { closed: Some(true), ..Options::default() })?;
/// fitter.ask(Ask::Tolerance(2.0))?;
/// let end = Instant::now() + Duration::from_secs(60);
/// loop {
///     let progress = fitter.step(4000.0)?; // some 4 ms of work; show progress.iteration
///     if progress.done || Instant::now() > end {
///         break;
///     }
/// }
/// let best = fitter.fit()?; // FitStatus::Running where time was up
/// assert!(best.status == FitStatus::Running || best.max_error <= 2.0, "within the tolerance");
///
/// fitter.ask(Ask::Smoothing(0.5))?; // the same points again: what was made of them is kept
/// while !fitter.step(4000.0)?.done {}
/// assert_eq!(fitter.fit()?.status, FitStatus::Converged);
/// # Ok::<(), expline::Error>(())
/// ```
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
    /// Those of [`Samples::new`]; degrees that are not one or two ascending numbers from 1 to 5; parameters that
    /// decrease; lists of the wrong length; numbers out of their range; `OutOfMemory`.
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

    /// Takes the run further by about `budget` microseconds' worth of work, at least by one round.
    ///
    /// A round is a few passes over the points: of 400,000 points of a noisy circle .15 s at most where λ is given,
    /// natively. Where a search ends with straight pieces the last round takes longer, .3 s for so many, and 1.3 s
    /// where a tolerance is far below the noise. [`Fitter::fit`] then takes as long as every point needs to find its
    /// foot, .1 to .7 s.
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
                done = go_on(searches, &mut self.rounds)?;
                iteration = self.rounds;
            }
            Run::Choice(rivals, others) => {
                done = false;
                if let Some(chosen) = choose(rivals, others, &mut self.rounds) {
                    self.run = Run::Search(chosen);
                }
                iteration = self.rounds;
            }
        }
        if done
            && !spent
            && let Some(aim) = self.aim_without_corners()
        {
            self.search(aim, false, matches!(self.ask, Ask::Tolerance(_)))?;
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
    /// Where nothing was asked for, and `OutOfMemory`. A curve that leaves the range of coordinates, which takes points
    /// near its limit or parameters that hardly grow, is replaced by the polygon of the points, `Stalled`.
    pub fn fit(&self) -> Result<Fit> {
        match self.described() {
            // A smooth curve swings beyond points near the limit, or as far as there is no number for it; the polygon
            // of the points does not.
            Err(error) if matches!(*error, Error::OutOfRange { .. } | Error::NotFinite { .. }) => {
                report::polygon(&self.frame())
            }
            result => result,
        }
    }
}

/// A round of the first search that is not done, if the one before leaves anything to be found; answers whether all
/// are.
fn go_on(searches: &mut Vec<Sparsest>, rounds: &mut usize) -> Result<bool> {
    let mut done = true;
    match searches.iter().position(|search| !search.is_done()) {
        Some(next) if next > 0 && searches[next - 1].suffices() => searches.truncate(next),
        Some(next) => {
            searches[next].step();
            *rounds += 1;
            done = next + 1 == searches.len() && searches[next].is_done();
        }
        None => {}
    }
    if done && searches.iter().all(|search| search.lacking().is_some()) {
        done = resorted(searches)?;
    }
    if BY_SQUARES
        && done
        && searches.len() == 1
        && let Some(search) = searches[0].through_all_points()?
    {
        searches.push(search);
        done = false;
    }
    Ok(done)
}

/// A round of what is resorted to where all searches lack something: the polyline of the first, and of the first
/// without corners where those must turn by so much. Answers whether there is no more of it.
fn resorted(searches: &mut Vec<Sparsest>) -> Result<bool> {
    let rounded = searches.iter().position(|search| search.least_turn() < searches[0].least_turn());
    for next in [Some(0), rounded].into_iter().flatten() {
        match searches[next].resort_to_polyline()? {
            Resorted::Over => {}
            Resorted::Underway => return Ok(false),
            Resorted::Begun(search) => {
                searches.push(*search);
                return Ok(false);
            }
        }
    }
    Ok(true)
}

/// A round of the first rival that has needless knots; where none has any, the cheapest of them, and the others.
/// Averages of the points say which is the cheapest, but not which can keep a tolerance with fewer knots: the rest
/// follow then.
fn choose(
    rivals: &mut Vec<Sparsest>,
    others: &mut Vec<Sparsest>,
    rounds: &mut usize,
) -> Option<Vec<Sparsest>> {
    if let Some(search) = rivals.iter_mut().find(|search| !search.is_thinned()) {
        search.step();
        *rounds += 1;
        return None;
    }
    sort_by_number(rivals, &|rival| rival.cost());
    if !matches!(rivals[0].aim(), Aim::Tolerance(_)) {
        rivals.truncate(1);
    }
    rivals.append(others);
    Some(core::mem::take(rivals))
}
