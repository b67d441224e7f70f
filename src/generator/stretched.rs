//! The hyperbolic basis where w is large: the closed forms divided through by cosh(w/2).

use super::Weights;

/// Constants of a hyperbolic segment with w > π, none of which can overflow (D 2.8).
#[derive(Clone, Copy, Debug)]
pub(super) struct Stretched {
    /// h = w/2.
    pub(super) half: f64,
    /// tanh h.
    pub(super) tanh: f64,
    /// h − tanh h.
    pub(super) gap: f64,
    /// h/(sinh h cosh h).
    pub(super) spread: f64,
    /// e^{−2h}.
    decay: f64,
}

impl Stretched {
    pub(super) fn new(frequency: f64) -> Self {
        let half = 0.5 * frequency;
        let decay = libm::exp(-frequency);
        let tanh = (1.0 - decay) / (1.0 + decay);
        let spread = 4.0 * half * decay / (1.0 - decay * decay);
        Self { half, tanh, gap: half - tanh, spread, decay }
    }

    /// cosh η/cosh h, sinh η/cosh h, e^{−t} and e^{−2η} for the distance t = w·r from the end, η = h − t.
    fn decayed(&self, r: f64) -> (f64, f64, f64, f64) {
        let t = 2.0 * self.half * r;
        let near = libm::exp(-t);
        let far = libm::exp(-2.0 * (self.half - t).max(0.0));
        let scale = near / (1.0 + self.decay);
        (scale * (1.0 + far), scale * (1.0 - far), near, far)
    }

    /// The weights at distance r ≤ 1/2 from the start, for w·r > π/2 (D 2.9).
    pub(super) fn values(&self, r: f64) -> Weights {
        let t = 2.0 * self.half * r;
        let (cosh, sinh, near, far) = self.decayed(r);
        let spread_cosh =
            self.half * 2.0 * near * far * (1.0 + near * near) / (1.0 - self.decay * self.decay);
        let even = (1.0 - cosh) / (2.0 * self.half * self.tanh);
        let arriving =
            -(self.tanh * t - (1.0 - self.spread) + (cosh - spread_cosh)) / (4.0 * self.half * self.gap);
        Weights { chord: (t - self.tanh + sinh) / (2.0 * self.gap), leaving: even + arriving, arriving }
    }

    /// Their first derivatives with respect to r.
    pub(super) fn slopes(&self, r: f64) -> Weights {
        let (cosh, sinh, near, far) = self.decayed(r);
        let spread_sinh =
            self.half * 2.0 * near * far * (1.0 - near * near) / (1.0 - self.decay * self.decay);
        let arriving = -(self.tanh - sinh - spread_sinh) / (2.0 * self.gap);
        Weights { chord: self.half * (1.0 - cosh) / self.gap, leaving: sinh / self.tanh + arriving, arriving }
    }

    /// Even and odd part of the second or third derivative of the leaving weight at x.
    pub(super) fn bends(&self, x: f64, derivative: usize) -> (f64, f64) {
        let (cosh, sinh, ..) = self.decayed(if x > 0.5 { 1.0 - x } else { x });
        let sinh = if x < 0.5 { -sinh } else { sinh };
        let (even, odd) = (self.half / self.tanh, self.half * self.half / self.gap);
        let w = 2.0 * self.half;
        if derivative == 2 { (-even * cosh, odd * sinh) } else { (-even * w * sinh, odd * w * cosh) }
    }
}
