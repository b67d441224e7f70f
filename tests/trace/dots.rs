//! Dots of small letters: smaller than two pixels, but drawn, as their gray edges say.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::pictures::{draw, traced};
use expline::curve::Curve;
use expline::trace::{Gray, TraceOptions, TracedContour, trace};

const WIDTH: usize = 120;
const HEIGHT: usize = 24;
const COUNT: usize = 14;

fn area(contour: &TracedContour) -> f64 {
    contour.curve.area().expect("closed").abs()
}

/// Where the k-th letter is: in every part of a pixel.
fn place(k: usize) -> (f64, f64) {
    (5.0 + 7.0 * k as f64 + (0.618 * k as f64) % 1.0, 6.0 + (0.382 * k as f64) % 1.0)
}

/// Letters i, stems of 1.3 by 9 pixels below dots of a side.
fn letters(side: f64) -> Vec<u8> {
    draw(WIDTH, HEIGHT, &|x, y| {
        (0..COUNT).any(|k| {
            let (left, top) = place(k);
            let (u, v) = (x - left, y - top);
            (0.0..1.3).contains(&u) && (3.6..12.6).contains(&v)
                || (0.0..side).contains(&u) && (0.0..side).contains(&v)
        })
    })
}

/// How much of a pixel a side covers at most, which begins somewhere.
fn most(begin: f64, side: f64) -> f64 {
    let first = 1.0 - begin.fract();
    first.min(side).max((side - first).min(1.0))
}

/// Of 14 dots of 1.2 pixels 4 were kept, of 1.3 pixels 5: they have less than two pixels.
#[test]
fn dots_of_small_letters_are_kept_and_as_large_as_they_are() {
    for side in [1.2, 1.3, 1.4] {
        let found = traced(WIDTH, HEIGHT, &letters(side));
        let dots: Vec<f64> = found.contours.iter().map(area).filter(|&area| area < 4.0).collect();
        assert_eq!(found.contours.len() - dots.len(), COUNT, "{side} wide: the stems");
        // Shared by four pixels a dot may be nowhere more than half.
        let is_dark = |&k: &usize| most(place(k).0, side) * most(place(k).1, side) > 0.65;
        let dark = (0..COUNT).filter(is_dark).count();
        assert!(dark > COUNT / 2 && dots.len() >= dark, "{side} wide: {} of {dark}", dots.len());
        let mean = dots.iter().sum::<f64>() / dots.len() as f64;
        // Pixels carry the area; an outline of a few pixels may leave a twentieth of one in some.
        let truth = side * side;
        assert!((mean / truth - 1.0).abs() < 0.05, "{side} wide: {mean} of {truth} in the mean");
    }
}

#[test]
fn a_speckle_that_is_asked_for_holds_for_dots_as_well() {
    let options = TraceOptions { speckle: Some(4.0), ..TraceOptions::default() };
    let gray = Gray::from_bytes(WIDTH, HEIGHT, &letters(1.2)).expect("a picture");
    assert_eq!(trace(gray, &options).expect("a drawing").contours.len(), COUNT);
}

#[test]
fn specks_beside_thick_strokes_and_single_pixels_of_a_scan_are_no_dots() {
    let side = 64;
    let is_speck = |x: f64, y: f64| (0.0..1.2).contains(&(x - 5.4)) && (0.0..1.2).contains(&(y - 7.3));
    let thick = draw(side, side, &|x, y| (x - 36.0).hypot(y - 34.0) < 22.3 || is_speck(x, y));
    assert_eq!(traced(side, side, &thick).contours.len(), 1, "dust beside a disc");
    let mut scan: Vec<u8> = letters(0.0).iter().map(|&shade| if shade < 128 { 0 } else { 255 }).collect();
    for at in [3 * WIDTH + 9, 3 * WIDTH + 40, 21 * WIDTH + 77] {
        scan[at] = 0;
    }
    assert_eq!(traced(WIDTH, HEIGHT, &scan).contours.len(), COUNT, "pixels of two shades");
}
