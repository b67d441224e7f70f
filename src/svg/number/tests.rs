//! Against the standard library, which is exact and shares nothing with this code.

use super::{read, scaled, shortest, write};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

/// Splitmix64: numbers of every size, the same on every machine.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ z >> 31
    }
}

fn assert_reads_like_std(text: &str) {
    let (value, end) = read(text.as_bytes(), 0).unwrap_or((f64::NAN, 0));
    let expected: f64 = text.parse().unwrap_or(f64::NAN);
    assert_eq!(end, text.len(), "all of {text} is one number");
    // Zero never has a sign here.
    assert_eq!(value.to_bits(), (expected + 0.0).to_bits(), "{text}: {value:e}, not {expected:e}");
}

fn sign(negative: bool) -> Option<u8> {
    negative.then_some(b'-')
}

fn fixed(value: f64, decimals: u32) -> String {
    let mut out = Vec::new();
    let n = scaled(value, decimals);
    write(&mut out, sign(value < 0.0 && n != 0), n, decimals);
    String::from_utf8_lossy(&out).into_owned()
}

fn short(value: f64) -> String {
    let mut out = Vec::new();
    let (n, decimals) = shortest(value);
    write(&mut out, sign(value < 0.0), n, decimals);
    String::from_utf8_lossy(&out).into_owned()
}

#[test]
fn any_double_is_read_back_from_seventeen_digits_and_from_all_its_digits() {
    let mut random = Random(1);
    for _ in 0..4000 {
        let value = f64::from_bits(random.next());
        if value.is_finite() {
            assert_reads_like_std(&format!("{value:.16e}"));
            assert_reads_like_std(&format!("{value:.25e}"));
        }
    }
    for exponent in [-1074, -1073, -1023, -1022, -1021, -60, 0, 60, 970, 1023] {
        let value = 2.0_f64.powi(exponent / 2) * 2.0_f64.powi(exponent - exponent / 2);
        assert_reads_like_std(&format!("{value:.770e}"));
        assert_reads_like_std(&format!("{value}"));
    }
}

#[test]
fn midpoints_between_doubles_are_read_to_even_and_beyond_them_upwards() {
    let mut random = Random(2);
    for round in 0..400_u64 {
        // 54 bits with the last one set: half way between two doubles, exactly representable in decimal.
        let odd = random.next() >> 10 | 1 << 53 | 1;
        let exponent = i32::try_from(round % 90).unwrap_or(0) - 45;
        let text = if exponent >= 0 {
            format!("{}", u128::from(odd) << exponent)
        } else {
            // odd·2^-k = odd·5^k·10^-k, computed in decimal digits by hand.
            let mut digits: Vec<u32> = odd.to_string().bytes().rev().map(|b| u32::from(b - b'0')).collect();
            for _ in 0..-exponent {
                let mut carry = 0;
                for digit in &mut digits {
                    carry += *digit * 5;
                    *digit = carry % 10;
                    carry /= 10;
                }
                if carry > 0 {
                    digits.push(carry);
                }
            }
            let text: String = digits.iter().rev().map(u32::to_string).collect();
            format!("{text}e{exponent}")
        };
        assert_reads_like_std(&text);
        let (mantissa, power) = text.split_once('e').unwrap_or((&text, "0"));
        assert_reads_like_std(&format!("{mantissa}.{}1e{power}", "0".repeat(900)));
        assert_reads_like_std(&format!("{mantissa}.0000e{power}"));
    }
}

#[test]
fn hard_numbers_are_read_correctly() {
    for text in [
        "2.2250738585072011e-308",
        "2.2250738585072014e-308",
        "4.9406564584124654e-324",
        "2.4703282292062327e-324",
        "2.4703282292062328e-324",
        "1.7976931348623157e308",
        "1.7976931348623158e308",
        "1.7976931348623159e308",
        "9007199254740993",
        "9007199254740992.999999999999999999999",
        "18446744073709551615",
        "18446744073709551616",
        "0.000000000000000000000000000000000000000000000000000001e54",
        "8.5e22",
        "1e23",
        "123456789012345678e-17",
        "-0",
        "-0.0e5",
        "1e-400",
        "1e400",
        "0e999999999999",
        // As many digits as 64 bits hold, and one more, wherever the point stands.
        "9999999999999999999",
        "99999999999999999999",
        "999999999.9999999999",
        "9999999999.9999999999",
        ".99999999999999999999e-5",
        "99999999999999999999.e5",
        "0000000000000000000000000000001.5",
        "5.",
        ".5",
        "+.5e+1",
    ] {
        assert_reads_like_std(text);
    }
    assert_reads_like_std(&format!("0.{}1", "0".repeat(2000)));
    assert_reads_like_std(&format!("1{}", "0".repeat(2000)));
    assert_reads_like_std(&format!("1{}e-2000", "0".repeat(2000)));
}

#[test]
fn what_is_no_number_is_left_alone() {
    for text in ["", ".", "-", "+", "-.", "e5", ".e5", "x", "--1", "NaN", "inf"] {
        assert_eq!(read(text.as_bytes(), 0), None, "{text}");
    }
    for (text, end) in [("1e", 1), ("1e+", 1), ("1em", 1), ("1.2.3", 3), ("1-2", 1), ("1,5", 1)] {
        assert_eq!(read(text.as_bytes(), 0).map(|(_, end)| end), Some(end), "{text}");
    }
}

#[test]
fn fixed_decimals_round_like_the_standard_library() {
    let mut random = Random(3);
    for decimals in 0..=17 {
        for _ in 0..400 {
            let value = (random.next() >> 11) as f64 / 2.0_f64.powi(27) * 10.0_f64.powi(-decimals / 2);
            let value = if random.next() & 1 == 0 { value } else { -value };
            if value.abs() * 10.0_f64.powi(decimals) > 1.8e19 {
                continue;
            }
            let full = format!("{value:.*}", decimals as usize);
            let trimmed =
                if full.contains('.') { full.trim_end_matches('0').trim_end_matches('.') } else { &full };
            let unsigned = trimmed.trim_start_matches('-');
            let point = if unsigned.len() > 1 { unsigned.trim_start_matches('0') } else { unsigned };
            let sign = if trimmed.starts_with('-') && point != "0" { "-" } else { "" };
            assert_eq!(fixed(value, decimals as u32), format!("{sign}{point}"), "{value:e} to {decimals}");
        }
    }
}

#[test]
fn numbers_are_written_without_ornament() {
    for (value, decimals, text) in [
        (0.0, 3, "0"),
        (-0.0, 3, "0"),
        (-0.0004, 3, "0"),
        (0.5, 3, ".5"),
        (-0.5, 3, "-.5"),
        (0.125, 2, ".13"),
        (1000.0, 3, "1000"),
        (1000.5, 0, "1001"),
        (-10.01, 1, "-10"),
        (1e9, 9, "1000000000"),
        (999.9996, 3, "1000"),
    ] {
        assert_eq!(fixed(value, decimals), text, "{value} to {decimals}");
    }
    for (value, text) in
        [(0.1, ".1"), (-1.5, "-1.5"), (1e-30, "1e-30"), (1.5e-100, "15e-101"), (123.0, "123")]
    {
        assert_eq!(short(value), text, "{value}");
    }
}

#[test]
fn the_shortest_text_brings_every_double_back_to_the_last_bit() {
    let mut random = Random(4);
    for round in 0..20_000 {
        let bits = random.next();
        // Half of them of the size of coordinates, the others of any size below 2⁶³.
        let exponent = if round % 2 == 0 { 1003 + (bits >> 52) % 50 } else { (bits >> 52) % 1085 };
        let value = f64::from_bits((bits & ((1 << 52) - 1)) | exponent << 52);
        let text = short(value);
        assert_eq!(text.parse::<f64>().map(f64::to_bits), Ok(value.to_bits()), "{text} for {value:e}");
        assert_eq!(read(text.as_bytes(), 0), Some((value, text.len())), "{text} for {value:e}");
        assert!(!text.contains('+') && text.len() <= 25, "{text}");
    }
}

#[test]
fn few_digits_are_written_as_many_are() {
    let mut random = Random(7);
    for round in 0..30_000_u64 {
        // Numbers of every length, many of which end in zeros.
        let n = random.next() % 10_u64.pow(u32::try_from(round % 9 + 1).unwrap_or(1));
        let n = if round % 3 == 0 { n / 100 * 100 } else { n };
        let decimals = u32::try_from(random.next() % 10).unwrap_or(0);
        let mut out = b"M".to_vec();
        let pointed = write(&mut out, sign(round % 2 == 1 && n > 0), n, decimals);
        let text = String::from_utf8_lossy(&out[1..]).into_owned();
        let whole = n / 10_u64.pow(decimals);
        let part = format!("{:0width$}", n % 10_u64.pow(decimals), width = decimals as usize);
        let part = if decimals == 0 { "" } else { part.trim_end_matches('0') };
        let (point, sign) =
            (if part.is_empty() { "" } else { "." }, if round % 2 == 1 && n > 0 { "-" } else { "" });
        let whole = if whole == 0 && !part.is_empty() { String::new() } else { whole.to_string() };
        assert_eq!(text, format!("{sign}{whole}{point}{part}"), "{n} with {decimals} decimals");
        assert_eq!(pointed, !part.is_empty(), "{text}");
    }
}
