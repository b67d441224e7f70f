//! What is ink and what is paper, also at the border and on a transparent ground.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::pictures::{STAR, draw, inside, traced};
use expline::curve::Curve;
use expline::trace::{Gray, TraceOptions, trace};

#[test]
fn ink_at_the_border_is_closed_along_the_border() {
    let drawing = traced(40, 30, &draw(40, 30, &|x, y| x < 12.5 && y > 10.25));
    assert_eq!(drawing.contours.len(), 1);
    let bounds = drawing.contours[0].curve.bounds();
    let near = |value: f64, expected: f64| assert!((value - expected).abs() < 0.02, "{value} for {expected}");
    near(bounds.min_x, 0.0);
    near(bounds.max_x, 12.5);
    near(bounds.min_y, 10.25);
    near(bounds.max_y, 30.0);
}

#[test]
fn light_ink_and_transparent_paper_are_what_they_seem() {
    let dark = draw(64, 64, &|x, y| inside(&STAR, x, y));
    let light: Vec<u8> = dark.iter().map(|v| 255 - v).collect();
    let gray = Gray::from_bytes(64, 64, &light).expect("valid");
    let options = TraceOptions { inverted: true, ..TraceOptions::default() };
    let found = trace(gray.clone(), &options).expect("a drawing");
    assert_eq!(found.contours[0].cusps.len(), 10, "light on dark");
    // Black ink whose opacity is its coverage.
    let rgba: Vec<u8> = dark.iter().flat_map(|&v| [0, 0, 0, 255 - v]).collect();
    let gray = Gray::from_rgba(64, 64, &rgba).expect("valid");
    let found = trace(gray.clone(), &TraceOptions::default()).expect("a drawing");
    assert_eq!(found.contours[0].cusps.len(), 10, "opacity");
    // White ink on nothing.
    let rgba: Vec<u8> = dark.iter().flat_map(|&v| [255, 255, 255, 255 - v]).collect();
    let gray = Gray::from_rgba(64, 64, &rgba).expect("valid");
    let found = trace(gray.clone(), &options).expect("a drawing");
    assert_eq!(found.contours[0].cusps.len(), 10, "white ink");
}

#[test]
fn a_light_drawing_on_nothing_is_ink_and_its_ground_is_not() {
    let star = draw(64, 64, &|x, y| inside(&STAR, x, y));
    let on_nothing = |color: [u8; 3]| -> Vec<u8> {
        star.iter().flat_map(|&v| [color[0], color[1], color[2], 255 - v]).collect()
    };
    for color in [[255, 255, 255], [250, 220, 90], [0, 0, 0], [20, 60, 160]] {
        let gray = Gray::from_rgba(64, 64, &on_nothing(color)).expect("valid");
        let found = trace(gray, &TraceOptions::default()).expect("a drawing");
        assert_eq!(found.contours.len(), 1, "{color:?}: the star alone");
        assert_eq!(found.contours[0].cusps.len(), 10, "{color:?}");
        assert!(!found.contours[0].hole, "{color:?}");
    }
    // A page with dark ink on it and transparent corners is a page, not a shape.
    let page: Vec<u8> = (0..64 * 64)
        .flat_map(|i| {
            let is_corner = (i % 64).min(63 - i % 64) + (i / 64).min(63 - i / 64) < 6;
            [star[i], star[i], star[i], if is_corner { 0 } else { 255 }]
        })
        .collect();
    let gray = Gray::from_rgba(64, 64, &page).expect("valid");
    let found = trace(gray, &TraceOptions::default()).expect("a drawing");
    assert_eq!(found.contours.len(), 1, "the star is ink, and the corners are not");
    assert_eq!(found.contours[0].cusps.len(), 10, "the star is ink");
}

/// A light square with a dark star on it, on nothing.
fn badge() -> Vec<u8> {
    let star = draw(64, 64, &|x, y| inside(&STAR, x, y));
    let square = draw(64, 64, &|x, y| (x - 32.0).abs().max((y - 32.0).abs()) < 31.0);
    star.iter().zip(&square).flat_map(|(&v, &d)| [v, v, v / 2 + 30, 255 - d]).collect()
}

#[test]
fn dark_ink_on_a_light_badge_is_ink_and_the_nothing_around_is_not() {
    let found = trace(Gray::from_rgba(64, 64, &badge()).expect("valid"), &TraceOptions::default())
        .expect("a drawing");
    assert_eq!(found.contours.len(), 1, "the star alone");
    assert_eq!(found.contours[0].cusps.len(), 10);
    assert!(!found.contours[0].hole);
}

#[test]
fn of_a_badge_that_is_inverted_the_light_part_is_ink_and_the_nothing_around_is_not() {
    let mut rows = Gray::begin(64, 64).expect("valid");
    rows.push_rgba_rows(&badge()).expect("all rows");
    let options = TraceOptions { inverted: true, ..TraceOptions::default() };
    let found = trace(rows.finish_for(true).expect("valid"), &options).expect("a drawing");
    let sides: Vec<_> = found.contours.iter().map(|contour| (contour.hole, contour.cusps.len())).collect();
    assert_eq!(sides, [(false, 4), (true, 10)], "the square, with a hole for the star");
}
