//! Drawings come back as the shapes that they were drawn from.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::pictures::{Noise, STAR, along, draw, draw_finely, inside, traced};
use expline::curve::Curve;
use expline::numerics::Point;
use expline::trace::{Gray, TraceOptions, trace};

#[test]
fn a_disk_is_an_exact_circle_to_a_fiftieth_of_a_pixel() {
    let disk = |x: f64, y: f64| (x - 30.3).hypot(y - 32.6) <= 22.7;
    let drawing = traced(64, 64, &draw(64, 64, &disk));
    assert_eq!(drawing.contours.len(), 1);
    let contour = &drawing.contours[0];
    assert!(!contour.hole && contour.cusps.is_empty(), "a smooth outline of ink");
    let circle = contour.curve.as_ellipse(1e-9).expect("the circle is exact");
    let off = (circle.center - Point::new(30.3, 32.6)).norm();
    assert!(off < 0.02 && (circle.radii.x - 22.7).abs() < 0.02, "{circle:?}");
    assert!(circle.radii.x - circle.radii.y < 1e-12, "one radius");
    let (most, mean) = along(&contour.curve, &|p| ((p - Point::new(30.3, 32.6)).norm() - 22.7).abs());
    // Sixteen places per axis leave 0.004 of coverage, four cubics of a quarter turn 0.006 of a radius of 22.7.
    assert!(mean < 0.015 && most < 0.03, "mean {mean}, most {most}");
    // In the pixels that the circle crosses, sixteen places per axis are off by about a sixteenth of a sixteenth of a
    // pixel's diagonal each.
    assert!(drawing.residual < 0.015, "{}", drawing.residual);
}

/// A sine is no cubic: where pieces may leave .012 of coverage, however long they are, this one takes six.
#[test]
fn a_long_gentle_edge_takes_few_pieces_and_is_near_its_own() {
    let (width, height) = (480, 260);
    let phase = |x: f64| core::f64::consts::TAU * x / 440.0 + 0.3;
    let edge = |x: f64| 110.0 + 50.0 * phase(x).sin();
    let inside = |x: f64, y: f64| (20.0..460.0).contains(&x) && (edge(x)..240.0).contains(&y);
    let drawing = traced(width, height, &draw(width, height, &inside));
    let curve = &drawing.contours[0].curve;
    assert!(curve.segment_count() <= 5 + 3, "{} pieces and lines", curve.segment_count());
    let slope = |x: f64| 50.0 * core::f64::consts::TAU / 440.0 * phase(x).cos();
    let off = |p: Point| {
        let side = (p.x - 20.0).abs().min((p.x - 460.0).abs()).min((p.y - 240.0).abs());
        side.min((p.y - edge(p.x)).abs() / slope(p.x).hypot(1.0))
    };
    let (most, mean) = along(curve, &off);
    assert!(most < 0.1 && mean < 0.02, "mean {mean}, most {most}");
}

#[test]
fn a_turned_ellipse_is_an_exact_ellipse() {
    let (sin, cos) = (0.6, 0.8);
    let ellipse = |x: f64, y: f64| {
        let (dx, dy) = (x - 40.2, y - 36.7);
        ((dx * cos + dy * sin) / 30.0).powi(2) + ((dy * cos - dx * sin) / 17.0).powi(2) <= 1.0
    };
    let drawing = traced(80, 80, &draw(80, 80, &ellipse));
    let found = drawing.contours[0].curve.as_ellipse(1e-9).expect("an ellipse");
    assert!((found.center - Point::new(40.2, 36.7)).norm() < 0.02, "{found:?}");
    assert!((found.radii - Point::new(30.0, 17.0)).norm() < 0.03, "{found:?}");
    // atan2(0.6, 0.8)
    assert!((found.rotation - 0.643_501_108_793_284_4).abs() < 2e-3, "{found:?}");
}

#[test]
fn a_hole_turns_the_other_way() {
    let ring = |x: f64, y: f64| (8.0..=20.0).contains(&(x - 24.5).hypot(y - 23.5));
    let drawing = traced(48, 48, &draw(48, 48, &ring));
    let mut holes: Vec<(bool, f64)> =
        drawing.contours.iter().map(|c| (c.hole, c.curve.area().expect("closed"))).collect();
    holes.sort_by(|a, b| a.1.total_cmp(&b.1));
    assert_eq!(holes.len(), 2);
    assert!(holes[0].0 && !holes[1].0, "the smaller is the hole");
    let area = core::f64::consts::PI;
    // An outline that is off by 0.005 pixels over a length of 50 and 126.
    assert!((holes[0].1 + 64.0 * area).abs() < 0.3, "{}", holes[0].1);
    assert!((holes[1].1 - 400.0 * area).abs() < 0.7, "{}", holes[1].1);
}

#[test]
fn a_star_has_its_ten_corners_and_straight_sides_and_nothing_else() {
    let drawing = traced(64, 64, &draw(64, 64, &|x, y| inside(&STAR, x, y)));
    assert_eq!(drawing.contours.len(), 1);
    let contour = &drawing.contours[0];
    assert_eq!(contour.cusps.len(), 10);
    assert_eq!(contour.curve.segment_count(), 10);
    assert!(contour.curve.segments().all(|segment| segment.as_line(1e-9)), "sides are lines");
    for &(x, y) in &STAR {
        let nearest = contour.cusps.iter().map(|p| (p - Point::new(x, y)).norm()).fold(f64::MAX, f64::min);
        // The acute tips are known along the tip only as well as their area: 0.004 of coverage.
        assert!(nearest < 0.06, "corner {x}, {y} is off by {nearest}");
    }
}

/// A bolt whose two tips turn by 160 degrees: sixteen pixels from the tip it is six wide.
const BOLT: [(f64, f64); 6] =
    [(70.5, 14.5), (23.5, 93.5), (53.5, 93.5), (41.5, 152.5), (92.5, 68.5), (60.5, 68.5)];

#[test]
fn a_tip_of_twenty_degrees_is_one_corner() {
    let drawing = traced(116, 168, &draw(116, 168, &|x, y| inside(&BOLT, x, y)));
    let contour = &drawing.contours[0];
    assert_eq!(contour.cusps.len(), 6, "{:?}", contour.cusps);
    assert_eq!(contour.curve.segment_count(), 6);
    for &(x, y) in &BOLT {
        let nearest = contour.cusps.iter().map(|p| (p - Point::new(x, y)).norm()).fold(f64::MAX, f64::min);
        // Along a tip of 20 degrees an error of the sides counts six times.
        assert!(nearest < 0.2, "corner {x}, {y} is off by {nearest}");
    }
}

/// Coverage by the distance from a circle, as many programs draw it.
fn by_distance(x: f64, y: f64, radius: f64) -> f64 {
    (radius + 0.5 - (x + 0.5 - 48.0).hypot(y + 0.5 - 48.0)).clamp(0.0, 1.0)
}

#[test]
fn circles_that_were_not_drawn_by_exact_coverage_are_circles_too() {
    let mut bytes = Vec::new();
    for i in 0..96 * 96 {
        let (x, y) = (f64::from(i % 96), f64::from(i / 96));
        let ink = by_distance(x, y, 38.4) - by_distance(x, y, 19.2);
        bytes.push((255.0 * (1.0 - ink)).round() as u8);
    }
    for (contour, radius) in traced(96, 96, &bytes).contours.iter().zip([38.4, 19.2]) {
        let circle = contour.curve.as_ellipse(1e-6).expect("one circle");
        assert!((circle.radii.x - radius).abs() < 0.02, "{circle:?}");
    }
}

#[test]
fn noise_and_blur_leave_the_shape() {
    let mut noise = Noise(7);
    let ink =
        |x: f64, y: f64| (x - 32.0).hypot(y - 31.0) <= 21.0 && !inside(&STAR, x * 1.6 - 19.0, y * 1.6 - 18.0);
    let clean = draw(64, 64, &ink);
    let bytes: Vec<u8> = clean
        .iter()
        .map(|&v| (f64::from(v) + 16.0 * noise.normal()).round().clamp(0.0, 255.0) as u8)
        .collect();
    let drawing = traced(64, 64, &bytes);
    assert_eq!(drawing.contours.len(), 2);
    let outer = drawing.contours.iter().find(|c| !c.hole).expect("ink");
    let (most, mean) = along(&outer.curve, &|p| ((p - Point::new(32.0, 31.0)).norm() - 21.0).abs());
    // Noise of 1/16 of the contrast: each pixel says where the outline is to 0.06, a dozen of them per unknown.
    assert!(mean < 0.06 && most < 0.25, "mean {mean}, most {most}");
    assert!(drawing.tones.noise > 0.02, "the noise is seen: {}", drawing.tones.noise);
}

#[test]
fn metrics_are_distances_to_the_contour_in_pixels() {
    let drawing = traced(64, 64, &draw(64, 64, &|x, y| inside(&STAR, x, y)));
    let metrics = drawing.contours[0].metrics;
    // Contours between pixel centres cut tips by up to a pixel; along the sides they are off by some hundredths.
    assert!(metrics.mae < 0.1 && metrics.mae <= metrics.rmse && metrics.rmse <= metrics.max, "{metrics:?}");
    assert!(metrics.max <= metrics.hausdorff, "{metrics:?}");
    assert!(metrics.hausdorff > 0.3 && metrics.hausdorff < 2.0 && metrics.jaccard > 0.9, "{metrics:?}");
}

#[test]
fn a_rounded_rectangle_is_four_lines_and_four_arcs_of_circles() {
    let (left, top, right, bottom, radius) = (12.3, 15.6, 112.4, 83.2, 17.4);
    let ink = |x: f64, y: f64| {
        let dx = (left + radius - x).max(x - right + radius).max(0.0);
        let dy = (top + radius - y).max(y - bottom + radius).max(0.0);
        dx.hypot(dy) <= radius && x >= left && x <= right && y >= top && y <= bottom
    };
    let drawing = traced(128, 100, &draw_finely(128, 100, 48, &ink));
    let curve = &drawing.contours[0].curve;
    let lines = curve.segments().filter(|segment| segment.as_line(1e-9)).count();
    let arcs = curve.omega().iter().filter(|&&omega| omega != 0.0).count();
    assert_eq!((lines, arcs), (4, 4));
    let (most, _) = along(curve, &|p| {
        let dx = (left + radius - p.x).max(p.x - right + radius).max(0.0);
        let dy = (top + radius - p.y).max(p.y - bottom + radius).max(0.0);
        if dx > 0.0 && dy > 0.0 {
            (dx.hypot(dy) - radius).abs()
        } else {
            (p.x - left).abs().min((p.x - right).abs()).min((p.y - top).abs()).min((p.y - bottom).abs())
        }
    });
    // Forty-eight places per axis leave a thousandth of coverage, as much as shades of a byte.
    assert!(most < 0.03, "{most}");
}

#[test]
fn a_curve_is_compared_with_its_own_side_of_a_sharp_tip_and_no_corner_turns_by_half_a_turn() {
    let bolt = [(70.5, 10.2), (37.0, 69.0), (62.0, 69.0), (56.0, 118.5), (91.5, 56.5), (65.5, 56.5)];
    let bytes = draw(128, 128, &|x, y| inside(&bolt, x, y));
    let drawing = traced(128, 128, &bytes);
    let contour = &drawing.contours[0];
    assert!(contour.metrics.hausdorff < 4.0 && contour.metrics.rmse < 0.3, "{:?}", contour.metrics);
    // A tip of 17 degrees is half a pixel wide 1.7 pixels before its end: no pixel there is more ink than paper. The
    // contour ends between sides that are nearer to each other than a pixel.
    assert!(contour.metrics.hausdorff > 1.7 && contour.metrics.max < 0.5, "{:?}", contour.metrics);
    let gray = Gray::from_bytes(128, 128, &bytes).expect("valid");
    let options = TraceOptions { corner: core::f64::consts::PI, ..TraceOptions::default() };
    let smooth = trace(gray, &options).expect("a drawing");
    assert!(smooth.contours[0].cusps.is_empty(), "nothing turns by half a turn");
}

#[test]
fn more_tolerance_never_takes_more_pieces() {
    let bytes = draw(96, 96, &|x, y| (x - 47.3).hypot(y - 48.1) < 38.4);
    for tolerance in [0.22, 1.0, 2.05] {
        let gray = Gray::from_bytes(96, 96, &bytes).expect("valid");
        let options = TraceOptions { tolerance, ..TraceOptions::default() };
        let disk = trace(gray, &options).expect("a drawing");
        let contour = &disk.contours[0];
        assert_eq!((contour.curve.segment_count(), contour.cusps.len()), (2, 0), "{tolerance}");
    }
}
