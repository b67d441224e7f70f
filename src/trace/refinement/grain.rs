//! How well a picture's pixels know where an edge is: what no outline explains of them.

use super::coverage::Part;
use super::field::{BEYOND, Field};
use super::refine::Shape;
use crate::numerics::order::nth;

/// Pixels along an outline that are looked at together.
const WINDOW: usize = 8;
/// Where an outline runs along rows or columns within so many pixels, all pixels say the same, right or wrong.
const LEVEL: f32 = 1.0;
/// Pixels of an outline that runs nearly along rows or columns are looked at together until it has gone so far the
/// other way: several of the steps that samples make of it. More pixels than this hold more than a parabola.
const STEPS: f32 = 1.5;
const FEWEST: usize = 12;
const MOST: usize = 96;
/// The median and the lower quartile of a sum of squares over its freedoms, of which a window has two less than pixels.
const MEDIAN: f64 = 0.891;
const QUARTILE: f64 = 0.576;

/// What an outline leaves in a pixel, and how much of it is in that pixel.
#[derive(Clone, Copy, Default)]
struct Crossing {
    rest: f64,
    length: f64,
}

/// The standard deviation of coverage in the pixels that outlines cross, beyond what moving and turning them would
/// explain (D 14.21).
#[derive(Clone, Copy, Debug)]
pub(super) struct Grain {
    /// By the window in the middle, and by the one that a quarter of them leaves less than.
    pub(super) middle: f64,
    pub(super) lower: f64,
    /// How many windows there are.
    pub(super) windows: usize,
}

/// What outlines leave of a picture.
///
/// # Cost
///
/// O(length of the outlines).
pub(super) fn grain(shapes: &[Shape], field: &Field) -> Grain {
    let mut squares = Vec::new();
    shapes.iter().for_each(|shape| windows(shape, field, false, &mut squares));
    Grain::of(&mut squares)
}

impl Grain {
    fn of(squares: &mut [f64]) -> Self {
        let lower = (part(squares, 4) / QUARTILE).sqrt();
        Self { middle: middle(squares), lower, windows: squares.len() }
    }
}

/// The same from the mean squares of windows, by the one in the middle.
pub(super) fn middle(squares: &mut [f64]) -> f64 {
    (part(squares, 2) / MEDIAN).sqrt()
}

/// The number that the first of so many parts of the sorted list ends before.
fn part(squares: &mut [f64], parts: usize) -> f64 {
    if squares.is_empty() {
        return 0.0;
    }
    nth(squares, squares.len() / parts)
}

/// What is left in windows where the outline runs nearly along rows or columns, beyond what moving, turning and bending
/// it would explain.
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
            if part.pixel >= BEYOND {
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

#[cfg(test)]
mod tests {
    use super::Grain;
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    /// Mean squares of windows of eight pixels whose coverage is off by a normal deviate of this deviation.
    fn noisy(count: usize, deviation: f64) -> Vec<f64> {
        let mut state = 1_u64;
        let mut uniform = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        // The sum of six squares, two by two, is one of logarithms.
        let mut square = || (0..3).map(|_| -2.0 * (1.0 - uniform()).ln()).sum::<f64>() / 6.0;
        (0..count).map(|_| deviation * deviation * square()).collect()
    }

    #[test]
    fn grain_is_as_large_by_a_quarter_of_the_windows_as_by_half_of_them() {
        let Grain { middle, lower, windows } = Grain::of(&mut noisy(4000, 0.02));
        assert_eq!(windows, 4000);
        // Of so many windows either is off by two hundredths at most, in 99 of 100 cases.
        assert!((middle / 0.02 - 1.0).abs() < 0.02, "{middle}");
        assert!((lower / 0.02 - 1.0).abs() < 0.02, "{lower}");
    }

    #[test]
    fn what_most_windows_lack_but_not_all_is_no_grain_by_a_quarter_of_them() {
        let mut squares = noisy(40, 0.03);
        squares.extend(noisy(30, 0.003));
        let Grain { middle, lower, .. } = Grain::of(&mut squares);
        assert!(middle > 0.008 && lower < 0.008, "{middle} and {lower}");
    }

    #[test]
    fn without_windows_there_is_no_grain() {
        let Grain { middle, lower, windows } = Grain::of(&mut []);
        assert_eq!((middle, lower, windows), (0.0, 0.0, 0));
    }
}
