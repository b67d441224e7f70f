//! How well the pixels of a picture say where its outlines are, and what first outlines are allowed for that.

use super::options::TraceOptions;
use super::outline::corners::CornerRule;
use super::outline::division::DivisionRule;
use crate::numerics::plane::smaller;

/// The largest deviation that a first outline may have if it is refined: pixels farther away say nothing.
const NEAR: f64 = 0.18;

/// How far steps of a nearly level edge are from it, in pixels: a half, and what evening leaves out.
const LEVEL: f64 = 0.6;

/// What scaling up leaves of pixels in edges has the period of the old ones, which is twice the deviation of the blur.
/// Blurred once more by so many times as much, a twentieth of it stays.
const EVENED: f64 = 0.8;
/// The farthest that a picture may be blurred by both, a deviation in pixels, to be compared with outlines.
const SOFTEST: f64 = 2.6;

/// By how much a picture of a softness is blurred once more, so that edges do not wind with the pixels that were scaled
/// up.
pub(super) fn evened(softness: f64) -> f64 {
    smaller(EVENED * softness, (SOFTEST * SOFTEST - softness * softness).max(0.0).sqrt())
}

/// What kind of picture it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Quality {
    /// Exact coverage.
    Clean,
    /// Flat places are flat, but outlines are not what was drawn, as after strong compression.
    Rough,
    /// Of every pixel only whether its centre is inside.
    Sampled,
    /// Blurred, but without noise: out of focus, or drawn smaller and scaled up.
    Soft,
    /// Noise everywhere.
    Noisy,
}

impl Quality {
    /// How many times farther than in a clean picture things may be from what they are.
    pub(super) fn slack(self) -> f64 {
        match self {
            Self::Clean => 1.0,
            Self::Rough | Self::Soft => 1.5,
            Self::Sampled => 5.0,
            Self::Noisy => 4.0,
        }
    }

    /// Corners, then corners close to others.
    pub(super) fn corner_rules(self, angle: f64) -> [CornerRule; 2] {
        let [gap, window, reach, least] = match self {
            Self::Clean => [1.0, 3.0, 1.0, angle],
            Self::Rough => [1.2, 4.0, 1.2, angle + 0.1],
            Self::Sampled => [1.2, 4.0, 1.2, angle + 0.15],
            Self::Soft | Self::Noisy => [1.6, 5.0, 1.8, angle],
        };
        let [close, short, more] = match self {
            Self::Clean => [0.75, 1.75, 0.25],
            Self::Rough => [1.0, 2.5, 0.3],
            Self::Sampled | Self::Soft | Self::Noisy => [1.5, 3.0, 0.2],
        };
        [
            CornerRule { gap, window, angle: least, reach },
            CornerRule { gap: close, window: short, angle: least + more, reach },
        ]
    }

    /// How pieces of a first outline are found.
    pub(super) fn division_rule(self, options: &TraceOptions) -> DivisionRule {
        let scale = match self {
            Self::Clean => 1.0,
            Self::Rough | Self::Soft | Self::Noisy => 2.0,
            Self::Sampled => 3.0,
        };
        let most = if options.refined { options.tolerance.min(NEAR) } else { options.tolerance };
        DivisionRule {
            gap: 1.2 * self.corner_rules(options.corner)[0].gap,
            straight: if self == Self::Sampled { LEVEL } else { 0.12 * scale },
            least_run: 6.0 * scale,
            most: most * scale,
            rms: 0.41 * most * scale,
            reach: 3.0 * scale,
            chords: false,
        }
    }
}
