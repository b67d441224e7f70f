//! Pictures of two shades only say of each pixel whether its centre is inside. What is drawn aslant comes back smooth,
//! as few lines and arcs with sharp corners between them; what is drawn along rows and columns comes back as it is.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::pictures::{Ink, draw, draw_finely, traced};
use expline::numerics::{Point, Vector};
use expline::trace::{Census, Gray, LayerTracer, Layers, Stage, TraceOptions, Tracer, trace};
use expline::{Curve, HermiteCurve};

/// One sample a pixel, at its centre.
fn two_shades(side: usize, ink: Ink) -> Vec<u8> {
    draw_finely(side, side, 1, ink)
}

/// A rectangle around the middle of a picture, turned, with its corners.
fn turned(side: usize, turn: f64) -> (Vec<u8>, [Point; 4]) {
    let (sin, cos) = turn.sin_cos();
    let (middle, w, h) = (0.5 * side as f64, 0.3 * side as f64, 0.24 * side as f64);
    let bytes = two_shades(side, &|x, y| {
        let (x, y) = (x - middle, y - middle);
        (x * cos + y * sin).abs() < w && (y * cos - x * sin).abs() < h
    });
    let corner = |u: f64, v: f64| Point::new(middle + u * cos - v * sin, middle + u * sin + v * cos);
    (bytes, [corner(w, h), corner(-w, h), corner(-w, -h), corner(w, -h)])
}

fn is_straight(curve: &HermiteCurve, i: usize) -> bool {
    let next = (i + 1) % curve.points().len();
    let chord = curve.points()[next] - curve.points()[i];
    let across = |way: Vector| (chord.x * way.y - chord.y * way.x).abs() / (chord.norm() * way.norm());
    across(curve.tangents()[i]) < 1e-9 && across(curve.tangents_in()[next]) < 1e-9
}

#[test]
fn a_disc_of_two_shades_is_a_circle() {
    for (side, radius) in [
        (32, 11.52),
        (64, 23.04),
        (64, 27.3),
        (96, 35.9),
        (128, 46.1),
        (256, 79.4),
        (512, 158.7),
        (512, 223.1),
    ] {
        let middle = Point::new(0.5 * side as f64 + 0.3, 0.5 * side as f64 - 0.2);
        let bytes = two_shades(side, &|x, y| (x - middle.x).hypot(y - middle.y) < radius);
        let drawing = traced(side, side, &bytes);
        assert_eq!(drawing.contours.len(), 1, "one outline");
        let circle = drawing.contours[0].curve.as_ellipse(1e-6).expect("a circle");
        // Each of the 4r rows and columns knows an edge to half a pixel: together they know it to .3/√(4r), below .05,
        // three times that with luck against us.
        let near = f64::max(0.1, 0.9 / (4.0 * radius).sqrt());
        assert!(
            (circle.radii - Vector::new(radius, radius)).norm() < near,
            "{circle:?}, drawn with {radius}"
        );
        assert!((circle.center - middle).norm() < near, "{circle:?}, drawn around {middle}");
    }
}

#[test]
fn a_turned_rectangle_of_two_shades_is_four_lines_and_four_sharp_corners() {
    for (side, turn) in [(256, 0.3), (256, 0.785), (512, 0.3), (512, 0.1), (512, 0.6)] {
        let (bytes, corners) = turned(side, turn);
        let drawing = traced(side, side, &bytes);
        let outline = &drawing.contours[0];
        assert_eq!(outline.curve.points().len(), 4, "{side} pixels, turned by {turn}");
        assert!((0..4).all(|i| is_straight(&outline.curve, i)), "{side} pixels, turned by {turn}");
        assert_eq!(outline.cusps.len(), 4, "{side} pixels, turned by {turn}");
        for corner in corners {
            let off = outline.cusps.iter().map(|cusp| (cusp - corner).norm()).fold(f64::INFINITY, f64::min);
            // A pixel knows half a pixel; both sides of a corner a tenth of their length away know it better.
            assert!(off < 0.5, "a corner {off} off at {side} pixels, turned by {turn}");
        }
    }
}

#[test]
fn a_crescent_of_two_shades_has_its_two_corners_and_no_other() {
    let side = 256;
    let bytes = two_shades(side, &|x, y| {
        (x - 128.0).hypot(y - 128.0) < 0.35 * 256.0 && (x - 0.65 * 256.0).hypot(y - 128.0) > 0.3 * 256.0
    });
    let drawing = traced(side, side, &bytes);
    let outline = &drawing.contours[0];
    assert_eq!(outline.cusps.len(), 2, "{:?}", outline.cusps);
    assert!(outline.curve.points().len() <= 6, "{} points", outline.curve.points().len());
    let end = outline.curve.domain().1;
    let off = |p: Point| {
        let circle = |x: f64, r: f64| ((p.x - x).hypot(p.y - 128.0) - r).abs();
        circle(128.0, 0.35 * 256.0).min(circle(0.65 * 256.0, 0.3 * 256.0))
    };
    let places = (0..2000).map(|k| outline.curve.evaluate(end * f64::from(k) / 2000.0, 0).expect("inside"));
    let mean = places.map(off).sum::<f64>() / 2000.0;
    // Edges of pixels are .25 away from it in the mean.
    assert!(mean < 0.12, "{mean} pixels from both circles in the mean");
}

/// Pixels from text, so many times as large, on a margin.
fn pixel_art(rows: &[&str], times: usize) -> (usize, Vec<u8>) {
    let side = (rows.len().max(rows[0].len()) + 4) * times;
    let ink = |x: f64, y: f64| {
        let at = |v: f64| ((v as usize) / times).wrapping_sub(2);
        rows.get(at(y)).and_then(|row| row.as_bytes().get(at(x))) == Some(&b'#')
    };
    (side, two_shades(side, &ink))
}

#[test]
fn what_is_drawn_along_rows_and_columns_comes_back_as_it_is() {
    let pictures: [(&[&str], usize); 6] = [
        (&[".###.", "#...#", "#...#", "#####", "#...#", "#...#", "#...#"], 1),
        (&["..####..", ".##..##.", ".##.....", "..###...", "....##..", ".##..##.", "..####.."], 1),
        (&["..####..", ".##..##.", ".##.....", "..###...", "....##..", ".##..##.", "..####.."], 5),
        (&["####................", "....########........", "............########"], 1),
        (&["####", "####", "####"], 13),
        (&["#######", "#.....#", "#.###.#", "#.....#", "#######"], 3),
    ];
    for (rows, times) in pictures {
        let (side, bytes) = pixel_art(rows, times);
        for refined in [true, false] {
            let options = TraceOptions { refined, speckle: Some(0.0), ..TraceOptions::default() };
            let drawing =
                trace(Gray::from_bytes(side, side, &bytes).expect("valid"), &options).expect("a drawing");
            for outline in &drawing.contours {
                let points = outline.curve.points();
                for (i, p) in points.iter().enumerate() {
                    let next = points[(i + 1) % points.len()];
                    assert!(p.x == p.x.round() && p.y == p.y.round(), "{rows:?}: a corner at {p}");
                    assert!((p.x == next.x) != (p.y == next.y), "{rows:?}: from {p} to {next}");
                }
            }
            let area: f64 = drawing.contours.iter().map(|c| c.curve.area().expect("closed")).sum();
            let ink = bytes.iter().filter(|&&shade| shade == 0).count() as f64;
            assert!((area - ink).abs() < 1e-9, "{rows:?}: {area} of {ink} pixels");
        }
    }
}

#[test]
fn smooth_shapes_and_squares_share_a_picture_of_two_shades_with_one_of_coverage() {
    let disc = |x: f64, y: f64| (x - 60.2).hypot(y - 70.1) < 41.3;
    let square = |x: f64, y: f64| (x - 150.0).abs() < 30.0 && (y - 60.0).abs() < 20.0;
    let soft = |x: f64, y: f64| (x - 140.4).hypot(y - 148.7) < 37.6;
    let two = two_shades(200, &|x, y| disc(x, y) || square(x, y));
    let bytes: Vec<u8> = two.iter().zip(draw(200, 200, &soft)).map(|(&a, b)| a.min(b)).collect();
    let drawing = traced(200, 200, &bytes);
    assert_eq!(drawing.contours.len(), 3, "three outlines");
    let round = |r: f64, most: f64| {
        let ink = core::f64::consts::PI * r * r;
        let is_it =
            |c: &HermiteCurve| c.points().len() <= 6 && (c.area().expect("closed") / ink - 1.0).abs() < most;
        drawing.contours.iter().any(|c| is_it(&c.curve))
    };
    // A tenth of a pixel is half a percent of its area; what has coverage is known to a hundredth.
    assert!(round(41.3, 5e-3), "the disc of two shades");
    assert!(round(37.6, 5e-4), "the other is as exact as ever");
    let corners = [(120.0, 40.0), (180.0, 40.0), (180.0, 80.0), (120.0, 80.0)];
    let is_square =
        |c: &HermiteCurve| c.points().len() == 4 && c.points().iter().all(|p| corners.contains(&(p.x, p.y)));
    assert!(drawing.contours.iter().any(|c| is_square(&c.curve)), "the square");
}

/// Alone, a slanted bar as small as a glyph, less than two pixels wide, is what its pixels are; beside a large disc it
/// is a part of the same drawing. A glyph with lines of one pixel is never smooth.
#[test]
fn what_is_small_is_followed_like_the_large_outlines_around_it() {
    let bar = |x: f64, y: f64| (12.0..24.0).contains(&y) && (x - 14.0 - 0.4 * (y - 12.0)).abs() < 0.85;
    let disc = |x: f64, y: f64| (x - 70.3).hypot(y - 70.1) < 40.2;
    let rows = [".###.", "#...#", "#...#", "#####", "#...#", "#...#", "#...#"];
    let glyph = |x: f64, y: f64| {
        let at = |v: f64, from: usize| (v as usize).wrapping_sub(from);
        rows.get(at(y, 8)).and_then(|row| row.as_bytes().get(at(x, 90))) == Some(&b'#')
    };
    let squares = |picture: &dyn Fn(f64, f64) -> bool, left: f64| {
        let drawing = traced(128, 128, &two_shades(128, picture));
        let at_place = drawing.contours.iter().filter(|c| {
            let bounds = c.curve.bounds();
            bounds.max_y < 28.0 && (bounds.min_x > 60.0) == (left > 60.0)
        });
        let points: Vec<Point> = at_place.flat_map(|c| c.curve.points().to_vec()).collect();
        assert!(!points.is_empty());
        points.iter().all(|p| p.x == p.x.round() && p.y == p.y.round())
    };
    assert!(squares(&bar, 0.0), "a bar alone");
    assert!(!squares(&|x, y| bar(x, y) || disc(x, y), 0.0), "a bar beside a disc");
    assert!(squares(&|x, y| glyph(x, y) || disc(x, y), 90.0), "a glyph beside a disc");
}

#[test]
fn a_threshold_between_two_shades_moves_nothing() {
    let (bytes, _) = turned(128, 0.4);
    let with = |threshold: Option<f64>| {
        let gray = Gray::from_bytes(128, 128, &bytes).expect("valid");
        trace(gray, &TraceOptions { threshold, ..TraceOptions::default() }).expect("a drawing")
    };
    let found = with(None);
    for threshold in [40.0, 200.0] {
        let given = with(Some(threshold));
        assert_eq!(given.contours[0].curve.points(), found.contours[0].curve.points(), "at {threshold}");
    }
}

#[test]
fn flat_colours_with_hard_edges_are_smooth_layers() {
    let side = 160;
    let mut bytes = Vec::new();
    for i in 0..side * side {
        let (x, y) = ((i % side) as f64 + 0.5, (i / side) as f64 + 0.5);
        let colour: [u8; 4] = if (x - 60.3).hypot(y - 79.6) < 42.2 {
            [200, 16, 46, 255]
        } else if x + 0.4 * y > 150.0 {
            [0, 48, 135, 255]
        } else {
            [255; 4]
        };
        bytes.extend(colour);
    }
    let mut census = Census::new(side).expect("colours");
    census.push_rgba_rows(&bytes);
    let mut rows = Layers::begin(side, side, &census.palette(8).expect("a palette")).expect("valid");
    rows.push_rgba_rows(&bytes).expect("rows");
    let mut tracer = LayerTracer::new(rows.finish().expect("all rows"), &TraceOptions::default());
    while !tracer.step(1e4).expect("a drawing") {}
    let points: usize =
        tracer.layers().iter().flat_map(|l| &l.contours).map(|c| c.curve.points().len()).sum();
    // Paper 4, what is aslant 4 or 5, a disc at most 8: along pixels there are hundreds.
    assert!(points <= 24, "{points} points");
    let red = tracer.layers().iter().find(|layer| layer.color == [200, 16, 46]).expect("red");
    let area: f64 = red.contours.iter().map(|c| c.curve.area().expect("closed")).sum();
    assert!((area / (core::f64::consts::PI * 42.2 * 42.2) - 1.0).abs() < 0.01, "{area}");
}

/// Places along a contour and its corners were found in one step, and all steps of all nodes of its outline were one:
/// both took longer than anybody who stops a trace waits for.
#[test]
fn one_long_outline_of_two_shades_is_followed_and_moved_step_by_step() {
    let gear = |x: f64, y: f64| {
        let (right, down) = (x - 210.0, y - 210.0);
        right.hypot(down) < 180.0 + 8.0 * (12.0 * down.atan2(right)).sin()
    };
    let gray = Gray::from_bytes(420, 420, &two_shades(420, &gear)).expect("a valid picture");
    let mut tracer = Tracer::new(gray, &TraceOptions::default()).expect("options in range");
    let (mut corners, mut moves) = (0, 0);
    loop {
        let progress = tracer.step(0.0).expect("a drawing");
        corners += usize::from(progress.stage == Stage::Corners);
        moves += usize::from(progress.stage == Stage::Refinement);
        if progress.done {
            break;
        }
    }
    assert_eq!(tracer.result().expect("done").contours.len(), 1);
    assert!(corners >= 2 && moves >= 18, "{corners} and {moves} steps");
}
