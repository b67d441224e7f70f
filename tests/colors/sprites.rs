//! What was drawn pixel by pixel in a few colours, as sprites are, comes back as the squares that its pixels are, in
//! every layer.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::colors::{BLUE, Paint, RED, WHITE, YELLOW, disc, draw, traced};
use expline::numerics::Point;
use expline::trace::{Color, TracedContour, TracedLayer};

const BLACK: Color = [20, 12, 28];
const GREEN: Color = [60, 150, 70];

/// A creature in a dark outline, with single pixels for its eyes and buttons.
const CREATURE: [&str; 16] = [
    "................",
    "....kk....kk....",
    "...krrk..krrk...",
    "...krrrkkrrrk...",
    "..krrrrrrrrrrk..",
    "..krywrrrrywrk..",
    "..krywrrrrywrk..",
    "..krrrrkkrrrrk..",
    "...krrrrrrrrk...",
    "..kgggggggggk...",
    ".kggybggggybggk.",
    ".kggggggggggggk.",
    "..kgggybbyggggk.",
    "...kgggggggggk..",
    "...kkrrkkrrkk...",
    "....kkkk.kkkk...",
];

/// The colours of a picture drawn by letters, a pixel each.
fn drawn(x: f64, y: f64) -> Option<Color> {
    match CREATURE[y as usize].as_bytes()[x as usize] {
        b'k' => Some(BLACK),
        b'r' => Some(RED),
        b'y' => Some(YELLOW),
        b'w' => Some(WHITE),
        b'g' => Some(GREEN),
        b'b' => Some(BLUE),
        _ => None,
    }
}

/// Whether a contour runs along the sides of pixels only.
fn is_along_pixels(contour: &TracedContour) -> bool {
    let points = contour.curve.points();
    let before = points.iter().cycle().skip(points.len() - 1);
    points.iter().zip(before).all(|(here, before)| {
        let is_whole = |v: f64| (v - v.round()).abs() < 1e-9;
        is_whole(here.x) && is_whole(here.y) && (here.x == before.x || here.y == before.y)
    })
}

/// Whether an odd number of a contour's pieces cross the ray from a place to the right.
fn is_around(contour: &TracedContour, place: Point) -> bool {
    let points = contour.curve.points();
    let crosses = |i: usize| {
        let (a, b) = (points[i], points[(i + 1) % points.len()]);
        (a.y > place.y) != (b.y > place.y) && a.x > place.x
    };
    (0..points.len()).filter(|&i| crosses(i)).count() % 2 == 1
}

/// The colour that layers of upright sides show at a place.
fn shown(layers: &[TracedLayer], place: Point) -> Option<Color> {
    let covers = |layer: &&TracedLayer| {
        layer.contours.iter().filter(|contour| is_around(contour, place)).count() % 2 == 1
    };
    layers.iter().rev().find(covers).map(|layer| layer.color)
}

fn assert_is_what_was_drawn(paint: Paint, colors: &[Color]) {
    let bytes = draw(16, 16, paint);
    let layers = traced(16, 16, &bytes, colors);
    for contour in layers.iter().flat_map(|layer| &layer.contours) {
        assert!(is_along_pixels(contour), "{:?}", contour.curve.points());
    }
    for i in 0..256 {
        let (x, y) = (f64::from(i % 16) + 0.5, f64::from(i / 16) + 0.5);
        assert_eq!(shown(&layers, Point::new(x, y)), paint(x, y), "at ({x}, {y})");
    }
}

#[test]
fn a_sprite_comes_back_as_its_pixels_to_the_last_one() {
    assert_is_what_was_drawn(&drawn, &[BLACK, RED, GREEN, YELLOW, WHITE, BLUE]);
}

#[test]
fn so_it_does_on_a_ground_of_its_own_colour() {
    let ground = [92, 148, 252];
    let paint = |x: f64, y: f64| drawn(x, y).or(Some(ground));
    assert_is_what_was_drawn(&paint, &[ground, BLACK, RED, GREEN, YELLOW, WHITE, BLUE]);
}

#[test]
fn a_drawing_without_gray_whose_edges_run_aslant_stays_smooth() {
    let paint = |x: f64, y: f64| {
        // Of each pixel only its centre says what it is.
        let (x, y) = (x.floor() + 0.5, y.floor() + 0.5);
        Some(if disc(x, y, 40.2, 33.1, 21.0) {
            RED
        } else if disc(x, y, 60.0, 45.0, 27.0) {
            BLUE
        } else {
            WHITE
        })
    };
    let layers = traced(100, 80, &draw(100, 80, &paint), &[WHITE, BLUE, RED]);
    let top = &layers[2].contours[0];
    assert!(top.curve.points().len() <= 8, "{} points", top.curve.points().len());
    let end = top.curve.domain().1;
    for i in 0..40 {
        let place = top.curve.evaluate(end * f64::from(i) / 40.0, 0).expect("in the domain");
        let off = (place - Point::new(40.2, 33.1)).norm() - 21.0;
        assert!(off.abs() < 0.5, "{off} beside the disc at {place}");
    }
}
