//! Pictures whose edges were not drawn by exact coverage are traced as well as those that were. Browsers and many
//! programs take four rows of four samples in each pixel, which tell where an edge is to 1/16 of a pixel or so.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use core::f64::consts::{FRAC_PI_2, PI};

use crate::support::pictures::{Ink, draw, draw_finely, inside, traced};
use expline::curve::HermiteCurve;
use expline::numerics::Vector;
use expline::trace::{Gray, TraceOptions, trace};

fn draw_by_samples(side: usize, ink: Ink) -> Vec<u8> {
    draw_finely(side, side, 4, ink)
}

#[test]
fn circles_and_ellipses_drawn_by_a_few_samples_a_pixel_are_circles_and_ellipses() {
    for radius in [7.3, 26.6, 95.9] {
        let side = 2 * (radius as usize + 4);
        let middle = 0.5 * side as f64 + 0.13;
        let bytes = draw_by_samples(side, &|x, y| (x - middle).hypot(y - middle) <= radius);
        let circle = traced(side, side, &bytes).contours[0].curve.as_ellipse(1e-6).expect("a circle");
        assert!((circle.radii - Vector::new(radius, radius)).norm() < 0.15, "{circle:?}");
    }
    // Programs draw curves as chords: these are a quarter of a pixel off in their middle.
    let (radius, side) = (140.0, 300);
    let chord = 2.0 * (1.0_f64 - 0.25 / radius).acos();
    let bytes = draw_by_samples(side, &|x, y| {
        let (x, y) = (x - 149.8, y - 150.3);
        let angle = y.atan2(x).rem_euclid(chord) - 0.5 * chord;
        x.hypot(y) * angle.cos() <= radius * (0.5 * chord).cos()
    });
    let circle = traced(side, side, &bytes).contours[0].curve.as_ellipse(1e-6).expect("a circle");
    assert!((circle.radii - Vector::new(radius, radius)).norm() < 0.4, "{circle:?}");
    let (sin, cos) = 0.35_f64.sin_cos();
    let bytes = draw_by_samples(128, &|x, y| {
        let (x, y) = (x - 63.7, y - 64.2);
        ((x * cos + y * sin) / 55.0).hypot((y * cos - x * sin) / 32.0) <= 1.0
    });
    let ellipse = traced(128, 128, &bytes).contours[0].curve.as_ellipse(1e-6).expect("an ellipse");
    assert!((ellipse.radii - Vector::new(55.0, 32.0)).norm() < 0.15, "{ellipse:?}");
}

#[test]
fn outlines_drawn_by_a_few_samples_a_pixel_have_as_few_points_as_exact_ones() {
    let wave = |x: f64, y: f64| y > 80.0 + 20.0 * (x / 37.0).sin() + 7.0 * (x / 61.0).cos();
    let rounded = |x: f64, y: f64| {
        let (x, y) = ((x - 80.3).abs() - 40.0, (y - 79.6).abs() - 25.0);
        x.max(0.0).hypot(y.max(0.0)) <= 15.0
    };
    // Grain is in longer waves where a shape is larger.
    let large = |x: f64, y: f64| rounded(0.4 * x, 0.4 * y);
    let shapes: [(usize, Ink); 3] = [(160, &wave), (160, &rounded), (400, &large)];
    for (side, ink) in shapes {
        let points = |fine: usize| {
            let drawing = traced(side, side, &draw_finely(side, side, fine, ink));
            drawing.contours.iter().map(|contour| contour.curve.points().len()).sum::<usize>()
        };
        let (exact, sampled) = (points(16), points(4));
        assert!(sampled <= exact + 2, "{sampled} points at {side} pixels, of exact coverage {exact}");
    }
}

#[test]
fn small_shapes_drawn_by_four_rows_of_many_samples_have_few_pieces() {
    // So browsers draw: edges that run along columns are nearly exact, others are not.
    let rows = |ink: Ink| -> Vec<u8> {
        let covered = |i: usize| {
            let at = |k: usize| {
                ((i % 64) as f64 + (k % 16) as f64 / 16.0, (i / 64) as f64 + (k / 16) as f64 / 4.0)
            };
            let inside = (0..64).filter(|&k| ink(at(k).0 + 1.0 / 32.0, at(k).1 + 1.0 / 8.0)).count();
            (255.0 * (1.0 - inside as f64 / 64.0)).round() as u8
        };
        (0..64 * 64).map(covered).collect()
    };
    let (mut pieces, mut shapes) = (0, 0);
    for radius in [5.0, 8.4, 11.8, 15.2, 18.6] {
        for share in [0.0, 0.2, 0.4, 0.6, 0.8] {
            for row in [30.0, 30.3] {
                let column = 15.3 + share * radius;
                let cut: Ink = &|x, y| x > 15.3 && (x - column).hypot(y - row) < radius;
                pieces += traced(64, 64, &rows(cut))
                    .contours
                    .iter()
                    .map(|c| c.curve.segment_count())
                    .sum::<usize>();
                shapes += 1;
            }
        }
    }
    // A line and one arc or two. Of exact coverage they have 3.3; where median and quartile of what windows leave had
    // to reach the same number, these had 3.7.
    assert!(10 * pieces <= 36 * shapes, "{pieces} pieces of {shapes} shapes");
}

#[test]
fn ink_whose_shade_lies_between_two_bytes_is_as_clean_as_black() {
    let blue = [0x11, 0x44, 0xaa];
    let share = draw(64, 64, &|x, y| (x - 31.7).hypot(y - 32.2) <= 20.6);
    let channel = |paper: u8, k: usize| {
        let (ink, paper) = (f64::from(blue[k]), f64::from(paper) / 255.0);
        (ink + (255.0 - ink) * paper).round() as u8
    };
    let pixel = |&paper: &u8| [channel(paper, 0), channel(paper, 1), channel(paper, 2), 255];
    let bytes: Vec<u8> = share.iter().flat_map(pixel).collect();
    let gray = Gray::from_rgba(64, 64, &bytes).expect("a valid picture");
    let drawing = trace(gray, &TraceOptions::default()).expect("a drawing");
    assert!(drawing.tones.ink % 256.0 > 1.0, "or it is no such ink: {}", drawing.tones.ink);
    // All of it seemed stained, by the fraction of a byte, and a disc had fifteen points.
    drawing.contours[0].curve.as_ellipse(1e-6).expect("a circle");
}

/// How many segments are straight, and how many are not.
fn straight_and_bent(curve: &HermiteCurve) -> (usize, usize) {
    let straight = |i: usize| {
        let next = (i + 1) % curve.points().len();
        let chord = curve.points()[next] - curve.points()[i];
        let across = |way: Vector| (chord.x * way.y - chord.y * way.x).abs() / (chord.norm() * way.norm());
        across(curve.tangents()[i]) < 1e-9 && across(curve.tangents_in()[next]) < 1e-9
    };
    let lines = (0..curve.segment_count()).filter(|&i| straight(i)).count();
    (lines, curve.segment_count() - lines)
}

#[test]
fn straight_sides_drawn_by_a_few_samples_a_pixel_are_lines_however_long() {
    // Between round corners.
    for (side, turn) in [(64, 0.12), (160, 0.12), (160, 0.53), (400, 0.12), (400, 0.785)] {
        let scale = side as f64 / 160.0;
        let (sin, cos) = f64::sin_cos(turn);
        let bytes = draw_by_samples(side, &|x, y| {
            let (x, y) = (x / scale - 80.3, y / scale - 79.6);
            let (x, y) = ((x * cos + y * sin).abs() - 30.0, (y * cos - x * sin).abs() - 25.0);
            x.max(0.0).hypot(y.max(0.0)) <= 20.0
        });
        let (lines, bent) = straight_and_bent(&traced(side, side, &bytes).contours[0].curve);
        assert!(
            lines == 4 && bent <= 8,
            "{lines} lines and {bent} others at {side} pixels, turned by {turn}"
        );
    }
    // Between sharp ones.
    for side in [32, 80, 300] {
        let scale = side as f64 / 100.0;
        let corners = [(12.0, 20.0), (88.0, 31.0), (84.0, 71.0), (47.0, 55.0), (20.0, 83.0)];
        let corners = corners.map(|(x, y)| (x * scale, y * scale));
        let bytes = draw_by_samples(side, &|x, y| inside(&corners, x, y));
        let drawing = traced(side, side, &bytes);
        assert_eq!(straight_and_bent(&drawing.contours[0].curve), (5, 0), "at {side} pixels");
    }
}

#[test]
fn a_shallow_arc_drawn_by_a_few_samples_a_pixel_is_no_line() {
    // The flatter ones cross few rows: four samples in each are steps that look like bends.
    for (side, sagitta, fall) in [(100, 0.8, 0.25), (300, 1.2, 0.25), (100, 0.8, 0.07), (300, 1.2, 0.07)] {
        let (start, length) = (10.3, side as f64 - 20.0);
        let bytes = draw_by_samples(side, &|x, y| {
            let along = (x - start) / length;
            let top = 10.2 + fall * x - 4.0 * sagitta * along * (1.0 - along);
            (0.0..=1.0).contains(&along) && y >= top && y <= side as f64 - 20.0
        });
        let (lines, bent) = straight_and_bent(&traced(side, side, &bytes).contours[0].curve);
        assert_eq!((lines, bent), (3, 1), "at {side} pixels, falling by {fall}");
    }
}

/// Places on an arc about a centre, which are the ends of chords that are `off` from it in their middle.
fn arc_by_chords(center: (f64, f64), radius: f64, [from, to]: [f64; 2], off: f64) -> Vec<(f64, f64)> {
    let count = ((to - from).abs() / (2.0 * (1.0 - off / radius).acos())).ceil();
    let angle = |k: f64| from + (to - from) * k / count;
    let place = |angle: f64| (center.0 + radius * angle.cos(), center.1 + radius * angle.sin());
    (0..=count as usize).map(|k| place(angle(k as f64))).collect()
}

#[test]
fn a_lens_drawn_as_chords_of_exact_coverage_has_few_pieces_and_two_corners() {
    let (side, off) = (256, 0.25);
    let scale = side as f64 / 100.0;
    let radius = 55.0 * scale;
    let half = (42.0_f64 / 55.0).asin();
    let (x, y, up) = (50.13 * scale, 49.7 * scale, radius * half.cos());
    let mut lens = arc_by_chords((x, y + up), radius, [-FRAC_PI_2 - half, -FRAC_PI_2 + half], off);
    lens.extend(arc_by_chords((x, y - up), radius, [FRAC_PI_2 - half, FRAC_PI_2 + half], off));
    let bytes = draw_finely(side, side, 8, &|x, y| inside(&lens, x, y));
    let contour = &traced(side, side, &bytes).contours[0];
    assert!(contour.curve.segment_count() <= 12, "{} pieces", contour.curve.segment_count());
    assert_eq!(contour.cusps.len(), 2);
}

/// How many segments are lines, arcs and others.
fn kinds(curve: &HermiteCurve) -> [usize; 3] {
    let lines = straight_and_bent(curve).0;
    let arcs = curve.omega().iter().filter(|&&angle| angle > 0.0).count();
    [lines, arcs, curve.segment_count() - lines - arcs]
}

#[test]
fn arcs_between_corners_drawn_as_chords_are_arcs() {
    for (side, off) in [(160, 0.15), (256, 0.25), (420, 0.3)] {
        let scale = side as f64 / 100.0;
        let radius = 55.0 * scale;
        let half = (42.0_f64 / 55.0).asin();
        let (x, up) = (50.13 * scale, radius * half.cos());
        let mut lens =
            arc_by_chords((x, 49.7 * scale + up), radius, [-FRAC_PI_2 - half, -FRAC_PI_2 + half], off);
        lens.extend(arc_by_chords((x, 49.7 * scale - up), radius, [FRAC_PI_2 - half, FRAC_PI_2 + half], off));
        let drawing = traced(side, side, &draw_by_samples(side, &|x, y| inside(&lens, x, y)));
        let curve = &drawing.contours[0].curve;
        assert_eq!(kinds(curve), [0, 2, 0], "a lens at {side} pixels");
        for k in 0..=200 {
            let place = curve.evaluate(0.01 * f64::from(k), 0).expect("a place");
            let down = (place.y - 49.7 * scale).abs();
            let far = (place.x - x).hypot(down + up) - radius;
            assert!(far.abs() < off + 0.05, "{far} at {side} pixels");
        }
    }
}

#[test]
fn half_a_disc_is_an_arc_and_a_line() {
    for (side, off) in [(100, 0.0), (100, 0.1), (256, 0.25), (400, 0.25)] {
        let scale = side as f64 / 100.0;
        // Chords as short as can be are as good as the arc itself.
        let (off, fine) = if off == 0.0 { (1e-4, 16) } else { (off, 4) };
        let disc = arc_by_chords((50.2 * scale, 60.3 * scale), 41.0 * scale, [PI, 2.0 * PI], off);
        let drawing = traced(side, side, &draw_finely(side, side, fine, &|x, y| inside(&disc, x, y)));
        assert_eq!(kinds(&drawing.contours[0].curve), [1, 1, 0], "at {side} pixels");
    }
}
