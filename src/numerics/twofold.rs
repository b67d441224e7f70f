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

    /// a + b, exactly. [Dek71]
    #[inline]
    pub fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let part = high - a;
        Self { high, low: (a - (high - part)) + (b - part) }
    }

    /// a·b, exactly where nothing over- or underflows. [Dek71]
    #[inline]
    pub fn product(a: f64, b: f64) -> Self {
        let high = a * b;
        let (a, a_low) = split(a);
        let (b, b_low) = split(b);
        Self { high, low: ((a * b - high) + a * b_low + a_low * b) + a_low * b_low }
    }

    /// The sum, to a few units of 2⁻¹⁰⁵.
    #[inline]
    pub fn plus(self, other: Self) -> Self {
        let high = Self::sum(self.high, other.high);
        Self::sum(high.high, high.low + self.low + other.low)
    }

    /// The product, to a few units of 2⁻¹⁰⁴.
    #[inline]
    pub fn times(self, other: Self) -> Self {
        let high = Self::product(self.high, other.high);
        Self::sum(high.high, high.low + self.high * other.low + self.low * other.high)
    }

    /// The quotient, to a few units of 2⁻¹⁰³.
    #[inline]
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
    use super::Twofold;

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
}
