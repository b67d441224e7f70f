//! Drawings that the border of their picture cuts off end there, and are as near to it as others.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::pictures::{draw_finely, inside, traced};
use expline::curve::Curve;
use expline::numerics::Point;
use expline::trace::{Trace, TracedContour};

/// Where joints go pieces may leave .012 of coverage in each of the 70 pixels or so of these outlines.
const SPILT: f64 = 0.84;

/// How far the curves reach beyond the picture.
fn beyond(drawing: &Trace, (width, height): (usize, usize)) -> f64 {
    let reach = |contour: &TracedContour| {
        let b = contour.curve.bounds();
        (-b.min_x).max(-b.min_y).max(b.max_x - width as f64).max(b.max_y - height as f64)
    };
    drawing.contours.iter().map(reach).fold(0.0, f64::max)
}

/// By how many square pixels the ink of the curves differs from that of the pixels.
fn spilt(drawing: &Trace, bytes: &[u8]) -> f64 {
    let ink: f64 = bytes.iter().map(|&shade| 1.0 - f64::from(shade) / 255.0).sum();
    let area = |contour: &TracedContour| contour.curve.area().expect("a closed curve");
    (drawing.contours.iter().map(area).sum::<f64>() - ink).abs()
}

#[test]
fn a_wedge_that_the_border_cuts_off_ends_there_and_is_as_near_to_its_pixels_as_others() {
    let size = (14, 34);
    // Its lower side is on the border, and its upper one comes to the left border in the last two rows: both meet up to
    // six pixels beyond the picture.
    for k in 0..120 {
        let (low, slope) = (32.0 + 0.01 * f64::from(k), 0.35 + 0.0245 * f64::from(k % 40));
        let tip = (-(34.0 - low) / slope, 34.0);
        let wedge = [tip, (8.0, low - 8.0 * slope), (5.6, 12.0), (14.0, 11.0), (14.0, 34.0)];
        let fine = [2, 4, 8, 16][k as usize % 4];
        let bytes = draw_finely(size.0, size.1, fine, &|x, y| inside(&wedge, x, y));
        let drawing = traced(size.0, size.1, &bytes);
        let (beyond, spilt) = (beyond(&drawing, size), spilt(&drawing, &bytes));
        assert!(beyond <= 0.25, "{low} {slope}: {beyond} px beyond the picture");
        assert!(spilt < SPILT, "{low} {slope}: {spilt} square pixels too much or too little");
    }
}

#[test]
fn discs_that_the_border_cuts_off_have_two_corners_on_it() {
    let (size, radius) = ((24, 30), 9.0_f64);
    for k in 0..18 {
        let centre = Point::new(1.3 + 0.17 * f64::from(k), 14.1 + 0.07 * f64::from(k));
        let ink = |x: f64, y: f64| (x - centre.x).hypot(y - centre.y) < radius;
        let bytes = draw_finely(size.0, size.1, 16, &ink);
        let drawing = traced(size.0, size.1, &bytes);
        let (beyond, spilt) = (beyond(&drawing, size), spilt(&drawing, &bytes));
        assert!(
            beyond <= 0.25 && spilt < SPILT,
            "{beyond} px beyond the picture, {spilt} too much or too little"
        );
        let half = (radius * radius - centre.x * centre.x).sqrt();
        let cusps = &drawing.contours[0].cusps;
        assert_eq!(cusps.len(), 2);
        for corner in [Point::new(0.0, centre.y - half), Point::new(0.0, centre.y + half)] {
            let nearest = cusps.iter().map(|cusp| (cusp - corner).norm()).fold(f64::MAX, f64::min);
            // As corners of exact coverage elsewhere (V21).
            assert!(nearest < 0.05, "{centre:?}: {corner:?} is {nearest} px away from a corner");
        }
    }
}
