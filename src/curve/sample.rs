//! Many points at once, into the caller's slice.

use super::hermite::{HermiteCurve, check_derivative};
use super::limits::{MOST_EVALUATIONS, too_many};
use crate::error::{Error, Result};

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
            return Err(Error::WrongLength { argument: "out", got: out.len(), needed: 2 * t.len() });
        }
        self.check_parameters(t)?;
        for (&t, out) in t.iter().zip(out.chunks_exact_mut(2)) {
            let (i, x) = self.locate(t)?;
            let value = self.segment(i).derivative(x, derivative);
            out.copy_from_slice(value.as_slice());
        }
        Ok(())
    }

    fn check_parameters(&self, parameters: &[f64]) -> Result<()> {
        let (least, most) = self.domain();
        for (i, &value) in parameters.iter().enumerate() {
            let (argument, index) = ("t", Some(i));
            if !value.is_finite() {
                return Err(Error::NotFinite { argument, index });
            }
            if !self.is_closed() && !(least..=most).contains(&value) {
                return Err(Error::OutOfRange { argument, index, value, least, most });
            }
        }
        Ok(())
    }

    /// Points first, first + 1, … of the uniform sampling of the curve by `count` points, as many as `out` has
    /// room for, x and y in turn.
    ///
    /// Point i lies at i/count of the parameter range of a closed curve, at i/(count − 1) of an open one.
    pub fn sample_range(&self, count: usize, first: usize, out: &mut [f64]) {
        let (_, end) = self.domain();
        let steps = if self.is_closed() { count } else { count.saturating_sub(1) }.max(1) as f64;
        for (i, out) in (first..count).zip(out.chunks_exact_mut(2)) {
            let t = (i as f64 * end / steps).min(end);
            let Ok((k, x)) = self.locate(t) else { continue };
            out.copy_from_slice(self.segment(k).position(x).as_slice());
        }
    }
}
