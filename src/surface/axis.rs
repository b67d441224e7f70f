//! One direction of a net: which points weigh on a parameter, and how much.

use super::weights::IntervalWeights;
use crate::error::{Error, Result};
use crate::generator::{Interpolator, Roots};
use crate::limits::{MOST_SURFACE_POINTS, check, too_many};
use crate::numerics::angle::wrapped;
use crate::numerics::lists::steps;

/// The finest level: a unit of the parameter then has 4096 points.
pub(super) const MOST_LEVELS: u32 = 12;

/// How a net runs in one of its two directions.
#[derive(Clone, Debug, PartialEq)]
pub struct Direction {
    /// The roots of the generator, per unit of the parameter.
    pub roots: Roots,
    /// How many points there are.
    pub count: usize,
    /// Whether the last point is followed by the first.
    pub closed: bool,
    /// 0 for points on the surface, one for each unit; k for B-spline control points on the grid 2⁻ᵏ.
    pub level: u32,
}

/// A place in one direction: an interval of the grid, the half of it, and how far from the middle of the half.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) interval: usize,
    half: usize,
    x: f64,
}

/// A direction with its generator as polynomials, ready to be evaluated.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Axis {
    pub(super) direction: Direction,
    /// Grid steps in one unit of the parameter.
    pub(super) scale: f64,
    /// Grid intervals that the domain has.
    pub(super) intervals: usize,
    /// Point of the grid that is the first to weigh on interval 0.
    pub(super) start: i64,
    weights: IntervalWeights,
}

/// How many points an open direction has beyond the number of its intervals.
pub(super) fn surplus(roots: &Roots, level: u32) -> usize {
    let order = roots.order();
    if level == 0 { (2 * order).saturating_sub(3) } else { order - 1 }
}

impl Axis {
    /// Prepares a direction of a caller's. B-splines exist for more roots than interpolators, but every surface can be
    /// reduced to points on it.
    pub(super) fn given(direction: Direction, arguments: [&'static str; 2]) -> Result<Self> {
        if direction.level > 0 {
            Interpolator::new(&direction.roots).map_err(|error| error.about(arguments[1]))?;
        }
        Self::new(direction, arguments)
    }

    /// Prepares a direction; errors name its count and its roots as the caller knows them.
    pub(super) fn new(direction: Direction, [argument, of_roots]: [&'static str; 2]) -> Result<Self> {
        let Direction { ref roots, count, closed, level } = direction;
        check("level", None, f64::from(level), 0.0, f64::from(MOST_LEVELS))?;
        if count > MOST_SURFACE_POINTS {
            return Err(too_many(argument, "maxSurfacePoints", MOST_SURFACE_POINTS, count));
        }
        let weights = if level == 0 {
            IntervalWeights::of_interpolator(roots)
        } else {
            IntervalWeights::of_b_spline(roots, level)
        };
        let weights = weights.map_err(|error| error.about(of_roots))?;
        let surplus = surplus(roots, level);
        let least = if closed { 3 } else { surplus + 1 };
        if count < least {
            return Err(Error::too_few(argument, count, least));
        }
        let intervals = if closed { count } else { count - surplus };
        let order = roots.order() as i64;
        let start = if level == 0 { 2 - order } else { 1 - (order + 1) / 2 };
        let scale = f64::from(1_u32 << level);
        Ok(Self { direction, scale, intervals, start, weights })
    }

    /// The last parameter of the domain, which begins at 0.
    pub(super) fn end(&self) -> f64 {
        self.intervals as f64 / self.scale
    }

    /// The parameter of the point in row `i`.
    pub(super) fn parameter(&self, i: usize) -> f64 {
        let offset =
            if self.direction.level == 0 { 0.0 } else { 0.5 * (self.direction.roots.order() % 2) as f64 };
        let first = if self.direction.closed { 0 } else { self.start };
        ((i as i64 + first) as f64 + offset) / self.scale
    }

    /// Parameter i of `count` that lie uniformly: at i/count of a closed direction, at i/(count − 1) of an open one.
    pub(super) fn uniform(&self, i: usize, count: usize) -> f64 {
        self.end() * (i as f64 / steps(count, self.direction.closed) as f64)
    }

    /// Checks a parameter; closed directions are periodic and take any.
    pub(super) fn check(&self, argument: &'static str, index: Option<usize>, t: f64) -> Result<()> {
        match (self.direction.closed, t.is_finite()) {
            (true, true) => Ok(()),
            (true, false) => Err(Error::not_finite(argument, index)),
            (false, _) => check(argument, index, t, 0.0, self.end()),
        }
    }

    /// The place of a parameter that was checked, or of one that is off the domain by a rounding.
    pub(super) fn nearest_place(&self, t: f64) -> Place {
        let end = self.end();
        self.place_within(if self.direction.closed { wrapped(t, end) } else { t.max(0.0).min(end) })
    }

    /// The place of a parameter of the domain; at a knot the piece to the right of it.
    pub(super) fn place_within(&self, t: f64) -> Place {
        let x = t * self.scale;
        // The end itself belongs to the last interval.
        let interval = (x as usize).min(self.intervals - 1);
        let rest = x - interval as f64;
        let (half, x) = self.weights.half(rest);
        Place { interval, half, x }
    }

    /// How many points weigh on an interval.
    #[inline]
    pub(super) fn width(&self) -> usize {
        self.weights.width
    }

    /// Weights of those points at a place, or of a derivative there.
    pub(super) fn weights(&self, Place { half, x, .. }: Place, derivative: usize, out: &mut [f64]) {
        let scale = (0..derivative).fold(1.0, |s, _| s * self.scale);
        self.weights.fill(half, x, derivative, scale, out);
    }

    /// The net's row that is the w-th to weigh on an interval; `at` counts intervals and w together.
    pub(super) fn row(&self, at: usize) -> usize {
        if self.direction.closed {
            (at as i64 + self.start).rem_euclid(self.direction.count as i64) as usize
        } else {
            at
        }
    }

    /// Rows of the net in the order in which intervals meet them; interval i is weighed on by places i … i + width − 1.
    pub(super) fn run(&self) -> usize {
        self.intervals + self.width() - 1
    }
}
