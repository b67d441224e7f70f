//! Laws that hold for every curve, on random and on awkward ones: all spaces, corners, sizes from 1e-6 to 1e8.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use core::f64::consts::TAU;

use expline::{HermiteCurve, HermiteOptions, Space};
use nalgebra::Vector2;

type Point = Vector2<f64>;

/// xorshift64*: the same numbers on every machine.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, least: f64, most: f64) -> f64 {
        least + (most - least) * self.unit()
    }

    fn below(&mut self, count: usize) -> usize {
        ((self.unit() * count as f64) as usize).min(count - 1)
    }

    fn vector(&mut self, size: f64) -> Point {
        Point::new(self.between(-size, size), self.between(-size, size))
    }

    /// A curve and the size of its data: of points, and of tangents times lengths.
    fn curve(&mut self) -> (HermiteCurve, f64) {
        let count = 2 + self.below(7);
        let closed = self.unit() < 0.5;
        let space = [Space::Trigonometric, Space::Hyperbolic, Space::Polynomial][self.below(3)];
        let segments = if closed { count } else { count - 1 };
        let scale = libm::pow(10.0, self.between(-3.0, 3.0));
        // Derivatives of cuts have to stay within the limit of 1e9.
        let size = libm::pow(10.0, self.between(-6.0, 8.0)).min(1e7 * scale);
        let lengths: Vec<f64> = (0..segments).map(|_| scale * self.between(0.3, 3.0)).collect();
        // Up to w = 5: towards 2π the basis itself grows without bound.
        let omega =
            lengths.iter().map(|length| [0.0, self.between(0.0, 5.0)][self.below(2)] / length).collect();
        let mut points: Vec<Point> = (0..count).map(|_| self.vector(size)).collect();
        if self.unit() < 0.1 {
            points[1] = points[0];
        }
        let speed = size.min(1e5) / scale;
        let mut tangents: Vec<Point> = (0..count).map(|_| self.vector(speed)).collect();
        if self.unit() < 0.2 {
            tangents[0] = Point::zeros();
        }
        let mut tangents_in = tangents.clone();
        if self.unit() < 0.5 {
            tangents_in[count - 1] = self.vector(speed);
        }
        let options =
            HermiteOptions { points, tangents, tangents_in, closed, space: Some(space), omega, lengths };
        (HermiteCurve::new(options).expect("within all limits"), size.max(3.0 * scale * speed))
    }
}

const ROUNDS: usize = 300;
/// A handful of roundings of the largest datum; up to w = 5 weights are below 1.
const SAME: f64 = 3e-15;

fn at(curve: &HermiteCurve, t: f64) -> Point {
    curve.evaluate(t, 0).expect("inside the domain")
}

/// The rounding of t itself, at the largest speed that the data allow.
fn late(curve: &HermiteCurve, size: f64) -> f64 {
    let (_, end) = curve.domain();
    let shortest = curve.lengths().iter().fold(f64::INFINITY, |least, length| least.min(*length));
    4.0 * f64::EPSILON * size * end / shortest
}

fn apart(first: &HermiteCurve, second: &HermiteCurve) -> f64 {
    let end = first.domain().1.min(second.domain().1);
    (0..=60)
        .map(|i| (end * f64::from(i) / 60.0).min(end))
        .map(|t| (at(first, t) - at(second, t)).norm())
        .fold(0.0, f64::max)
}

#[test]
fn cutting_joining_and_refining_never_move_a_curve() {
    let mut random = Random(1);
    for round in 0..ROUNDS {
        let (curve, size) = random.curve();
        let most = 4.0 * SAME * size + late(&curve, size);
        let (_, end) = curve.domain();
        let t = random.unit() * end;
        let inserted = curve.insert(t).expect("inside");
        assert!(apart(&curve, &inserted) <= most, "round {round}: inserted at {t}");
        assert_eq!(inserted.domain(), curve.domain(), "round {round}: the end is still inside");
        let refined = curve.refine(1 + random.below(5)).expect("within limits");
        assert!(apart(&curve, &refined) <= most, "round {round}: refined");
        let parts = curve.split(t).expect("inside");
        let mut start = if curve.is_closed() { t } else { 0.0 };
        for part in parts {
            for i in 0..=20 {
                let s = (part.domain().1 * f64::from(i) / 20.0).min(part.domain().1);
                let there = (start + s).min(if curve.is_closed() { f64::INFINITY } else { end });
                let error = (at(&part, s) - at(&curve, there)).norm();
                assert!(
                    error <= 2.0 * most,
                    "round {round}: split at {t}, part from {start}, {s}: {error:e}"
                );
            }
            start += part.domain().1;
        }
    }
}

#[test]
fn an_inserted_point_can_be_removed_without_a_trace() {
    let mut random = Random(2);
    for round in 0..ROUNDS {
        let (curve, size) = random.curve();
        let t = random.between(0.01, 0.99) * curve.domain().1;
        let inserted = curve.insert(t).expect("inside");
        if inserted.points().len() == curve.points().len() {
            continue;
        }
        let added = inserted.points().iter().zip(curve.points()).take_while(|(a, b)| a == b).count();
        let (restored, deviation) = inserted.remove(added).expect("points to spare");
        assert!(deviation <= 10.0 * SAME * size, "round {round}: {deviation:e} of {size:e}");
        let moved = apart(&curve, &restored);
        assert!(moved <= 10.0 * SAME * size + late(&curve, size), "round {round}: {moved:e} of {size:e}");
    }
}

#[test]
fn removing_any_point_gives_a_finite_curve_and_an_honest_deviation() {
    let mut random = Random(3);
    for round in 0..ROUNDS / 3 {
        let (curve, size) = random.curve();
        if curve.points().len() < 3 {
            continue;
        }
        let i = random.below(curve.points().len());
        let (healed, deviation) = curve.remove(i).expect("points to spare");
        assert!(deviation.is_finite(), "round {round}");
        // Every place of the old curve is as near to the new one as was said, up to the steps of this sampling.
        let near = healed.sample(4000).expect("within limits");
        let gap = near
            .windows(4)
            .step_by(2)
            .map(|pair| (pair[0] - pair[2]).hypot(pair[1] - pair[3]))
            .fold(0.0, f64::max);
        let open_end = !curve.is_closed() && (i == 0 || i + 1 == curve.points().len());
        if open_end {
            continue;
        }
        for k in 0..200 {
            let p = at(&curve, curve.domain().1 * f64::from(k) / 200.0);
            let distance =
                near.chunks_exact(2).map(|q| (q[0] - p.x).hypot(q[1] - p.y)).fold(f64::INFINITY, f64::min);
            assert!(
                distance <= 1.1 * deviation + gap + 1e-12 * size,
                "round {round}: {distance} and {deviation}"
            );
        }
    }
}

#[test]
fn affine_maps_and_curves_commute() {
    let mut random = Random(4);
    for round in 0..ROUNDS {
        let (curve, size) = random.curve();
        let [a, b, c, d] = core::array::from_fn(|_| random.between(-2.0, 2.0));
        let [e, f] = core::array::from_fn(|_| random.between(-size, size));
        let image = curve.transformed([a, b, c, d, e, f]).expect("within limits");
        for _ in 0..20 {
            let t = random.unit() * curve.domain().1;
            let p = at(&curve, t);
            let expected = Point::new(a * p.x + c * p.y + e, b * p.x + d * p.y + f);
            let error = (at(&image, t) - expected).norm();
            assert!(error <= 10.0 * SAME * size, "round {round}, t = {t}: {error:e} of {size:e}");
        }
    }
}

#[test]
fn backwards_is_the_same_curve() {
    let mut random = Random(5);
    for round in 0..ROUNDS {
        let (curve, size) = random.curve();
        let (reversed, (_, end)) = (curve.reversed(), curve.domain());
        for _ in 0..20 {
            let t = random.unit() * end;
            let error = (at(&reversed, t) - at(&curve, end - t)).norm();
            assert!(error <= SAME * size + 2.0 * late(&curve, size), "round {round}, t = {t}: {error:e}");
        }
    }
}

#[test]
fn the_image_of_a_circle_is_recognised_as_the_ellipse_that_it_is() {
    let mut random = Random(6);
    for round in 0..ROUNDS {
        let count = 2 + random.below(10);
        let circle = HermiteCurve::ellipse(Point::zeros(), Point::new(1.0, 1.0), 0.0, count).expect("valid");
        let [a, b, c, d] = core::array::from_fn(|_| random.between(-10.0, 10.0));
        // Ellipses a thousand times as long as wide are as good as lines.
        let (spread, area) = (a.hypot(b).hypot(c.hypot(d)), (a * d - b * c).abs());
        if area < 1e-2 * spread * spread {
            continue;
        }
        let center = random.vector(100.0);
        let image = circle.transformed([a, b, c, d, center.x, center.y]).expect("valid");
        let image = image.insert(random.unit() * count as f64).expect("closed curves take any t");
        let arc = image.as_ellipse(1e-9).expect("an affine image of a circle");
        assert!((arc.center - center).norm() < 1e-8, "round {round}: centre {}", arc.center);
        assert!((arc.radii.x * arc.radii.y - area).abs() < 1e-8 * spread * spread, "round {round}: area");
        assert!(arc.radii.x >= arc.radii.y * (1.0 - 1e-12), "the longer axis comes first");
        assert_eq!(arc.sweep, if a * d > b * c { TAU } else { -TAU }, "round {round}: orientation");
        for i in 0..50 {
            let p = arc.point(arc.start + arc.sweep * f64::from(i) / 50.0);
            // Its inverse image lies on the unit circle.
            let q = p - center;
            let (u, v) = ((d * q.x - c * q.y) / (a * d - b * c), (a * q.y - b * q.x) / (a * d - b * c));
            assert!((u.hypot(v) - 1.0).abs() < 1e-7, "round {round}: {u}, {v}");
        }
    }
}

#[test]
fn curves_at_the_limits_stay_finite() {
    let pole = TAU - 1e-6;
    for (space, w) in [
        (Space::Trigonometric, pole),
        (Space::Trigonometric, 0.0),
        (Space::Hyperbolic, 1e4),
        (Space::Hyperbolic, 1421.0),
        (Space::Polynomial, 1e4),
    ] {
        for (size, length) in [(1e9, 1.0), (1e9, 1e9), (1e-300, 1e-12), (0.0, 1.0)] {
            let curve = HermiteCurve::new(HermiteOptions {
                points: [1.0, -1.0, 0.5].map(|k| Point::new(k * size, -k * size)).to_vec(),
                tangents: [1.0, 0.3, -1.0].map(|k| Point::new(size, k * size)).to_vec(),
                closed: true,
                space: Some(space),
                omega: vec![w / length],
                lengths: vec![length; 3],
                ..HermiteOptions::default()
            })
            .expect("the limits belong to the domain");
            let finite = |values: &[f64]| values.iter().all(|value| value.is_finite());
            for count in [1, 7, 100] {
                assert!(finite(&curve.sample(count).expect("few")), "{space:?}, w = {w}, size {size}");
            }
            assert!(finite(&curve.bezier_points()), "{space:?}, w = {w}, size {size}");
            for edited in
                [curve.refine(2), curve.insert(0.3 * length), curve.remove(1).map(|(curve, _)| curve)]
            {
                match edited {
                    Ok(edited) => {
                        assert!(finite(&edited.sample(10).expect("few")), "{space:?}, w = {w}, size {size}")
                    }
                    Err(error) => {
                        assert!(
                            ["E_RANGE", "E_DEGENERATE"].contains(&error.code()),
                            "{space:?}, w = {w}: {error}"
                        );
                    }
                }
            }
        }
    }
}
