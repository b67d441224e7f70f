//! The filters that change the grid: from interpolation points to B-splines, and from B-splines to finer ones.

use super::exponential_b_spline::ExponentialBSpline;
use super::interpolator::Interpolator;
use super::roots::Roots;
use crate::error::{Error, Result};
use crate::limits::{LARGEST_FACTOR, check, filled};
use crate::numerics::angle::sin_cos;

impl ExponentialBSpline {
    /// h, k = 0 … n₀(m − 1), with β⁺(t/m) = Σ h\[k\] β⁺_fine(t − k); the fine roots are these divided by m.
    ///
    /// # Accuracy
    ///
    /// 2e-15 of the largest (`tests/refine/exponential.rs`).
    ///
    /// # Errors
    ///
    /// m not from 1 to 1024.
    ///
    /// # Source
    ///
    /// [SFBGU17, eq. 15, 16], in real arithmetic (D 9.7).
    pub fn refinement_filter(&self, m: usize) -> Result<Vec<f64>> {
        refinement_filter(self.roots(), m)
    }

    /// The same for B-splines that are divided by their integrals: the taps sum to m, and if 0 is a root every m-th of
    /// them sum to 1, so that a translation of the control points is a translation of the finer ones.
    ///
    /// # Errors
    ///
    /// As [`Self::refinement_filter`]; roots for which ∫β is 0.
    pub fn affine_refinement_filter(&self, m: usize) -> Result<Vec<f64>> {
        affine_refinement_filter(self.roots(), m)
    }
}

impl Interpolator {
    /// g, k = 0 …, with φ⁺(t/m₀) = Σ g\[k\] β⁺_fine(t − k) and φ⁺ = φ(· − n₀ + 1); m₀ is even, the fine roots are these
    /// divided by it.
    ///
    /// # Errors
    ///
    /// m₀ not even, not from 2 to 1024.
    ///
    /// # Source
    ///
    /// [SFBGU17, eq. 17, 18] with the roots divided once and the coarse λ (docs/SOURCES.md).
    pub fn pre_filter(&self, m0: usize) -> Result<Vec<f64>> {
        check("m0", None, m0 as f64, 2.0, LARGEST_FACTOR as f64)?;
        if !m0.is_multiple_of(2) {
            return Err(Error::degenerate("m0", None, "half-integer shifts need an even factor"));
        }
        let h = refinement_filter(self.roots(), m0)?;
        let reach = self.order() - 2;
        let mut g = filled(0.0, m0 * reach + h.len())?;
        for shift in 0..=2 * reach {
            let lambda = self.lambda()[shift.abs_diff(reach)];
            for (sum, tap) in g[shift * (m0 / 2)..].iter_mut().zip(&h) {
                *sum += lambda * tap;
            }
        }
        Ok(g)
    }

    /// The same for fine B-splines that are divided by their integral.
    ///
    /// # Errors
    ///
    /// As [`Self::pre_filter`].
    pub fn affine_pre_filter(&self, m0: usize) -> Result<Vec<f64>> {
        let mut g = self.pre_filter(m0)?;
        scale(&mut g, self.roots().divided(m0 as f64).integral());
        Ok(g)
    }
}

/// [`ExponentialBSpline::affine_refinement_filter`] from the roots alone.
pub(crate) fn affine_refinement_filter(roots: &Roots, m: usize) -> Result<Vec<f64>> {
    let mut h = refinement_filter(roots, m)?;
    let ratio = roots.divided(m as f64).integral() / roots.integral();
    if !ratio.is_finite() {
        return Err(Error::degenerate("roots", None, "the B-spline's integral is 0"));
    }
    scale(&mut h, ratio);
    Ok(h)
}

fn scale(taps: &mut [f64], by: f64) {
    for tap in taps {
        *tap *= by;
    }
}

/// The coefficients of m^{1−n₀}·Π Σ_{k<m} e^{ak}zᵏ over the fine roots a.
pub(crate) fn refinement_filter(roots: &Roots, m: usize) -> Result<Vec<f64>> {
    check("m", None, m as f64, 1.0, LARGEST_FACTOR as f64)?;
    let mut product = filled(0.0, roots.order() * (m - 1) + 1)?;
    // Every factor but one brings a division by m.
    product[0] = m as f64;
    let mut degree = 0;
    for root in roots.divided(m as f64).upper() {
        let growth = libm::exp(root.re);
        let pair = root.im != 0.0;
        let count = if pair { 2 * m - 1 } else { m };
        let divisor = if pair { (m * m) as f64 } else { m as f64 };
        let mut factor = filled(1.0 / divisor, count)?;
        let mut power = 1.0;
        for (j, tap) in factor.iter_mut().enumerate() {
            *tap *= power;
            power *= growth;
            if pair {
                // e^{aj} times the sum of cos b(2k − j) over the k that reach j (D 9.7).
                *tap *= dirichlet(root.im, j.min(2 * m - 2 - j) + 1);
            }
        }
        multiply(&mut product, degree, &factor);
        degree += count - 1;
    }
    Ok(product)
}

/// The sum of n cosines of the multiples …, −b, b, … or …, −2b, 0, 2b, … that are symmetric about 0.
fn dirichlet(b: f64, n: usize) -> f64 {
    let mut sum = if n % 2 == 1 { 1.0 } else { 0.0 };
    let mut k = n - 1;
    while k > 0 {
        sum += 2.0 * sin_cos(k as f64 * b).1;
        k = k.saturating_sub(2);
    }
    sum
}

/// Multiplies a polynomial of this degree by another, in place; there is room.
fn multiply(product: &mut [f64], degree: usize, factor: &[f64]) {
    for k in (0..degree + factor.len()).rev() {
        let mut sum = 0.0;
        for (j, tap) in factor.iter().enumerate() {
            if j <= k && k - j <= degree {
                sum += product[k - j] * tap;
            }
        }
        product[k] = sum;
    }
}
