//! Folds, tips, kinks and rounded corners of a whole outline, one trial after another.

use super::trial::Trial;
use crate::error::Result;

/// Nodes that are looked at in one step, where nothing is tried.
const NODES: usize = 512;

/// What is looked for, node by node.
#[derive(Clone, Copy, Debug)]
enum Looking {
    Folds,
    Tips,
    Kinks,
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
        Self { left: &[Looking::Kinks, Looking::Arcs], at: 0 }
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
                Looking::Kinks => trial.even(self.at)?,
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
    use crate::numerics::{Point, Vector};
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

    /// Tidies an outline against a picture of so much ink in each pixel: how many pieces each step took.
    fn tidied(
        outline: Outline,
        (width, height): (usize, usize),
        ink: &dyn Fn(usize, usize) -> f64,
        mut tidying: Tidying,
    ) -> (Outline, Vec<usize>) {
        let bytes: Vec<u8> =
            (0..width * height).map(|i| (255.0 - 255.0 * ink(i % width, i / width)).round() as u8).collect();
        let gray = Gray::from_bytes(width, height, &bytes).expect("a picture");
        let found = contours(&gray, 32_640.0, false, 2.0).expect("a contour");
        let shading = Shading { ink: 0.0, paper: 65_280.0, level: 32_640.0, inverted: false };
        let points = found.iter().map(|contour| contour.points.as_slice());
        let mut field = Field::new(&gray, &shading, points, 2.5).expect("room");
        let (mut refiner, mut shape) = (Refiner::new(Relaxing::BOLD), Shape::new(outline));
        let all = shape.outline.len();
        refiner.show(&field, &mut shape, 0..all);
        refiner.sweep.cover(&mut field);
        let limits = Limits { rms: 0.012, most: 0.055, off: 0.25, noise: 0.0, share: 12.0, grain: 0.0 };
        let mut taken = Vec::new();
        loop {
            let before = shape.outline.len();
            let trial =
                &mut Trial { refiner: &mut refiner, field: &mut field, shape: &mut shape, limits: &limits };
            let cost = tidying.step(trial).expect("numbers");
            taken.push(before - shape.outline.len());
            if cost.is_none() {
                return (shape.outline, taken);
            }
        }
    }

    #[test]
    fn one_tip_a_step_is_tried_so_that_a_trace_can_be_stopped_between() {
        let (_, taken) = tidied(blunt(), SIZE, &coverage, Tidying::first());
        assert!(taken.iter().all(|&count| count <= 1), "more than one tip in a step");
        assert_eq!(taken.iter().sum::<usize>(), TEETH, "every tip is sharp again");
    }

    #[test]
    fn a_loop_of_a_fifth_of_a_pixel_goes_though_nothing_turns_back_at_its_corner() {
        // A square with a piece on its upper side that goes once round, to a corner of 90 degrees.
        let (from, to) = (Point::new(23.79, 8.07), Point::new(40.0, 8.0));
        let node = |x, y, smooth| Node { point: Point::new(x, y), smooth, kept: false };
        let round = Piece::Cubic { leaving: Vector::new(0.06, 0.0), arriving: Vector::new(-0.03, -0.27) };
        let on = Piece::Cubic { leaving: (to - from) / 3.0, arriving: (to - from) / 3.0 };
        let outline = Outline {
            nodes: vec![
                node(8.0, 8.0, false),
                node(24.0, 8.0, true),
                node(from.x, from.y, false),
                node(to.x, to.y, false),
                node(40.0, 40.0, false),
                node(8.0, 40.0, false),
            ],
            pieces: vec![Piece::Line, round, on, Piece::Line, Piece::Line, Piece::Line],
        };
        let ink = |x: usize, y: usize| f64::from(u8::from((8..40).contains(&x) && (8..40).contains(&y)));
        let (outline, taken) = tidied(outline, (48, 48), &ink, Tidying::first());
        assert_eq!(taken.iter().sum::<usize>(), 1, "the loop is gone");
        for i in 0..outline.len() {
            let cubic = outline.cubic(i);
            let high = (0..=16)
                .map(|k| cubic.point(f64::from(k) / 16.0))
                .filter(|p| p.y < 24.0 && p.x > 8.5 && p.x < 39.5);
            // Bytes round coverage by 1/510.
            assert!(high.into_iter().all(|p| (p.y - 8.0).abs() < 0.01), "the side is straight");
        }
    }

    /// Where two circles of radius 18 overlap whose centres are so far above and below (24, 24), with corners where
    /// they meet; one turns by so much besides.
    fn lens(off: f64, kink: f64) -> Outline {
        let angle = (off / 18.0).asin();
        let quarter = 0.5 * (core::f64::consts::PI - 2.0 * angle);
        let reach = 18.0 * 4.0 / 3.0 * (0.25 * quarter).tan();
        let mut outline = Outline::default();
        for (side, k) in [(1.0, 0.0), (1.0, 1.0), (-1.0, 0.0), (-1.0, 1.0)] {
            let at = |k: f64| Vector::new((angle + k * quarter).cos(), (angle + k * quarter).sin()) * side;
            let way = |k: f64, turned: f64| {
                let (sine, cosine) = (angle + k * quarter + turned).sin_cos();
                Vector::new(-sine, cosine) * (side * reach)
            };
            let point = Point::new(24.0, 24.0 - side * off) + at(k) * 18.0;
            let turned = if outline.nodes.is_empty() { kink } else { 0.0 };
            outline.nodes.push(Node { point, smooth: k > 0.0, kept: false });
            outline.pieces.push(Piece::Cubic { leaving: way(k, turned), arriving: way(k + 1.0, 0.0) });
        }
        outline
    }

    #[test]
    fn a_kink_of_six_degrees_in_a_circle_goes_and_corners_of_twelve_that_were_drawn_stay() {
        let ink = |off: f64| {
            // Sixteen by sixteen samples of a pixel.
            move |x: usize, y: usize| {
                let at = |v: usize, k: usize| v as f64 + (k as f64 + 0.5) / 16.0 - 24.0;
                let inside = |x: f64, y: f64| x.hypot(y - off) < 18.0 && x.hypot(y + off) < 18.0;
                (0..256).filter(|k| inside(at(x, k % 16), at(y, k / 16))).count() as f64 / 256.0
            }
        };
        let (round, _) = tidied(lens(0.0, 0.1), (48, 48), &ink(0.0), Tidying::end());
        assert!(round.nodes.iter().all(|node| node.smooth), "no corner is left");
        let (sharp, _) = tidied(lens(1.9, 0.0), (48, 48), &ink(1.9), Tidying::end());
        assert_eq!(sharp.cusps(0.2).len(), 2, "both corners are those of the picture");
    }
}
