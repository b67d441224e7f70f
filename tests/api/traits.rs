//! What Rust programs expect of the types: any curve can be asked where it is, work can go on in another thread, and
//! what is plain data can be compared.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::collections::HashSet;

use expline::curve::{Sampler, Scheme, Side, SplineSampler};
use expline::fit::{Ask, Fit, FitStatus, Fitter, Norm, Options, Parametrisation, fit};
use expline::generator::Roots;
use expline::numerics::{Point, Vector};
use expline::surface::TensorSurface;
use expline::svg::{ParsedPath, PrintOptions, parse_path};
use expline::trace::{
    Gray, LayerTracer, Model, Source, Stage, Trace, TraceOptions, TracedLayer, Tracer, trace,
};
use expline::{
    BSplineCurve, Curve, Error, HermiteCurve, HermiteOptions, InterpolatingCurve, LocalCurve, Space,
};

/// A curve of every kind, open and closed, in the plane and in space.
fn curves() -> Vec<Box<dyn Curve>> {
    let oval = HermiteCurve::ellipse(Point::new(1.0, 2.0), Vector::new(5.0, 3.0), 0.4, 3).expect("in range");
    let arc = HermiteCurve::arc(Point::zeros(), Vector::new(5.0, 3.0), 0.4, 0.1, 5.0).expect("in range");
    let numbers: Vec<f64> = (0..21).map(|i| f64::from(i * i % 17)).collect();
    let plane = InterpolatingCurve::new(numbers[..14].to_vec(), 2, false, None).expect("in range");
    let space = InterpolatingCurve::new(numbers, 3, true, Some(Roots::ellipse(7).expect("in range")))
        .expect("in range");
    let fine: BSplineCurve = plane.refine(2, 2, 3).expect("in range");
    let local = LocalCurve::new(space.clone()).refine_at(1.5, 2, 0.5).expect("in range");
    vec![Box::new(oval), Box::new(arc), Box::new(plane), Box::new(space), Box::new(fine), Box::new(local)]
}

#[test]
fn any_curve_says_where_it_is_without_its_kind_being_known() {
    for curve in curves() {
        let (dimension, (start, end)) = (curve.dimension(), curve.domain());
        let middle = 0.3 * start + 0.7 * end;
        let point = curve.evaluate(middle, 0).expect("in the domain");
        assert_eq!(point.len(), dimension);
        let mut both = vec![0.0; 2 * dimension];
        curve.evaluate_into(&[start, middle], 0, &mut both).expect("in the domain");
        assert_eq!(both[dimension..], point);
        for count in [0, 1, 2, 9] {
            let sample = curve.sample(count).expect("few");
            assert_eq!(sample.len(), count * dimension);
            let steps = if curve.is_closed() { count } else { count.saturating_sub(1).max(1) } as f64;
            for (i, point) in sample.chunks(dimension).enumerate() {
                let t = (start + (end - start) * i as f64 / steps).min(end);
                let expected = curve.evaluate(t, 0).expect("in the domain");
                let off = point.iter().zip(&expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                assert!(off < 1e-12, "point {i} of {count} is off by {off}");
            }
        }
        let length = curve.length(1e-9).expect("a tolerance");
        let slope = curve.evaluate(middle, 1).expect("in the domain");
        let speed = slope.iter().map(|x| x * x).sum::<f64>().sqrt();
        assert!(speed > 0.0 && speed < 9.0 * length, "derivatives are by the same parameter");
    }
}

#[test]
fn what_a_curve_of_unknown_kind_cannot_be_asked_is_an_error() {
    for curve in curves() {
        let (_, end) = curve.domain();
        for t in [f64::NAN, f64::INFINITY] {
            assert!(matches!(*curve.evaluate(t, 0).expect_err("no number"), Error::NotFinite { .. }));
        }
        assert_eq!(curve.evaluate(2.0 * end + 1.0, 0).is_ok(), curve.is_closed());
        assert!(curve.evaluate(0.5 * end, usize::MAX).is_err(), "no such derivative");
        assert!(matches!(*curve.sample(usize::MAX).expect_err("too many"), Error::LimitExceeded { .. }));
        let mut short = [7.0];
        assert!(curve.evaluate_into(&[0.0], 0, &mut short).is_err(), "no room");
        assert_eq!(short, [7.0], "nothing was written");
    }
}

#[test]
fn work_can_go_on_in_another_thread() {
    fn moves<T: Send + Sync + 'static>() {}
    moves::<HermiteCurve>();
    moves::<InterpolatingCurve>();
    moves::<LocalCurve>();
    moves::<TensorSurface>();
    moves::<Sampler>();
    moves::<SplineSampler>();
    moves::<Fitter>();
    moves::<Tracer>();
    moves::<LayerTracer>();
    moves::<Box<Error>>();
    moves::<Fit>();
    moves::<Trace>();
    moves::<TracedLayer>();
}

#[test]
fn plain_data_can_be_compared_and_counted() {
    let path = |d| -> ParsedPath { parse_path(d).expect("a path") };
    assert_eq!(path("M0 0L1 1"), path("M0,0 1,1"));
    assert_ne!(path("M0 0L1 1"), path("M0 0L1 2"));
    assert_eq!(path("M0 0L1 1").curves[0].to_options(), path("m0 0 1 1").curves[0].to_options());
    assert_ne!(HermiteOptions::default(), HermiteOptions { closed: true, ..HermiteOptions::default() });
    assert_ne!(PrintOptions::default(), PrintOptions { arcs: false, ..PrintOptions::default() });
    let points: Vec<Point> = (0..30).map(|i| Point::new(f64::from(i), f64::from(i * i % 7))).collect();
    let fitted = || fit(&points, Ask::Tolerance(1.0), &Options::default()).expect("points");
    assert_eq!(fitted(), fitted(), "the same bits each time");
    let square: Vec<u8> = (0..256)
        .map(|i| if (4..12).contains(&(i % 16)) && (64..192).contains(&i) { 0 } else { 255 })
        .collect();
    let traced = || trace(Gray::from_bytes(16, 16, &square).expect("a picture"), &TraceOptions::default());
    assert_eq!(traced().expect("a drawing"), traced().expect("a drawing"));
    let kinds = HashSet::from([Space::Hyperbolic, Space::Hyperbolic, Space::Polynomial]);
    assert_eq!(kinds.len(), 2);
    let words = HashSet::from([(Side::In, Scheme::Scalar, Norm::L1, Model::Sparse)]);
    assert!(words.contains(&(Side::In, Scheme::Scalar, Norm::L1, Model::Sparse)));
    let stages = HashSet::from([(Stage::Edges, Source::Lines, FitStatus::Running, Parametrisation::Chord)]);
    assert_eq!(stages.len(), 1);
}

#[test]
fn every_option_says_what_it_is_by_default() {
    let mut silent = Vec::new();
    let mut count = 0;
    for (name, text) in [
        ("HermiteOptions", include_str!("../../src/curve/hermite.rs")),
        ("Options", include_str!("../../src/fit/options.rs")),
        ("PrintOptions", include_str!("../../src/svg/print.rs")),
        ("TraceOptions", include_str!("../../src/trace/options.rs")),
    ] {
        let start = text.find(&format!("pub struct {name} {{")).expect("the options are here");
        let body = &text[start..start + text[start..].find("\n}").expect("it ends")];
        let mut said = String::new();
        for line in body.lines().skip(1).map(str::trim) {
            if let Some(field) = line.strip_prefix("pub ") {
                count += 1;
                if !["default", "`None`", "empty", "not given"].iter().any(|word| said.contains(word)) {
                    silent.push(format!("{name}.{field}"));
                }
                said.clear();
            } else {
                said.push_str(line);
            }
        }
    }
    assert!(count > 30, "only {count} were looked at");
    assert!(silent.is_empty(), "{silent:?}");
}
