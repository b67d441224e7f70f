//! Natural numbers of a few thousand bits: what exact conversion needs in the rare case that 64 bits are too few.

/// 800 digits are 2658 bits; dividing by 5¹¹³⁰ with 66 bits left over needs 2690 at first.
const LIMBS: usize = 96;
/// 5¹³, the largest power of five in 32 bits.
const FIVE_13: u32 = 1_220_703_125;

/// A natural number, least limb first; `len` limbs are in use and the last of them is not 0.
#[derive(Debug)]
pub(super) struct Big {
    limbs: [u32; LIMBS],
    len: usize,
}

impl Big {
    pub(super) fn new() -> Self {
        Self { limbs: [0; LIMBS], len: 0 }
    }

    pub(super) fn from(n: u64) -> Self {
        let mut big = Self::new();
        big.multiply_add(0, (n >> 32) as u32);
        if big.len > 0 {
            big.shift_left_limbs(1);
        }
        big.limbs[0] = n as u32;
        big.len = big.len.max(usize::from(n != 0));
        big
    }

    fn push(&mut self, limb: u32) {
        if limb != 0
            && let Some(slot) = self.limbs.get_mut(self.len)
        {
            *slot = limb;
            self.len += 1;
        }
    }

    fn used(&mut self) -> impl DoubleEndedIterator<Item = &mut u32> {
        self.limbs.iter_mut().take(self.len)
    }

    fn limb(&self, i: usize) -> u32 {
        self.limbs.get(i).copied().unwrap_or(0)
    }

    pub(super) fn multiply_add(&mut self, factor: u32, summand: u32) {
        let mut carry = u64::from(summand);
        for limb in self.used() {
            carry += u64::from(*limb) * u64::from(factor);
            *limb = carry as u32;
            carry >>= 32;
        }
        self.push(carry as u32);
    }

    /// Whether there was a remainder.
    fn divide(&mut self, divisor: u32) -> bool {
        let mut rest = 0_u64;
        for limb in self.used().rev() {
            rest = rest << 32 | u64::from(*limb);
            *limb = (rest / u64::from(divisor)) as u32;
            rest %= u64::from(divisor);
        }
        while self.len > 0 && self.limb(self.len - 1) == 0 {
            self.len -= 1;
        }
        rest != 0
    }

    fn shift_left_limbs(&mut self, by: usize) {
        let (len, by) = (self.len, by.min(LIMBS - self.len));
        self.limbs.copy_within(0..len, by);
        self.limbs.iter_mut().take(by).for_each(|limb| *limb = 0);
        self.len = len + by;
    }

    pub(super) fn is_zero(&self) -> bool {
        self.len == 0
    }

    fn bits(&self) -> i32 {
        match self.len {
            0 => 0,
            len => 32 * len as i32 - self.limb(len - 1).leading_zeros() as i32,
        }
    }

    /// self·2^two, rounded to the nearest integer, halves up; clamped to 64 bits.
    pub(super) fn shifted(&self, two: i32) -> u64 {
        if self.bits() + two > 64 {
            return u64::MAX;
        }
        if two >= 0 {
            return self.window(0) << (two & 63);
        }
        let below = (-two - 1) as usize;
        let window = self.window(below);
        (window >> 1 | self.window(below + 64) << 63).saturating_add(window & 1)
    }

    /// 64 bits from bit `at` on.
    pub(super) fn window(&self, at: usize) -> u64 {
        let (limb, bit) = (at / 32, at % 32);
        let low = u64::from(self.limb(limb)) | u64::from(self.limb(limb + 1)) << 32;
        if bit == 0 { low } else { low >> bit | u64::from(self.limb(limb + 2)) << (64 - bit) }
    }

    /// self·10^exponent as an `f64`; the number has `digits` digits or fewer, and `dropped` says that it is a
    /// little more than these.
    pub(super) fn times_power_of_ten(mut self, exponent: i32, digits: i32, dropped: bool) -> f64 {
        let size = exponent.saturating_add(digits);
        if self.len == 0 || size < -330 {
            return 0.0;
        }
        if size > 330 {
            return f64::INFINITY;
        }
        let (mut sticky, mut two) = (dropped, exponent);
        let mut fives = exponent.unsigned_abs();
        if exponent < 0 {
            // log₂ 5 < 2.322: after the division 66 bits or more are left.
            let wanted = 67 + (i64::from(fives) * 2322 / 1000) as i32 - self.bits();
            let limbs = (wanted.max(0) as usize).div_ceil(32);
            self.shift_left_limbs(limbs);
            two -= 32 * limbs as i32;
        }
        while fives > 0 {
            let step = fives.min(13);
            let factor = if step == 13 { FIVE_13 } else { 5_u32.pow(step) };
            fives -= step;
            if exponent < 0 {
                sticky |= self.divide(factor);
            } else {
                self.multiply_add(factor, 0);
            }
        }
        self.round(two, sticky)
    }

    /// self·2^two (and a little more when `sticky`), to the nearest `f64`, ties to even.
    fn round(&self, two: i32, mut sticky: bool) -> f64 {
        let below = self.bits() - 64;
        let top = if below >= 0 { self.window(below as usize) } else { self.window(0) << -below };
        sticky |= (0..below.max(0) as usize).step_by(64).any(|at| {
            let left = below as usize - at;
            let window = self.window(at);
            (if left < 64 { window << (64 - left) } else { window }) != 0
        });
        // The value is top·2^(two + below) with 2⁶³ ≤ top < 2⁶⁴.
        let exponent = two + below + 63;
        let subnormal = (-1022 - exponent).max(0);
        let shift = 11 + subnormal;
        if shift > 64 {
            return 0.0;
        }
        let (mut m, rest) = if shift == 64 { (0, top) } else { (top >> shift, top << (64 - shift)) };
        if rest > 1 << 63 || rest == 1 << 63 && (sticky || m & 1 == 1) {
            m += 1;
        }
        if exponent > 1023 {
            return f64::INFINITY;
        }
        // A mantissa that was rounded up to the next power of two carries into the exponent by itself.
        let biased = if subnormal > 0 { 0 } else { (exponent + 1022) as u64 };
        f64::from_bits((biased << 52) + m)
    }
}
