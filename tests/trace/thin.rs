//! Strokes of which no pixel is all ink come back as thick as they are: what pixels are covered by, together, is their
//! area.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::support::pictures::traced;
use expline::curve::Curve;
use expline::trace::{Gray, Trace, TraceOptions, Tracer, trace};

const SIDE: usize = 48;

type Place = (f64, f64);

/// What of a polygon is on the positive side of a line.
fn cut(polygon: &[Place], side: &dyn Fn(Place) -> f64) -> Vec<Place> {
    let mut left = Vec::new();
    for (i, &a) in polygon.iter().enumerate() {
        let b = polygon[(i + 1) % polygon.len()];
        let (at_a, at_b) = (side(a), side(b));
        if at_a >= 0.0 {
            left.push(a);
        }
        if (at_a >= 0.0) != (at_b >= 0.0) {
            let t = at_a / (at_a - at_b);
            left.push((a.0 + t * (b.0 - a.0), a.1 + t * (b.1 - a.1)));
        }
    }
    left
}

fn area(polygon: &[Place]) -> f64 {
    let twice: f64 = (0..polygon.len())
        .map(|i| (polygon[i], polygon[(i + 1) % polygon.len()]))
        .map(|(a, b)| a.0 * b.1 - a.1 * b.0)
        .sum();
    0.5 * twice
}

/// The area of every pixel that polygons cover, exactly; clockwise ones are holes.
fn coverage(polygons: &[Vec<Place>]) -> Vec<f64> {
    let mut covered = vec![0.0; SIDE * SIDE];
    for polygon in polygons {
        for row in 0..SIDE {
            let top = row as f64;
            let band = cut(&cut(polygon, &|p| p.1 - top), &|p| top + 1.0 - p.1);
            for column in 0..if band.is_empty() { 0 } else { SIDE } {
                let left = column as f64;
                covered[row * SIDE + column] +=
                    area(&cut(&cut(&band, &|p| p.0 - left), &|p| left + 1.0 - p.0));
            }
        }
    }
    let truth: f64 = polygons.iter().map(|polygon| area(polygon)).sum();
    // Sums of some thousand areas of size 1.
    assert!((covered.iter().sum::<f64>() - truth).abs() < 1e-9, "the picture carries its area");
    covered
}

/// A bar of a length and a width around a place.
fn bar(middle: Place, length: f64, width: f64, angle: f64) -> Vec<Place> {
    let (sin, cos) = angle.sin_cos();
    let corners = [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)];
    corners
        .iter()
        .map(|&(u, v)| (u * length, v * width))
        .map(|(u, v)| (middle.0 + u * cos - v * sin, middle.1 + u * sin + v * cos))
        .collect()
}

/// A polygon of 400 sides that is a circle to a thousandth of a pixel; the other way round it is a hole.
fn circle(middle: Place, radius: f64, direction: f64) -> Vec<Place> {
    let angle = |k: i32| direction * f64::from(k) * TAU / 400.0;
    (0..400).map(|k| (middle.0 + radius * angle(k).cos(), middle.1 + radius * angle(k).sin())).collect()
}

fn shades(covered: &[f64], ink: f64, paper: f64) -> Vec<u8> {
    covered.iter().map(|c| (paper + (ink - paper) * c).round().clamp(0.0, 255.0) as u8).collect()
}

/// The area that all outlines enclose, holes taken off.
fn enclosed(found: &Trace) -> f64 {
    found.contours.iter().map(|contour| contour.curve.area().expect("closed")).sum()
}

/// Places that fall evenly into all parts of a pixel.
fn spread(k: usize) -> Place {
    ((k as f64 * 0.754_878 + 0.41) % 1.0, (k as f64 * 0.381_966 + 0.03) % 1.0)
}

/// How many times too large what is traced of polygons is, drawn in black on white.
fn excess(polygons: &[Vec<Place>]) -> f64 {
    let truth: f64 = polygons.iter().map(|polygon| area(polygon)).sum();
    enclosed(&traced(SIDE, SIDE, &shades(&coverage(polygons), 0.0, 255.0))) / truth
}

/// The darkest pixel was taken for ink: bars came out as much too thick as it lacked of being covered.
#[test]
fn slanted_bars_thinner_than_pixels_keep_their_area() {
    for width in [0.85, 1.0, 1.2, 1.5, 1.9] {
        for k in 0..8 {
            let (x, y) = spread(k);
            let angle = 0.15 + 0.18 * k as f64;
            let excess = excess(&[bar((24.0 + x, 24.0 + y), 36.0, width, angle)]);
            // The ends of a bar of 36 pixels may be half a pixel off each.
            assert!((excess - 1.0).abs() < 0.03, "{width} wide at {angle}: {excess} times its area");
        }
    }
}

#[test]
fn thin_rings_keep_their_area_and_their_radii() {
    for width in [0.85, 1.0, 1.2, 1.9] {
        for k in 0..4 {
            let (x, y) = spread(k);
            let (middle, radius) = ((24.0 + x, 24.0 + y), 14.0);
            let ring =
                [circle(middle, radius + 0.5 * width, 1.0), circle(middle, radius - 0.5 * width, -1.0)];
            let found = traced(SIDE, SIDE, &shades(&coverage(&ring), 0.0, 255.0));
            assert_eq!(found.contours.len(), 2, "an outline and a hole");
            let truth = TAU * radius * width;
            let excess = enclosed(&found) / truth;
            assert!((excess - 1.0).abs() < 0.02, "{width} wide: {excess} times its area");
            let mut radii: Vec<f64> =
                found.contours.iter().map(|c| (c.curve.area().expect("closed").abs() / PI).sqrt()).collect();
            radii.sort_by(f64::total_cmp);
            // Pixels say what lies between the two circles, to a fiftieth; where it lies they say less well.
            let [inner, outer] = [radii[0], radii[1]];
            let off = (inner - radius + 0.5 * width).abs().max((outer - radius - 0.5 * width).abs());
            assert!(off < 0.05, "{width} wide: {off} off, {radii:?}");
        }
    }
}

/// Whether ink is gray or strokes are thin, pixels in rows do not tell: black ink explains them.
#[test]
fn bars_along_rows_and_columns_are_black_and_keep_their_area() {
    for width in [1.0, 1.2, 1.5] {
        for k in 0..6 {
            let (x, y) = spread(k);
            let angle = if k % 2 == 0 { 0.0 } else { FRAC_PI_2 };
            let excess = excess(&[bar((24.0 + x, 24.0 + y), 36.0, width, angle)]);
            // The ends of a bar of 36 pixels may be a pixel off.
            assert!((excess - 1.0).abs() < 0.03, "{width} wide: {excess} times its area");
        }
    }
}

/// Gray strokes of two pixels show their ink, and slanted ones of one and a half.
#[test]
fn gray_strokes_that_show_their_ink_are_as_thick_as_they_are() {
    let (ink, paper) = (90.0, 230.0);
    for (width, k) in [(1.6, 1), (1.6, 3), (1.9, 2), (2.5, 4), (2.5, 5)] {
        let (x, y) = spread(k);
        let bar = [bar((24.0 + x, 24.0 + y), 36.0, width, 0.2 + 0.21 * k as f64)];
        let found = traced(SIDE, SIDE, &shades(&coverage(&bar), ink, paper));
        let excess = enclosed(&found) / area(&bar[0]);
        assert!((excess - 1.0).abs() < 0.01, "{width} wide: {excess} times its area");
        // Half a step of a byte, and what a pixel of 98 per cent lacks.
        assert!((found.tones.ink / 256.0 - ink).abs() < 3.0, "{:?}", found.tones);
    }
}

/// Black was taken for the ink of gray strokes that are nearly level, of every second one or third: they came out half
/// as thick.
#[test]
fn gray_strokes_that_are_nearly_level_are_as_thick_as_they_are() {
    let mut off = Vec::new();
    for (ink, width) in [(90.0, 1.2), (90.0, 1.5), (128.0, 1.2), (128.0, 1.5)] {
        for angle in [0.0175, 0.03, 0.052, 0.08, 0.12] {
            for offset in [0.0, 0.13, 0.31, 0.5, 0.77] {
                let bar = [bar((24.0, 24.0 + offset), 36.0, width, angle)];
                let excess =
                    enclosed(&traced(SIDE, SIDE, &shades(&coverage(&bar), ink, 255.0))) / area(&bar[0]);
                if (excess - 1.0).abs() > 0.03 {
                    off.push((ink, width, angle, offset, excess));
                }
            }
        }
    }
    // Of some that rise by less than a pixel black explains all as well.
    assert!(off.len() <= 6, "of 100 bars these are not: {off:?}");
}

/// Where each pixel is all ink or none, nothing says that gray is not the ink.
#[test]
fn crisp_lines_are_as_thick_as_they_are_whatever_their_shade() {
    for (ink, width) in [(0.0, 1), (90.0, 1), (128.0, 2), (204.0, 1)] {
        let frame = |i: usize| {
            let within =
                |margin: usize| [i % SIDE, i / SIDE].iter().all(|k| (margin..SIDE - margin).contains(k));
            f64::from(u8::from(within(8) && !within(8 + width)))
        };
        let covered: Vec<f64> = (0..SIDE * SIDE).map(frame).collect();
        let excess =
            enclosed(&traced(SIDE, SIDE, &shades(&covered, ink, 255.0))) / covered.iter().sum::<f64>();
        assert!((excess - 1.0).abs() < 1e-9, "{ink}, {width} wide: {excess} times its area");
    }
}

#[test]
fn light_strokes_on_dark_ground_keep_their_area_too() {
    let bar = [bar((24.2, 23.7), 36.0, 1.1, 0.4)];
    let light = shades(&coverage(&bar), 255.0, 0.0);
    let gray = Gray::from_bytes(SIDE, SIDE, &light).expect("a valid picture");
    let options = TraceOptions { inverted: true, ..TraceOptions::default() };
    let found = trace(gray, &options).expect("a drawing");
    let excess = enclosed(&found) / area(&bar[0]);
    assert!((excess - 1.0).abs() < 0.02, "{excess} times its area");
    assert_eq!(found.tones.paper, 65_280.0, "the ink is white");
}

/// Other inks begin the refinement again, which is no reason for progress to go back.
#[test]
fn progress_never_goes_back_while_inks_are_tried() {
    let bar = [bar((24.2, 23.7), 36.0, 1.1, 0.4)];
    let gray = Gray::from_bytes(SIDE, SIDE, &shades(&coverage(&bar), 90.0, 230.0)).expect("a valid picture");
    let mut tracer = Tracer::new(gray, &TraceOptions::default()).expect("options in range");
    let mut last = tracer.step(0.0).expect("a drawing");
    while !last.done {
        let next = tracer.step(0.0).expect("a drawing");
        let rises = (last.stage, last.completed) <= (next.stage, next.completed);
        assert!(rises && next.completed <= next.total, "{last:?}, then {next:?}");
        last = next;
    }
}

/// Half-way from paper to black, where the ink is known from a bold part, strokes below a pixel broke or were not
/// found.
#[test]
fn thin_strokes_beside_bold_shapes_are_whole() {
    let mut off = Vec::new();
    for width in [0.55, 0.65, 0.75, 0.85] {
        for k in 0..6 {
            let (x, y) = spread(k);
            let lean = 0.05 + 0.03 * k as f64;
            let bold = bar((12.0, 24.0), 36.0, 12.0, FRAC_PI_2);
            let thin = [28.0, 38.0].map(|left| bar((left + x, 24.0 + y), 34.0, width, FRAC_PI_2 + lean));
            let drawing = [vec![bold], thin.to_vec()].concat();
            let found = traced(SIDE, SIDE, &shades(&coverage(&drawing), 0.0, 255.0));
            let excess = enclosed(&found) / drawing.iter().map(|polygon| area(polygon)).sum::<f64>();
            // Strokes are a tenth of the ink: without one of them a twentieth is missing.
            if found.contours.len() != 3 || (excess - 1.0).abs() > 0.01 {
                off.push((width, lean, found.contours.len(), excess));
            }
        }
    }
    assert!(off.len() <= 2, "of 24 drawings these are not: {off:?}");
}

/// Half-way from paper to ink the tips of stars with many of them broke off: of these twelve, eight.
#[test]
fn tips_of_sharp_stars_stay_on() {
    for tips in [10, 12, 14] {
        for k in 0..4 {
            let (x, y) = spread(k);
            let corner = |i: usize| {
                let radius = if i.is_multiple_of(2) { 22.0 } else { 5.0 };
                let angle = 0.3 * k as f64 + PI * i as f64 / tips as f64;
                (24.0 + x + radius * angle.cos(), 24.0 + y + radius * angle.sin())
            };
            let star: Vec<Place> = (0..2 * tips).map(corner).collect();
            let found = traced(SIDE, SIDE, &shades(&coverage(core::slice::from_ref(&star)), 0.0, 255.0));
            let excess = enclosed(&found) / area(&star);
            assert_eq!(found.contours.len(), 1, "{tips} tips at {x}, {y}");
            assert!((excess - 1.0).abs() < 0.02, "{excess} times its area, {tips} tips at {x}, {y}");
        }
    }
}
