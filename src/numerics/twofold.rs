//! Numbers of two doubles, 106 bits: for sums in which a double would lose the answer.

/// The unevaluated sum of two doubles, the second at most half a unit in the last place of the first.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Twofold {
    /// The number rounded.
    pub high: f64,
    /// What rounding left.
    pub low: f64,
}

impl Twofold {
    /// Zero.
    pub const ZERO: Self = Self { high: 0.0, low: 0.0 };

    /// The number itself.
    pub fn new(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }

    /// a + b, exactly. \[Dek71\]
    #[inline]
    pub fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let part = high - a;
        Self { high, low: (a - (high - part)) + (b - part) }
    }

    /// a·b, exactly where nothing over- or underflows. \[Dek71\]
    #[inline]
    pub fn product(a: f64, b: f64) -> Self {
        let high = a * b;
        let (a, a_low) = split(a);
        let (b, b_low) = split(b);
        Self { high, low: ((a * b - high) + a * b_low + a_low * b) + a_low * b_low }
    }

    /// The sum, to a few units of 2⁻¹⁰⁵. Like product and quotient out of line: these are for preparations, and are
    /// large.
    #[inline(never)]
    pub fn plus(self, other: Self) -> Self {
        let high = Self::sum(self.high, other.high);
        Self::sum(high.high, high.low + self.low + other.low)
    }

    /// The product, to a few units of 2⁻¹⁰⁴.
    #[inline(never)]
    pub fn times(self, other: Self) -> Self {
        let high = Self::product(self.high, other.high);
        Self::sum(high.high, high.low + self.high * other.low + self.low * other.high)
    }

    /// The number plus a·b.
    #[inline(never)]
    pub fn plus_product(self, a: Self, b: Self) -> Self {
        self.plus(a.times(b))
    }

    /// The quotient, to a few units of 2⁻¹⁰³.
    #[inline(never)]
    pub fn over(self, other: Self) -> Self {
        let first = self.high / other.high;
        let rest = self.plus(other.times(Self::new(-first)));
        let second = rest.high / other.high;
        let rest = rest.plus(other.times(Self::new(-second)));
        Self::sum(first, second).plus(Self::new(rest.high / other.high))
    }

    /// The number with the other sign.
    #[inline]
    pub fn negative(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }

    /// The number rounded to a double.
    #[inline]
    pub fn value(self) -> f64 {
        self.high + self.low
    }
}

/// e^x for |x| ≤ 300, to 2⁻⁹⁰ or so: x/256 by its series, squared eight times.
#[inline(never)]
pub fn exponential(x: f64) -> Twofold {
    let x = Twofold::new(x / 256.0);
    // e^x − 1 keeps its digits: (1 + e)² − 1 = e(2 + e).
    let mut rest = series(x, 24, 1, 0);
    for _ in 0..8 {
        rest = rest.times(rest.plus(Twofold::new(2.0)));
    }
    rest.plus(Twofold::new(1.0))
}

/// cos x for |x| ≤ 16, to 2⁻⁹⁰ of 1.
pub fn cosine(x: f64) -> Twofold {
    sine_and_cosine(x).1
}

/// sin x and cos x for |x| ≤ 16, to 2⁻⁹⁰ of 1: sin x/64 and 1 − cos x/64 by their series, doubled six times.
#[inline(never)]
pub fn sine_and_cosine(x: f64) -> (Twofold, Twofold) {
    let x = Twofold::new(x / 64.0);
    let square = x.times(x).negative();
    let mut sine = x.plus_product(x, series(square, 12, 2, 1));
    // With v = 1 − cos: 1 − cos 2x = 2v(2 − v).
    let mut versine = series(square, 12, 2, 0).negative();
    for _ in 0..6 {
        let product = sine.times(Twofold::new(1.0).plus(versine.negative()));
        sine = product.plus(product);
        let half = versine.times(Twofold::new(2.0).plus(versine.negative()));
        versine = half.plus(half);
    }
    (sine, Twofold::new(1.0).plus(versine.negative()))
}

/// x/(s + f)! + x²/(2s + f)! + … times f!, to `terms` terms.
fn series(x: Twofold, terms: usize, stride: usize, from: usize) -> Twofold {
    let mut sum = Twofold::ZERO;
    for k in (1..=terms).rev() {
        let mut divisor = 1.0;
        for j in 0..stride {
            divisor *= (stride * k + from - j) as f64;
        }
        sum = sum.plus(Twofold::new(1.0)).times(x).over(Twofold::new(divisor));
    }
    sum
}

/// Halves of 26 bits each.
#[inline]
fn split(a: f64) -> (f64, f64) {
    const FACTOR: f64 = 134_217_729.0;
    let scaled = FACTOR * a;
    let high = scaled - (scaled - a);
    (high, a - high)
}

#[cfg(test)]
mod tests {
    use super::{Twofold, cosine, exponential, sine_and_cosine};

    #[test]
    fn what_a_double_loses_is_kept() {
        let tiny = 1e-25;
        let sum = Twofold::new(1.0).plus(Twofold::new(tiny)).plus(Twofold::new(-1.0));
        assert!((sum.value() - tiny).abs() < 1e-32, "{sum:?}");
        let third = Twofold::new(1.0).over(Twofold::new(3.0));
        let one = third.times(Twofold::new(3.0)).plus(Twofold::new(-1.0));
        assert!(one.value().abs() < 1e-31, "{one:?}");
        let square = Twofold::product(1.0 + f64::EPSILON, 1.0 - f64::EPSILON);
        assert_eq!(square.low, -f64::EPSILON * f64::EPSILON, "the product is exact");
    }

    #[test]
    fn exponentials_and_cosines_keep_their_laws_to_thirty_digits() {
        for k in -40..=40 {
            let x = f64::from(k) * 0.25;
            let one = exponential(x).times(exponential(-x)).plus(Twofold::new(-1.0));
            assert!(one.value().abs() < 1e-27, "{x}: {one:?}");
            assert!((exponential(x).high / x.exp() - 1.0).abs() < 1e-15, "{x}");
            let double = cosine(x).times(cosine(x)).times(Twofold::new(2.0)).plus(Twofold::new(-1.0));
            let off = double.plus(cosine(2.0 * x).negative());
            assert!(x.abs() > 8.0 || off.value().abs() < 1e-26, "{x}: {off:?}");
            assert!((cosine(x).high - x.cos()).abs() < 1e-15, "{x}");
        }
        for k in -64..=64 {
            let x = f64::from(k) * 0.25;
            let (sine, cosine) = sine_and_cosine(x);
            let one = sine.times(sine).plus_product(cosine, cosine).plus(Twofold::new(-1.0));
            assert!(one.value().abs() < 1e-26, "{x}: {one:?}");
            assert!((sine.high - x.sin()).abs() < 1e-15, "{x}");
        }
        // π/2 to 32 digits is a double and this.
        let quarter = cosine(core::f64::consts::FRAC_PI_2);
        assert!((quarter.value() / 6.123_233_995_736_766e-17 - 1.0).abs() < 1e-10, "{quarter:?}");
    }
}
