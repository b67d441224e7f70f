//! The weighted quasi-interpolant of a cloud: means of nearest neighbours as coefficients of B-splines.

pub(super) mod choice;
pub(super) mod cloud;
pub(super) mod knots;
mod local;
mod placement;
pub(super) mod projection;
pub(super) mod selection;

use self::cloud::Cloud;
use self::knots::{Knots, MOST_DEGREE, MOST_INTERIOR};
use self::local::LocalFit;
use self::projection::Projection;
use crate::error::{Error, Result};
use crate::limits::{check, filled, with_room};
use crate::numerics::Point;

/// What holds at an end of a tube, in the frame in which both ends have the ordinate 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum End {
    /// Nothing: the coefficient is what the cloud says.
    Free,
    /// The curve ends on the axis.
    Held,
    /// The curve ends on the axis with this slope: the second coefficient is on the tangent as well, moved vertically
    /// so that the curve keeps x(t) = t.
    Tangent(f64),
}

/// How coefficients are estimated from the cloud.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Estimator {
    /// The mean of the k nearest ordinates \[RB21, eq. 3 and 4\].
    Mean {
        /// How many neighbours.
        k: usize,
    },
    /// The polynomial of the spline's degree fitted to the k nearest points, through its blossom (D 14.2).
    Local {
        /// How many neighbours.
        k: usize,
    },
    /// The spline on the same knots that is nearest, in the mean square, to the points of some pieces around, of which
    /// one coefficient is taken (D 14.10).
    Projected {
        /// How many pieces on both sides of a B-spline's support count.
        reach: usize,
    },
}

/// A spline function that follows a cloud without solving a system.
#[derive(Clone, Debug, PartialEq)]
pub struct QuasiInterpolant {
    knots: Knots,
    coefficients: Vec<f64>,
}

impl QuasiInterpolant {
    /// The quasi-interpolant of `cloud` on `knots`, with `ends` held as they say.
    ///
    /// With [`Estimator::Mean`] constants are reproduced, and the spline stays between the least and the largest
    /// ordinate; with [`Estimator::Local`] all polynomials of the degree are reproduced; with [`Estimator::Projected`]
    /// all splines on the knots are, but for about a thousandth of the jumps of their highest derivative, where every
    /// piece has a point or more.
    ///
    /// # Errors
    ///
    /// k of 0 or of more than there are points; a reach of more than a million; local polynomials over distances so
    /// unlike that none of their digits is left.
    ///
    /// # Cost
    ///
    /// O(n·(log N + k)) for n coefficients; with windows of a reach r and degree p, O((N + n)·p²·(p + r)).
    ///
    /// # Source
    ///
    /// \[RB21, eq. 2\].
    pub fn new(cloud: &Cloud, knots: Knots, estimator: Estimator, ends: [End; 2]) -> Result<Self> {
        match estimator {
            Estimator::Mean { k } => Self::of_means(cloud, knots, k, ends),
            Estimator::Local { k } => {
                check("neighbours", None, k as f64, 1.0, cloud.len() as f64)?;
                let mut local = LocalFit::new(k)?;
                let made = Self::of(knots, ends, &mut |knots, q| local.coefficient(cloud, knots, q))?;
                check_digits(made.coefficients.iter().all(|coefficient| coefficient.is_finite()))?;
                Ok(made)
            }
            Estimator::Projected { reach } => Self::projected(cloud, knots, reach, ends),
        }
    }

    /// By the mean of the k nearest ordinates. What the package has no use for is only in [`QuasiInterpolant::new`].
    pub(crate) fn of_means(cloud: &Cloud, knots: Knots, k: usize, ends: [End; 2]) -> Result<Self> {
        check("neighbours", None, k as f64, 1.0, cloud.len() as f64)?;
        let mut order = with_room(k + 1)?;
        Self::of(knots, ends, &mut |knots, q| {
            cloud.nearest(knots.abscissa(q), k, &mut order);
            order.iter().map(|&i| cloud.y()[i]).sum::<f64>() / k as f64
        })
    }

    /// By windows of the spline itself.
    pub(super) fn projected(cloud: &Cloud, knots: Knots, reach: usize, ends: [End; 2]) -> Result<Self> {
        check("reach", None, reach as f64, 0.0, MOST_INTERIOR as f64)?;
        let coefficients = Projection::new(cloud, &knots, reach, ends)?.coefficients()?;
        Ok(Self { knots, coefficients })
    }

    fn of(knots: Knots, ends: [End; 2], estimate: &mut dyn FnMut(&Knots, usize) -> f64) -> Result<Self> {
        let mut coefficients = with_room(knots.count())?;
        for q in 0..knots.count() {
            coefficients.push(match held(&knots, q, ends) {
                Some(value) => value,
                None => estimate(&knots, q),
            });
        }
        Ok(Self { knots, coefficients })
    }

    /// The knots.
    pub fn knots(&self) -> &Knots {
        &self.knots
    }

    /// The coefficients; coefficient q belongs to the abscissa [`Knots::greville`].
    pub fn coefficients(&self) -> &[f64] {
        &self.coefficients
    }

    /// The value at x; beyond the ends the first and the last polynomial.
    pub fn evaluate(&self, x: f64) -> f64 {
        let places = [x; MOST_DEGREE];
        self.knots.blossom(&self.coefficients, self.knots.piece(x), &places[..self.knots.degree()])
    }

    /// The points (x, y) that control piece i as a Bézier curve of the degree.
    pub fn bezier(&self, piece: usize) -> Vec<Point> {
        let degree = self.knots.degree();
        let piece = piece.min(self.knots.piece_count() - 1);
        let (start, end) = self.knots.ends(piece);
        let mut places = [start; MOST_DEGREE];
        let mut points = Vec::with_capacity(degree + 1);
        for r in 0..=degree {
            if r > 0 {
                places[degree - r] = end;
            }
            let x = start + (end - start) * r as f64 / degree as f64;
            points.push(Point::new(x, self.knots.blossom(&self.coefficients, piece, &places[..degree])));
        }
        points
    }

    /// Ordinate less value at every point of a cloud.
    ///
    /// # Errors
    ///
    /// Where memory is short.
    pub fn residuals(&self, cloud: &Cloud) -> Result<Vec<f64>> {
        let mut residuals = filled(0.0, cloud.len())?;
        for (i, residual) in residuals.iter_mut().enumerate() {
            *residual = cloud.y()[i] - self.evaluate(cloud.x()[i]);
        }
        Ok(residuals)
    }
}

/// Refuses what has no digits: powers of distances up to 1e9 beside others near 0 have more of them than doubles.
pub(super) fn check_digits(known: bool) -> Result<()> {
    if known { Ok(()) } else { Err(Error::degenerate("points", None, "their distances are too unlike")) }
}

/// The value at which coefficient q is held. A lone middle coefficient between two tangents takes their mean.
pub(super) fn held(knots: &Knots, q: usize, [start, end]: [End; 2]) -> Option<f64> {
    let last = knots.count() - 1;
    let slope = |end: End| if let End::Tangent(slope) = end { Some(slope) } else { None };
    let at_start = match q {
        0 if start != End::Free => Some(0.0),
        1 => slope(start).map(|slope| slope * (knots.abscissa(1) - knots.abscissa(0))),
        _ => None,
    };
    let at_end = if q == last {
        (end != End::Free).then_some(0.0)
    } else if q + 1 == last {
        slope(end).map(|slope| slope * (knots.abscissa(q) - knots.abscissa(last)))
    } else {
        None
    };
    match (at_start, at_end) {
        (Some(first), Some(second)) if q > 0 && q < last => Some(0.5 * (first + second)),
        (Some(_), Some(_)) if q == last => at_end,
        (Some(value), _) => Some(value),
        (None, value) => value,
    }
}
