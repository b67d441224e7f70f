//! Drawings come back as the shapes that they were drawn from, and hostile pictures do no harm.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

mod support;

use expline::curve::Curve;
use expline::numerics::Point;
use expline::trace::{Gray, Progress, Source, Stage, Trace, TraceOptions, Tracer, trace};
use expline::{Error, HermiteCurve};
use support::pictures::{draw, draw_finely, inside, traced};

/// The largest and the mean value of a distance along a curve.
fn along(curve: &HermiteCurve, distance: &dyn Fn(Point) -> f64) -> (f64, f64) {
    let (mut most, mut sum) = (0.0_f64, 0.0);
    for i in 0..2000 {
        let t = curve.domain().1 * f64::from(i) / 2000.0;
        let off = distance(curve.evaluate(t, 0).expect("inside the domain"));
        most = most.max(off);
        sum += off / 2000.0;
    }
    (most, sum)
}

/// A small generator of noise: the same numbers everywhere.
struct Noise(u64);

impl Noise {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as f64 / (1_u64 << 31) as f64
    }

    /// About normal, of deviation 1.
    fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.unit()).sum::<f64>() - 6.0
    }
}

const STAR: [(f64, f64); 10] = [
    (32.3, 4.2),
    (38.1, 24.4),
    (59.2, 25.1),
    (42.6, 37.8),
    (48.7, 58.3),
    (31.9, 46.4),
    (14.2, 58.9),
    (21.3, 38.2),
    (4.6, 24.8),
    (25.4, 24.1),
];

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
    // In the pixels that the circle crosses, sixteen places per axis are off by about a sixteenth of a sixteenth of a pixel's diagonal each.
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
fn a_diagonal_of_single_pixels_stays_in_the_picture() {
    let bytes: Vec<u8> = (0..100 * 100).map(|i| if i % 101 == 0 { 0 } else { 255 }).collect();
    let gray = Gray::from_bytes(100, 100, &bytes).expect("a valid picture");
    let found = trace(gray, &TraceOptions { blur: Some(0.0), ..TraceOptions::default() }).expect("a drawing");
    let bounds = found.contours[0].curve.bounds();
    assert!(bounds.min_x > -1.0 && bounds.max_y < 101.0, "{bounds:?}");
    assert!(bounds.max_x > 99.0 && bounds.min_y < 1.0, "{bounds:?}");
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
    assert!(
        found.contours.iter().any(|contour| !contour.hole && contour.cusps.len() == 10),
        "the star is ink"
    );
}

#[test]
fn the_same_picture_gives_the_same_bits() {
    let bytes = draw(64, 64, &|x, y| inside(&STAR, x, y) || (x - 50.0).hypot(y - 50.0) < 9.0);
    let (first, second) = (traced(64, 64, &bytes), traced(64, 64, &bytes));
    let points = |drawing: &Trace| -> Vec<Point> {
        drawing.contours.iter().flat_map(|c| c.curve.points().to_vec()).collect()
    };
    assert_eq!(points(&first), points(&second));
}

#[test]
fn pictures_of_any_size_and_nothing_in_them_do_no_harm() {
    let finite = |drawing: &Trace| {
        drawing.contours.iter().all(|c| c.curve.points().iter().all(|p| p.x.is_finite() && p.y.is_finite()))
    };
    for (width, height) in [(1, 1), (1, 2), (2, 1), (2, 2), (3, 3), (1, 10_000), (10_000, 2), (7, 5)] {
        for shade in [0, 100, 255] {
            let drawing = traced(width, height, &vec![shade; width * height]);
            let most = usize::from(shade < 128);
            assert!(drawing.contours.len() <= most && finite(&drawing), "{width}×{height} {shade}");
        }
        let stripes: Vec<u8> = (0..width * height).map(|i| if i / 10 % 2 == 0 { 0 } else { 255 }).collect();
        assert!(finite(&traced(width, height, &stripes)), "{width}×{height}");
    }
    let black = traced(64, 64, &[0; 64 * 64]);
    let bounds = black.contours[0].curve.bounds();
    assert!(bounds.min_x > -0.1 && bounds.max_y < 64.1, "the border is the outline");
    let diagonal: Vec<u8> = (0..10_000).map(|i| if i % 100 == i / 100 { 0 } else { 255 }).collect();
    assert!(finite(&traced(100, 100, &diagonal)), "a line of one pixel");
}

#[test]
fn rings_in_rings_need_no_stack() {
    let size = 801;
    let bytes: Vec<u8> = (0..size * size)
        .map(|i| {
            let (column, row) = (i % size, i / size);
            let depth = column.min(row).min(size - 1 - column).min(size - 1 - row);
            if depth % 4 < 2 { 0 } else { 255 }
        })
        .collect();
    let gray = Gray::from_bytes(size, size, &bytes).expect("valid");
    let options = TraceOptions { refined: false, ..TraceOptions::default() };
    let drawing = trace(gray.clone(), &options).expect("a drawing");
    assert_eq!(drawing.contours.len(), 200, "the pixel in the middle is a speckle");
    assert_eq!(drawing.contours.iter().filter(|c| c.hole).count(), 100);
}

#[test]
fn what_is_not_a_drawing_is_refused_by_name() {
    let error = |result: expline::Result<()>| *result.expect_err("refused");
    let limit = |error: Error| match error {
        Error::LimitExceeded { limit, .. } => limit,
        _ => "another error",
    };
    let checker: Vec<u8> =
        (0..400 * 400).map(|i| if (i % 400 + i / 400) % 2 == 0 { 0 } else { 255 }).collect();
    let gray = Gray::from_bytes(400, 400, &checker).expect("valid");
    let options = TraceOptions { speckle: 0.0, ..TraceOptions::default() };
    let refused = error(trace(gray.clone(), &options).map(drop));
    assert!(["maxContours", "maxContourPoints"].contains(&limit(refused)), "a checkerboard");
    let mut noise = Noise(4);
    let salt: Vec<u8> = (0..300 * 300).map(|_| if noise.unit() < 0.5 { 0 } else { 255 }).collect();
    let gray = Gray::from_bytes(300, 300, &salt).expect("valid");
    let refused = error(trace(gray.clone(), &options).map(drop));
    assert!(["maxContours", "maxContourPoints"].contains(&limit(refused)), "salt");

    assert_eq!(error(Gray::from_bytes(0, 5, &[]).map(drop)).argument(), Some("width"));
    assert_eq!(error(Gray::from_bytes(5, 0, &[]).map(drop)).argument(), Some("height"));
    assert_eq!(error(Gray::from_bytes(65_536, 65_536, &[]).map(drop)).argument(), Some("width"));
    assert_eq!(limit(error(Gray::from_bytes(16_384, 16_384, &[]).map(drop))), "maxPixels");
    assert_eq!(error(Gray::from_rgba(10, 10, &[0; 404]).map(drop)).argument(), Some("data"));
    let gray = Gray::from_bytes(2, 2, &[0; 4]).expect("valid");
    for options in [
        TraceOptions { threshold: Some(f64::NAN), ..TraceOptions::default() },
        TraceOptions { threshold: Some(256.5), ..TraceOptions::default() },
        TraceOptions { tolerance: -1.0, ..TraceOptions::default() },
        TraceOptions { corner: 0.0, ..TraceOptions::default() },
        TraceOptions { speckle: f64::INFINITY, ..TraceOptions::default() },
    ] {
        assert!(error(trace(gray.clone(), &options).map(drop)).argument().is_some(), "{options:?}");
    }
    let speckle = TraceOptions { speckle: 1000.0, ..TraceOptions::default() };
    assert!(
        trace(gray.clone(), &speckle).expect("a drawing").contours.is_empty(),
        "smaller than the speckle"
    );
}

#[test]
fn a_picture_in_steps_is_the_picture_at_once_and_progress_never_goes_back() {
    let bytes = draw(64, 64, &|x, y| inside(&STAR, x, y));
    let at_once = traced(64, 64, &bytes);
    let gray = Gray::from_bytes(64, 64, &bytes).expect("valid");
    let mut tracer = Tracer::new(gray, &TraceOptions::default()).expect("options in range");
    assert!(tracer.result().is_err(), "nothing is done yet");
    let mut last: Option<Progress> = None;
    let mut steps = 0;
    loop {
        let progress = tracer.step(100.0).expect("a drawing");
        assert!(progress.completed <= progress.total, "{progress:?}");
        if let Some(last) = last {
            let rises = (last.stage, last.completed) <= (progress.stage, progress.completed);
            assert!(rises, "{last:?}, then {progress:?}");
        }
        steps += 1;
        last = Some(progress);
        if progress.done {
            break;
        }
    }
    assert!(steps > 5, "{steps} steps");
    let in_steps = tracer.result().expect("done");
    let points = |trace: &Trace| -> Vec<Point> { trace.contours[0].curve.points().to_vec() };
    assert_eq!(points(&in_steps), points(&at_once));
}

#[test]
fn a_picture_given_in_rows_is_the_picture_given_whole() {
    let mut noise = Noise(11);
    for paper in [0, 255] {
        let ink = 255 - paper;
        let mut rgba: Vec<u8> =
            (0..40 * 30).flat_map(|_| [ink, ink, ink, (noise.unit() * 256.0) as u8]).collect();
        rgba[3] = 255;
        let whole = Gray::from_rgba(40, 30, &rgba).expect("valid");
        let mut rows = Gray::begin(40, 30).expect("a size in range");
        for block in rgba.chunks(4 * 40 * 7) {
            rows.push_rgba_rows(block).expect("whole rows");
        }
        assert!(rows.push_rgba_rows(&rgba[..160]).is_err(), "a row too many");
        assert_eq!(rows.finish().expect("all rows"), whole);
    }
    let mut rows = Gray::begin(4, 2).expect("a size in range");
    assert!(rows.push_gray_rows(&[0; 5]).is_err(), "not a whole row");
    rows.push_gray_rows(&[9; 4]).expect("a row");
    assert!(rows.finish().is_err(), "a row is missing");
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
    // A tip of 17 degrees is half a pixel wide 1.7 pixels before its end: no pixel there is more ink than paper. The contour ends
    // between sides that are nearer to each other than a pixel.
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

/// Four disks in a row, with these radii.
fn disks(radii: [f64; 4]) -> Gray {
    let inside = |x: f64, y: f64| {
        radii.iter().enumerate().any(|(i, r)| (x - 12.0 - 24.0 * i as f64).hypot(y - 16.0) < *r)
    };
    Gray::from_bytes(96, 32, &draw(96, 32, &inside)).expect("valid")
}

/// What is offered as the least size of a contour to a trace that is refused because it has too many.
fn offered(gray: Gray, options: &TraceOptions) -> f64 {
    let mut tracer = Tracer::new(gray, options).expect("options in range");
    assert_eq!(tracer.offer(), None, "nothing was refused yet");
    let refused = loop {
        match tracer.step(1000.0) {
            Ok(progress) => assert!(!progress.done, "there are too many"),
            Err(error) => break error,
        }
    };
    assert_eq!(refused.argument(), Some("data"), "the picture has too many");
    tracer.offer().expect("an offer")
}

#[test]
fn who_sees_too_many_contours_is_told_what_to_leave_out() {
    let gray = disks([2.0, 3.0, 5.0, 7.0]);
    let options = |speckle| TraceOptions { speckle, most_contours: 2, ..TraceOptions::default() };
    let speckle = offered(gray.clone(), &options(0.0));
    assert_eq!(trace(gray, &options(speckle)).expect("a drawing").contours.len(), 2);
}

#[test]
fn who_sees_too_many_edges_is_told_what_to_leave_out() {
    let gray = disks([4.0, 6.0, 8.0, 11.0]);
    let options = |speckle| TraceOptions {
        source: Source::Edges,
        speckle,
        most_contours: 2,
        ..TraceOptions::default()
    };
    let speckle = offered(gray.clone(), &options(0.0));
    // The square that the third ring goes round: (2π·6/4)², edges are within a pixel of it.
    assert!((60.0..120.0).contains(&speckle), "{speckle}");
    assert_eq!(trace(gray, &options(speckle)).expect("edges").contours.len(), 2);
}

/// 32,000 corners: comparing each with all others took thirty times as long as all the rest.
#[test]
fn one_outline_may_have_any_number_of_corners() {
    let side = 1024;
    let ink = |x: usize, y: usize| y % 16 < 8 || (y % 16 < 12 && x % 8 < 4) || x < 12;
    let inner = |k: usize| (4..side - 4).contains(&k);
    let shade = |i: usize| {
        let (x, y) = (i % side, i / side);
        if inner(x) && inner(y) && ink(x, y) { 0 } else { 255 }
    };
    let bytes: Vec<u8> = (0..side * side).map(shade).collect();
    let gray = Gray::from_bytes(side, side, &bytes).expect("a valid picture");
    let options = TraceOptions { refined: false, ..TraceOptions::default() };
    let found = trace(gray, &options).expect("a drawing");
    assert_eq!(found.contours.len(), 1);
    let points = found.contours[0].curve.points().len();
    assert!(points > 32_000, "{points} points");
}

/// Dividing one contour was one step, however many corners it has.
#[test]
fn a_contour_of_thousands_of_corners_is_divided_step_by_step() {
    let comb = |x: f64, y: f64| {
        let inside = x > 12.0 && y > 12.0 && x < 396.0 && y < 396.0;
        let (along, across) = (x % 12.0, y % 24.0);
        inside && (x < 24.0 || across < 12.0 || across < 18.0 && along < 6.0)
    };
    let gray = Gray::from_bytes(408, 408, &draw_finely(408, 408, 1, &comb)).expect("a valid picture");
    let mut tracer = Tracer::new(gray, &TraceOptions::default()).expect("options in range");
    let mut steps = 0;
    loop {
        let progress = tracer.step(0.0).expect("a drawing");
        steps += usize::from(progress.stage == Stage::Splines);
        if progress.stage > Stage::Splines {
            break;
        }
    }
    assert!(steps >= 4, "{steps} steps");
}

/// A round of taking joints away was one step, which took seconds where an outline has tens of thousands of them.
#[test]
fn joints_are_tried_step_by_step() {
    let waves = |x: f64, y: f64| {
        let (right, down) = (x - 210.0, y - 210.0);
        right.hypot(down) < 200.0 + 3.0 * (40.0 * down.atan2(right)).sin()
    };
    let gray = Gray::from_bytes(420, 420, &draw_finely(420, 420, 4, &waves)).expect("a valid picture");
    // So much may be off that every joint may go.
    let options = TraceOptions { tolerance: 2.0, ..TraceOptions::default() };
    let mut tracer = Tracer::new(gray, &options).expect("options in range");
    let mut steps = 0;
    loop {
        let progress = tracer.step(0.0).expect("a drawing");
        steps += usize::from(progress.stage == Stage::Refinement);
        if progress.done {
            break;
        }
    }
    assert!(steps > 60, "{steps} steps");
}

/// A way without corners was followed in one step, and an outline was shown and compared in one, however long it is.
#[test]
fn a_long_way_without_corners_is_followed_step_by_step() {
    let spiral = |x: f64, y: f64| {
        let (right, down) = (x - 300.0, y - 300.0);
        let way = right.hypot(down) - 10.0 * down.atan2(right) / core::f64::consts::TAU;
        right.hypot(down) < 292.0 && way.rem_euclid(10.0) < 5.0
    };
    let gray = Gray::from_bytes(600, 600, &draw_finely(600, 600, 4, &spiral)).expect("a valid picture");
    let mut tracer = Tracer::new(gray, &TraceOptions::default()).expect("options in range");
    let (mut splines, mut last) = (0, 0);
    loop {
        let progress = tracer.step(0.0).expect("a drawing");
        splines += usize::from(progress.stage == Stage::Splines);
        last += usize::from(progress.stage == Stage::Refinement && progress.total - progress.completed <= 1);
        if progress.done {
            break;
        }
    }
    let contours = tracer.result().expect("a drawing").contours.len();
    assert!(splines >= 3 * contours, "{splines} steps to the first outlines of {contours} contours");
    assert!(last >= 4, "{last} steps for the last curve");
}
