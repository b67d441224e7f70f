//! What is chosen, and by which rule.

/// The errors of predicting each point from all the others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Score {
    /// Root of the mean square.
    pub rmse: f64,
    /// Mean of the absolute values.
    pub mae: f64,
}

/// Which of the candidates is taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rule {
    /// The least error; of equal ones fewer knots, then more neighbours \[RB21, section 3.3\].
    Least,
    /// The fewest knots whose error is at most `share` of it, or `slack`, above the least. The noise of chains of
    /// pixels is correlated, so that the least error alone asks for too many knots.
    Parsimonious {
        /// A tenth, say.
        share: f64,
        /// In the unit of the ordinates.
        slack: f64,
    },
}

/// The number of interior knots and of neighbours that were chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Choice {
    /// Interior knots.
    pub interior: usize,
    /// Neighbours; for projections the most points that one coefficient comes from.
    pub k: usize,
    /// The error of predicting each point from the others.
    pub score: f64,
}
