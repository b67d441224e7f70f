//! Corners of drawings are found where they are, all of them and no others.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::pictures::{draw, inside, traced};
use expline::curve::Curve;
use expline::numerics::Point;
use expline::trace::{Gray, TraceOptions, trace};

#[test]
fn corners_three_pixels_apart_are_all_found() {
    // Slanted strokes with ends that are as short as corners are far from each other.
    let slant = [(6.3, 40.2), (10.1, 8.4), (13.2, 8.1), (9.4, 39.9)];
    let strokes: Vec<Vec<(f64, f64)>> = (0..4)
        .map(|k| slant.iter().map(|&(x, y)| (x + 12.37 * f64::from(k), y + 0.21 * f64::from(k))).collect())
        .collect();
    let drawn = |x: f64, y: f64| strokes.iter().any(|stroke| inside(stroke, x, y));
    let drawing = traced(64, 48, &draw(64, 48, &drawn));
    assert_eq!(drawing.contours.len(), 4, "one outline for each stroke");
    for (k, stroke) in strokes.iter().enumerate() {
        let near = |p: &(f64, f64)| {
            let cusps = drawing.contours.iter().flat_map(|contour| &contour.cusps);
            cusps.map(|c| (c.x - p.0).hypot(c.y - p.1)).fold(f64::MAX, f64::min)
        };
        // Within a twentieth of a pixel, as all corners of exact coverage (V21).
        let most = stroke.iter().map(near).fold(0.0, f64::max);
        assert!(most < 0.05, "stroke {k}: a corner is {most} px away");
    }
    assert!(drawing.contours.iter().all(|contour| contour.cusps.len() == 4), "and no others");
}

#[test]
fn narrow_ends_keep_both_corners_and_a_narrow_tip_is_one() {
    // An H whose strokes are two pixels wide, and a wedge of which pixels cut off the tip.
    let letter = [
        (3.9, 6.3),
        (5.8, 6.3),
        (5.8, 12.5),
        (10.1, 12.5),
        (10.1, 6.3),
        (12.0, 6.3),
        (12.0, 19.4),
        (10.1, 19.4),
        (10.1, 14.6),
        (5.8, 14.6),
        (5.8, 19.4),
        (3.9, 19.4),
    ];
    let wedge = [(36.59, 10.7), (6.78, 106.81), (45.5, 106.81), (55.94, 73.82)];
    for (corners, width, height) in [(letter.as_slice(), 16, 24), (wedge.as_slice(), 64, 116)] {
        let drawing = traced(width, height, &draw(width, height, &|x, y| inside(corners, x, y)));
        let contour = &drawing.contours[0];
        assert_eq!((drawing.contours.len(), contour.cusps.len()), (1, corners.len()), "{:?}", contour.cusps);
        for &(x, y) in corners {
            let nearest =
                contour.cusps.iter().map(|p| (p - Point::new(x, y)).norm()).fold(f64::MAX, f64::min);
            assert!(nearest < 0.06, "corner {x}, {y} is off by {nearest}");
        }
    }
}

#[test]
fn corners_lie_on_the_curve_also_where_an_arc_ends_in_them() {
    // Joints move onto an arc that is recognised: by up to a sixteenth of a pixel, and the corners stayed where they
    // had been.
    for (radius, cut) in [(5.0, -0.4), (8.0, 0.0), (13.7, -0.4), (20.0, 0.3)] {
        let part = |x: f64, y: f64| {
            (x - 24.0).hypot(y - 24.0) < radius && x - 24.0 + 0.3 * (y - 24.0) > cut * radius
        };
        let drawing = traced(48, 48, &draw(48, 48, &part));
        let contour = &drawing.contours[0];
        assert_eq!(contour.cusps.len(), 2, "{radius}, {cut}: a part of a disc has two corners");
        for cusp in &contour.cusps {
            assert!(
                contour.curve.points().contains(cusp),
                "{radius}, {cut}: {cusp} is no point of the curve"
            );
        }
    }
}

#[test]
fn a_corner_too_blunt_for_what_is_asked_is_none() {
    let rhombus = [(6.0, 32.0), (32.0, 8.0), (58.0, 32.0), (32.0, 56.0)];
    let bytes = draw(64, 64, &|x, y| inside(&rhombus, x, y));
    let gray = Gray::from_bytes(64, 64, &bytes).expect("valid");
    for (corner, cusps) in [(0.49, 4), (core::f64::consts::PI, 0)] {
        let options = TraceOptions { corner, ..TraceOptions::default() };
        let drawing = trace(gray.clone(), &options).expect("a drawing");
        assert_eq!(drawing.contours[0].cusps.len(), cusps, "corners of {corner} and more");
    }
}

#[test]
fn a_corner_between_an_arc_and_its_chord_is_no_round_of_a_pixel() {
    // Drawn by 256 samples a pixel, which leave a few thousandths of coverage that a round of a pixel would explain,
    // too.
    for (x, y) in [(11.5, 27.57), (11.6, 27.57), (11.9, 27.44), (11.2, 26.53), (11.4, 26.53), (11.7, 26.01)] {
        let ink = |px: f64, py: f64| px > 8.0 && py < 32.0 && (px - x).hypot(py - y) < 9.0;
        let drawing = traced(40, 40, &draw(40, 40, &ink));
        let across = (81.0 - (32.0 - y) * (32.0 - y)).sqrt();
        let cusps = &drawing.contours[0].cusps;
        let nearest =
            cusps.iter().map(|p| (p - Point::new(x + across, 32.0)).norm()).fold(f64::MAX, f64::min);
        assert!(nearest < 0.05, "{x}, {y}: the corner is {nearest} px off");
    }
}

/// How much of each pixel is in a bar, exactly.
fn bar((width, height): (usize, usize), [left, right]: [f64; 2], [top, bottom]: [f64; 2]) -> Vec<u8> {
    let share = |from: f64, to: f64, i: usize| (to.min(i as f64 + 1.0) - from.max(i as f64)).max(0.0);
    let cover = |i: usize| share(left, right, i % width) * share(top, bottom, i / width);
    (0..width * height).map(|i| (255.0 * (1.0 - cover(i))).round() as u8).collect()
}

#[test]
fn a_bar_little_more_than_a_pixel_thick_is_a_bar_wherever_it_lies() {
    for (thick, long) in [(1.25, 15.0), (1.5, 15.0), (1.5, 40.0), (1.75, 15.0), (2.5, 15.0)] {
        for place in 0..64 {
            let (x, y) = (20.0 + f64::from(place % 8) / 8.0, 8.0 + f64::from(place / 8) / 8.0);
            let (across, along) = ([x, x + thick], [y, y + long]);
            for (size, xs, ys) in [((48, 64), across, along), ((64, 48), along, across)] {
                let drawing = traced(size.0, size.1, &bar(size, xs, ys));
                assert_eq!(drawing.contours.len(), 1, "{xs:?} {ys:?}");
                let curve = &drawing.contours[0].curve;
                let share = curve.area().expect("closed") / (thick * long);
                // Where no pixel is all ink the tone of ink is not known: coverage of a half is taken for all, and the
                // bar is up to twice as thick.
                assert!((0.75..1.7).contains(&share), "{share} of {xs:?} {ys:?}");
                let bounds = curve.bounds();
                let beyond =
                    [xs[0] - bounds.min_x, bounds.max_x - xs[1], ys[0] - bounds.min_y, bounds.max_y - ys[1]];
                // For the same reason; it is a pixel at most.
                assert!(beyond.iter().all(|&beyond| beyond < 1.0), "{beyond:?} of {xs:?} {ys:?}");
            }
        }
    }
}
