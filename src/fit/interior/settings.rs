//! When the solver stops, and where its numbers end.

/// λ in scaled units is not less than this: the curve goes through the points to within 1e-10 of the drawing then.
pub(crate) const LEAST_LAMBDA: f64 = 1e-10;

/// Who asks for a gap like this wants to see the curve at once.
pub(in crate::fit) const GLIMPSE: f64 = 1e-3;

/// When to stop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// The relative duality gap to reach.
    pub gap: f64,
    /// The most iterations of one run.
    pub most_iterations: usize,
}

impl Default for Settings {
    fn default() -> Self {
        Self { gap: 1e-6, most_iterations: 120 }
    }
}
