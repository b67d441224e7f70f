//! The basis functions of one interval between knots, as polynomials.

/// The highest degree of a spline here.
pub(crate) const MOST_DEGREE: usize = 5;
/// One more than the highest degree: the number of coefficients of a polynomial here.
pub(crate) const TERMS: usize = MOST_DEGREE + 1;

/// The basis functions of one interval as polynomials of x = (t − middle)/half in ascending powers.
#[derive(Clone, Copy, Debug)]
pub struct Local {
    /// The degree of the polynomials.
    pub degree: usize,
    /// The middle of the interval.
    pub middle: f64,
    /// Half its length.
    pub half: f64,
    /// One row per basis function.
    pub rows: [[f64; TERMS]; TERMS],
}

impl Local {
    /// The derivative of basis function i at t.
    pub fn derivative(&self, i: usize, t: f64, order: usize) -> f64 {
        let x = if self.half > 0.0 { (t - self.middle) / self.half } else { 0.0 };
        let mut sum = 0.0;
        for power in (order..=self.degree).rev() {
            let mut term = self.rows[i][power];
            for k in 0..order {
                term *= (power - k) as f64 / self.half;
            }
            sum = sum * x + term;
        }
        sum
    }
}

/// De Boor's recursion with polynomials in place of values. `knots` are the 2·degree + 2 around the interval; the
/// interval itself lies between the two in the middle. [deB78, X (4)]
pub(crate) fn polynomials(knots: &[f64], degree: usize, middle: f64, half: f64) -> Local {
    let rows = match degree {
        1 => recursion::<2>(knots, degree, middle, half),
        3 => recursion::<4>(knots, degree, middle, half),
        _ => recursion::<TERMS>(knots, degree, middle, half),
    };
    Local { degree, middle, half, rows }
}

/// The recursion for a degree below T; where T is one more, its loops are of known length.
fn recursion<const T: usize>(knots: &[f64], degree: usize, middle: f64, half: f64) -> [[f64; TERMS]; TERMS] {
    let mut rows = [[0.0; T]; T];
    rows[0][0] = 1.0;
    for d in 1..T {
        if d > degree || half.is_nan() || half <= 0.0 {
            break;
        }
        // Function i of degree d starts at knot degree − d + i; it takes part of functions i − 1 and i of degree d − 1.
        let lower = rows;
        rows = [[0.0; T]; T];
        for i in 0..d {
            let first = degree + 1 - d + i;
            let (start, width) = (knots[first], knots[first + d] - knots[first]);
            let (offset, slope) = ((middle - start) / width, half / width);
            for power in 0..d {
                let value = lower[i][power];
                let (stay, rise) = (value * offset, value * slope);
                rows[i + 1][power] += stay;
                rows[i + 1][power + 1] += rise;
                rows[i][power] += value - stay;
                rows[i][power + 1] -= rise;
            }
        }
    }
    let mut all = [[0.0; TERMS]; TERMS];
    for (row, own) in all.iter_mut().zip(&rows) {
        row[..T].copy_from_slice(own);
    }
    all
}
