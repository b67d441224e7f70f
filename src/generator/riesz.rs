//! How stable the Hermite representation is: Gram entries and exact Riesz bounds.

use super::{Basis, HermiteGenerators};
use crate::numerics::quadrature::{SIXTEEN, nodes};

/// Inner products of the generators and their shifts; all others vanish or follow by symmetry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gram {
    /// ⟨φ₁, φ₁(· − 1)⟩; 9/70 for ω = 0.
    pub a: f64,
    /// ‖φ₁‖²; 26/35 for ω = 0.
    pub b: f64,
    /// ⟨φ₁, φ₂(· − 1)⟩; −13/420 for ω = 0.
    pub c: f64,
    /// ⟨φ₂, φ₂(· − 1)⟩; −1/140 for ω = 0.
    pub d: f64,
    /// ‖φ₂‖²; 2/105 for ω = 0.
    pub e: f64,
}

/// The largest `lower` and the smallest `upper` for which every curve r of the space with values and derivatives a
/// keeps lower·‖a‖ ≤ ‖r‖ ≤ upper·‖a‖, in the norms of square sums and square integrals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RieszBounds {
    /// The lower bound.
    pub lower: f64,
    /// The upper bound.
    pub upper: f64,
}

/// Panels at the ends of a hyperbolic segment are this long, in units of 1/w, and there are so many of them.
const REACH: f64 = 4.0;
const LAYERS: usize = 10;

/// Squares and products of the three parts of the weights, integrated over the segment.
struct Moments {
    /// ∫(chord − 1/2)².
    chord: f64,
    /// ∫E², E the even part of the leaving weight about the middle.
    even: f64,
    /// ∫O², O its odd part.
    odd: f64,
    /// ∫(1/2 − chord)(O − E).
    mixed: f64,
}

impl HermiteGenerators {
    /// The entries of the Gram matrix.
    ///
    /// # Accuracy
    ///
    /// 3e-15 relative for ω ≤ π, 1e-14 elsewhere (`tests/generator/stability.rs`).
    ///
    /// # Source
    ///
    /// [CRU15, sec. 5]; by quadrature of the stable weights instead of the closed forms, which lose eps·ω⁻⁷
    /// (D 6.1).
    pub fn gram(&self) -> Gram {
        Gram::of(&moments(self.basis()))
    }

    /// The exact Riesz bounds.
    ///
    /// In the hyperbolic space and for ω ≤ 5.7754 in the trigonometric one they are sqrt(e + 2d) and 1, both attained
    /// by constant sequences. From 5.8887 to the pole at 2π the upper one is that of alternating derivatives,
    /// sqrt(e − 2d); between, it is attained at a frequency inside.
    ///
    /// # Accuracy
    ///
    /// 1e-14 relative (`tests/generator/stability.rs`, against a dense scan of the Fourier Gram matrix). Exact means
    /// that no grid is searched: (D 6.3) lists every place where an eigenvalue can be extreme.
    pub fn riesz_bounds(&self) -> RieszBounds {
        let m = moments(self.basis());
        let gram = Gram::of(&m);
        // At ω = 0 and ω = π the matrix is diagonal; b + 2a = 1 because φ₁'s shifts sum to 1.
        let ends = [1.0, 4.0 * m.chord, 4.0 * m.odd, 4.0 * m.even];
        let mut bounds = (f64::INFINITY, 0.0_f64);
        let mut extend = |value: f64| bounds = (bounds.0.min(value), bounds.1.max(value));
        for value in ends {
            extend(value);
        }
        for cosine in gram.stationary().into_iter().filter(|x| x.abs() < 1.0) {
            let (least, most) = gram.eigenvalues(cosine);
            extend(least);
            extend(most);
        }
        RieszBounds { lower: bounds.0.max(0.0).sqrt(), upper: bounds.1.sqrt() }
    }
}

impl Gram {
    fn of(m: &Moments) -> Self {
        Self {
            a: 0.25 - m.chord,
            b: 0.5 + 2.0 * m.chord,
            c: m.mixed,
            d: m.odd - m.even,
            e: 2.0 * (m.odd + m.even),
        }
    }

    /// The two eigenvalues of the Fourier Gram matrix at the frequency with this cosine.
    ///
    /// # Source
    ///
    /// [CRU15, sec. 5, Theorem 1]: the matrix is Hermitian, [[b + 2a cos ω, −2ic sin ω], [2ic sin ω, e + 2d cos ω]].
    pub fn eigenvalues(&self, cosine: f64) -> (f64, f64) {
        let (first, second) = (self.b + 2.0 * self.a * cosine, self.e + 2.0 * self.d * cosine);
        let product = 4.0 * self.c * self.c * (1.0 - cosine * cosine);
        let half = 0.5 * (first - second);
        let most = 0.5 * (first + second) + (half * half + product).sqrt();
        ((first * second - product) / most, most)
    }

    /// The cosines at which an eigenvalue λ may be stationary: where the characteristic polynomial, a quadratic
    /// in the cosine, has a double root (D 6.3). That is a quadratic equation in λ.
    fn stationary(&self) -> [f64; 2] {
        let Self { a, b, c, d, e } = *self;
        let leading = 4.0 * (a * d + c * c);
        // The coefficient of the cosine is slope·λ + offset, the constant one λ² − (b + e)λ + be − 4c².
        let (slope, offset) = (-2.0 * (a + d), 2.0 * (a * e + b * d));
        let second = slope * slope - 4.0 * leading;
        let first = slope * offset + 2.0 * leading * (b + e);
        let zeroth = offset * offset - 4.0 * leading * (b * e - 4.0 * c * c);
        let root = (first * first - second * zeroth).max(0.0).sqrt();
        let larger = if first > 0.0 { -first - root } else { root - first };
        [larger / second, zeroth / larger].map(|lambda| -(slope * lambda + offset) / (2.0 * leading))
    }
}

fn moments(basis: &Basis) -> Moments {
    // Panels from the start to the middle on which sixteen points are enough: a hyperbolic segment of large w bends
    // within a few 1/w of its ends and is straight, to e⁻⁴⁰, between.
    let width = if basis.square() < 0.0 { REACH / basis.frequency() } else { 0.5 };
    let mut sums = [0.0; 4];
    let mut from = 0.0_f64;
    for k in 0..=LAYERS {
        let to = if k == LAYERS { 0.5 } else { (from + width).min(0.5) };
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        nodes(&SIXTEEN, |node, weight| {
            let w = basis.weights(middle + half * node, 0);
            let (chord, even, odd) =
                (0.5 - w.chord, 0.5 * (w.leaving - w.arriving), 0.5 * (w.leaving + w.arriving));
            let products = [chord * chord, even * even, odd * odd, chord * odd - 0.5 * even];
            for (sum, product) in sums.iter_mut().zip(products) {
                // Twice, for the other half of the segment.
                *sum += 2.0 * half * weight * product;
            }
        });
        if to >= 0.5 {
            break;
        }
        from = to;
    }
    let [chord, even, odd, mixed] = sums;
    Moments { chord, even, odd, mixed }
}
