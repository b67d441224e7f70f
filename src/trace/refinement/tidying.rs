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

#[cfg(test)]
mod tests {
    use super::Tidying;
    use crate::numerics::Point;
    use crate::trace::outline::{Node, Outline, Piece};
    use crate::trace::refinement::field::{Field, Shading};
    use crate::trace::refinement::refine::{Refiner, Relaxing, Shape};
    use crate::trace::refinement::trial::{Limits, Trial};
    use crate::trace::{Gray, contours};

    const TEETH: usize = 12;
    const SIZE: (usize, usize) = (112, 48);

    /// How much of a pixel is in a saw: teeth of 8 by 16 pixels side by side.
    fn coverage(column: usize, row: usize) -> f64 {
        let inside = |k: usize| {
            let (x, y) = (column as f64 + (k % 16) as f64 / 16.0, row as f64 + (k / 16) as f64 / 16.0);
            let top = 16.0 + 4.0 * ((x + 1.0 / 32.0) % 8.0 - 4.0).abs();
            (8.0..104.0).contains(&x) && (top..40.0).contains(&y)
        };
        (0..256).filter(|&k| inside(k)).count() as f64 / 256.0
    }

    /// The saw with its tips cut off four pixels below them.
    fn blunt() -> Outline {
        let teeth = (0..TEETH).flat_map(|k| {
            let x = 8.0 + 8.0 * k as f64;
            [(x, 32.0), (x + 3.0, 20.0), (x + 5.0, 20.0)]
        });
        let places = teeth.chain([(104.0, 32.0), (104.0, 40.0), (8.0, 40.0)]);
        let nodes: Vec<Node> =
            places.map(|(x, y)| Node { point: Point::new(x, y), smooth: false, kept: false }).collect();
        Outline { pieces: vec![Piece::Line; nodes.len()], nodes }
    }

    #[test]
    fn one_tip_a_step_is_tried_so_that_a_trace_can_be_stopped_between() {
        let (width, height) = SIZE;
        let bytes: Vec<u8> = (0..width * height)
            .map(|i| (255.0 - 255.0 * coverage(i % width, i / width)).round() as u8)
            .collect();
        let gray = Gray::from_bytes(width, height, &bytes).expect("a picture");
        let found = contours(&gray, 32_640.0, false, 2.0).expect("a contour");
        let shading = Shading { ink: 0.0, paper: 65_280.0, level: 32_640.0, inverted: false };
        let points = found.iter().map(|contour| contour.points.as_slice());
        let mut field = Field::new(&gray, &shading, points, 2.5).expect("room");
        let (mut refiner, mut shape) = (Refiner::new(Relaxing::BOLD), Shape::new(blunt()));
        let all = shape.outline.len();
        refiner.show(&mut field, &mut shape, 0..all);
        let limits = Limits { rms: 0.012, most: 0.055, off: 0.25, noise: 0.0, share: 12.0, grain: 0.0 };
        let mut tidying = Tidying::first();
        loop {
            let before = shape.outline.len();
            let trial =
                &mut Trial { refiner: &mut refiner, field: &mut field, shape: &mut shape, limits: &limits };
            let cost = tidying.step(trial).expect("numbers");
            assert!(before - shape.outline.len() <= 1, "more than one tip in a step");
            if cost.is_none() {
                break;
            }
        }
        assert_eq!(all - shape.outline.len(), TEETH, "every tip is sharp again");
    }
}
