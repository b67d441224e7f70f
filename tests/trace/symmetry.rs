//! A picture of two shades, its mirror images and what they are turned by quarters have the same drawing, mirrored and
//! turned: what is found does not depend on which pixel is first, nor on which way round an outline is followed.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::pictures::{Ink, draw_finely, traced};
use expline::numerics::Point;
use expline::trace::{Trace, TracedContour};
use expline::{Curve, HermiteCurve};

const SIDE: usize = 256;

/// From centred coordinates of an image to those of the picture: the first is the picture itself.
const IMAGES: [[f64; 4]; 8] = [
    [1.0, 0.0, 0.0, 1.0],
    [-1.0, 0.0, 0.0, 1.0],
    [1.0, 0.0, 0.0, -1.0],
    [-1.0, 0.0, 0.0, -1.0],
    [0.0, 1.0, 1.0, 0.0],
    [0.0, -1.0, 1.0, 0.0],
    [0.0, 1.0, -1.0, 0.0],
    [0.0, -1.0, -1.0, 0.0],
];

fn mapped(image: [f64; 4], p: Point) -> Point {
    let [a, b, c, d] = image;
    let half = 0.5 * SIDE as f64;
    let (x, y) = (p.x - half, p.y - half);
    Point::new(half + a * x + b * y, half + c * x + d * y)
}

/// The drawings of all images of a picture.
fn drawings(ink: Ink) -> Vec<Trace> {
    let drawing = |image: &[f64; 4]| {
        let there = |x: f64, y: f64| {
            let p = mapped(*image, Point::new(x, y));
            ink(p.x, p.y)
        };
        traced(SIDE, SIDE, &draw_finely(SIDE, SIDE, 1, &there))
    };
    IMAGES.iter().map(drawing).collect()
}

fn places(curve: &HermiteCurve) -> Vec<Point> {
    let end = curve.domain().1;
    (0..1500).map(|k| curve.evaluate(end * f64::from(k) / 1500.0, 0).expect("inside")).collect()
}

/// How far an outline of an image is from the picture's, in the mean and at most.
fn off(image: &TracedContour, image_of: [f64; 4], own: &TracedContour) -> (f64, f64) {
    let there = places(&image.curve).into_iter().map(|p| own.curve.nearest(mapped(image_of, p)).distance);
    // Turned by a quarter the other way; all other images are their own inverse.
    let [a, b, c, d] = image_of;
    let back = places(&own.curve).into_iter().map(|p| image.curve.nearest(mapped([a, c, b, d], p)).distance);
    let all: Vec<f64> = there.chain(back).collect();
    (all.iter().sum::<f64>() / all.len() as f64, all.iter().fold(0.0, |most, &off| most.max(off)))
}

/// Checks that all images of a shape have as many outlines as it and corners in each, nowhere farther from its own than
/// is said.
fn assert_alike(name: &str, ink: Ink, mean: f64, most: f64) {
    let all = drawings(ink);
    for (drawing, image) in all.iter().zip(IMAGES).skip(1) {
        assert_eq!(drawing.contours.len(), all[0].contours.len(), "{name} by {image:?}");
        for (there, own) in drawing.contours.iter().zip(&all[0].contours) {
            assert_eq!(there.cusps.len(), own.cusps.len(), "{name} by {image:?}");
            let (found, farthest) = off(there, image, own);
            assert!(found < mean && farthest < most, "{name} by {image:?}: {found} and {farthest} off");
        }
    }
}

#[test]
fn what_is_known_by_all_of_its_pixels_is_the_same_to_a_hundredth_of_a_pixel() {
    let disc = |x: f64, y: f64| (x - 127.3).hypot(y - 129.1) < 80.4;
    let ellipse = |x: f64, y: f64| {
        let (sin, cos) = 0.5_f64.sin_cos();
        let (x, y) = (x - 128.2, y - 127.7);
        ((x * cos + y * sin) / 100.0).hypot((y * cos - x * sin) / 45.0) < 1.0
    };
    let rectangle = |x: f64, y: f64| {
        let (sin, cos) = 0.3_f64.sin_cos();
        let (x, y) = (x - 128.2, y - 127.7);
        (x * cos + y * sin).abs() < 77.0 && (y * cos - x * sin).abs() < 61.0
    };
    assert_alike("a disc", &disc, 5e-3, 0.01);
    assert_alike("an ellipse", &ellipse, 5e-3, 0.01);
    assert_alike("a rectangle", &rectangle, 5e-3, 0.01);
}

/// Pieces are found one after another, so that joints of a smooth outline are elsewhere in an image; but a drawing is
/// .1 pixels from its shape in the mean, and no farther is it from the other, nor anywhere farther than half a pixel's
/// diagonal.
#[test]
fn what_is_followed_piece_by_piece_is_the_same_as_far_as_pixels_tell() {
    let crescent =
        |x: f64, y: f64| (x - 128.0).hypot(y - 128.0) < 89.6 && (x - 166.4).hypot(y - 130.0) > 76.8;
    let gear = |x: f64, y: f64| {
        let (x, y) = (x - 127.4, y - 128.3);
        x.hypot(y) < 96.0 + 8.0 * (9.0 * y.atan2(x)).sin()
    };
    let star = |x: f64, y: f64| {
        let (x, y) = (x - 128.4, y - 127.3);
        let side = core::f64::consts::TAU / 5.0;
        let angle = (y.atan2(x) + 7.0).rem_euclid(side) - 0.5 * side;
        x.hypot(y) * (0.9 * angle.abs() + 0.35).sin() < 38.0
    };
    let leaf = |x: f64, y: f64| {
        let (x, y) = (x - 60.0, y - 64.0);
        let middle = 60.0 + 40.0 * (x / 30.0).sin() * (x / 140.0);
        (0.0..140.0).contains(&x) && (y - middle).abs() < 8.0 + x / 7.0
    };
    let half = core::f64::consts::FRAC_1_SQRT_2;
    let shapes: [(&str, Ink); 4] =
        [("a crescent", &crescent), ("a gear", &gear), ("a star", &star), ("a leaf", &leaf)];
    for (name, ink) in shapes {
        assert_alike(name, ink, 0.1, half);
    }
}

#[test]
fn squares_are_the_same_squares() {
    let rows = [".##..###", "##...#.#", "#.##.###", "####...."];
    let ink = |x: f64, y: f64| {
        let at = |v: f64| (v as usize / 8).wrapping_sub(9);
        rows.get(at(y)).and_then(|row| row.as_bytes().get(at(x))) == Some(&b'#')
    };
    let corners = |drawing: &Trace, [a, b, c, d]: [f64; 4]| {
        let points = drawing.contours.iter().flat_map(|contour| contour.curve.points());
        let mut corners: Vec<_> =
            points.map(|&p| mapped([a, b, c, d], p)).map(|p| (p.x.to_bits(), p.y.to_bits())).collect();
        corners.sort_unstable();
        corners
    };
    let all = drawings(&ink);
    let own = corners(&all[0], IMAGES[0]);
    assert!(own.len() > 20, "{} corners", own.len());
    for (drawing, image) in all.iter().zip(IMAGES) {
        assert_eq!(corners(drawing, image), own, "by {image:?}");
    }
}
