//! Drawings on paper that was photographed: light falls unevenly on it, and the outlines are those of the drawing in
//! even light.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::pictures::{draw, inside, traced};
use expline::curve::Curve;
use expline::trace::{Gray, Source, TraceOptions, trace};

const SIDE: usize = 240;

/// A ring, a house and a disc in lines and shapes a few pixels wide.
fn ink(x: f64, y: f64) -> bool {
    let house = |grow: f64| {
        let (left, right, top, bottom) = (30.0 - grow, 110.0 + grow, 120.0 - grow, 205.0 + grow);
        inside(&[(left, bottom), (left, top), (70.0, 70.0 - 1.3 * grow), (right, top), (right, bottom)], x, y)
    };
    let ring = ((x - 165.3).hypot(y - 80.6) - 42.0).abs() < 2.6;
    ring || (house(2.5) && !house(-2.5)) || (x - 178.2).hypot(y - 182.7) < 21.4
}

/// How much light falls on a place of the unit square, from 0 to 1.
type Light<'a> = &'a dyn Fn(f64, f64) -> f64;

/// The drawing, ink of a tenth of the paper's shade, in a light.
fn lit(light: Light) -> Vec<u8> {
    let paper = draw(SIDE, SIDE, &ink);
    let shade = |i: usize| {
        let (x, y) = ((i % SIDE) as f64 / SIDE as f64, (i / SIDE) as f64 / SIDE as f64);
        light(x, y) * (0.1 * 255.0 + 0.9 * f64::from(paper[i]))
    };
    (0..SIDE * SIDE).map(|i| shade(i).round() as u8).collect()
}

#[test]
fn a_drawing_in_uneven_light_has_the_outlines_of_the_drawing_in_even_light() {
    let even = traced(SIDE, SIDE, &lit(&|_, _| 1.0));
    assert_eq!(even.contours.len(), 5);
    let lights: [(&str, Light); 3] = [
        ("from the left", &|x, _| 0.95 - 0.6 * x),
        ("from a corner", &|x, y| 0.4 + 0.35 * x + 0.25 * y),
        ("of a lamp above the sheet", &|x, y| 0.97 - 0.8 * ((x - 0.45).powi(2) + (y - 0.4).powi(2))),
    ];
    for (name, light) in lights {
        let found = traced(SIDE, SIDE, &lit(light));
        assert_eq!(found.contours.len(), 5, "light {name}");
        for (a, b) in even.contours.iter().zip(&found.contours) {
            assert_eq!(a.hole, b.hole, "light {name}");
            // A byte is a hundredth of the way from ink to paper where there is least light.
            let (_, end) = b.curve.domain();
            for k in 0..64 {
                let place = b.curve.evaluate(end * f64::from(k) / 64.0, 0).expect("on the curve");
                let distance = a.curve.nearest(place).distance;
                assert!(distance < 0.12, "light {name}: {distance} at {place}");
            }
        }
    }
}

#[test]
fn centre_lines_are_found_in_uneven_light() {
    let stroke =
        |x: f64, y: f64| (y - 120.0 - 40.0 * (x / 40.0).sin()).abs() < 3.0 && (20.0..220.0).contains(&x);
    let paper = draw(SIDE, SIDE, &stroke);
    let bytes: Vec<u8> = (0..SIDE * SIDE)
        .map(|i| (f64::from(paper[i]) * (0.95 - 0.6 * (i % SIDE) as f64 / SIDE as f64)) as u8)
        .collect();
    let gray = Gray::from_bytes(SIDE, SIDE, &bytes).expect("a picture");
    let options = TraceOptions { source: Source::Lines, ..TraceOptions::default() };
    let lines = trace(gray, &options).expect("lines");
    assert_eq!(lines.contours.len(), 1, "one stroke");
    assert!(!lines.contours[0].closed);
}

#[test]
fn a_threshold_that_is_given_is_meant_for_the_shades_as_they_are() {
    let bytes = lit(&|x, _| 0.95 - 0.6 * x);
    let gray = Gray::from_bytes(SIDE, SIDE, &bytes).expect("a picture");
    let options = TraceOptions { threshold: Some(128.0), ..TraceOptions::default() };
    let dark = trace(gray, &options).expect("a drawing");
    let edge = dark.contours.iter().any(|contour| contour.curve.bounds().max_x > SIDE as f64 - 0.5);
    assert!(edge, "the dark side of the paper counts as ink");
}
