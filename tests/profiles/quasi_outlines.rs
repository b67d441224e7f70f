//! Outlines by the quasi-interpolant enclose what was drawn, however small it is.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::pictures::draw;
use expline::curve::Curve;
use expline::trace::{Gray, Model, TraceOptions, trace};

#[test]
fn the_quasi_interpolant_of_a_small_disc_encloses_it() {
    for place in 0..16 {
        let (x, y) = (12.0 + f64::from(place % 4) / 4.0, 12.0 + f64::from(place / 4) / 4.0);
        for radius in [1.0, 1.25, 1.5, 2.0] {
            let bytes = draw(24, 24, &|px, py| (px - x).hypot(py - y) < radius);
            let gray = Gray::from_bytes(24, 24, &bytes).expect("a valid picture");
            let options = TraceOptions { model: Model::QuasiInterpolant, ..TraceOptions::default() };
            for contour in &trace(gray, &options).expect("a drawing").contours {
                let share = contour.curve.area().expect("closed") / (core::f64::consts::PI * radius * radius);
                // A contour through a few centres cuts off a third; where no pixel is all ink it is as much too large.
                assert!((0.5..2.0).contains(&share), "{share} at {x}, {y}, radius {radius}");
            }
        }
    }
}
