//! What is asked for, as a run of the solver or of the search: by λ, by smoothing, by tolerance, by noise.

use super::{Fitter, Run};
use crate::error::{Error, Result};
use crate::fit::knots::free_knots::Located;
use crate::fit::knots::sparsest::Aim;
use crate::fit::noise::{is_regular_at, is_steady, levels, sober, turn_alike};
use crate::fit::options::{Ask, Options};
use crate::fit::outline::{Outline, between, filled};
use crate::fit::parametrise::{Parametrisation, given, parametrise};
use crate::fit::report;
use crate::fit::samples::Samples;
use crate::limits::{LARGEST_COORDINATE, LEAST_WEIGHT, check};
use crate::numerics::Point;

/// A curve is not looked for nearer to the points than one rounding of its place and so many of a drawing's size.
const ROUNDINGS: f64 = 256.0;
/// No knot is for less than this part of a drawing.
const LEAST_NOISE: f64 = 1e-4;
/// Noise moves few points farther than so many standard deviations.
const WIDEST: f64 = 3.0;
/// The part of a tolerance by which points may be off that are drawn.
const DRAWN: f64 = 0.25;
/// So many points of an open way show their corners.
const CLICKS: core::ops::Range<usize> = 7..16;

/// What points are given parameters for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Purpose {
    /// λ, or a mean square at the parameters: the papers' own, the index.
    Papers,
    /// The optimum for a smoothing: the index where points follow one another evenly, be it slowly here and fast there.
    /// What a hand draws slowly then turns smoothly.
    Optimum,
    /// Few knots by distances: the index only where points are equally far apart, as every change of the speed asks for
    /// knots. Sides between corners are looked for where it is said how far points may be off.
    Search(Option<f64>),
    /// The same for few points of an open way, which show their corners themselves.
    Clicks,
}

impl Fitter {
    /// Starts a run.
    ///
    /// # Errors
    ///
    /// Where a number is refused, what was asked before stays as it was.
    ///
    /// λ not from 0 to 1e12 or not one per degree (all 0 for two), smoothing not from 0 to 1, a tolerance that is
    /// negative. For λ and smoothing, `TooFewPoints` where an open curve has no more points than its highest degree;
    /// points that repeat their neighbour are one. A tolerance, and the noise, make do with what [`Fitter::new`] takes.
    pub fn ask(&mut self, ask: Ask) -> Result<()> {
        match &ask {
            Ask::Lambda(lambdas) => self.ask_lambdas(lambdas, &ask),
            Ask::Smoothing(smoothing) => self.ask_smoothing(*smoothing, &ask),
            Ask::Tolerance(tolerance) => self.ask_tolerance(*tolerance, &ask),
            Ask::MeanSquare(square) => self.ask_mean_square(*square, &ask),
            Ask::Noise => self.ask_noise(&ask),
        }?;
        (self.ask, self.rounds) = (ask, 0);
        Ok(())
    }

    fn ask_lambdas(&mut self, lambdas: &[f64], ask: &Ask) -> Result<()> {
        if lambdas.len() != self.options.degrees.len() {
            return Err(Error::wrong_length("lambda", lambdas.len(), self.options.degrees.len()));
        }
        for (i, &lambda) in lambdas.iter().enumerate() {
            check("lambda", Some(i), lambda, 0.0, 1e12)?;
        }
        if lambdas.len() == 2 && lambdas.iter().sum::<f64>() <= 0.0 {
            return Err(Error::out_of_range("lambda", Some(0), 0.0, f64::MIN_POSITIVE, 1e12));
        }
        self.locate(Purpose::Papers, ask)?;
        self.lambdas = lambdas.to_vec();
        self.solve()
    }

    fn ask_smoothing(&mut self, smoothing: f64, ask: &Ask) -> Result<()> {
        check("smoothing", None, smoothing, 0.0, 1.0)?;
        self.locate(Purpose::Optimum, ask)?;
        self.lambdas = self.lambdas_of(smoothing);
        self.solve()
    }

    fn ask_tolerance(&mut self, tolerance: f64, ask: &Ask) -> Result<()> {
        check("tolerance", None, tolerance, 0.0, LARGEST_COORDINATE)?;
        // Points without noise are off nowhere: a side that is longer than twice the tolerance is one.
        let off = if self.is_untold() { DRAWN * tolerance } else { tolerance };
        self.locate(Purpose::Search(Some(off / self.samples.scale)), ask)?;
        // Nearer than coordinates are told apart nothing can be.
        let place = self.samples.center.amax() / self.samples.scale;
        let least = f64::EPSILON * (ROUNDINGS + place);
        let left = tolerance - report::rounding(&self.samples);
        self.search(Aim::Tolerance((left / self.samples.scale).max(least)), self.options.corners, true)
    }

    fn ask_mean_square(&mut self, square: f64, ask: &Ask) -> Result<()> {
        check("meanSquare", None, square, 0.0, LARGEST_COORDINATE * LARGEST_COORDINATE)?;
        self.locate(Purpose::Papers, ask)?;
        let unit = self.samples.scale * self.samples.scale;
        self.search(Aim::Squares(square * report::weight(&self.located) / unit), self.options.corners, false)
    }

    fn ask_noise(&mut self, ask: &Ask) -> Result<()> {
        // Where nothing tells about the noise, the curve goes through the points.
        let untold = self.is_untold();
        // An open list that goes up and down is noisy rather than drawn so.
        let drawn = untold || self.samples.closed;
        let sides = Purpose::Search(drawn.then_some(WIDEST * self.noise));
        let purpose = if self.is_clicked() { Purpose::Clicks } else { sides };
        self.locate(purpose, ask)?;
        let noise = self.level.max(self.least_noise());
        let aim = if untold { Aim::Tolerance(noise) } else { Aim::Noise(noise) };
        self.search(aim, self.options.corners, false)
    }

    /// Whether nothing tells about the noise: points are few, or drawn.
    fn is_untold(&self) -> bool {
        self.levels == Some([0.0; 2])
    }

    /// Whether points are so few, and so plain, that what each of them says about corners is looked at.
    fn is_clicked(&self) -> bool {
        let Options {
            degrees, corners, noise, weights, parameters, parametrisation, robust, least_turn, ..
        } = &self.options;
        let plain =
            *parametrisation == Parametrisation::Auto && !robust && noise.is_none() && *least_turn <= 0.0;
        let few =
            !self.samples.closed && CLICKS.contains(&self.samples.points.len()) && !turn_alike(&self.samples);
        let curved = degrees.last().is_some_and(|degree| *degree > 1);
        few && plain && curved && *corners && weights.is_empty() && parameters.is_empty()
    }

    /// What is less than a ten-thousandth of the drawing is not worth a knot: of its size without points that are far
    /// off all others, for beside these all else is little.
    fn least_noise(&self) -> f64 {
        if self.level >= LEAST_NOISE {
            return LEAST_NOISE;
        }
        let near = sober(&self.samples, self.level).1;
        LEAST_NOISE * report::size_of(&near) / report::size_of(&self.samples.points)
    }

    /// Ends the run before, and gives the points their parameters: to be called once nothing that is asked can be
    /// refused any more.
    fn locate(&mut self, purpose: Purpose, ask: &Ask) -> Result<()> {
        match core::mem::replace(&mut self.run, Run::Idle) {
            Run::Convex(solver) => self.warm = Some(solver),
            Run::Finish(finishing) => self.warm = Some(finishing.solver),
            _ => {}
        }
        if self.located_for == Some(purpose) && !self.options.robust {
            return Ok(());
        }
        if self.located_for.is_some_and(|before| before != purpose) {
            // Other parameters are another problem.
            self.warm = None;
        }
        let outline = self.outline(purpose)?;
        self.level = self.noise;
        if let Some(Outline { samples, cornered: true, .. }) = &outline
            && self.options.noise.is_none()
        {
            // Corners look like noise.
            self.level = self.level.min(levels(samples)[0]);
        }
        let samples = outline.as_ref().map_or(&self.samples, |outline| &outline.samples);
        let (weights, pulled) = self.weighed(samples, outline.is_some());
        // What is kept to all points, be it a tolerance, is kept to those that are far off as they came.
        let pulled = pulled.filter(|_| !matches!(ask, Ask::Tolerance(_) | Ask::MeanSquare(_)));
        let pulled = pulled.map(|points| Samples { points, ..samples.clone() });
        let samples = pulled.as_ref().unwrap_or(samples);
        let even = self.is_even(samples, outline.is_some(), purpose);
        let own = outline.as_ref().map_or(&[][..], |outline| &outline.own[..]);
        let (parameters, end, unit) = self.parameters(samples, even || purpose == Purpose::Papers, own)?;
        self.located = Located { points: samples.points.clone(), parameters, weights };
        self.own = own.to_vec();
        (self.even, self.end, self.unit) = (even, end, unit);
        self.located_for = Some(purpose);
        Ok(())
    }

    /// The points with others along their sides, where there are such. The optimum for a smoothing is that of the
    /// points where something is said of each of them, and to points that are far off no sides lead.
    fn outline(&self, purpose: Purpose) -> Result<Option<Outline>> {
        let Options { parametrisation, robust, weights, parameters, corners, .. } = &self.options;
        let plain = *parametrisation == Parametrisation::Auto && !robust;
        let off = match purpose {
            Purpose::Optimum if plain && weights.is_empty() && parameters.is_empty() => None,
            Purpose::Search(off) => off.filter(|_| *corners),
            Purpose::Clicks => None,
            _ => return Ok(None),
        };
        let is_far = |weight: &f64| *weight < 1.0;
        if *robust && sober(&self.samples, self.noise).0.iter().any(is_far) {
            return Ok(None);
        }
        filled(&self.samples, self.noise, off)
    }

    /// The weight of each point, or none at all; where points that are far off are to count for little, also where
    /// those would count. None of an outline is: its sharp corners would look so.
    fn weighed(&self, samples: &Samples, is_outline: bool) -> (Vec<f64>, Option<Vec<Point>>) {
        let given = if samples.is_weighted() { samples.weights.clone() } else { Vec::new() };
        if !self.options.robust || is_outline {
            return (given, None);
        }
        let (sober, near) = sober(samples, self.level);
        let both = |(m, w): (usize, &f64)| (w * given.get(m).copied().unwrap_or(1.0)).max(LEAST_WEIGHT);
        (sober.iter().enumerate().map(both).collect(), Some(near))
    }

    /// Whether the index of a point may be its parameter.
    fn is_even(&self, samples: &Samples, is_outline: bool, purpose: Purpose) -> bool {
        let options = &self.options;
        let automatic = options.parametrisation == Parametrisation::Auto && options.parameters.is_empty();
        if !automatic || purpose == Purpose::Papers {
            return false;
        }
        let known = self.levels.unwrap_or_else(|| levels(if is_outline { &self.samples } else { samples }));
        is_regular_at(samples, known) && (purpose == Purpose::Optimum || is_steady(samples, known[0]))
    }

    /// The parameters on [0, end], the end, and how much of the caller's one of them is.
    fn parameters(&self, samples: &Samples, by_index: bool, own: &[u32]) -> Result<(Vec<f64>, f64, f64)> {
        let options = &self.options;
        let chosen = options.parametrisation != Parametrisation::Auto;
        let (mut parameters, mut end, mut unit) = if options.parameters.is_empty() {
            let kind = match options.parametrisation {
                Parametrisation::Auto if by_index => Parametrisation::Index,
                kind => kind,
            };
            let (parameters, end) =
                parametrise(if chosen { &self.samples } else { samples }, kind, self.level);
            (parameters, end, 1.0)
        } else {
            let count = self.samples.points.len();
            let (parameters, end) = given(&options.parameters, count, samples.closed, options.period)?;
            // Inside, one step is about 1.
            let unit = end / count as f64;
            (parameters.iter().map(|t| t / unit).collect(), end / unit, unit)
        };
        if !own.is_empty() && (chosen || !options.parameters.is_empty()) {
            unit /= between(&mut parameters, &mut end, own, samples.points.len());
        }
        if samples.closed {
            // A last point as near to the first as rounding allows comes before it all the same.
            parameters.iter_mut().for_each(|t| *t = t.min(end.next_down()));
        }
        Ok((parameters, end, unit))
    }

    /// λ for each degree from the slider: ℓ from 2 points to all of them, the first of two degrees a part of it.
    fn lambdas_of(&self, smoothing: f64) -> Vec<f64> {
        self.lambdas_for(smoothing, report::diameter(&self.samples))
    }

    /// The same for a drawing of that diameter.
    fn lambdas_for(&self, smoothing: f64, diameter: f64) -> Vec<f64> {
        let count = self.samples.points.len() as f64;
        let detail = 2.0 * libm::pow((0.5 * count).max(1.0), smoothing);
        let ratio = 6.0 - 3.5 * self.options.mix;
        let degrees = &self.options.degrees;
        let part = |i: usize| if degrees.len() == 2 && i == 0 { detail / ratio } else { detail };
        degrees.iter().enumerate().map(|(i, &degree)| diameter * report::power(part(i), degree)).collect()
    }

    /// The slider's place of all λ, where there is one.
    pub(super) fn smoothing_of(&self) -> Option<f64> {
        let (degree, lambda) = (*self.options.degrees.last()?, *self.lambdas.last()?);
        let count = self.samples.points.len() as f64;
        if lambda <= 0.0 || count <= 2.0 {
            return None;
        }
        let diameter = report::diameter(&self.samples);
        let root = libm::log(lambda / diameter) / (degree + 1) as f64;
        let detail = libm::exp(root) * core::f64::consts::TAU;
        let place = (libm::log(0.5 * detail) / libm::log(0.5 * count)).clamp(0.0, 1.0);
        // What lies beyond an end of the slider, and pairs in another ratio, are at no place: going back tells, but for
        // the rounding of logarithms and powers.
        let back = self.lambdas_for(place, diameter);
        let same = |(own, back): (&f64, &f64)| (own - back).abs() <= 1e-9 * own;
        self.lambdas.iter().zip(&back).all(same).then_some(place)
    }

    /// Whether nothing is paid for knots: the curve goes through the points.
    pub(super) fn is_free(&self) -> bool {
        self.lambdas.iter().all(|lambda| *lambda <= 0.0)
    }
}
