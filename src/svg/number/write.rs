//! `f64` → decimal text.

use super::{decimal, exact, power};

/// Room for twenty digits, twenty-two decimals and a sign.
const MOST_BYTES: usize = 32;
const BILLION: u64 = 1_000_000_000;

/// |`value`|·10^`decimals`, rounded to the nearest integer, halves up; clamped to 64 bits.
pub(in crate::svg) fn scaled(value: f64, decimals: u32) -> u64 {
    let value = value.abs();
    // Case far from a half: the product's error is below 2⁻⁸, so the nearest integer is the right one.
    let product = value * power(decimals);
    if product < 7e13 {
        let nearest = product.round_ties_even();
        if (product - nearest).abs() < 0.49 {
            return nearest as u64;
        }
    }
    exact::scaled(value, decimals)
}

/// Fewest decimals that bring `value` back to the last bit: (n, p) with |value| = n·10⁻ᵖ after reading.
pub(in crate::svg) fn shortest(value: f64) -> (u64, u32) {
    let value = value.abs();
    if value == 0.0 {
        return (0, 0);
    }
    // Fewer decimals than this leave no digit at all.
    let two = ((value.to_bits() >> 52) as i32).max(1) - 1022;
    let first = (f64::from(-two) * core::f64::consts::LOG10_2).max(0.0) as u32;
    let mut decimals = first;
    loop {
        let n = scaled(value, decimals);
        // 17 significant digits tell any two numbers apart.
        if decimals > first + 18 || decimal(n, -(decimals as i32)) == value {
            return (n, decimals);
        }
        decimals += 1;
    }
}

/// Digits that are made at once, and the numbers that have no more.
const EIGHT: usize = 8;
const HUNDRED_MILLION: u64 = 100_000_000;
/// Two lists of eight digits one behind the other, a point, a sign, and room to copy whole.
const FEW_BYTES: usize = 18 + MOST_BYTES;

/// Appends n·10^−`decimals`: no trailing zeros, no zero before the point; from 23 decimals on as an
/// integer with an exponent. Returns whether there is a point or an exponent. What comes `before` it is a sign or a
/// separator.
#[inline(never)]
pub(in crate::svg) fn write(out: &mut Vec<u8>, before: Option<u8>, n: u64, decimals: u32) -> bool {
    if n != 0 && n < HUNDRED_MILLION && decimals < EIGHT as u32 {
        write_few(out, before, n, decimals)
    } else {
        write_many(out, before, n, decimals)
    }
}

/// Eight digits, the first in the lowest byte: 4 + 4, then 2 + 2 twice, then one by one, side by side in one number.
#[inline(always)]
fn eight_digits(n: u64) -> u64 {
    let n = n as u32;
    let fours = u64::from(n / 10_000) | u64::from(n % 10_000) << 32;
    // Below 10⁴, 5243/2¹⁹ is 1/100 near enough; below 100, 103/2¹⁰ is 1/10.
    let hundreds = ((fours * 5243) >> 19) & 0x0000_007f_0000_007f;
    let twos = hundreds | (fours - 100 * hundreds) << 16;
    let tens = ((twos * 103) >> 10) & 0x000f_000f_000f_000f;
    tens | (twos - 10 * tens) << 8
}

/// A number of at most eight digits that is not 0, with fewer decimals than that.
#[inline(always)]
fn write_few(out: &mut Vec<u8>, before: Option<u8>, n: u64, decimals: u32) -> bool {
    let digits = eight_digits(n);
    let (leading, trailing) = (digits.trailing_zeros() as usize / 8, digits.leading_zeros() as usize / 8);
    let (text, point) = (digits | 0x3030_3030_3030_3030, EIGHT - decimals as usize);
    // One byte is left free for what comes before.
    let mut bytes = [0; FEW_BYTES];
    bytes[1..=EIGHT].copy_from_slice(&text.to_le_bytes());
    let pointed = trailing < decimals as usize;
    let mut end = 1 + point;
    if pointed {
        bytes[end] = b'.';
        let behind = (text >> (8 * point)).to_le_bytes();
        bytes[end + 1..=end + EIGHT].copy_from_slice(&behind);
        end = 2 + EIGHT - trailing;
    }
    let mut start = 1 + if leading < point { leading } else { point };
    if let Some(before) = before {
        start -= 1;
        bytes[start] = before;
    }
    append(out, &bytes, start, end);
    pointed
}

/// Of a length that is known, a copy is two instructions; else it is a call of the engine's.
#[inline(always)]
fn append(out: &mut Vec<u8>, bytes: &[u8], start: usize, end: usize) {
    let length = out.len() + end - start;
    if let Some(text) = bytes.get(start..).and_then(<[u8]>::first_chunk::<MOST_BYTES>) {
        out.extend_from_slice(text);
    }
    out.truncate(length);
}

/// Any number, digit by digit.
#[inline(never)]
fn write_many(out: &mut Vec<u8>, before: Option<u8>, n: u64, decimals: u32) -> bool {
    if decimals > 22 {
        write(out, before, n, 0);
        out.extend(b"e-");
        write(out, None, u64::from(decimals), 0);
        return true;
    }
    // From the right, so that what is written begins at `at` and ends in the middle.
    let (mut text, mut at) = ([b'0'; 2 * MOST_BYTES], MOST_BYTES);
    let (mut rest, mut chunk, mut left, mut place, mut started) = (n, 0_u32, 0, 0, false);
    let mut pointed = false;
    while at > 1 {
        // Nine digits at a time: 32-bit divisions by a constant are multiplications, 64-bit ones are not.
        if left == 0 {
            (chunk, rest) =
                if rest < BILLION { (rest as u32, 0) } else { ((rest % BILLION) as u32, rest / BILLION) };
            left = 9;
        }
        if place >= decimals {
            if started && place == decimals && decimals > 0 {
                at -= 1;
                text[at] = b'.';
                pointed = true;
            }
            if chunk == 0 && rest == 0 {
                break;
            }
            started = true;
        }
        let digit = (chunk % 10) as u8;
        chunk /= 10;
        left -= 1;
        if started || digit != 0 {
            at -= 1;
            text[at] = b'0' + digit;
            started = true;
        }
        place += 1;
    }
    if at == MOST_BYTES {
        // Zero: one of those that the list began with.
        at -= 1;
    }
    if let Some(before) = before {
        at -= 1;
        text[at] = before;
    }
    append(out, &text, at, MOST_BYTES);
    pointed
}
