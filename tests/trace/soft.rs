//! Pictures with soft edges, out of focus or drawn smaller and scaled up, are traced as what was drawn, not as what the
//! blur made of it.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::pictures::{along, draw, inside, traced};
use expline::numerics::Point;
use expline::trace::TracedContour;

/// An arrow aslant, in a picture of 128 pixels.
const ARROW: [(f64, f64); 7] =
    [(19.2, 42.6), (90.1, 67.3), (96.4, 49.2), (113.6, 83.4), (79.3, 98.6), (85.6, 80.5), (14.7, 55.8)];
const SIDE: usize = 128;

/// A picture scaled up by the program that shows it: between the centres of pixels shades are in proportion to the way.
fn scaled(bytes: &[u8], side: usize, times: usize) -> Vec<u8> {
    let shade = |x: isize, y: isize| {
        let [x, y] = [x, y].map(|v| v.clamp(0, side as isize - 1) as usize);
        f64::from(bytes[y * side + x])
    };
    let fine = side * times;
    let place = |at: usize| (at as f64 + 0.5) / times as f64 - 0.5;
    let pixel = |i: usize| {
        let (x, y) = (place(i % fine), place(i / fine));
        let (left, top) = (x.floor() as isize, y.floor() as isize);
        let (u, v) = (x - x.floor(), y - y.floor());
        let upper = shade(left, top) * (1.0 - u) + shade(left + 1, top) * u;
        let lower = shade(left, top + 1) * (1.0 - u) + shade(left + 1, top + 1) * u;
        (upper * (1.0 - v) + lower * v).round() as u8
    };
    (0..fine * fine).map(pixel).collect()
}

/// A picture out of focus: every pixel is the mean of those around it, by the weights of a Gaussian.
fn unfocused(bytes: &[u8], side: usize, sigma: f64) -> Vec<u8> {
    let reach = (4.0 * sigma).ceil() as isize;
    let weights: Vec<f64> = (-reach..=reach).map(|d| (-0.5 * (d as f64 / sigma).powi(2)).exp()).collect();
    let total: f64 = weights.iter().sum();
    let pass = |from: &[f64], step: [isize; 2]| -> Vec<f64> {
        let last = side as isize - 1;
        let pixel = |i: usize| {
            let (x, y) = ((i % side) as isize, (i / side) as isize);
            let at = |d: isize| {
                let [x, y] = [x + d * step[0], y + d * step[1]].map(|v| v.clamp(0, last) as usize);
                from[y * side + x]
            };
            (-reach..=reach).zip(&weights).map(|(d, weight)| weight * at(d)).sum::<f64>() / total
        };
        (0..from.len()).map(pixel).collect()
    };
    let shades: Vec<f64> = bytes.iter().map(|&shade| f64::from(shade)).collect();
    pass(&pass(&shades, [1, 0]), [0, 1]).into_iter().map(|shade| shade.round() as u8).collect()
}

/// The one contour of a picture.
fn only(bytes: &[u8], side: usize) -> TracedContour {
    let mut drawing = traced(side, side, bytes);
    assert_eq!(drawing.contours.len(), 1, "one shape has one contour");
    drawing.contours.remove(0)
}

/// How far a place is from the sides of a polygon that is drawn larger.
fn from_sides(corners: &[(f64, f64)], times: f64, p: Point) -> f64 {
    let side = |i: usize| {
        let [a, b] = [corners[i], corners[(i + 1) % corners.len()]];
        let (x, y) = (p.x / times - a.0, p.y / times - a.1);
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        let share = ((x * dx + y * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
        times * (x - share * dx).hypot(y - share * dy)
    };
    (0..corners.len()).map(side).fold(f64::INFINITY, f64::min)
}

/// A polygon's corners and sides are where they were drawn.
fn assert_polygon(contour: &TracedContour, corners: &[(f64, f64)], times: f64, near: [f64; 2]) {
    for &(x, y) in corners {
        let distance = |p: &Point| (p.x - times * x).hypot(p.y - times * y);
        let off = contour.cusps.iter().map(|&cusp| distance(&cusp)).fold(f64::INFINITY, f64::min);
        assert!(off < near[0], "a corner is {off} pixels off");
    }
    let (_, mean) = along(&contour.curve, &|p| from_sides(corners, times, p));
    assert!(mean < near[1], "sides are {mean} pixels off");
}

#[test]
fn drawings_that_were_scaled_up_have_the_corners_and_no_more_points_than_were_drawn() {
    let bytes = draw(SIDE, SIDE, &|x, y| inside(&ARROW, x, y));
    for times in [2, 3] {
        let contour = only(&scaled(&bytes, SIDE, times), SIDE * times);
        // A hundredth of an old pixel is what traces of clean pictures are off; corners are, by a tenth.
        assert_eq!(contour.curve.points().len(), ARROW.len(), "{contour:?}");
        let times = times as f64;
        assert_polygon(&contour, &ARROW, times, [0.1 * times, 0.01 * times]);
    }
}

#[test]
fn circles_that_were_scaled_up_are_circles() {
    let bytes = draw(SIDE, SIDE, &|x, y| (x - 63.3).hypot(y - 64.2) <= 47.6);
    for times in [2, 3, 4] {
        let contour = only(&scaled(&bytes, SIDE, times), SIDE * times);
        let circle = contour.curve.as_ellipse(1e-6).expect("a circle");
        let (radius, old) = (circle.radii.x / times as f64, 47.6);
        assert!((radius - old).abs() < 0.02, "{radius} for {old}");
    }
}

#[test]
fn corners_of_pictures_out_of_focus_are_where_they_were_drawn() {
    let bytes = draw(SIDE, SIDE, &|x, y| inside(&ARROW, x, y));
    for sigma in [0.7, 1.0, 1.5] {
        // The blurred contour ends up to a pixel before the arrow's tip.
        assert_polygon(&only(&unfocused(&bytes, SIDE, sigma), SIDE), &ARROW, 1.0, [0.15, 0.015]);
    }
}

#[test]
fn smooth_shapes_of_pictures_out_of_focus_are_as_large_as_they_were_drawn() {
    for (radius, sigma) in [(10.4, 0.6), (10.4, 1.0), (10.4, 1.5), (20.4, 2.0)] {
        // A level at half follows such a circle σ²/2r farther inside, up to .11 pixels.
        let bytes = draw(64, 64, &|x, y| (x - 32.3).hypot(y - 31.8) <= radius);
        let contour = only(&unfocused(&bytes, 64, sigma), 64);
        let (most, _) = along(&contour.curve, &|p| ((p.x - 32.3).hypot(p.y - 31.8) - radius).abs());
        assert!(most < 0.05, "{most} at {sigma}");
    }
}
