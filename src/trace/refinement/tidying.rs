//! Folds, tips and rounded corners of a whole outline, one trial after another.

use super::trial::Trial;
use crate::error::Result;

/// Nodes that are looked at in one step, where nothing is tried.
const NODES: usize = 512;

/// What is looked for, node by node.
#[derive(Clone, Copy, Debug)]
enum Looking {
    Folds,
    Tips,
    Arcs,
}

/// An outline that is being tidied.
#[derive(Debug)]
pub(super) struct Tidying {
    left: &'static [Looking],
    /// The node that is next.
    at: usize,
}

impl Tidying {
    /// Before joints are taken away.
    pub(super) fn first() -> Self {
        Self { left: &[Looking::Folds, Looking::Tips, Looking::Arcs], at: 0 }
    }

    /// After bends.
    pub(super) fn last() -> Self {
        Self { left: &[Looking::Folds, Looking::Arcs], at: 0 }
    }

    /// After all else.
    pub(super) fn end() -> Self {
        Self { left: &[Looking::Arcs], at: 0 }
    }

    /// One trial at most: its cost in about microseconds, or nothing when all is done.
    pub(super) fn step(&mut self, trial: &mut Trial<'_>) -> Result<Option<f64>> {
        for _ in 0..NODES {
            let Some((looking, rest)) = self.left.split_first() else { return Ok(None) };
            let pieces = trial.shape.outline.len();
            if self.at >= pieces {
                (self.left, self.at) = (rest, 0);
                continue;
            }
            let (next, tried) = match looking {
                Looking::Folds => trial.unfold(self.at)?,
                Looking::Tips => trial.sharpen(self.at)?,
                Looking::Arcs => trial.round_off(self.at)?,
            };
            self.at = next;
            if tried {
                // An arc on trial takes all of the outline's places.
                return Ok(Some(100.0 + if matches!(looking, Looking::Arcs) { pieces as f64 } else { 0.0 }));
            }
        }
        Ok(Some(100.0))
    }
}
