//! Hostile pictures do no harm, and what is no drawing is refused by name.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::pictures::{Noise, STAR, draw, inside, traced};
use expline::Error;
use expline::curve::Curve;
use expline::numerics::Point;
use expline::trace::{Gray, Source, Trace, TraceOptions, Tracer, trace};

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
    let options = TraceOptions { speckle: Some(0.0), ..TraceOptions::default() };
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
        TraceOptions { speckle: Some(f64::INFINITY), ..TraceOptions::default() },
    ] {
        assert!(error(trace(gray.clone(), &options).map(drop)).argument().is_some(), "{options:?}");
    }
    let speckle = TraceOptions { speckle: Some(1000.0), ..TraceOptions::default() };
    assert!(
        trace(gray.clone(), &speckle).expect("a drawing").contours.is_empty(),
        "smaller than the speckle"
    );
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
    let options =
        |speckle| TraceOptions { speckle: Some(speckle), most_contours: 2, ..TraceOptions::default() };
    let speckle = offered(gray.clone(), &options(0.0));
    assert_eq!(trace(gray, &options(speckle)).expect("a drawing").contours.len(), 2);
}

/// The rows of the picture were through at the refusal, and the next step looked for one beyond the last.
#[test]
fn after_an_error_every_further_step_fails_alike() {
    let options = TraceOptions { most_contours: 2, ..TraceOptions::default() };
    let mut tracer = Tracer::new(disks([2.0, 3.0, 5.0, 7.0]), &options).expect("options in range");
    let refused = loop {
        if let Err(error) = tracer.step(1000.0) {
            break error;
        }
    };
    for _ in 0..3 {
        assert_eq!(tracer.step(f64::INFINITY).err(), Some(refused.clone()));
    }
    assert!(tracer.result().is_err(), "nothing was found");
}

#[test]
fn who_sees_too_many_edges_is_told_what_to_leave_out() {
    let gray = disks([4.0, 6.0, 8.0, 11.0]);
    let options = |speckle| TraceOptions {
        source: Source::Edges,
        speckle: Some(speckle),
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
