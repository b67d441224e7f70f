//! The cardinal Hermite exponential splines φ₁ and φ₂ on the whole line.

use super::{Basis, Space};
use crate::error::Result;
use crate::limits::{LARGEST_FREQUENCY, MOST_EVALUATIONS, MOST_LEVELS, POLE_MARGIN, check, filled, too_many};
use crate::numerics::entire::stumpff;
use core::f64::consts::TAU;

/// Values of two functions at the same places.
pub type Pair = (Vec<f64>, Vec<f64>);

/// What a table of the generators holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Table {
    /// φ₁, then φ₂.
    Pair,
    /// b₀ … b₃ for every place.
    Bernstein,
    /// ρ₁, then ρ₂.
    Greens,
}

/// The masks of this arity are 4 million numbers.
const LARGEST_ARITY: usize = 500_000;
/// e^t is finite up to here.
const LARGEST_EXPONENT: f64 = 700.0;

/// Sine and cosine are known up to here.
const LARGEST_ANGLE: f64 = 1e9;
/// Cubes of places are finite up to here.
const LARGEST_PLACE: f64 = 1e100;

/// The pair φ₁, φ₂ that interpolates values and first derivatives at the integers.
///
/// ```text
/// φ₁(n) = δₙ   φ₁′(n) = 0        r(t) = Σₙ r(n) φ₁(t − n) + r′(n) φ₂(t − n)
/// φ₂(n) = 0    φ₂′(n) = δₙ
/// ```
///
/// φ₁ is even, φ₂ odd; both vanish outside [−1, 1] and are once continuously differentiable. Their integer
/// shifts reproduce the whole space, 1, t, cos ωt, sin ωt in the trigonometric one: an ellipse sampled at
/// M ≥ 2 points with ω = 2π/M comes back exactly.
///
/// # Accuracy
///
/// That of [`Basis`]: a few 1e-16 for ω ≤ π and in the hyperbolic space.
///
/// # Source
///
/// [CRU15, eq. 2–7]; the interpolation conditions as corrected in docs/SOURCES.md.
///
/// # Example
///
/// ```
/// use expline::generator::{HermiteGenerators, Space};
///
/// let generators = HermiteGenerators::new(core::f64::consts::PI, Space::Trigonometric)?;
/// // A quarter of the way, half a circle has fallen from 1 to (1 + cos(π/4))/2.
/// let (first, _) = generators.evaluate(&[0.25], 0)?;
/// assert!((first[0] - 0.853_553_390_593_273_8).abs() < 1e-15);
/// # Ok::<(), expline::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HermiteGenerators {
    basis: Basis,
}

impl HermiteGenerators {
    /// The generators for `omega` radians per unit; 0 gives the cubic ones in any space.
    ///
    /// # Errors
    ///
    /// `omega` not finite, negative, 2π − 1e-6 or more in the trigonometric space, more than 1e4 otherwise.
    pub fn new(omega: f64, space: Space) -> Result<Self> {
        let most = if space == Space::Trigonometric { TAU - POLE_MARGIN } else { LARGEST_FREQUENCY };
        check("omega", None, omega, 0.0, most)?;
        Ok(Self { basis: Basis::new(space, omega) })
    }

    /// The basis of one segment of length 1.
    pub fn basis(&self) -> &Basis {
        &self.basis
    }

    /// φ₁ and φ₂ at one place, or their derivative of the given order, 0 to 3; at a knot the limit from the
    /// right.
    pub fn at(&self, x: f64, derivative: usize) -> (f64, f64) {
        if !(-1.0..1.0).contains(&x) {
            return (0.0, 0.0);
        }
        let weights = self.basis.weights(x.abs(), derivative);
        let first = match derivative {
            0 if x.abs() > 0.5 => self.basis.weights(1.0 - x.abs(), 0).chord,
            0 => 1.0 - weights.chord,
            _ => -weights.chord,
        };
        // φ₁ is even and φ₂ odd; a derivative of odd order swaps that.
        let mirrored = x < 0.0;
        let odd_order = derivative % 2 == 1;
        let first = if mirrored && odd_order { -first } else { first };
        let second = if mirrored && !odd_order { -weights.leaving } else { weights.leaving };
        (first, second)
    }

    /// φ₁ and φ₂, or their derivative of order 1 or 2, at every x; at a knot the limit from the right.
    ///
    /// # Errors
    ///
    /// An x that is not finite, a derivative above 2, more than 4 million places.
    pub fn evaluate(&self, x: &[f64], derivative: usize) -> Result<Pair> {
        let mut first = self.tabulate(Table::Pair, x, derivative)?;
        let second = first.split_off(x.len());
        Ok((first, second))
    }

    /// The four Bernstein functions, or their derivative of order 1 or 2, at every x: four values each.
    ///
    /// # Errors
    ///
    /// An x that is not finite or not in [0, 1], a derivative above 2, more than 4 million places.
    ///
    /// # Source
    ///
    /// [CRU15, eq. 36]; see [`Basis::bernstein`].
    pub fn bernstein(&self, x: &[f64], derivative: usize) -> Result<Vec<f64>> {
        self.tabulate(Table::Bernstein, x, derivative)
    }

    /// The refinement masks `H[n]`, n = −(arity − 1) … arity − 1, that take values and derivatives on the grid of
    /// step `arity`^−`level` to the next finer grid.
    ///
    /// Four numbers each, row by row; `H[n]` acts on the column (value, derivative) at the grid point that lies n
    /// fine steps to the left:
    ///
    /// ```text
    /// a′[k] = Σₗ H[k − arity·l] a[l]        H[n] = [ φ₁     step·φ₂ ]
    ///                                              [ φ₁′/step   φ₂′ ] (n/arity), with ω·step for ω
    /// ```
    ///
    /// # Errors
    ///
    /// An arity of 0 or above 500 000, whose masks are 4 million numbers; a level above 24.
    ///
    /// # Source
    ///
    /// [CRU15, eq. 33–35]; the index of (34) as corrected in docs/SOURCES.md.
    pub fn mask(&self, arity: usize, level: usize) -> Result<Vec<f64>> {
        check("arity", None, arity as f64, 1.0, LARGEST_ARITY as f64)?;
        check("level", None, level as f64, 0.0, MOST_LEVELS as f64)?;
        let mut pieces = 1.0;
        for _ in 0..level {
            pieces *= arity as f64;
        }
        let step = 1.0 / pieces;
        let basis = Basis::new(self.basis.space(), self.basis.frequency() * step);
        let mut values = filled(0.0, 4 * (2 * arity - 1))?;
        // n = 0 in the middle; places to its right see it as the start of their segment, those to its left as the end.
        let (before, after) = values.split_at_mut(4 * (arity - 1));
        let (middle, after) = after.split_at_mut(4);
        (middle[0], middle[3]) = (1.0, 1.0);
        let mut k = 0.0;
        for (before, after) in before.chunks_exact_mut(4).zip(after.chunks_exact_mut(4)) {
            k += 1.0;
            let [start, end] = basis.taps(step, k / arity as f64);
            before.copy_from_slice(&end);
            after.copy_from_slice(&start);
        }
        Ok(values)
    }

    /// The Green's functions ρ₁ of d⁴/dx⁴ + ω² d²/dx² and ρ₂ = ρ₁′ of d³/dx³ + ω² d/dx, at every x.
    ///
    /// # Errors
    ///
    /// An x that is not finite or is too large: ω·x to 700 in the hyperbolic space, to 1e9 in the trigonometric one.
    ///
    /// # Source
    ///
    /// [CRU15, eq. 13, 14] as ρ₁ = |x|³c₃/2 and ρ₂ = x|x|c₂/2 (D 4.1).
    pub fn greens(&self, x: &[f64]) -> Result<Pair> {
        let mut first = self.tabulate(Table::Greens, x, 0)?;
        let second = first.split_off(x.len());
        Ok((first, second))
    }

    /// What [`Self::evaluate`], [`Self::bernstein`] and [`Self::greens`] give, two arrays one after the other.
    pub(crate) fn tabulate(&self, table: Table, x: &[f64], derivative: usize) -> Result<Vec<f64>> {
        check("derivative", None, derivative as f64, 0.0, 2.0)?;
        let count = x.len();
        if count > MOST_EVALUATIONS {
            return Err(too_many("x", "maxEvalPoints", MOST_EVALUATIONS, count));
        }
        let square = self.basis.square();
        let (least, most, columns) = match table {
            Table::Pair => (-f64::MAX, f64::MAX, 2),
            Table::Bernstein => (0.0, 1.0, 4),
            Table::Greens => {
                let angle = if square < 0.0 { LARGEST_EXPONENT } else { LARGEST_ANGLE };
                let most = (angle / self.basis.frequency()).min(LARGEST_PLACE);
                (-most, most, 2)
            }
        };
        let mut values = filled(0.0, columns * count)?;
        for (i, &x) in x.iter().enumerate() {
            check("x", Some(i), x, least, most)?;
            if let (Table::Bernstein, Some(four)) = (table, values.get_mut(4 * i..4 * i + 4)) {
                four.copy_from_slice(&self.basis.bernstein(x, derivative));
                continue;
            }
            let (first, second) = match table {
                Table::Greens => {
                    let at = stumpff(square * x * x);
                    (0.5 * x.abs() * x * x * at.c3, 0.5 * x * x.abs() * at.c2)
                }
                _ => self.at(x, derivative),
            };
            if let Some(value) = values.get_mut(i) {
                *value = first;
            }
            if let Some(value) = values.get_mut(count + i) {
                *value = second;
            }
        }
        Ok(values)
    }

    /// Weights of the exponential B-splines in terms of the generators: γ and μ of B₄ = γφ₁(x − 1) +
    /// (1 − 2γ)φ₁(x − 2) + γφ₁(x − 3) + (φ₂(x − 1) − φ₂(x − 3))/2, and of B₃ = (φ₁(x − 1) + φ₁(x − 2))/2 +
    /// μ(φ₂(x − 1) − φ₂(x − 2)).
    ///
    /// # Source
    ///
    /// [CRU15, eq. 23, 24] in the form γ = κ/2, μ = c₀/c₁ at ω/2 (D 4.3).
    pub fn b_spline_weights(&self) -> (f64, f64) {
        (0.5 * self.basis.kappa(), self.basis.half_cotangent())
    }

    /// The exponential B-spline of order 4 on [0, 4], or a derivative: the smoothest bump of the space. Its
    /// shifts sum to 1; for ω = 0 it is the cubic B-spline.
    ///
    /// # Source
    ///
    /// [CRU15, eq. 21, 23].
    pub fn b_spline4(&self, x: f64, derivative: usize) -> f64 {
        let (gamma, _) = self.b_spline_weights();
        let [one, two, three] = [1.0, 2.0, 3.0].map(|n| self.at(x - n, derivative));
        gamma * (one.0 + three.0) + (1.0 - 2.0 * gamma) * two.0 + 0.5 * (one.1 - three.1)
    }

    /// The exponential B-spline of order 3 on [0, 3], or a derivative: piecewise in 1, cos ωt, sin ωt. Its
    /// shifts sum to 1; for ω = 0 it is the quadratic B-spline.
    ///
    /// # Source
    ///
    /// [CRU15, eq. 22, 24].
    pub fn b_spline3(&self, x: f64, derivative: usize) -> f64 {
        let (_, mu) = self.b_spline_weights();
        let [one, two] = [1.0, 2.0].map(|n| self.at(x - n, derivative));
        0.5 * (one.0 + two.0) + mu * (one.1 - two.1)
    }
}
