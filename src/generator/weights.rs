//! What the ends of a segment weigh at a place on it.

/// Weights of one place on a segment; see [`Basis::weights`](super::Basis::weights).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weights {
    /// Weight of the chord, end − start.
    pub chord: f64,
    /// Weight of the length times the derivative that leaves the start.
    pub leaving: f64,
    /// Weight of the length times the derivative that arrives at the end.
    pub arriving: f64,
}
