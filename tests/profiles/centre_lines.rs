//! Strokes come back as their centre lines, edges as curves, all through one door.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use expline::curve::Curve;
use expline::numerics::Point;
use expline::trace::{Gray, Model, Source, Trace, TraceOptions, TracedContour, trace};

/// Places per pixel and axis at which a test picture asks whether there is ink.
const FINE: usize = 8;

/// Draws strokes of half width `half` around polylines, with round ends and joins.
fn strokes(width: usize, height: usize, half: f64, lines: &[&[(f64, f64)]]) -> Vec<u8> {
    let off = |x: f64, y: f64| {
        let pairs = lines.iter().flat_map(|line| line.windows(2));
        pairs
            .map(|pair| {
                let ((ax, ay), (bx, by)) = (pair[0], pair[1]);
                let (dx, dy) = (bx - ax, by - ay);
                let length = (dx * dx + dy * dy).max(1e-12);
                let t = (((x - ax) * dx + (y - ay) * dy) / length).clamp(0.0, 1.0);
                (x - ax - t * dx).hypot(y - ay - t * dy)
            })
            .fold(f64::MAX, f64::min)
    };
    let mut bytes = Vec::with_capacity(width * height);
    for row in 0..height {
        for column in 0..width {
            let place = |start: usize, k: usize| start as f64 + (k as f64 + 0.5) / FINE as f64;
            let hits = (0..FINE * FINE)
                .filter(|k| off(place(column, k % FINE), place(row, k / FINE)) <= half)
                .count();
            bytes.push((255.0 * (1.0 - hits as f64 / (FINE * FINE) as f64)).round() as u8);
        }
    }
    bytes
}

fn traced(width: usize, height: usize, bytes: &[u8], source: Source, model: Model) -> Trace {
    let gray = Gray::from_bytes(width, height, bytes).expect("a valid picture");
    trace(gray, &TraceOptions { source, model, ..TraceOptions::default() }).expect("a trace")
}

fn lines(width: usize, height: usize, bytes: &[u8]) -> Trace {
    traced(width, height, bytes, Source::Lines, Model::Sparse)
}

fn ends(contour: &TracedContour) -> [Point; 2] {
    let points = contour.curve.points();
    [points[0], points[points.len() - 1]]
}

fn has_end(contour: &TracedContour, x: f64, y: f64, within: f64) -> bool {
    ends(contour).iter().any(|p| (p - Point::new(x, y)).norm() < within)
}

/// Within what rounding leaves.
fn is_on_border(p: Point, width: f64, height: f64) -> bool {
    p.x.min(p.y).min(width - p.x).min(height - p.y).abs() < 1e-9
}

#[test]
fn a_stroke_is_its_centre_line_from_middle_to_middle_of_its_round_ends() {
    for half in [1.5, 3.0, 7.0] {
        let picture = strokes(72, 40, half, &[&[(12.3, 11.8), (58.9, 27.2)]]);
        let found = lines(72, 40, &picture);
        assert_eq!(found.contours.len(), 1, "half width {half}");
        let line = &found.contours[0];
        assert!(!line.closed && line.cusps.is_empty(), "open and straight");
        // Two outlines of 0.04 each, their normals good to a degree; pixels round the ends of thin strokes.
        let within = if half < 4.0 { 0.8 } else { 0.3 };
        let both = has_end(line, 12.3, 11.8, within) && has_end(line, 58.9, 27.2, within);
        assert!(both, "{half}: {:?}", ends(line));
        let (sin, cos) = ((27.2 - 11.8) / 49.077, (58.9 - 12.3) / 49.077);
        let off = |p: Point| ((p.x - 12.3) * sin - (p.y - 11.8) * cos).abs();
        let middle = line.curve.evaluate(0.5 * line.curve.domain().1, 0).expect("inside");
        assert!(off(middle) < 0.1, "half width {half}: {}", off(middle));
    }
}

#[test]
fn a_ring_is_one_closed_line_and_a_dot_is_a_short_one() {
    let circle: Vec<(f64, f64)> = (0..=90)
        .map(|i| f64::from(i) * 4.0_f64.to_radians())
        .map(|a| (32.0 + 20.0 * a.cos(), 31.0 + 20.0 * a.sin()))
        .collect();
    let picture = strokes(64, 64, 3.5, &[&circle, &[(32.4, 31.2), (32.4, 31.2)]]);
    let found = lines(64, 64, &picture);
    assert_eq!(found.contours.len(), 2);
    let ring = found.contours.iter().find(|c| c.closed).expect("a ring");
    let (from, to) = ring.curve.domain();
    for i in 0..60 {
        let p = ring.curve.evaluate(from + (to - from) * f64::from(i) / 60.0, 0).expect("inside");
        assert!(((p - Point::new(32.0, 31.0)).norm() - 20.0).abs() < 0.25, "{p:?}");
    }
    let dot = found.contours.iter().find(|c| !c.closed).expect("a dot");
    assert!(has_end(dot, 32.4, 31.2, 0.3), "{:?}", ends(dot));
}

#[test]
fn through_lines_go_on_where_lines_meet_and_the_others_end_on_them() {
    // A T: the stem ends on the bar.
    let stem = strokes(72, 64, 4.0, &[&[(10.0, 14.0), (62.0, 14.0)], &[(36.0, 14.0), (36.0, 54.0)]]);
    let found = lines(72, 64, &stem);
    assert_eq!(found.contours.len(), 2);
    assert!(found.contours.iter().any(|c| has_end(c, 10.0, 14.0, 0.3) && has_end(c, 62.0, 14.0, 0.3)), "bar");
    assert!(
        found.contours.iter().any(|c| has_end(c, 36.0, 14.0, 0.4) && has_end(c, 36.0, 54.0, 0.3)),
        "stem"
    );
    // An X: both go through.
    let cross = strokes(72, 64, 4.0, &[&[(12.0, 10.0), (60.0, 54.0)], &[(60.0, 12.0), (12.0, 52.0)]]);
    let found = lines(72, 64, &cross);
    assert_eq!(found.contours.len(), 2);
    assert!(found.contours.iter().any(|c| has_end(c, 12.0, 10.0, 0.3) && has_end(c, 60.0, 54.0, 0.3)), "one");
    assert!(found.contours.iter().any(|c| has_end(c, 60.0, 12.0, 0.3) && has_end(c, 12.0, 52.0, 0.3)), "two");
}

/// A frame of 68 × 60 with round corners.
fn frame() -> Vec<(f64, f64)> {
    let (radius, right, below) = (8.0, 78.0, 70.0);
    let corner = |x: f64, y: f64, from: usize| {
        (0..=16).map(move |k| {
            let (sin, cos) = (std::f64::consts::FRAC_PI_2 * (from as f64 + k as f64 / 16.0)).sin_cos();
            (x + radius * cos, y + radius * sin)
        })
    };
    let (left, above) = (10.0 + radius, 10.0 + radius);
    let mut places: Vec<_> = corner(right - radius, below - radius, 0)
        .chain(corner(left, below - radius, 1))
        .chain(corner(left, above, 2))
        .chain(corner(right - radius, above, 3))
        .collect();
    places.push(places[0]);
    places
}

#[test]
fn a_line_that_meets_a_closed_one_ends_on_it_wherever_that_begins() {
    let frame = frame();
    for half in [2.0, 4.0] {
        for place in [24.0, 31.0, 37.5, 42.0, 53.0] {
            let level = strokes(88, 80, half, &[&frame, &[(10.0, place), (78.0, place)]]);
            let upright = strokes(88, 80, half, &[&frame, &[(place, 10.0), (place, 70.0)]]);
            for (bytes, one, other) in
                [(level, (10.0, place), (78.0, place)), (upright, (place, 10.0), (place, 70.0))]
            {
                let found = lines(88, 80, &bytes);
                let is_bar = |c: &&TracedContour| (ends(c)[0] - ends(c)[1]).norm() > 45.0;
                let bar = found.contours.iter().find(is_bar);
                let bar = bar.expect("a line from side to side");
                for (x, y) in [one, other] {
                    assert!(has_end(bar, x, y, 0.3), "half {half}: {:?} for ({x}, {y})", ends(bar));
                }
            }
        }
    }
}

#[test]
fn thin_strokes_end_in_the_middles_of_their_round_ends_whichever_way_they_go() {
    for half in [1.5, 3.0] {
        for i in 0..60 {
            // Every six degrees, and on other parts of pixels.
            let angle = f64::from(i) * 6.0_f64.to_radians();
            let (x, y) = (40.0 + 0.37 * f64::from(i % 5), 40.0 + 0.23 * f64::from(i % 3));
            let (to_x, to_y) = (x + 30.0 * angle.cos(), y + 30.0 * angle.sin());
            let found = lines(80, 80, &strokes(80, 80, half, &[&[(x, y), (to_x, to_y)]]));
            assert_eq!(found.contours.len(), 1, "half width {half}, {i}");
            let line = &found.contours[0];
            // A few places of a cap say where its middle is: 0.25 of them, were each off by half a pixel.
            let both = has_end(line, x, y, 0.25) && has_end(line, to_x, to_y, 0.25);
            assert!(both, "half width {half}, {i}: {:?}", ends(line));
        }
    }
}

/// The only place or two of an outline that are about such an end were taken for none: lines ended in the skeleton's
/// last pixel, up to .7 beside.
#[test]
fn strokes_hardly_wider_than_a_pixel_run_straight_to_their_ends() {
    for (half, slope) in
        [0.625, 0.75, 1.0].into_iter().flat_map(|half| [5.0, 10.0, 20.0, 40.0].map(|s| (half, s)))
    {
        for i in 0..8 {
            let (x, y) = (12.0 + 0.37 * f64::from(i % 5), 30.0 + 0.23 * f64::from(i % 3));
            let (to_x, to_y) = (x + 50.0, y + f64::from(1 - i % 2 * 2) * 50.0 / slope);
            let is_upright = i >= 4;
            let turned = |(x, y): (f64, f64)| if is_upright { (y, x) } else { (x, y) };
            let (from, to) = (turned((x, y)), turned((to_x, to_y)));
            let found = lines(80, 80, &strokes(80, 80, half, &[&[from, to]]));
            assert_eq!(found.contours.len(), 1, "half width {half}, 1:{slope}, {i}");
            let line = &found.contours[0];
            let (length, end) = ((to.0 - from.0).hypot(to.1 - from.1), line.curve.domain().1);
            for k in 0..=200 {
                let p = line.curve.evaluate(end * f64::from(k) / 200.0, 0).expect("inside the domain");
                let off = ((p.x - from.0) * (to.1 - from.1) - (p.y - from.1) * (to.0 - from.0)) / length;
                // Outlines of strokes that fill hardly a pixel waver by a fifth of it around where they were drawn.
                assert!(off.abs() < 0.2, "half width {half}, 1:{slope}, {i}: {off}");
            }
            // A place of an outline is half a pixel long.
            let both = has_end(line, from.0, from.1, 0.75) && has_end(line, to.0, to.1, 0.75);
            assert!(both, "half width {half}, 1:{slope}, {i}: {:?} for {from:?} {to:?}", ends(line));
        }
    }
}

#[test]
fn thin_strokes_still_meet_where_three_come_together() {
    for half in [0.75, 1.0, 1.5] {
        for i in 0..12 {
            let (x, y) = (32.0 + 0.37 * f64::from(i % 5), 32.0 + 0.23 * f64::from(i % 3));
            let arm = |k: i32| {
                let angle = (f64::from(i) * 7.0 + f64::from(k) * 120.0).to_radians();
                [(x, y), (x + 24.0 * angle.cos(), y + 24.0 * angle.sin())]
            };
            let arms = [arm(0), arm(1), arm(2)];
            let found = lines(64, 64, &strokes(64, 64, half, &[&arms[0], &arms[1], &arms[2]]));
            for contour in &found.contours {
                let end = contour.curve.domain().1;
                let off = (0..=200)
                    .map(|k| {
                        contour.curve.evaluate(end * f64::from(k) / 200.0, 0).expect("inside the domain")
                    })
                    .map(|p| (p.x - x).hypot(p.y - y))
                    .fold(f64::MAX, f64::min);
                assert!(off < 1.0, "half width {half}, {i}: {off} from where they meet");
            }
        }
    }
}

#[test]
fn strokes_that_the_border_cuts_off_are_followed_straight_to_it() {
    let (width, height) = (90.0, 70.0);
    for half in [1.0, 1.5, 3.0, 5.0] {
        for degrees in [90.0, 75.0, 60.0, 45.0, 30.0, 20.0_f64] {
            let (sin, cos) = degrees.to_radians().sin_cos();
            // It comes through the left border, so far below the corner that all of its width does.
            let (start, far) = (half / sin + 2.0, 20.0 / sin);
            let (outer, inner) = ((-40.0 * sin, start - 40.0 * cos), (far * sin, start + far * cos));
            for side in 0..4 {
                let turned = |(x, y): (f64, f64)| match side {
                    0 => (x, y),
                    1 => (width - x, y),
                    2 => (y, x),
                    _ => (y, height - x),
                };
                let (from, to) = (turned(outer), turned(inner));
                let found = lines(90, 70, &strokes(90, 70, half, &[&[from, to]]));
                let what = format!("half width {half}, {degrees}°, side {side}");
                assert_eq!(found.contours.len(), 1, "{what}");
                let line = &found.contours[0];
                let (x, y) = turned((0.0, start));
                let end = ends(line).into_iter().find(|&p| is_on_border(p, width, height));
                let end = end.expect("one end is on the border");
                // Two outlines of 0.04 each, seen along the border.
                let off = (end - Point::new(x, y)).norm() * sin;
                assert!(off < 0.15, "{what}: {off} beside where it goes");
                let (domain, length) = (line.curve.domain(), (to.0 - from.0).hypot(to.1 - from.1));
                for i in 0..40 {
                    let t = domain.0 + (domain.1 - domain.0) * f64::from(i) / 40.0;
                    let p = line.curve.evaluate(t, 0).expect("inside");
                    let off = ((p.x - from.0) * (to.1 - from.1) - (p.y - from.1) * (to.0 - from.0)) / length;
                    assert!(off.abs() < 0.25, "{what}: {off} beside the line at {p:?}");
                }
            }
        }
    }
}

#[test]
fn strokes_that_cross_the_picture_come_to_both_borders_and_a_circle_comes_in_parts() {
    let cross = strokes(90, 70, 3.0, &[&[(-20.0, 20.0), (120.0, 50.0)], &[(30.0, -30.0), (60.0, 120.0)]]);
    let found = lines(90, 70, &cross);
    assert_eq!(found.contours.len(), 2);
    let one = |(x, y), (u, v)| found.contours.iter().any(|c| has_end(c, x, y, 0.2) && has_end(c, u, v, 0.2));
    assert!(one((0.0, 20.0 + 20.0 * 30.0 / 140.0), (90.0, 20.0 + 110.0 * 30.0 / 140.0)), "one");
    assert!(one((36.0, 0.0), (50.0, 70.0)), "two");
    // A circle that reaches two pixels beyond each side.
    let circle: Vec<(f64, f64)> = (0..=120)
        .map(|i| f64::from(i) * 3.0_f64.to_radians())
        .map(|a| (32.0 + 34.0 * a.cos(), 32.0 + 34.0 * a.sin()))
        .collect();
    let found = lines(64, 64, &strokes(64, 64, 1.5, &[&circle]));
    assert_eq!(found.contours.len(), 4);
    for contour in &found.contours {
        assert!(!contour.closed);
        for p in ends(contour) {
            assert!(is_on_border(p, 64.0, 64.0), "{p:?}");
            // It goes straight on where the circle does not: a pixel in ten is a degree of its turning.
            assert!(((p - Point::new(32.0, 32.0)).norm() - 34.0).abs() < 0.3, "{p:?} is on the circle");
        }
    }
}

#[test]
fn strokes_that_touch_the_border_are_as_they_are_elsewhere() {
    for half in [1.0, 2.0, 4.0, 6.0] {
        let (right, bottom) = (120.0 - half, 100.0 - half);
        let frame = [(half, half), (right, half), (right, bottom), (half, bottom), (half, half)];
        let found = lines(120, 100, &strokes(120, 100, half, &[&frame]));
        assert_eq!(found.contours.len(), 1);
        let line = &found.contours[0];
        assert!(line.closed && line.cusps.len() == 4, "half width {half}: {} corners", line.cusps.len());
        for p in line.curve.points() {
            // Outlines of 0.04, and pixels round the corners.
            let off =
                (p.x - half).abs().min((p.x - right).abs()).min((p.y - half).abs().min((p.y - bottom).abs()));
            assert!(off < 0.15, "half width {half}: {p:?}");
        }
        // Round ends on the border are ends, not strokes that go on.
        let end = strokes(120, 100, half, &[&[(half, 40.0), (60.0, 43.0)]]);
        let found = lines(120, 100, &end);
        assert!(
            has_end(&found.contours[0], half, 40.0, 0.25),
            "half width {half}: {:?}",
            ends(&found.contours[0])
        );
    }
}

#[test]
fn a_bend_keeps_its_corner() {
    let picture = strokes(72, 64, 3.0, &[&[(12.0, 52.0), (14.0, 12.0), (60.0, 14.0)]]);
    let found = lines(72, 64, &picture);
    assert_eq!(found.contours.len(), 1);
    let cusps = &found.contours[0].cusps;
    assert_eq!(cusps.len(), 1);
    assert!((cusps[0] - Point::new(14.0, 12.0)).norm() < 0.4, "{cusps:?}");
}

#[test]
fn edges_come_through_the_same_door_by_both_models() {
    let disk = strokes(64, 64, 20.0, &[&[(31.5, 32.2), (31.5, 32.2)]]);
    for model in [Model::Sparse, Model::QuasiInterpolant] {
        for source in [Source::Edges, Source::Brightness] {
            let found = traced(64, 64, &disk, source, model);
            assert_eq!(found.contours.len(), 1, "{source:?} {model:?}");
            let contour = &found.contours[0];
            assert!(contour.closed && !contour.hole, "{source:?} {model:?}");
            let (from, to) = contour.curve.domain();
            for i in 0..60 {
                let t = from + (to - from) * f64::from(i) / 60.0;
                let p = contour.curve.evaluate(t, 0).expect("inside");
                let off = ((p - Point::new(31.5, 32.2)).norm() - 20.0).abs();
                assert!(off < 0.25, "{source:?} {model:?}: {off}");
            }
            let metrics = contour.metrics;
            assert!(metrics.mae <= metrics.rmse && metrics.rmse <= metrics.hausdorff, "{metrics:?}");
            assert!(metrics.rmse < 0.15 && metrics.jaccard > 0.98, "{source:?} {model:?}: {metrics:?}");
        }
    }
}

#[test]
fn no_line_leaves_the_picture_where_its_ink_is_no_stroke() {
    // A dark sheet with a hole: what lies between hole and border is no stroke, and middles of its sides were 5 pixels
    // outside.
    for (width, height, radius) in [(100, 15, 5.0), (40, 15, 5.0), (30, 11, 4.0)] {
        let hole = |i: usize| {
            let (x, y) = ((i % width) as f64, (i / width) as f64);
            let beyond = (x - 0.5 * (width - 1) as f64).hypot(y - 0.5 * (height - 1) as f64) - radius;
            (255.0 * (0.5 - beyond).clamp(0.0, 1.0)) as u8
        };
        let bytes: Vec<u8> = (0..width * height).map(hole).collect();
        let drawing = lines(width, height, &bytes);
        assert!(!drawing.contours.is_empty(), "{width}: the dark is followed");
        for contour in drawing.contours {
            let b = contour.curve.bounds();
            // Curves may be as far from their lines as the tolerance of 0.22 allows.
            let beyond = (-b.min_x).max(-b.min_y).max(b.max_x - width as f64).max(b.max_y - height as f64);
            assert!(beyond <= 0.22, "{width}: {beyond} px outside");
        }
    }
}

#[test]
fn hostile_pictures_do_no_harm_whatever_is_followed() {
    for (width, height) in [(1, 1), (1, 40), (40, 1), (2, 2), (7, 5), (24, 24)] {
        for kind in 0..4 {
            let byte = |i: usize| match kind {
                0 => 0,
                1 => 255,
                2 => {
                    if (i % width + i / width).is_multiple_of(2) {
                        0
                    } else {
                        255
                    }
                }
                _ => (i * 7919 % 251) as u8,
            };
            let bytes: Vec<u8> = (0..width * height).map(byte).collect();
            for source in [Source::Edges, Source::Lines, Source::Brightness] {
                for model in [Model::Sparse, Model::QuasiInterpolant] {
                    for contour in traced(width, height, &bytes, source, model).contours {
                        let finite =
                            contour.curve.points().iter().all(|p| p.x.is_finite() && p.y.is_finite());
                        assert!(finite && contour.metrics.rmse.is_finite(), "{width} {height} {kind}");
                    }
                }
            }
        }
    }
}

#[test]
fn a_disc_wider_than_the_strokes_is_a_ring_with_its_hole_filled() {
    let circle: Vec<(f64, f64)> = (0..=36)
        .map(|i| f64::from(i) * 10.0_f64.to_radians())
        .map(|a| (20.2 + 3.0 * a.cos(), 31.4 + 3.0 * a.sin()))
        .collect();
    let bar = [(44.0, 8.0), (44.0, 56.0), (62.0, 56.0), (62.0, 8.0)];
    let found = lines(72, 64, &strokes(72, 64, 6.0, &[&circle, &bar]));
    let ring = found.contours.iter().find(|c| c.closed).expect("a ring");
    for p in ring.curve.points() {
        let off = (p - Point::new(20.2, 31.4)).norm() - 3.0;
        assert!(off.abs() < 0.4, "{off}");
    }
}
