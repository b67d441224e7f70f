//! Numbers with a point in the middle and room for every `f64` on either side of it: what exact conversion needs in the
//! rare case that 64 bits are too few.

/// Limbs on either side of the point, and their bits: 10³³⁰ has room before it, half of the smallest `f64` behind it.
const HALF: usize = 36;
const POINT: usize = 32 * HALF;
/// So many bits behind the point is the last one of the smallest `f64`.
const LAST_BIT: usize = 1074;
/// No midpoint between two `f64` has more significant digits than 767: later ones only say "a bit more".
const MOST_DIGITS: usize = 800;
/// Beyond so many digits before the point, or zeros behind it, there is no `f64`.
const FARTHEST: i32 = 330;
/// So many digits are less than a limb.
const GROUP: i32 = 9;

/// A number that is not negative, least limb first.
struct Exact {
    limbs: [u32; 2 * HALF],
    /// Whether the number is a little more than the limbs say.
    more: bool,
}

impl Exact {
    const ZERO: Self = Self { limbs: [0; 2 * HALF], more: false };

    /// What lies before the point becomes so many times what it was and a summand; with `all`, what lies behind it as
    /// well.
    fn multiply(&mut self, factor: u32, summand: u32, all: bool) {
        let mut carry = u64::from(summand);
        for limb in &mut self.limbs[if all { 0 } else { HALF }..] {
            carry += u64::from(*limb) * u64::from(factor);
            *limb = carry as u32;
            carry >>= 32;
        }
    }

    /// What lies behind the point becomes the quotient of `whole` and itself by a divisor larger than `whole`.
    ///
    /// So many limbs are looked at: what would come behind them is only "a bit more".
    fn divide(&mut self, divisor: u32, whole: u32, depth: usize) {
        let mut rest = u64::from(whole);
        for limb in self.limbs[HALF.saturating_sub(depth)..HALF].iter_mut().rev() {
            rest = rest << 32 | u64::from(*limb);
            *limb = (rest / u64::from(divisor)) as u32;
            rest %= u64::from(divisor);
        }
        self.more |= rest != 0;
    }

    /// 64 bits from bit `at` on.
    fn window(&self, at: usize) -> u64 {
        let limb = |i: usize| u128::from(self.limbs.get(at / 32 + i).copied().unwrap_or(0));
        ((limb(0) | limb(1) << 32 | limb(2) << 64) >> (at % 32)) as u64
    }

    /// Whether one of these limbs is not 0.
    fn any(&self, mut limbs: core::ops::Range<usize>) -> bool {
        limbs.any(|i| self.limbs.get(i).is_some_and(|&limb| limb != 0))
    }

    /// To the nearest `f64`, ties to even.
    fn round(&self) -> f64 {
        let Some(top) = self.limbs.iter().rposition(|&limb| limb != 0) else { return 0.0 };
        let highest = 32 * top + 31 - self.limbs[top].leading_zeros() as usize;
        if highest > POINT + 1023 {
            return f64::INFINITY;
        }
        // The last bit that is kept, and the one behind it.
        let last = highest.saturating_sub(52).max(POINT - LAST_BIT);
        let (kept, half) = (self.window(last), last - 1);
        let rest = self.more
            || self.any(0..half / 32)
            || self.window(half / 32 * 32) as u32 & ((1 << (half % 32)) - 1) != 0;
        let up = self.window(half) & 1 == 1 && (rest || kept & 1 == 1);
        // The first bit of a normal number, which is not written, and a carry count the exponent up by themselves.
        f64::from_bits((((last + LAST_BIT - POINT) as u64) << 52) + kept + u64::from(up))
    }
}

/// 10^`decimals` for up to nine of them.
fn ten_to(decimals: i32) -> u32 {
    super::power(decimals as u32) as u32
}

/// The number with these digits, one of which may be a point, times 10^`power`, correctly rounded.
pub(super) fn read(text: &[u8], power: i32) -> f64 {
    let (mut digits, mut count, mut number) = ([0; MOST_DIGITS], 0, Exact::ZERO);
    // How many digits are before the point, less the zeros behind it.
    let (mut point, mut behind) = (power, 0);
    for &b in text {
        if b == b'.' {
            behind = 1;
            continue;
        }
        let digit = b - b'0';
        if count > 0 || digit != 0 {
            match digits.get_mut(count) {
                Some(place) => *place = digit,
                None => number.more |= digit != 0,
            }
            count += 1;
            point += 1;
        }
        point -= behind;
    }
    if count == 0 || point < -FARTHEST {
        return 0.0;
    }
    if point > FARTHEST {
        return f64::INFINITY;
    }
    let group = |from: i32, to: i32| {
        (from..to).fold(0, |sum, i| 10 * sum + u32::from(digits.get(i as usize).copied().unwrap_or(0)))
    };
    let mut at = 0;
    while at < point {
        let next = point.min(at + GROUP);
        number.multiply(ten_to(next - at), group(at, next), false);
        at = next;
    }
    let mut end = count.min(MOST_DIGITS) as i32;
    // A limb is more than nine of the zeros behind the point, and four hold all bits of an `f64` and the one behind
    // them.
    let depth = 5 + (-point).max(0) as usize / 9;
    while end > point {
        let next = point.max(end - GROUP);
        number.divide(ten_to(end - next), group(next, end), depth);
        end = next;
    }
    number.round()
}

/// `value`·10^`decimals`, rounded to the nearest integer, halves up; clamped to 64 bits.
#[inline(never)]
pub(super) fn scaled(value: f64, decimals: u32) -> u64 {
    let bits = value.to_bits();
    let (exponent, fraction) = ((bits >> 52) as usize, bits & ((1 << 52) - 1));
    let mantissa = if exponent == 0 { fraction } else { fraction | 1 << 52 };
    let at = exponent.max(1) - 1 + POINT - LAST_BIT;
    let mut number = Exact::ZERO;
    for (i, limb) in number.limbs[at / 32..][..3].iter_mut().enumerate() {
        *limb = ((u128::from(mantissa) << (at % 32)) >> (32 * i)) as u32;
    }
    let mut left = decimals as i32;
    while left > 0 {
        let step = left.min(GROUP);
        number.multiply(ten_to(step), 0, true);
        left -= step;
    }
    if number.any(HALF + 2..2 * HALF) {
        return u64::MAX;
    }
    number.window(POINT).saturating_add(number.window(POINT - 1) & 1)
}
