//! What may be asked of a fit.

use super::convex::problem::Norm;
use super::parametrise::Parametrisation;
use crate::error::{Error, Result};
use crate::limits::{LARGEST_COORDINATE, LARGEST_WEIGHT, LEAST_WEIGHT, check};

/// What the fit is asked for.
///
/// But for λ and a mean square, the curve also keeps to long straight sides of which the points are only the ends:
/// where a step is more than four times as long as most of the twelve around it, further points are put on it. For a
/// smoothing that is so unless parameters, a parametrisation or weights are given or [`Options::robust`] is set; with
/// that, none are put where points are far off all others. Distances are those of the given points.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub enum Ask {
    /// The minimiser of the sum of squares and λ times the jumps, one λ per degree, in the unit of the points.
    Lambda(Vec<f64>),
    /// The same with λ = size·(ℓ/2π)^(degree + 1), ℓ = 2·(M/2)^s points, for s in [0, 1]: the same drawing at another
    /// size, turned, or with more points, is smoothed alike. The size is the diameter of the smallest circle around the
    /// points.
    Smoothing(f64),
    /// The fewest knots with which no point is farther from the curve. The curve keeps to the way of the points, too:
    /// as a rule it is no farther from it than this and half of their distance from one another. Below the noise that
    /// is a polyline with the fewest vertices, rounded off where corners may not be. A polygon by its vertices is kept
    /// to along its sides.
    Tolerance(f64),
    /// The fewest simple knots with which the mean square of the points' distances, at their parameters, is not larger.
    MeanSquare(f64),
    /// The fewest knots that explain the points, up to their noise; where these tell nothing about it (see
    /// [`noise`](super::noise())), those that lead through them.
    #[default]
    Noise,
}

/// What is done after the convex problem is solved; nothing by default.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Finish {
    /// Goes to an extreme point of the set of optima: no knots that others can stand for. It changes neither the curve
    /// at the points nor the objective; on a grid that is not finer than the points the optimum is one already.
    pub extreme: bool,
    /// Joins neighbouring knots of the grid that stand for one knot in between.
    pub merge: bool,
    /// Slides knots off the grid to the optimum of the problem without one.
    pub slide: bool,
    /// Fits the points again with the knots kept, without the price that pulls the curve inwards.
    pub debias: bool,
    /// Takes knots away, and slides the others, while the mean square stays what it was.
    pub prune: bool,
}

/// How to fit.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// One degree, or two ascending ones for the sum of two splines; 1 to 5, by default 1 and 3. Where fewest knots are
    /// asked for the last one counts alone. Curves of degree 4 and 5 come as cubics, see
    /// [`Fit::deviation`](super::Fit::deviation).
    pub degrees: Vec<usize>,
    /// Whether the curve is closed; `None` where ends that are close belong together.
    pub closed: Option<bool>,
    /// How parameters are found; by default [`Parametrisation::Auto`].
    pub parametrisation: Parametrisation,
    /// Given parameters, one per point and not decreasing; empty to have them found.
    pub parameters: Vec<f64>,
    /// The period of given parameters on a closed curve; `None` for one mean step after the last.
    pub period: Option<f64>,
    /// Weights, one per point, 1e-6 to 1e6; empty for 1 each.
    pub weights: Vec<f64>,
    /// Steps of the grid that knots may be on, for [`Ask::Lambda`] and [`Ask::Smoothing`]; `None` chooses (the number
    /// of points, at most 5000 for degree 1 and 2000 above). Where every λ is 0, more steps than there are points are
    /// as good as none said.
    pub grid_size: Option<usize>,
    /// How the size of a jump is measured, for [`Ask::Lambda`] and [`Ask::Smoothing`]; by default [`Norm::L2`].
    pub norm: Norm,
    /// For two degrees with [`Ask::Smoothing`]: from 0, as straight as can be, to 1, as smooth as can be; by default
    /// 0.5.
    pub mix: f64,
    /// Whether corners are kept where fewest knots are asked for, as they are by default.
    pub corners: bool,
    /// By how much a corner turns at least, in radians, where fewest knots are asked for: at slighter ones the curve is
    /// smooth, for a knot or two more. 0 to π; 0, the default, keeps every corner that spares a knot.
    pub least_turn: f64,
    /// Whether points far off the curve are to count for little; by default all count alike.
    pub robust: bool,
    /// The noise's standard deviation in each coordinate, in their unit, 0 to 1e9; `None` has it estimated.
    pub noise: Option<f64>,
    /// The relative duality gap to reach, 0 to 1, for [`Ask::Lambda`] and [`Ask::Smoothing`]; by default 1e-6.
    pub gap: f64,
    /// The most iterations: of the solver for [`Ask::Lambda`] and [`Ask::Smoothing`], where `None` allows 400, of the
    /// search for the fewest knots otherwise, where `None` allows as many as it takes.
    pub most_iterations: Option<usize>,
    /// What is done after the convex problem of [`Ask::Lambda`] and [`Ask::Smoothing`] is solved; by default nothing.
    pub finish: Finish,
}

impl Options {
    /// Checks everything but the parameters, for so many points.
    pub(super) fn check(&self, count: usize) -> Result<()> {
        let options = self;
        let degrees = &options.degrees;
        if degrees.is_empty() || degrees.len() > 2 {
            return Err(Error::wrong_length("degree", degrees.len(), 1));
        }
        for (i, &degree) in degrees.iter().enumerate() {
            check("degree", Some(i), degree as f64, 1.0, 5.0)?;
            if i > 0 && degree <= degrees[i - 1] {
                return Err(Error::degenerate("degree", Some(i), "degrees ascend"));
            }
        }
        if !options.weights.is_empty() && options.weights.len() != count {
            return Err(Error::wrong_length("weights", options.weights.len(), count));
        }
        for (i, &weight) in options.weights.iter().enumerate() {
            check("weights", Some(i), weight, LEAST_WEIGHT, LARGEST_WEIGHT)?;
        }
        check("mix", None, options.mix, 0.0, 1.0)?;
        check("corners", None, options.least_turn, 0.0, core::f64::consts::PI)?;
        check("gap", None, options.gap, 0.0, 1.0)?;
        if let Some(noise) = options.noise {
            check("noise", None, noise, 0.0, LARGEST_COORDINATE)?;
        }
        Ok(())
    }
}

impl Default for Options {
    fn default() -> Self {
        Self {
            degrees: vec![1, 3],
            closed: None,
            parametrisation: Parametrisation::Auto,
            parameters: Vec::new(),
            period: None,
            weights: Vec::new(),
            grid_size: None,
            norm: Norm::L2,
            mix: 0.5,
            corners: true,
            least_turn: 0.0,
            robust: false,
            noise: None,
            gap: 1e-6,
            most_iterations: None,
            finish: Finish::default(),
        }
    }
}
