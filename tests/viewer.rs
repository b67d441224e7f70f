//! A viewer draws what the path data says: Chromium itself decides which points lie inside.
#![cfg(target_arch = "wasm32")]

use core::f64::consts::TAU;

use expline::HermiteCurve;
use expline::numerics::{Point, Vector};
use expline::svg::{PrintOptions, parse_path, to_path_d};
use wasm_bindgen_test::{wasm_bindgen_test as test, wasm_bindgen_test_configure};
use web_sys::wasm_bindgen::JsCast;
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement, Path2d};

wasm_bindgen_test_configure!(run_in_browser);

/// How far beside the outline we ask, as a share of its size: ten times what Chromium's own arcs are off.
const ASIDE: f64 = 1e-3;

fn canvas() -> CanvasRenderingContext2d {
    let document = web_sys::window().and_then(|window| window.document()).expect("a page has a document");
    let canvas: HtmlCanvasElement =
        document.create_element("canvas").expect("canvas is an element's name").unchecked_into();
    canvas.get_context("2d").ok().flatten().expect("a canvas can be drawn on").unchecked_into()
}

fn printed(curve: &HermiteCurve) -> Path2d {
    let options = PrintOptions { tolerance: 1e-3, ..PrintOptions::default() };
    let text = to_path_d(curve, &options).expect("the options are valid").d;
    Path2d::new_with_path_string(&text).expect("a browser reads what we write")
}

#[test]
fn ellipses_are_drawn_where_their_equation_says() {
    let context = canvas();
    for (count, rotation) in [(2, 0.0), (3, 0.4), (8, 2.1)] {
        let (center, radii) = (Point::new(150.0, 140.0), Vector::new(120.0, 60.0));
        let curve = HermiteCurve::ellipse(center, radii, rotation, count).expect("the ellipse is sound");
        let path = printed(&curve);
        let (sin, cos) = rotation.sin_cos();
        for i in 0..360 {
            let (y, x) = (TAU * f64::from(i) / 360.0).sin_cos();
            let (u, v) = (radii.x * x, radii.y * y);
            for (scale, inside) in [(1.0 - ASIDE, true), (1.0 + ASIDE, false)] {
                let x = center.x + scale * (u * cos - v * sin);
                let y = center.y + scale * (u * sin + v * cos);
                let found = context.is_point_in_path_with_path_2d_and_f64(&path, x, y);
                assert_eq!(found, inside, "{count} points, degree {i}, at {scale} of the radius");
            }
        }
    }
}

#[test]
fn a_path_read_and_written_encloses_what_it_enclosed() {
    let context = canvas();
    let text = "M10 10h80v40a20 20 0 0 1-20 20H40q-30 0-30-30zM120 20c20-20 60-20 80 0s20 60 0 80t-80-20z";
    let before = Path2d::new_with_path_string(text).expect("a sound path");
    let curves = parse_path(text).expect("a sound path").curves;
    let after: Vec<Path2d> = curves.iter().map(printed).collect();
    let (mut inside, mut compared) = (0, 0);
    for i in 0..44 {
        for k in 0..24 {
            // Off the straight edges, which lie on multiples of 10.
            let (x, y) = (5.0 * f64::from(i) + 1.37, 5.0 * f64::from(k) + 1.71);
            let expected = context.is_point_in_path_with_path_2d_and_f64(&before, x, y);
            let found = after.iter().any(|path| context.is_point_in_path_with_path_2d_and_f64(path, x, y));
            assert_eq!(found, expected, "at ({x}, {y})");
            inside += u32::from(found);
            compared += 1;
        }
    }
    assert!(inside > compared / 5 && inside < compared, "{inside} of {compared} points lie inside");
}
