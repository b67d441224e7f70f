//! A picture that is given and traced bit by bit is the picture at once, and no step is long.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::pictures::{Noise, STAR, draw, draw_finely, inside, traced};
use expline::numerics::Point;
use expline::trace::{Gray, Progress, Stage, Trace, TraceOptions, Tracer};

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
