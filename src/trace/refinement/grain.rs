//! How well a picture's pixels know where an edge is: what no outline explains of them.

use super::coverage::Part;
use super::field::{Field, NONE};
use super::refine::Shape;
use crate::numerics::order::nth;

/// Pixels along an outline that are looked at together.
const WINDOW: usize = 8;
/// Where an outline runs along rows or columns within so many pixels, all pixels say the same, right or wrong.
const LEVEL: f32 = 1.0;
/// Pixels of an outline that runs nearly along rows or columns are looked at together until it has gone so far the other way: several of the steps
/// that samples make of it. More pixels than this hold more than a parabola.
const STEPS: f32 = 1.5;
const FEWEST: usize = 12;
const MOST: usize = 96;
/// The median of a sum of squares over its freedoms, of which a window has two less than pixels.
const MEDIAN: f64 = 0.891;

/// What an outline leaves in a pixel, and how much of it is in that pixel.
#[derive(Clone, Copy, Default)]
struct Crossing {
    rest: f64,
    length: f64,
}

/// The standard deviation of coverage in the pixels that outlines cross, beyond what moving and turning them would explain (D 14.21), and how many
/// windows say so.
///
/// # Cost
///
/// O(length of the outlines).
pub(super) fn grain(shapes: &[Shape], field: &Field) -> (f64, usize) {
    let mut squares = Vec::new();
    shapes.iter().for_each(|shape| windows(shape, field, false, &mut squares));
    (middle(&mut squares), squares.len())
}

/// The same from the mean squares of windows.
pub(super) fn middle(squares: &mut [f64]) -> f64 {
    if squares.is_empty() {
        return 0.0;
    }
    let middle = squares.len() / 2;
    (nth(squares, middle) / MEDIAN).sqrt()
}

/// What is left in windows where the outline runs nearly along rows or columns, beyond what moving, turning and bending it would explain.
///
/// # Cost
///
/// O(length of the outline).
pub(super) fn level(shape: &Shape, field: &Field, squares: &mut Vec<f64>) {
    windows(shape, field, true, squares);
}

fn windows(shape: &Shape, field: &Field, level: bool, squares: &mut Vec<f64>) {
    let mut window = Window::default();
    for (piece, parts) in shape.parts.iter().enumerate() {
        if !shape.outline.nodes[piece].smooth {
            window.clear();
        }
        for part in parts {
            if part.pixel == NONE {
                window.clear();
                continue;
            }
            if window.last != Some(part.pixel) {
                if window.is_full(level) {
                    if window.tells(level) {
                        squares.push(window.square(if level { 3 } else { 2 }));
                    }
                    window.clear();
                }
                window
                    .pixels
                    .push(Crossing { rest: f64::from(field.rest[part.pixel as usize]), length: 0.0 });
                window.last = Some(part.pixel);
            }
            window.see(part);
        }
    }
}

/// Pixels that follow each other.
#[derive(Default)]
struct Window {
    pixels: Vec<Crossing>,
    last: Option<u32>,
    /// How far they reach along rows and columns.
    reach: [f32; 2],
    /// Room for what is left in them, and for a basis of what moves them.
    room: Vec<f64>,
}

impl Window {
    fn clear(&mut self) {
        self.pixels.clear();
        (self.last, self.reach) = (None, [0.0; 2]);
    }

    /// One part more of the last pixel.
    fn see(&mut self, part: &Part) {
        if let Some(pixel) = self.pixels.last_mut() {
            pixel.length += f64::from(part.dx * part.dx + part.dy * part.dy).sqrt();
        }
        self.reach = [self.reach[0] + part.dx, self.reach[1] + part.dy];
    }

    fn reaches(&self, far: f32) -> bool {
        self.reach.iter().all(|&way| way.abs() > far)
    }

    fn is_full(&self, level: bool) -> bool {
        let count = self.pixels.len();
        if level { count >= MOST || self.reaches(STEPS) } else { count == WINDOW }
    }

    /// Whether a full window says anything.
    fn tells(&self, level: bool) -> bool {
        if level { self.pixels.len() >= FEWEST && self.reaches(STEPS) } else { self.reaches(LEVEL) }
    }

    /// What is left for each freedom when the outline is moved by the best polynomial with so many coefficients.
    fn square(&mut self, freedoms: usize) -> f64 {
        let count = self.pixels.len();
        let half = 0.5 * (count as f64 - 1.0);
        self.room.clear();
        self.room.extend(self.pixels.iter().map(|pixel| pixel.rest));
        for power in 0..freedoms {
            let place = |i: usize| (i as f64 - half) / half;
            let raise = |(i, pixel): (usize, &Crossing)| {
                pixel.length * (0..power).fold(1.0, |product, _| product * place(i))
            };
            self.room.extend(self.pixels.iter().enumerate().map(raise));
            let (before, column) = self.room.split_at_mut((power + 1) * count);
            let (rest, basis) = before.split_at_mut(count);
            basis.chunks_exact(count).for_each(|other| take_away(column, other));
            let size = column.iter().map(|x| x * x).sum::<f64>().sqrt();
            if size > 0.0 {
                column.iter_mut().for_each(|x| *x /= size);
                take_away(rest, column);
            }
        }
        self.room[..count].iter().map(|x| x * x).sum::<f64>() / (count - freedoms) as f64
    }
}

/// Takes away what of some numbers lies along others, the squares of which sum to 1.
fn take_away(from: &mut [f64], along: &[f64]) {
    let share: f64 = from.iter().zip(along).map(|(a, b)| a * b).sum();
    from.iter_mut().zip(along).for_each(|(a, b)| *a -= share * b);
}
