//! Outlines about a pixel thick of rings and stars: where they run between two rows of pixels no pixel is more than
//! half ink, and elsewhere one is all ink. They come back whole and as thick as they are, in ink and in colours.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use core::f64::consts::{PI, TAU};

use crate::support::colors::{BLUE, RED, WHITE, YELLOW, disc, draw, palette, traced as traced_layers};
use crate::support::pictures::{draw_finely, traced};
use expline::curve::Curve;
use expline::trace::{Color, TracedContour};

const SIDE: usize = 160;
const BLACK: Color = [0, 0, 0];
const PAPER: Color = [236, 236, 232];
const TEAL: Color = [0, 140, 130];
const TIPS: usize = 5;
const WIDTHS: [f64; 6] = [0.7, 0.8, 0.9, 1.0, 1.1, 1.2];

/// How far a place is from a line, and how long the line is.
type Line = (&'static str, fn(f64, f64) -> f64, f64);

fn from_ring(x: f64, y: f64) -> f64 {
    ((x - 80.3).hypot(y - 79.7) - 60.4).abs()
}

/// A side of the star and those like it: by symmetry only one is looked at.
fn from_star(x: f64, y: f64) -> f64 {
    let step = PI / TIPS as f64;
    let (dx, dy) = (x - 80.3, y - 79.6);
    let angle = (dy.atan2(dx) - 0.2).rem_euclid(2.0 * step);
    let angle = if angle > step { 2.0 * step - angle } else { angle };
    let [px, py] = [angle.cos(), angle.sin()].map(|part| dx.hypot(dy) * part);
    let [tip, notch] = star_side();
    let (ux, uy) = (notch.0 - tip.0, notch.1 - tip.1);
    let along = (((px - tip.0) * ux + (py - tip.1) * uy) / (ux * ux + uy * uy)).clamp(0.0, 1.0);
    (px - tip.0 - along * ux).hypot(py - tip.1 - along * uy)
}

fn star_side() -> [(f64, f64); 2] {
    let step = PI / TIPS as f64;
    [(65.3, 0.0), (30.2 * step.cos(), 30.2 * step.sin())]
}

fn lines() -> [Line; 2] {
    let [tip, notch] = star_side();
    let side = (notch.0 - tip.0).hypot(notch.1 - tip.1);
    [("ring", from_ring, TAU * 60.4), ("star", from_star, 2.0 * TIPS as f64 * side)]
}

/// The area that outlines enclose, holes taken off, as a share of a stroke's. Round ends at tips and notches add less
/// than a hundredth to it.
fn share<'a>(contours: impl Iterator<Item = &'a TracedContour>, length: f64, width: f64) -> f64 {
    contours.map(|contour| contour.curve.area().expect("closed")).sum::<f64>() / (length * width)
}

/// Of a ring of one pixel there were 26 pieces, of a star of .7 there were 44.
#[test]
fn black_outlines_of_a_pixel_are_whole_and_as_thick_as_they_are() {
    for (name, far, length) in lines() {
        for width in WIDTHS {
            let bytes = draw_finely(SIDE, SIDE, 8, &|x, y| far(x, y) < 0.5 * width);
            let found = traced(SIDE, SIDE, &bytes);
            assert_eq!(found.contours.len(), 2, "{name} of {width}: outside and inside");
            let share = share(found.contours.iter(), length, width);
            // Samples of an eighth of a pixel say the coverage of a side to a hundredth or so.
            assert!((share - 1.0).abs() < 0.03, "{name} of {width}: {share} of its area");
        }
    }
}

#[test]
fn coloured_outlines_of_a_pixel_are_whole_and_as_thick_as_they_are() {
    let pairs = [(Some(WHITE), RED), (None, RED), (None, BLACK), (Some(BLUE), YELLOW), (Some(PAPER), TEAL)];
    for ((name, far, length), (ground, color)) in
        lines().into_iter().flat_map(|line| pairs.map(|pair| (line, pair)))
    {
        for width in WIDTHS {
            let paint = |x: f64, y: f64| if far(x, y) < 0.5 * width { Some(color) } else { ground };
            let colors: Vec<Color> = ground.into_iter().chain([color]).collect();
            let layers = traced_layers(SIDE, SIDE, &draw(SIDE, SIDE, &paint), &colors);
            let own = || layers.iter().filter(|layer| layer.color == color).flat_map(|layer| &layer.contours);
            assert_eq!(own().count(), 2, "{name} of {width} in {color:?} on {ground:?}");
            let share = share(own(), length, width);
            // What shows less than a tenth of a colour is the ground.
            assert!((share - 1.0).abs() < 0.04, "{name} of {width} on {ground:?}: {share} of its area");
            let below = layers.iter().filter(|layer| Some(layer.color) == ground);
            assert_eq!(
                below.map(|layer| layer.contours.len()).sum::<usize>(),
                colors.len() - 1,
                "the ground"
            );
        }
    }
}

/// Of a ring of one pixel in red on white the census found red, white and a pink, in 25 pieces.
#[test]
fn what_two_rows_share_of_an_outline_is_no_colour_of_its_own() {
    for (ground, color) in [(WHITE, RED), (BLUE, YELLOW), (PAPER, TEAL)] {
        for ((name, far, _), width) in lines().into_iter().flat_map(|line| WIDTHS.map(|width| (line, width)))
        {
            let paint = |x: f64, y: f64| Some(if far(x, y) < 0.5 * width { color } else { ground });
            let bytes = draw(SIDE, SIDE, &paint);
            let found = palette(SIDE, &bytes, 4);
            assert_eq!(found.len(), 2, "{name} of {width} in {color:?} on {ground:?}: {found:?}");
            let layers = traced_layers(SIDE, SIDE, &bytes, &found);
            let counts: Vec<usize> = layers.iter().map(|layer| layer.contours.len()).collect();
            assert_eq!(counts, [1, 2], "{name} of {width} in {color:?}: the ground, outside and inside");
        }
    }
}

/// Black and white mixed, but black is broad: nothing of its edge is alike all around.
#[test]
fn a_gray_line_beside_a_black_disc_is_gray() {
    for (width, slope) in
        [3.0, 4.0].into_iter().flat_map(|width| [0.1, 0.15, 0.3].map(|slope| (width, slope)))
    {
        let gray = [128; 3];
        let paint = |x: f64, y: f64| {
            let off = (y - 90.3 - slope * (x - 80.0)).abs() / 1.0_f64.hypot(slope);
            Some(if disc(x, y, 40.0, 40.0, 25.3) {
                BLACK
            } else if off < 0.5 * width {
                gray
            } else {
                WHITE
            })
        };
        let found = palette(SIDE, &draw(SIDE, SIDE, &paint), 6);
        assert!(found.contains(&gray) && found.len() == 3, "{width} at {slope}: {found:?}");
    }
}
