//! Many points at once, into the caller's slice.

use super::sampler::Sampler;
use super::{HermiteCurve, check_derivative};
use crate::error::{Error, Result};
use crate::limits::{MOST_EVALUATIONS, MOST_OUTPUT_POINTS, too_many, with_room};

impl HermiteCurve {
    /// Points (order 0) or derivatives at every parameter, x and y in turn, into `out`.
    ///
    /// # Errors
    ///
    /// `out` not twice as long as `t`; more than 4 million parameters; a parameter that is not finite or, on an
    /// open curve, outside the domain: `out` is untouched then.
    pub fn evaluate_into(&self, t: &[f64], derivative: usize, out: &mut [f64]) -> Result<()> {
        check_derivative(derivative)?;
        if t.len() > MOST_EVALUATIONS {
            return Err(too_many("t", "maxEvalPoints", MOST_EVALUATIONS, t.len()));
        }
        if out.len() != 2 * t.len() {
            return Err(Error::wrong_length("out", out.len(), 2 * t.len()));
        }
        check_parameters(self.is_closed(), self.domain(), t)?;
        let mut i = 0;
        for (&t, out) in t.iter().zip(out.chunks_exact_mut(2)) {
            let x;
            (i, x) = self.place(t, i);
            let value = self.nth_segment(i).derivative(x, derivative);
            // One by one: of so few, a copy is a call.
            (out[0], out[1]) = (value.x, value.y);
        }
        Ok(())
    }

    /// `count` points that lie uniformly in the parameter, x and y in turn; see [`Sampler::points`].
    ///
    /// # Errors
    ///
    /// More than 4 million points.
    pub fn sample(&self, count: usize) -> Result<Vec<f64>> {
        if count > MOST_OUTPUT_POINTS {
            return Err(too_many("count", "maxOutputPoints", MOST_OUTPUT_POINTS, count));
        }
        let mut points = with_room(2 * count)?;
        points.resize(2 * count, 0.0);
        self.sample_range(count, 0, &mut points);
        Ok(points)
    }

    /// A part of a uniform sampling; see [`Sampler::points`], which is quicker when there are several.
    pub fn sample_range(&self, count: usize, first: usize, out: &mut [f64]) {
        Sampler::default().points(self, count, first, out);
    }
}

/// Checks parameters that are about to be evaluated: all finite, and within the domain of an open curve.
pub(crate) fn check_parameters(closed: bool, domain: (f64, f64), parameters: &[f64]) -> Result<()> {
    let (least, most) = if closed { (f64::MIN, f64::MAX) } else { domain };
    for (i, &value) in parameters.iter().enumerate() {
        if !(least..=most).contains(&value) {
            return Err(Error::unfit("t", Some(i), value, least, most));
        }
    }
    Ok(())
}
