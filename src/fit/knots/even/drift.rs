//! Points that follow one another nearly evenly: their spacing changes slowly, and by how much can be told from their
//! feet.

use core::f64::consts::{PI, TAU};

use super::Spread;
use crate::fit::knots::free_knots::Located;
use crate::numerics::angle::sin_cos;

/// The waves on a whole curve that slow changes are made of.
const MOST_WAVES: usize = 4;

impl Spread {
    /// By how many steps points are ahead of their numbers: the slowest waves of what their feet, which `located` has,
    /// are ahead by, those of which every number lowers the sum of squares by more than `worth`. Empty where there is
    /// none. `end` is that of the parameter.
    #[inline(never)]
    pub(super) fn drift(&self, located: &Located, end: f64, worth: f64) -> Vec<f64> {
        let (off, count) = (self.off(located, end), located.points.len());
        // On a closed curve the mean is the lead, which is known.
        let middle = if self.closed { off.iter().sum::<f64>() / count as f64 } else { 0.0 };
        let (turn, numbers) =
            if self.closed { (TAU / count as f64, 2.0) } else { (PI / (count - 1) as f64, 1.0) };
        let mut drift = Vec::new();
        for wave in 1..=MOST_WAVES {
            // The ends of an open curve stay.
            let at = |m: usize| {
                let (sine, cosine) = sin_cos(turn * (wave * m) as f64);
                if self.closed { [sine, cosine] } else { [sine, 0.0] }
            };
            let waves: Vec<[f64; 2]> = (0..count).map(at).collect();
            let mut sums = [0.0; 2];
            for (off, [sine, cosine]) in off.iter().zip(&waves) {
                sums[0] += (off - middle) * sine;
                sums[1] += (off - middle) * cosine;
            }
            let [a, b] = sums.map(|sum| 2.0 * sum / count as f64);
            if 0.5 * count as f64 * (a * a + b * b) > numbers * worth {
                drift.resize(count, 0.0);
                let more = waves.iter().map(|[sine, cosine]| (a * sine + b * cosine) / self.step);
                drift.iter_mut().zip(more).for_each(|(drift, more)| *drift += more);
            }
        }
        drift
    }
}
