//! `f64` → decimal text.

use super::big::Big;
use super::{decimal, power};

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
    exactly_scaled(value, decimals)
}

#[inline(never)]
fn exactly_scaled(value: f64, decimals: u32) -> u64 {
    let bits = value.to_bits();
    let (exponent, fraction) = ((bits >> 52) as i32, bits & ((1 << 52) - 1));
    let mut big = Big::from(if exponent == 0 { fraction } else { fraction | 1 << 52 });
    for _ in 0..decimals {
        big.multiply_add(10, 0);
    }
    big.shifted(exponent.max(1) - 1075)
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

/// Appends n·10^−`decimals`: no trailing zeros, no zero before the point, never `-0`; from 23 decimals on as an
/// integer with an exponent.
pub(in crate::svg) fn write(out: &mut Vec<u8>, negative: bool, n: u64, decimals: u32) {
    if decimals > 22 {
        write(out, negative, n, 0);
        out.extend(b"e-");
        return write(out, false, u64::from(decimals), 0);
    }
    let mut reversed = [0_u8; 32];
    let mut slots = reversed.iter_mut();
    let mut len = 0;
    let mut put = |byte: u8| {
        if let Some(slot) = slots.next() {
            *slot = byte;
            len += 1;
        }
    };
    let (mut rest, mut chunk, mut left, mut place, mut started) = (n, 0_u32, 0, 0, false);
    loop {
        // Nine digits at a time: 32-bit divisions by a constant are multiplications, 64-bit ones are not.
        if left == 0 {
            chunk = (rest % 1_000_000_000) as u32;
            rest /= 1_000_000_000;
            left = 9;
        }
        if place >= decimals {
            if started && place == decimals && decimals > 0 {
                put(b'.');
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
            put(b'0' + digit);
            started = true;
        }
        place += 1;
    }
    if len == 0 {
        out.push(b'0');
        return;
    }
    if negative {
        out.push(b'-');
    }
    out.extend(reversed.iter().take(len).rev());
}
