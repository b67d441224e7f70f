//! Measures of a curve side by side with kurbo: one run, one curve, answers checked against each other.
//!
//! The curve: closed, 16 cubics in a box of 512, the uniform Catmull–Rom spline of 16 points. Every row is the least of
//! many rounds in which the candidates take turns.

#![allow(clippy::print_stdout, reason = "a table is what this program is for")]

#[cfg(target_arch = "wasm32")]
fn main() {}

#[cfg(not(target_arch = "wasm32"))]
fn main() {
    host::run();
}

#[cfg(not(target_arch = "wasm32"))]
mod host {
    use core::hint::black_box;
    use std::time::Instant;

    use expline::curve::NearestFinder;
    use expline::numerics::Point;
    use expline::{Curve, HermiteCurve, HermiteOptions, Space};
    use kurbo::{BezPath, CubicBez, ParamCurveArclen, ParamCurveArea, ParamCurveExtrema, ParamCurveNearest};

    type Row = fn(&HermiteCurve, &[CubicBez]);

    /// Numbers in [0, 1) that are the same on every machine.
    fn uniform(seed: &mut u64) -> f64 {
        *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*seed >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn curve() -> HermiteCurve {
        let mut seed = 42;
        let points: Vec<Point> = (0..16)
            .map(|i| {
                let angle = core::f64::consts::TAU * f64::from(i) / 16.0;
                let radius = 120.0 + 130.0 * uniform(&mut seed);
                Point::new(256.0 + radius * angle.cos(), 256.0 + radius * angle.sin())
            })
            .collect();
        let tangents = (0..16).map(|i| (points[(i + 1) % 16] - points[(i + 15) % 16]) * 0.5).collect();
        HermiteCurve::new(HermiteOptions {
            points,
            tangents,
            closed: true,
            space: Some(Space::Polynomial),
            ..HermiteOptions::default()
        })
        .expect("a curve")
    }

    fn cubics(curve: &HermiteCurve) -> Vec<CubicBez> {
        let at = |p: Point| kurbo::Point::new(p.x, p.y);
        curve
            .segments()
            .map(|s| {
                CubicBez::new(
                    at(s.start),
                    at(s.start + s.leaving / 3.0),
                    at(s.end - s.arriving / 3.0),
                    at(s.end),
                )
            })
            .collect()
    }

    /// Least nanoseconds per call of each candidate; they take turns so that they share the machine's moods.
    fn race<const N: usize>(calls: usize, candidates: [&mut dyn FnMut(); N]) -> [f64; N] {
        let mut least = [f64::INFINITY; N];
        let mut candidates = candidates;
        for _ in 0..200 {
            for (best, candidate) in least.iter_mut().zip(&mut candidates) {
                let start = Instant::now();
                for _ in 0..calls {
                    candidate();
                }
                *best = best.min(start.elapsed().as_nanos() as f64 / calls as f64);
            }
        }
        least
    }

    fn row(name: &str, ours: f64, theirs: f64, check: &str) {
        println!("{name:<34} {ours:>9.1} ns   kurbo {theirs:>9.1} ns   {:>6.2}x   {check}", theirs / ours);
    }

    pub(super) fn run() {
        let curve = curve();
        let path = cubics(&curve);
        // A word on the command line runs the rows whose name holds it.
        let wanted = std::env::args().nth(1).filter(|word| !word.starts_with('-')).unwrap_or_default();
        let rows: [(&str, Row); 6] = [
            ("bounds", bounds),
            ("area", area),
            ("length", length),
            ("nearest", nearest),
            ("flatten", flatten),
            ("spread", spread),
        ];
        for (name, run) in rows {
            if name.contains(&wanted) {
                run(&curve, &path);
            }
        }
    }

    fn bounds(curve: &HermiteCurve, path: &[CubicBez]) {
        let theirs =
            path.iter().map(ParamCurveExtrema::bounding_box).reduce(|a, b| a.union(b)).expect("boxes");
        let ours = curve.bounds();
        let gap = (ours.min_x - theirs.x0).abs() + (ours.max_y - theirs.y1).abs();
        assert!(gap < 1e-10, "boxes differ by {gap}");
        let [a, b] = race(
            100,
            [
                &mut || {
                    black_box(black_box(curve).bounds());
                },
                &mut || {
                    let mut all: Option<kurbo::Rect> = None;
                    for cubic in black_box(path) {
                        let one = ParamCurveExtrema::bounding_box(cubic);
                        all = Some(all.map_or(one, |b| b.union(one)));
                    }
                    black_box(all);
                },
            ],
        );
        row("bounds, 16 segments", a, b, &format!("difference {gap:.1e}"));
    }

    fn area(curve: &HermiteCurve, path: &[CubicBez]) {
        let theirs: f64 = path.iter().map(ParamCurveArea::signed_area).sum();
        let ours = curve.area().expect("closed");
        assert!((ours - theirs).abs() < 1e-8, "{ours} and {theirs}");
        let [a, b] = race(
            100,
            [&mut || drop(black_box(black_box(curve).area())), &mut || {
                let sum: f64 = black_box(path).iter().map(ParamCurveArea::signed_area).sum();
                black_box(sum);
            }],
        );
        row("area, 16 segments", a, b, &format!("difference {:.1e}", (ours - theirs).abs()));
    }

    fn length(curve: &HermiteCurve, path: &[CubicBez]) {
        let truth: f64 = path.iter().map(|c| c.arclen(1e-13)).sum();
        for (tolerance, accuracy) in [(1e-3, 1e-3), (1e-6, 1e-6), (1e-9, 1e-6), (1e-9, 1e-9), (1e-12, 1e-9)] {
            let ours = curve.length(tolerance).expect("a length");
            let theirs: f64 = path.iter().map(|c| c.arclen(accuracy)).sum();
            assert!((ours - truth).abs() <= tolerance.max(1e-11), "{ours} is not {truth}");
            let [a, b] = race(
                100,
                [&mut || drop(black_box(black_box(curve).length(tolerance))), &mut || {
                    let sum: f64 = black_box(path).iter().map(|c| c.arclen(accuracy)).sum();
                    black_box(sum);
                }],
            );
            let check = format!("errors {:.1e}, {:.1e}", (ours - truth).abs(), (theirs - truth).abs());
            row(&format!("length to {tolerance:e} (kurbo {accuracy:e})"), a, b, &check);
        }
    }

    fn nearest(curve: &HermiteCurve, path: &[CubicBez]) {
        let mut seed = 7;
        let places: Vec<Point> =
            (0..10_000).map(|_| Point::new(uniform(&mut seed) * 512.0, uniform(&mut seed) * 512.0)).collect();
        let finder = NearestFinder::new(curve);
        let kurbo_one = |p: Point| {
            let p = kurbo::Point::new(p.x, p.y);
            path.iter().map(|c| c.nearest(p, 1e-6).distance_sq).fold(f64::INFINITY, f64::min).sqrt()
        };
        let mut worst: f64 = 0.0;
        for &p in &places {
            let (ours, theirs) = (finder.nearest(p).distance, kurbo_one(p));
            worst = worst.max(ours - theirs);
            assert!(ours - theirs < 1e-9, "missed: {ours} and {theirs}");
        }
        let (mut i, mut k) = (0, 0);
        let [a, b, c] = race(
            1000,
            [
                &mut || {
                    i = (i + 1) % places.len();
                    black_box(finder.nearest(places[i]));
                },
                &mut || {
                    k = (k + 1) % places.len();
                    black_box(kurbo_one(places[k]));
                },
                &mut || drop(black_box(NearestFinder::new(black_box(curve)))),
            ],
        );
        row("nearest point, per query", a, b, &format!("0 misses of 10000, worst {worst:.1e}"));
        println!("{:<34} {c:>9.1} ns", "  preparing the curve");
    }

    fn flatten(curve: &HermiteCurve, path: &[CubicBez]) {
        let mut bez = BezPath::new();
        bez.move_to(path[0].p0);
        for c in path {
            bez.curve_to(c.p1, c.p2, c.p3);
        }
        let count = |tolerance: f64| {
            let mut n = 0;
            kurbo::flatten(&bez, tolerance, |_| n += 1);
            n - 1
        };
        for tolerance in [1.0, 0.1, 0.01] {
            let (points, deviation) = curve.flatten(tolerance).expect("a polyline");
            assert!(deviation <= tolerance, "{deviation} exceeds {tolerance}");
            let [a, b] = race(
                100,
                [&mut || drop(black_box(black_box(curve).flatten(tolerance))), &mut || {
                    let mut all = Vec::new();
                    kurbo::flatten(black_box(&bez), tolerance, |element| all.push(element));
                    black_box(all);
                }],
            );
            let check =
                format!("{} points proved {deviation:.4}, kurbo {}", points.len() / 2, count(tolerance));
            row(&format!("flatten to {tolerance}"), a, b, &check);
        }
    }

    fn spread(curve: &HermiteCurve, _: &[CubicBez]) {
        let length = curve.length(1e-12).expect("a length");
        let [a] = race(3, [&mut || drop(black_box(black_box(curve).sample_by_length(1000, 1e-9 * length)))]);
        println!("{:<34} {:>9.1} ns per point", "uniform arc length, 1000 points", a / 1000.0);
    }
}
