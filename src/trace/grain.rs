//! How well a picture's pixels know where an edge is: what no outline explains of them.

use super::coverage::Part;
use super::field::{Field, NONE};
use super::refine::Shape;
use crate::numerics::order::nth;

/// Pixels along an outline that are looked at together.
const WINDOW: usize = 8;
/// Where an outline runs along rows or columns within so many pixels, all pixels say the same, right or wrong.
const LEVEL: f32 = 1.0;
/// The median of a sum of squares over its freedoms, of which a window has two less than pixels.
const MEDIAN: f64 = 0.891;

/// What an outline leaves in a pixel, and how much of it is in that pixel.
#[derive(Clone, Copy, Default)]
struct Crossing {
    rest: f64,
    length: f64,
}

/// The standard deviation of coverage in the pixels that outlines cross, beyond what moving and turning them would explain (D 14.21).
///
/// # Cost
///
/// O(length of the outlines).
pub(super) fn grain(shapes: &[Shape], field: &Field) -> f64 {
    let mut squares = Vec::new();
    for shape in shapes {
        let mut window = Window::default();
        for (piece, parts) in shape.parts.iter().enumerate() {
            if !shape.outline.nodes[piece].smooth {
                window = Window::default();
            }
            for part in parts {
                window.see(part, field, &mut squares);
            }
        }
    }
    if squares.is_empty() {
        return 0.0;
    }
    let middle = squares.len() / 2;
    (nth(&mut squares, middle) / MEDIAN).sqrt()
}

/// Pixels that follow each other.
#[derive(Default)]
struct Window {
    pixels: [Crossing; WINDOW],
    count: usize,
    last: Option<u32>,
    /// How far they reach along rows and columns.
    reach: [f32; 2],
}

impl Window {
    /// One part more; with the first of a ninth pixel the eight before have their say.
    fn see(&mut self, part: &Part, field: &Field, squares: &mut Vec<f64>) {
        if part.pixel == NONE {
            *self = Self::default();
            return;
        }
        if self.last != Some(part.pixel) {
            if self.count == WINDOW {
                if self.reach.iter().all(|&way| way.abs() > LEVEL) {
                    squares.push(self.square());
                }
                *self = Self::default();
            }
            self.pixels[self.count] =
                Crossing { rest: f64::from(field.rest[part.pixel as usize]), length: 0.0 };
            self.count += 1;
            self.last = Some(part.pixel);
        }
        self.pixels[self.count - 1].length += f64::from(part.dx * part.dx + part.dy * part.dy).sqrt();
        self.reach = [self.reach[0] + part.dx, self.reach[1] + part.dy];
    }

    /// What is left for each freedom when the outline is moved and turned as is best.
    fn square(&self) -> f64 {
        let (mut all, mut by) = (0.0, [0.0; 2]);
        let mut moments = [0.0; 3];
        for (i, pixel) in self.pixels.iter().enumerate() {
            let place = i as f64 - 0.5 * (WINDOW - 1) as f64;
            let weight = pixel.length * pixel.length;
            for (k, moment) in moments.iter_mut().enumerate() {
                *moment += weight * [1.0, place, place * place][k];
            }
            all += pixel.rest * pixel.rest;
            by[0] += pixel.rest * pixel.length;
            by[1] += pixel.rest * pixel.length * place;
        }
        let [a, b, c] = moments;
        let size = a * c - b * b;
        let explained = (by[0] * by[0] * c - 2.0 * by[0] * by[1] * b + by[1] * by[1] * a) / size;
        if size > 0.0 { (all - explained).max(0.0) / (WINDOW - 2) as f64 } else { 0.0 }
    }
}
