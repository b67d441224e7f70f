//! The hyperbolic basis where w is large: the closed forms divided through by cosh(w/2).

use super::weights::Weights;

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
    #[cold]
    #[inline(never)]
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

    /// The weights at distance r ≤ 1/2 from the start, or a derivative to order 3, for w·r > π/2 (D 2.9).
    #[cold]
    #[inline(never)]
    pub(super) fn weights(&self, r: f64, derivative: usize) -> Weights {
        let Self { half, tanh, gap, spread, decay } = *self;
        let t = 2.0 * half * r;
        let (cosh, sinh, near, far) = self.decayed(r);
        // ρ·e^t/2 and ρ·e^−t/2.
        let rising = 2.0 * half * near * far / (1.0 - decay * decay);
        let falling = rising * near * near;
        // Even part times two, chord times 2(h − T) and arriving times −4h(h − T), and how they go on in t.
        let (even, chord, arriving) = match derivative {
            0 => (
                (1.0 - cosh) / (2.0 * half * tanh),
                t - tanh + sinh,
                tanh * t - (1.0 - spread) + (cosh - (rising + falling)),
            ),
            1 => (sinh / tanh, 1.0 - cosh, tanh - sinh - (rising - falling)),
            2 => (-2.0 * half * cosh / tanh, sinh, cosh - (rising + falling)),
            _ => (4.0 * half * half * sinh / tanh, -cosh, -sinh - (rising - falling)),
        };
        let mut scale = 1.0;
        for _ in 0..derivative.min(3) {
            scale *= 2.0 * half;
        }
        let arriving = -arriving * scale / (4.0 * half * gap);
        Weights { chord: chord * scale / (2.0 * gap), leaving: even + arriving, arriving }
    }
}
