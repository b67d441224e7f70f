//! Chains cut at their cusps into tubes that are graphs, each followed by a quasi-interpolant.

pub(super) mod chain;
pub(super) mod cusps;
pub(super) mod discs;
mod parabola;
