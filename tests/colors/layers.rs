//! Pictures of a few flat colours come back as shapes that lie on one another, and nothing of what is below shows
//! between them.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::colors::{BLUE, Paint, RED, WHITE, YELLOW, disc, draw, palette, traced};
use expline::Error;
use expline::numerics::Point;
use expline::trace::{Census, Color, LayerTracer, Layers, Tint, TraceOptions, TracedLayer};

/// Polygons with many corners for every contour of every layer.
fn polygons(layers: &[TracedLayer]) -> Vec<(Color, Vec<Vec<Point>>)> {
    let polygon = |layer: &TracedLayer| {
        let of = |contour: &expline::trace::TracedContour| {
            let end = contour.curve.domain().1;
            let count = 60 * contour.curve.points().len();
            (0..count)
                .map(|i| contour.curve.evaluate(end * i as f64 / count as f64, 0).expect("in the domain"))
                .collect()
        };
        (layer.color, layer.contours.iter().map(of).collect())
    };
    layers.iter().map(polygon).collect()
}

/// Whether an odd number of the polygons' sides crosses the ray from a place to the right.
fn inside(polygons: &[Vec<Point>], x: f64, y: f64) -> bool {
    let mut odd = false;
    for polygon in polygons {
        for (i, a) in polygon.iter().enumerate() {
            let b = polygon[(i + 1) % polygon.len()];
            if (a.y > y) != (b.y > y) && x < a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x) {
                odd = !odd;
            }
        }
    }
    odd
}

/// Compares what the layers show at many places with what was painted; places nearer than `edge` to another colour do
/// not count. The colours below must not show there either.
fn assert_shows(width: usize, height: usize, layers: &[TracedLayer], paint: Paint, edge: f64) {
    let polygons = polygons(layers);
    let mut looked = 0;
    for i in 0..4000_u32 {
        // A sequence that fills the picture evenly.
        let x = width as f64 * (0.5 + 0.754_877_666 * f64::from(i)).fract();
        let y = height as f64 * (0.5 + 0.569_840_291 * f64::from(i)).fract();
        let wanted = paint(x, y);
        let around = [(edge, 0.0), (-edge, 0.0), (0.0, edge), (0.0, -edge)];
        if around.iter().any(|(dx, dy)| paint(x + dx, y + dy) != wanted) {
            continue;
        }
        looked += 1;
        let shown = polygons.iter().rev().find(|(_, own)| inside(own, x, y)).map(|(color, _)| *color);
        assert_eq!(shown, wanted, "at ({x}, {y})");
    }
    assert!(looked > 2000, "only {looked} places were clear");
}

/// A red disc over a blue square with a hole in which white shows, and a yellow disc that touches both.
fn logo(x: f64, y: f64) -> Option<Color> {
    Some(if disc(x, y, 60.3, 61.7, 18.0) {
        YELLOW
    } else if disc(x, y, 40.0, 40.0, 25.2) {
        RED
    } else if disc(x, y, 75.0, 38.0, 6.5) {
        WHITE
    } else if (30.0..90.0).contains(&x) && (25.5..85.25).contains(&y) {
        BLUE
    } else {
        WHITE
    })
}

#[test]
fn the_colours_of_a_drawing_are_found_to_the_bit() {
    let bytes = draw(110, 100, &logo);
    let found = palette(110, &bytes, 8);
    assert_eq!(found.len(), 4, "{found:?}");
    for color in [WHITE, RED, BLUE, YELLOW] {
        assert!(found.contains(&color), "{color:?} among {found:?}");
    }
    assert_eq!(found[0], WHITE, "the largest first");
}

#[test]
fn layers_show_what_was_painted_up_to_a_quarter_of_a_pixel_from_every_edge() {
    let bytes = draw(110, 100, &logo);
    let layers = traced(110, 100, &bytes, &palette(110, &bytes, 8));
    assert_eq!(layers.len(), 4, "one for each colour");
    assert_shows(110, 100, &layers, &logo, 0.25);
}

#[test]
fn a_disc_on_top_is_a_circle_of_its_own_and_leaves_no_hole_below() {
    let paint = |x: f64, y: f64| Some(if disc(x, y, 31.2, 28.9, 17.5) { RED } else { WHITE });
    let bytes = draw(64, 60, &paint);
    let layers = traced(64, 60, &bytes, &[RED, WHITE]);
    assert_eq!(layers.iter().map(|layer| layer.color).collect::<Vec<_>>(), [WHITE, RED]);
    assert_eq!(layers.iter().map(|layer| layer.contours.len()).collect::<Vec<_>>(), [1, 1]);
    let circle = &layers[1].contours[0].curve;
    for i in 0..50 {
        let p = circle.evaluate(circle.domain().1 * f64::from(i) / 50.0, 0).expect("in the domain");
        // The picture was asked at places an eighth of a pixel apart.
        assert!(((p - Point::new(31.2, 28.9)).norm() - 17.5).abs() < 0.0625, "{p}");
    }
}

/// Coverage of what lies below a wave, to an 8000th: exact along columns, sixteen of them in each pixel.
fn below_a_wave(column: usize, row: usize) -> f64 {
    let height = |x: f64| 60.0 + 14.0 * (x / 29.0).sin() + 5.0 * (x / 61.0).cos();
    let strip = |k: usize| row as f64 + 1.0 - height(column as f64 + (k as f64 + 0.5) / 16.0);
    (0..16).map(|k| strip(k).clamp(0.0, 1.0)).sum::<f64>() / 16.0
}

#[test]
fn an_edge_between_pale_colours_is_the_one_between_black_and_white() {
    let segments = |[above, below]: [Color; 2]| {
        let mix = |at: usize| {
            let share = below_a_wave(at % 200, at / 200);
            let channel = |k: usize| f64::from(above[k]) * (1.0 - share) + f64::from(below[k]) * share;
            [channel(0).round() as u8, channel(1).round() as u8, channel(2).round() as u8, 255]
        };
        let bytes: Vec<u8> = (0..200 * 120).flat_map(mix).collect();
        let layers = traced(200, 120, &bytes, &[above, below]);
        layers[1].contours[0].curve.points().len()
    };
    let clear = segments([WHITE, [0, 0, 0]]);
    // Roundings of the channels are three times as large beside the way from one colour to the other: one joint for
    // them.
    let pale = segments([[144, 205, 232], [240, 214, 166]]);
    assert!(clear <= 10 && pale <= clear + 1, "{pale} points where black and white have {clear}");
}

#[test]
fn three_colours_that_meet_leave_no_gap() {
    let paint = |x: f64, y: f64| {
        let angle = (y - 30.3).atan2(x - 31.7);
        Some(if angle < -1.3 {
            RED
        } else if angle < 0.9 {
            BLUE
        } else {
            YELLOW
        })
    };
    let bytes = draw(64, 60, &paint);
    let layers = traced(64, 60, &bytes, &palette(64, &bytes, 8));
    assert_eq!(layers.len(), 3);
    assert_shows(64, 60, &layers, &paint, 0.4);
    let lowest = &polygons(&layers)[0].1;
    for i in 0..60 {
        assert!(inside(lowest, f64::from(i) + 0.5, 30.5), "the lowest layer lies under all of them");
    }
}

#[test]
fn what_is_transparent_stays_so() {
    let paint =
        |x: f64, y: f64| (disc(x, y, 30.0, 30.0, 22.0) && !disc(x, y, 30.0, 30.0, 9.0)).then_some(BLUE);
    let bytes = draw(60, 60, &paint);
    let layers = traced(60, 60, &bytes, &palette(60, &bytes, 4));
    assert_eq!(layers.len(), 1);
    assert_eq!(layers[0].contours.len(), 2, "the disc and its hole");
    assert_shows(60, 60, &layers, &paint, 0.25);
}

#[test]
fn a_line_of_one_pixel_keeps_its_colour() {
    let paint = |x: f64, y: f64| {
        Some(if (20.0..21.0).contains(&x) && (5.0..45.0).contains(&y) { RED } else { WHITE })
    };
    let bytes = draw(50, 50, &paint);
    let layers = traced(50, 50, &bytes, &[WHITE, RED]);
    assert_eq!(layers.len(), 2);
    let points = layers[1].contours[0].curve.points();
    let (low, high) =
        points.iter().fold((f64::MAX, f64::MIN), |(low, high), p| (low.min(p.x), high.max(p.x)));
    assert!(low > 19.4 && high < 21.6, "it is where it was: {low} to {high}");
}

#[test]
fn a_picture_of_one_colour_is_one_layer_whatever_was_asked_for() {
    let bytes = draw(8, 8, &|_, _| Some([1, 2, 3]));
    let found = palette(8, &bytes, 16);
    assert_eq!(found, [[1, 2, 3]]);
    let layers = traced(8, 8, &bytes, &found);
    assert_eq!(layers.len(), 1);
    assert_eq!(layers[0].contours.len(), 1, "the border");
}

#[test]
fn rows_may_come_one_by_one() {
    let bytes = draw(40, 33, &|x, y| logo(2.0 * x, 2.0 * y));
    let mut census = Census::new(40).expect("a few colours");
    let mut rows = Layers::begin(40, 33, &[WHITE, RED, BLUE, YELLOW]).expect("a valid picture");
    for row in bytes.chunks_exact(160) {
        census.push_rgba_rows(row);
        rows.push_rgba_rows(row).expect("a whole row");
    }
    let found: Vec<Color> = census.palette(8).expect("8 colours").iter().map(Tint::on_white).collect();
    assert_eq!(found, palette(40, &bytes, 8));
    let mut tracer = LayerTracer::new(rows.finish().expect("all rows"), &TraceOptions::default());
    while !tracer.step(1.0).expect("a drawing") {}
    let whole = traced(40, 33, &bytes, &[WHITE, RED, BLUE, YELLOW]);
    for (a, b) in tracer.layers().iter().zip(&whole) {
        assert_eq!(a.color, b.color);
        let points = |layer: &TracedLayer| -> Vec<Point> {
            layer.contours.iter().flat_map(|contour| contour.curve.points().to_vec()).collect()
        };
        assert_eq!(points(a), points(b));
    }
}

#[test]
fn wrong_numbers_of_colours_and_of_rows_are_refused() {
    let mut census = Census::new(4).expect("a few colours");
    for most in [0, 1, 65] {
        assert_eq!(census.palette(most).expect_err("out of range").code(), "E_RANGE");
    }
    assert_eq!(Layers::begin::<Color>(4, 4, &[]).expect_err("none").code(), "E_RANGE");
    assert_eq!(Layers::begin(0, 4, &[RED]).expect_err("no column").code(), "E_RANGE");
    let mut rows = Layers::begin(4, 4, &[RED]).expect("a valid picture");
    assert_eq!(rows.push_rgba_rows(&[0; 15]).expect_err("no row").code(), "E_LENGTH");
    assert_eq!(rows.push_rgba_rows(&[0; 80]).expect_err("five rows").code(), "E_LENGTH");
    rows.push_rgba_rows(&[0; 48]).expect("three rows");
    assert_eq!(rows.finish().expect_err("one is missing").code(), "E_LENGTH");
}

#[test]
fn noise_in_colours_is_refused_with_the_count() {
    let mut state = 7_u64;
    let bytes: Vec<u8> = (0..4 * 120 * 120)
        .map(|i| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            if i % 4 == 3 { 255 } else { (state >> 56) as u8 }
        })
        .collect();
    let mut rows = Layers::begin(120, 120, &palette(120, &bytes, 6)).expect("a valid picture");
    rows.push_rgba_rows(&bytes).expect("whole rows");
    let options = TraceOptions { most_contours: 5, ..TraceOptions::default() };
    let mut tracer = LayerTracer::new(rows.finish().expect("all rows"), &options);
    let error = loop {
        match tracer.step(4000.0) {
            Ok(done) => assert!(!done, "noise is no drawing"),
            Err(error) => break error,
        }
    };
    assert_eq!(error.code(), "E_LIMIT");
}

#[test]
fn a_refusal_of_colours_counts_the_contours_of_all_layers_so_that_its_count_is_enough() {
    let side = 60;
    let colors = [[200, 0, 0], [0, 160, 0], [0, 0, 220]];
    let bytes: Vec<u8> = (0..side * side)
        .flat_map(|i| {
            let (x, y) = (i % side, i / side);
            let [r, g, b] = if x % 6 < 4 && y % 6 < 4 { colors[(x / 6 + y / 6) % 3] } else { [255; 3] };
            [r, g, b, 255]
        })
        .collect();
    let traced = |most_contours: usize| {
        let mut rows = Layers::begin(side, side, &palette(side, &bytes, 4)).expect("a valid picture");
        rows.push_rgba_rows(&bytes).expect("whole rows");
        let options = TraceOptions { most_contours, ..TraceOptions::default() };
        let mut tracer = LayerTracer::new(rows.finish().expect("all rows"), &options);
        loop {
            match tracer.step(f64::INFINITY) {
                Ok(false) => {}
                Ok(true) => {
                    return Ok(tracer.layers().iter().map(|layer| layer.contours.len()).sum::<usize>());
                }
                Err(error) => return Err(error),
            }
        }
    };
    let all = traced(1000).expect("few enough");
    for most in [1, 5, 60, all - 1] {
        let refused = traced(most).expect_err("too many");
        let limits = match *refused {
            Error::LimitExceeded { needed, most, .. } => Some((needed, most)),
            _ => None,
        };
        assert_eq!(limits, Some((all as f64, most as f64)));
    }
    assert_eq!(traced(all).expect("as many as there may be"), all);
}
