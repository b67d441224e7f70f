//! Drawings of which all marks are small, as halftones, hatching and lettering are, are drawings: their edges are no
//! noise.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use core::f64::consts::PI;

use crate::support::pictures::{Noise, draw, traced};
use expline::curve::Curve;
use expline::trace::Trace;

/// The area that all outlines enclose, holes taken off.
fn enclosed(found: &Trace) -> f64 {
    found.contours.iter().map(|contour| contour.curve.area().expect("closed")).sum()
}

/// Dots on a grid that is turned, those which are whole in a square picture.
struct Dots {
    radius: f64,
    pitch: f64,
    side: usize,
}

impl Dots {
    fn new(radius: f64, gap: f64) -> Self {
        let pitch = 2.0 * radius + gap;
        Self { radius, pitch, side: (8.5 * pitch) as usize }
    }

    fn turned((x, y): (f64, f64), angle: f64) -> (f64, f64) {
        let (sin, cos) = angle.sin_cos();
        (x * cos - y * sin, x * sin + y * cos)
    }

    /// The place of a dot of the grid, if it is whole.
    fn dot(&self, column: f64, row: f64) -> Option<(f64, f64)> {
        let middle = 0.5 * self.side as f64;
        let (x, y) = Self::turned((self.pitch * column, self.pitch * row), 0.25);
        let most = middle - self.radius - 1.5;
        (x.abs().max(y.abs()) < most).then_some((x + middle, y + middle))
    }

    fn count(&self) -> usize {
        let place = |k: i32| self.dot(f64::from(k % 15 - 7), f64::from(k / 15 - 7));
        (0..225).filter_map(place).count()
    }

    fn drawn(&self) -> Vec<u8> {
        let middle = 0.5 * self.side as f64;
        draw(self.side, self.side, &|x, y| {
            let (u, v) = Self::turned((x - middle, y - middle), -0.25);
            let nearest = self.dot((u / self.pitch).round(), (v / self.pitch).round());
            nearest.is_some_and(|dot| (x - dot.0).hypot(y - dot.1) <= self.radius)
        })
    }
}

/// Where dots lie close together their edges are beside most of the paper: they were taken for noise, of which specks
/// are left out.
#[test]
fn dots_of_a_halftone_are_found_however_small_and_close() {
    for radius in [0.85, 1.1, 1.4, 2.0, 3.0] {
        for gap in [2.5, 4.0, 8.0] {
            let dots = Dots::new(radius, gap);
            let found = traced(dots.side, dots.side, &dots.drawn());
            let name = format!("radius {radius}, {gap} apart");
            assert_eq!(found.contours.len(), dots.count(), "{name}");
            let excess = enclosed(&found) / (PI * radius * radius * dots.count() as f64);
            // Pixels carry the area to some thousandths, shades of one byte as much of dots of nine pixels.
            assert!((excess - 1.0).abs() < 0.025, "{name}: {excess} times their area");
            assert!(found.tones.noise < 0.001, "{name}: {}", found.tones.noise);
        }
    }
}

#[test]
fn fine_hatching_is_found_stroke_by_stroke() {
    let (side, pitch) = (80, 3.7);
    for (width, angle) in [(1.0, 0.85), (1.5, 2.58), (1.5, 2.0), (0.8, 0.65)] {
        let (sin, cos) = f64::sin_cos(angle);
        let ink = |x: f64, y: f64| {
            let across = (x - 40.0) * sin - (y - 40.0) * cos;
            (x - 40.0).hypot(y - 40.0) < 36.0 && across.rem_euclid(pitch) < width
        };
        let bytes = draw(side, side, &ink);
        let found = traced(side, side, &bytes);
        let truth: f64 = bytes.iter().map(|&v| 1.0 - f64::from(v) / 255.0).sum();
        let excess = enclosed(&found) / truth;
        assert!((excess - 1.0).abs() < 0.02, "{width} wide at {angle}: {excess} times its area");
        // One or two more where the disc cuts a stroke's long side.
        let strokes = 72.0 / pitch;
        assert!((found.contours.len() as f64 - strokes).abs() <= 2.0, "{} strokes", found.contours.len());
    }
}

/// A letter of five by seven units: strokes of one.
fn is_letter(letter: usize, x: f64, y: f64) -> bool {
    let within = |left: f64, top: f64, right: f64, bottom: f64| {
        (left..right).contains(&x) && (top..bottom).contains(&y)
    };
    let stem = within(0.0, 0.0, 1.0, 7.0);
    let [top, bottom] = [0.0, 6.0].map(|y| within(0.0, y, 5.0, y + 1.0));
    match letter % 4 {
        0 => stem || bottom,
        1 => top || within(2.0, 0.0, 3.0, 7.0),
        2 => stem || within(4.0, 0.0, 5.0, 7.0) || within(0.0, 3.0, 5.0, 4.0),
        _ => stem || top || bottom || within(4.0, 0.0, 5.0, 7.0),
    }
}

/// Where strokes meet a few pixels are dark all around: their shades, between ink and paper, were taken for the ink.
#[test]
fn letters_of_few_pixels_are_as_thick_as_they_are() {
    for height in [8.0, 9.0, 10.0] {
        let unit = height / 7.0;
        let ink = |x: f64, y: f64| {
            let (x, y) = ((x + 0.2 * y - 8.3) / unit, (y - 3.4) / unit);
            let (column, row) = ((x / 6.5).floor(), (y / 9.0).floor());
            let inside = (0.0..10.0).contains(&column) && (0.0..5.0).contains(&row);
            inside && is_letter((3.0 * row + column) as usize, x - 6.5 * column, y - 9.0 * row)
        };
        let (width, lines) = ((65.0 * unit) as usize + 16, (45.0 * unit) as usize + 8);
        let bytes = draw(width, lines, &ink);
        let found = traced(width, lines, &bytes);
        let truth: f64 = bytes.iter().map(|&v| 1.0 - f64::from(v) / 255.0).sum();
        let excess = enclosed(&found) / truth;
        // Of counters two pixels wide a few are lost at eight pixels, or grown by half.
        assert!((excess - 1.0).abs() < 0.03, "{height} high: {excess} times their area");
        assert!(found.tones.ink < 256.0, "{height} high: the ink is black: {:?}", found.tones);
    }
}

#[test]
fn noise_among_dots_is_no_dot() {
    let mut noise = Noise(11);
    let dots = Dots::new(3.2, 8.0);
    let bytes: Vec<u8> = dots
        .drawn()
        .iter()
        .map(|&v| (f64::from(v) + 16.0 * noise.normal()).round().clamp(0.0, 255.0) as u8)
        .collect();
    let found = traced(dots.side, dots.side, &bytes);
    assert_eq!(found.contours.len(), dots.count());
    assert!(found.tones.noise > 0.02, "the noise is seen: {}", found.tones.noise);
}
