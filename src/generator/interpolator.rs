//! Interpolators of compact support: combinations of half-integer shifts of an exponential B-spline.

use core::f64::consts::PI;

use nalgebra::Complex;

use super::exponential_b_spline::{ExponentialBSpline, tabulate};
use super::pieces::{PolynomialPieces, polynomial};
use super::propagation::{Propagated, recentre};
use super::riesz::RieszBounds;
use super::root::Root;
use super::roots::{Roots, too_fast};
use crate::error::{Error, Result};
use crate::limits::with_room;
use crate::numerics::angle::sin_cos;
use crate::numerics::dense::inverse;
use crate::numerics::lists::dot;
use crate::numerics::twofold::{Twofold, exponential, sine_and_cosine};

/// Above this condition the linear system counts as singular.
const WORST_CONDITION: f64 = 1e12;
/// The identity Σλₙe^{−αn/2}·β̂(α) = 1 holds to this, or there is no interpolator.
const IDENTITY: f64 = 1e-6;
/// What the roundings of λ do to it, relative to their sum.
const ROUNDING: f64 = 1e-12;
/// And what those of λ in twofold numbers do, relative to the largest and to the condition.
const TWOFOLD_ROUNDING: f64 = 1e-30;
/// Rounds of elimination: each adds the digits that the condition leaves of sixteen, four at the worst.
const MOST_ROUNDS: usize = 8;
/// Below this the shifts do not form a Riesz basis.
const LEAST_RIESZ: f64 = 1e-7;
/// Places per half unit at which the Lebesgue function is looked at.
const LOOKS: usize = 40;

/// The interpolator φ of a list of roots: φ(k) = δₖ, φ = λ₀β + Σₙ λₙ(β(· − n/2) + β(· + n/2)), n ≤ n₀ − 2.
///
/// It is even, has n₀ − 2 continuous derivatives and vanishes for |x| ≥ n₀ − 1. Its integer shifts reproduce what the
/// roots stand for.
///
/// # Domain
///
/// Lists of 3 roots and more that are closed under conjugation and negation, with |im| < π. There it exists, as far as
/// anyone knows; the conjecture that it always does is false (docs/SOURCES.md).
///
/// # Accuracy
///
/// 1e-15 of the largest value, λ itself 1e-15 (`tests/generator/interpolators.rs`): the pieces are added up in twofold
/// precision. Roots that crowd near ±iπ make φ large between the points: see [`Self::condition`] and
/// [`Self::lebesgue`].
///
/// # Source
///
/// [SFBGU17, Definition 3, eq. 24–27].
///
/// # Example
///
/// ```
/// use expline::generator::Interpolator;
///
/// let generator = Interpolator::for_ellipse(5)?;
/// assert_eq!(generator.support(), 2);
/// // A circle through five points: cos(2π/5·t) halfway between two of them.
/// let places = [-1.5, -0.5, 0.5, 1.5];
/// let angle = core::f64::consts::TAU / 5.0;
/// let value: f64 = places.iter().map(|x| generator.at(*x, 0) * (angle * (0.5 - x)).cos()).sum();
/// assert!((value - (angle / 2.0).cos()).abs() < 1e-15);
/// # Ok::<(), expline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Interpolator {
    spline: ExponentialBSpline,
    lambda: Vec<f64>,
    halves: PolynomialPieces,
    condition: f64,
    identity: f64,
}

impl Interpolator {
    /// The interpolator of these roots.
    ///
    /// # Errors
    ///
    /// Fewer than 3 roots; a root without its opposite; |im| ≥ π; a system whose condition exceeds 1e12, and roots that
    /// leave no digits otherwise.
    pub fn new(roots: &Roots) -> Result<Self> {
        if let Some(i) = roots.too_fast() {
            return Err(too_fast(i, roots.as_slice()[i].im, PI));
        }
        Self::beyond_pi(roots)
    }

    /// The interpolator of roots with |im| up to 10, where it exists.
    ///
    /// # Errors
    ///
    /// As [`Self::new`], without the bound on |im|; shifts that are no Riesz basis.
    pub fn beyond_pi(roots: &Roots) -> Result<Self> {
        let order = roots.order();
        if order < 3 {
            return Err(Error::too_few("roots", order, 3));
        }
        if let Some(i) = roots.without_opposite() {
            return Err(Error::degenerate("roots", Some(i), "its opposite is missing"));
        }
        let exact = Propagated::new(roots)?;
        let spline = ExponentialBSpline::rounded(roots, &exact)?;
        let (weights, condition) = solve(roots, &exact)?;
        let halves = halves(order, &exact, &weights)?;
        let lambda = weights.iter().map(|l| l.high).collect();
        let identity = deviation_of_identity(roots, &weights, condition);
        let interpolator = Self { spline, lambda, halves, condition, identity };
        // Written so that NaN fails.
        let rounding = interpolator.lambda.iter().fold(0.0, |sum, l| sum + l.abs()) * ROUNDING;
        let sound = interpolator.identity <= IDENTITY + rounding && condition <= WORST_CONDITION;
        if !sound || (roots.too_fast().is_some() && interpolator.halves.riesz_bounds().lower < LEAST_RIESZ) {
            return Err(nonexistent(roots));
        }
        Ok(interpolator)
    }

    /// Roots (0, ±2πi/count): ellipses through `count` ≥ 3 points are exact.
    ///
    /// # Errors
    ///
    /// Fewer than 3 points a turn.
    pub fn for_ellipse(count: usize) -> Result<Self> {
        Self::new(&Roots::ellipse(count)?)
    }

    /// λ₀ … λ_{n₀−2}.
    pub fn lambda(&self) -> &[f64] {
        &self.lambda
    }

    /// n₀ − 1: φ vanishes for |x| ≥ this.
    pub fn support(&self) -> usize {
        self.order() - 1
    }

    /// The number of roots, n₀.
    pub fn order(&self) -> usize {
        self.spline.order()
    }

    /// The roots.
    pub fn roots(&self) -> &Roots {
        self.spline.roots()
    }

    /// The B-spline that φ is a combination of.
    pub fn b_spline(&self) -> &ExponentialBSpline {
        &self.spline
    }

    /// The polynomial on [k/2, (k + 1)/2], k = −2(n₀ − 1) … 2(n₀ − 1) − 1, in ascending powers of the distance from the
    /// middle of that interval; empty elsewhere. All have one length.
    pub fn half_piece(&self, k: isize) -> &[f64] {
        let first = 2 * self.support() as isize;
        if (-first..first).contains(&k) { self.halves.piece((k + first) as usize) } else { &[] }
    }

    /// φ at x, or a derivative. Orders to n₀ − 2 are continuous; beyond, the limit from the right.
    pub fn at(&self, x: f64, derivative: usize) -> f64 {
        self.halves.at(x + self.support() as f64, derivative)
    }

    /// φ, or a derivative of an order to n₀ − 1, at every x.
    ///
    /// # Errors
    ///
    /// An x that is not finite, a derivative above n₀ − 1, more than 4 million places.
    pub fn evaluate(&self, x: &[f64], derivative: usize) -> Result<Vec<f64>> {
        tabulate(x, derivative, self.order() - 1, &|x| self.at(x, derivative))
    }

    /// The largest lower and the smallest upper Riesz bound of the integer shifts, exactly; the bounds of
    /// [SFBGU17, eq. A.6, A.7] enclose them.
    pub fn riesz_bounds(&self) -> RieszBounds {
        self.halves.riesz_bounds()
    }

    /// The condition of the linear system for λ in the maximum norm, its rows scaled to 1. Above 1e6 digits are lost.
    pub fn condition(&self) -> f64 {
        self.condition
    }

    /// How far Σₙλₙe^{−αn/2}·β̂(α) is from 1, at the worst root α and beyond what roundings explain: a check on all of
    /// the computation, in twofold precision (D 9.5).
    pub fn identity(&self) -> f64 {
        self.identity
    }

    /// The Lebesgue constant max Σₖ|φ(t − k)|: how much an error in the points can grow on the curve.
    pub fn lebesgue(&self) -> f64 {
        let step = 0.5 / LOOKS as f64;
        let (mut best, mut most) = (0.0, 1.0);
        for i in 1..=LOOKS {
            let value = self.lebesgue_at(step * i as f64);
            if value > most {
                (best, most) = (step * i as f64, value);
            }
        }
        // Thirds of the bracket until it is too small to matter.
        let (mut lo, mut hi) = (best - step, best + step);
        for _ in 0..LOOKS {
            let third = (hi - lo) / 3.0;
            let [below, above] = [lo + third, hi - third].map(|t| self.lebesgue_at(t));
            most = most.max(below).max(above);
            if below > above {
                hi -= third;
            } else {
                lo += third;
            }
        }
        most
    }

    #[inline(never)]
    fn lebesgue_at(&self, t: f64) -> f64 {
        let reach = self.support() as isize;
        (1 - reach..=reach).map(|k| self.at(t - k as f64, 0).abs()).sum()
    }

    pub(crate) fn pieces(&self) -> &PolynomialPieces {
        &self.halves
    }
}

/// How far Σₙλₙe^{−αn/2}·β̂(α) is from 1, at the worst root α, beyond what the roundings of λ explain.
///
/// In twofold numbers λ is right to 1e-30 of the largest, times the condition.
#[inline(never)]
fn deviation_of_identity(roots: &Roots, weights: &[Twofold], condition: f64) -> f64 {
    let rounding =
        weights.iter().fold(0.0, |most: f64, l| most.max(l.high.abs())) * TWOFOLD_ROUNDING * condition;
    let mut worst: f64 = 0.0;
    for root in roots.upper() {
        let (sum, size) = weighted_exponentials(root, weights);
        // β is β⁺ shifted to the left by n₀/2, which multiplies its transform by e^{α·n₀/2}.
        let (x, y) = (0.5 * roots.order() as f64 * root.re, 0.5 * roots.order() as f64 * root.im);
        let (sine, cosine) = sin_cos(y);
        let shift = Complex::new(cosine, sine) * libm::exp(x);
        let transform = roots.transform(Complex::new(root.re, root.im)) * shift;
        let off = sum * transform - Complex::new(1.0, 0.0);
        let deviation = length(off) - rounding * size * length(transform);
        if deviation > worst || deviation.is_nan() {
            worst = deviation;
        }
    }
    worst
}

fn length(z: Complex<f64>) -> f64 {
    (z.re * z.re + z.im * z.im).sqrt()
}

/// λ₀ + Σ λₙ(e^{−αn/2} + e^{αn/2}), and the sum of the sizes of what is multiplied by λ.
///
/// The terms of real roots are up to e^{|α|(n₀ − 1)} times their sum: in doubles nothing of it would be left.
fn weighted_exponentials(root: Root, weights: &[Twofold]) -> (Complex<f64>, f64) {
    let (up, down) = (exponential(0.5 * root.re), exponential(-0.5 * root.re));
    let (sine, cosine) = sine_and_cosine(0.5 * root.im);
    let first = [up.plus(down).times(cosine), up.plus(down.negative()).times(sine)];
    let (mut before, mut now) = ([Twofold::new(2.0), Twofold::ZERO], first);
    let (mut sum, mut size) = ([weights[0], Twofold::ZERO], 1.0);
    for weight in &weights[1..] {
        sum = [sum[0].plus_product(*weight, now[0]), sum[1].plus_product(*weight, now[1])];
        size += now[0].high.abs() + now[1].high.abs();
        // 2 cosh (n + 1)a = 2 cosh a · 2 cosh na − 2 cosh (n − 1)a.
        let re = first[0].times(now[0]).plus_product(first[1].negative(), now[1]);
        let im = first[0].times(now[1]).plus_product(first[1], now[0]);
        (before, now) = (now, [re.plus(before[0].negative()), im.plus(before[1].negative())]);
    }
    (Complex::new(sum[0].value(), sum[1].value()), size)
}

/// Below π no list is known that has none, however few of its digits are left.
fn nonexistent(roots: &Roots) -> Box<Error> {
    let beyond = roots.too_fast().is_some();
    Error::degenerate(
        "roots",
        None,
        if beyond {
            "there is no interpolator for these roots"
        } else {
            "no digits of the interpolator are left"
        },
    )
}

/// λ and the condition of its system.
///
/// Row k says φ(k) = δₖ: `A[k][l]` = β(k − l/2) + β(k + l/2), without the second term for l = 0 [SFBGU17, eq. 26, 27].
/// What is left over in twofold numbers goes through the same elimination until nothing is (D 9.4), in which there are
/// closed forms for three roots, too, that are less exact near π.
#[inline(never)]
fn solve(roots: &Roots, exact: &Propagated) -> Result<(Vec<Twofold>, f64)> {
    let order = roots.order();
    let size = order - 1;
    // β at half of j − n₀.
    let sample = |j: usize| exact.sample(j / 2, j % 2 == 1);
    let mut matrix = with_room(size * size)?;
    let mut scaled = with_room(size * size)?;
    let mut right = with_room(size)?;
    for k in 0..size {
        let row = matrix.len();
        for l in 0..size {
            let (above, below) = (sample(order + 2 * k + l), order + 2 * k - l);
            matrix.push(if l == 0 { above } else { above.plus(sample(below)) });
        }
        // Rows that sum to 1 tell the condition of the problem from that of its scale.
        let total: f64 = matrix[row..].iter().map(|a| a.high.abs()).sum();
        scaled.extend(matrix[row..].iter().map(|a| a.high / total));
        right.push(1.0 / total);
    }
    let Some(inverse) = inverse(&scaled, size) else {
        return Err(nonexistent(roots));
    };
    let mut condition: f64 = 0.0;
    for row in inverse.chunks_exact(size) {
        let total: f64 = row.iter().map(|a| a.abs()).sum();
        condition = if total <= condition { condition } else { total };
    }
    let mut lambda = vec![Twofold::ZERO; size];
    let mut left = vec![0.0; size];
    for _ in 0..MOST_ROUNDS {
        for (k, row) in matrix.chunks_exact(size).enumerate() {
            let mut rest = Twofold::new(if k == 0 { 1.0 } else { 0.0 });
            for (a, l) in row.iter().zip(&lambda) {
                rest = rest.plus_product(a.negative(), *l);
            }
            left[k] = rest.high * right[k];
        }
        for (lambda, row) in lambda.iter_mut().zip(inverse.chunks_exact(size)) {
            *lambda = lambda.plus(Twofold::new(dot(row, &left)));
        }
    }
    Ok((lambda, condition))
}

/// φ on every half interval: the halves of the B-spline's pieces, weighted by λ, about the middles of the halves
/// (D 9.3).
#[inline(never)]
fn halves(order: usize, exact: &Propagated, lambda: &[Twofold]) -> Result<PolynomialPieces> {
    let terms = exact.terms;
    let mut parts: Vec<Twofold> = with_room(2 * order * terms)?;
    for piece in exact.coefficients.chunks_exact(terms) {
        for by in [-0.25, 0.25] {
            let begin = parts.len();
            parts.extend_from_slice(piece);
            recentre(&mut parts[begin..], by, terms);
        }
    }
    let count = 4 * (order - 1);
    let mut coefficients = with_room(count * terms)?;
    coefficients.resize(count * terms, Twofold::ZERO);
    let reach = order as isize - 2;
    for k in 0..count / 2 {
        let begin = (count / 2 + k) * terms;
        for n in -reach..=reach {
            // β(x − n/2) for x in half interval k: half interval k − n of β, which is k − n + n₀ from its left end.
            let Ok(part) = usize::try_from(k as isize - n + order as isize) else { continue };
            let Some(part) = parts.get(part * terms..(part + 1) * terms) else { continue };
            let weight = lambda[n.unsigned_abs()];
            for (sum, c) in coefficients[begin..].iter_mut().zip(part) {
                *sum = sum.plus_product(weight, *c);
            }
        }
        let mirror = (count / 2 - 1 - k) * terms;
        for q in 0..terms {
            let c = coefficients[begin + q];
            coefficients[mirror + q] = if q % 2 == 1 { c.negative() } else { c };
        }
    }
    let mut pieces = Propagated { coefficients, terms }.rounded(2, order - 1)?;
    settle(&mut pieces);
    Ok(pieces)
}

/// Makes φ(k) = 0 hold to the last bit and φ(0) = 1 to the last but one, from either side, by what rounding took from
/// the constant terms.
fn settle(pieces: &mut PolynomialPieces) {
    let count = pieces.count();
    for (k, piece) in pieces.coefficients.chunks_exact_mut(pieces.stride).enumerate() {
        // Every half interval has an integer at one end: at its start if its number from the left is even.
        let (integer, y) = if k % 2 == 0 { (k, -0.25) } else { (k + 1, 0.25) };
        let value = if integer == count / 2 { 1.0 } else { 0.0 };
        piece[0] = 0.0;
        piece[0] = value - polynomial(piece, y, 0);
    }
}
