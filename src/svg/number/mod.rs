//! Decimal text and `f64`, correctly rounded both ways, in a few hundred bytes of code.
//!
//! The standard library's conversions are exact too, but they carry tables and formatting machinery that
//! weigh more than all the rest of path reading and writing together.

mod exact;
#[cfg(test)]
mod tests;
mod write;

pub(super) use write::{scaled, shortest, write};

/// 10⁰ … 10²²: the powers of ten that an `f64` holds exactly.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18,
    1e19, 1e20, 1e21, 1e22,
];
/// So many digits always fit in a `u64`.
const DIGITS_THAT_FIT: usize = 19;

/// The number whose text starts at `at`, and the offset behind it; `None` where no number starts.
///
/// ```text
/// sign? (digits ("." digits?)? | "." digits) (("e" | "E") sign? digits)?
/// ```
///
/// That is the grammar of SVG 1.1; SVG 2 wants a digit behind the point. An `e` without digits behind it is not
/// part of the number. Zero is never negative; what is too large becomes infinite.
pub(super) fn read(text: &[u8], at: usize) -> Option<(f64, usize)> {
    let byte = |i: usize| text.get(i).copied().unwrap_or(0);
    let negative = byte(at) == b'-';
    let first = at + usize::from(negative || byte(at) == b'+');
    let (whole, point) = digits(text, first, 0);
    let (mantissa, behind) =
        if byte(point) == b'.' { digits(text, point + 1, whole) } else { (whole, point) };
    let decimals = behind.saturating_sub(point + 1);
    let count = point - first + decimals;
    if count == 0 {
        return None;
    }
    let (power, end) = read_exponent(text, behind);
    let magnitude = if count > DIGITS_THAT_FIT {
        exact::read(text.get(first..behind).unwrap_or(&[]), power)
    } else {
        inline_decimal(mantissa, power - decimals as i32)
    };
    Some((if negative && magnitude != 0.0 { -magnitude } else { magnitude }, end))
}

/// The digits from `at` on, behind those of `before` (modulo 2⁶⁴), and where they end.
#[inline(always)]
fn digits(text: &[u8], at: usize, before: u64) -> (u64, usize) {
    let (mut value, mut i) = (before, at);
    while let Some(digit) = text.get(i).map(|byte| byte.wrapping_sub(b'0')).filter(|&digit| digit < 10) {
        value = value.wrapping_mul(10).wrapping_add(u64::from(digit));
        i += 1;
    }
    (value, i)
}

fn read_exponent(text: &[u8], at: usize) -> (i32, usize) {
    let byte = |i: usize| text.get(i).copied().unwrap_or(0);
    if byte(at) | 0x20 != b'e' {
        return (0, at);
    }
    let sign = byte(at + 1);
    let first = at + 1 + usize::from(sign == b'-' || sign == b'+');
    let (mut i, mut value) = (first, 0_i32);
    while byte(i).is_ascii_digit() {
        value = (value * 10 + i32::from(byte(i) - b'0')).min(100_000_000);
        i += 1;
    }
    if i == first { (0, at) } else { (if sign == b'-' { -value } else { value }, i) }
}

/// `mantissa`·10^`exponent`, correctly rounded.
#[inline(never)]
pub(super) fn decimal(mantissa: u64, exponent: i32) -> f64 {
    inline_decimal(mantissa, exponent)
}

/// The same where a call would show.
#[inline(always)]
pub(super) fn inline_decimal(mantissa: u64, exponent: i32) -> f64 {
    // Case both factors exact: one rounding, which is the right one.
    if mantissa <= 1 << 53
        && let Some(power) = POWERS.get(exponent.unsigned_abs() as usize)
    {
        let m = mantissa as f64;
        return if exponent < 0 { m / power } else { m * power };
    }
    long(mantissa, exponent)
}

#[cold]
#[inline(never)]
fn long(mantissa: u64, exponent: i32) -> f64 {
    let (mut digits, mut rest) = ([b'0'; 20], mantissa);
    for digit in digits.iter_mut().rev() {
        *digit += (rest % 10) as u8;
        rest /= 10;
    }
    exact::read(&digits, exponent)
}

/// Whether `digits`·10^−`decimals` is below 1, for up to 22 decimals.
pub(super) fn below_one(digits: u64, decimals: u32) -> bool {
    // What is above all integers of 64 bits becomes the last of them.
    digits < power(decimals) as u64
}

/// 10^`decimals` for up to 22 decimals.
pub(super) fn power(decimals: u32) -> f64 {
    POWERS.get(decimals as usize).copied().unwrap_or(f64::INFINITY)
}
