//! A Hermite curve whose pieces are written as polynomials must measure the same as by its closed forms; lifted into
//! space, as in the plane.

use super::Pieces;
use crate::curve::{Curve, HermiteOptions};
use crate::error::Result;
use crate::numerics::{Point, Vector};
use crate::{HermiteCurve, Space};

/// Taylor coefficients of the pieces of a Hermite curve, turned into space where `lifted`.
struct Expanded {
    curve: HermiteCurve,
    lifted: bool,
}

/// Two unit vectors of space at right angles.
const FRAME: [[f64; 3]; 2] = [[0.6, 0.48, 0.64], [-0.8, 0.36, 0.48]];

impl Expanded {
    fn lift(&self, v: Vector) -> Vec<f64> {
        if self.lifted {
            (0..3).map(|axis| v.x * FRAME[0][axis] + v.y * FRAME[1][axis]).collect()
        } else {
            vec![v.x, v.y]
        }
    }
}

impl Pieces for Expanded {
    fn coordinate_count(&self) -> usize {
        if self.lifted { 3 } else { 2 }
    }

    fn closed(&self) -> bool {
        self.curve.is_closed()
    }

    fn piece_count(&self) -> usize {
        self.curve.segment_count()
    }

    fn knot(&self, i: usize) -> f64 {
        self.curve.knots()[i]
    }

    fn coefficients(&self, i: usize, out: &mut Vec<f64>) {
        let jet = self.curve.piece(i).jet(0.0);
        let square = self.curve.piece(i).rate();
        let (mut even, mut odd) = (jet.second, jet.third);
        out.extend(self.lift(jet.position));
        out.extend(self.lift(jet.first));
        let mut factorial = 1.0;
        for k in 2..30 {
            factorial *= f64::from(k);
            let derivative = if k % 2 == 0 { &mut even } else { &mut odd };
            out.extend(self.lift(*derivative / factorial));
            *derivative *= -square;
        }
    }

    fn values(&self, t: &[f64], derivative: usize, out: &mut [f64]) -> Result<()> {
        for (&t, out) in t.iter().zip(out.chunks_exact_mut(self.coordinate_count())) {
            out.copy_from_slice(&self.lift(self.curve.evaluate(t, derivative)?));
        }
        Ok(())
    }

    fn find(&self, t: f64) -> Result<(usize, f64)> {
        self.curve.locate(t)
    }

    fn start(&self, i: usize) -> Point {
        self.curve.start(i)
    }
}

impl Curve for Expanded {
    fn as_pieces(&self) -> &dyn Pieces {
        self
    }
}

/// A closed curve with corners, turns and inflections, and its two expansions.
fn family(space: Space, omega: f64) -> (HermiteCurve, Expanded, Expanded) {
    let at = |k: usize| k as f64 * 1.3;
    let points = (0..7).map(|k| Point::new(30.0 * libm::cos(at(k)), 20.0 * libm::sin(0.9 * at(k)))).collect();
    let tangents =
        (0..7).map(|k| Vector::new(17.0 * libm::sin(3.0 * at(k)), -25.0 * libm::cos(at(k)))).collect();
    let options = HermiteOptions {
        points,
        tangents,
        closed: true,
        space: Some(space),
        omega: vec![omega],
        ..HermiteOptions::default()
    };
    let curve = HermiteCurve::new(options).expect("a curve");
    let expanded = |lifted| Expanded { curve: curve.clone(), lifted };
    (curve.clone(), expanded(false), expanded(true))
}

fn families() -> [(HermiteCurve, Expanded, Expanded); 4] {
    [
        family(Space::Trigonometric, 1.1),
        family(Space::Trigonometric, 2.9),
        family(Space::Hyperbolic, 2.0),
        family(Space::Polynomial, 0.0),
    ]
}

#[test]
fn polynomial_pieces_have_the_lengths_areas_and_boxes_of_closed_forms() {
    for (curve, plane, space) in families() {
        let length = curve.length(1e-11).expect("a length");
        for other in [&plane as &dyn Curve, &space] {
            assert!((other.length(1e-11).expect("a length") - length).abs() < 1e-10);
            let (one, two) = (0.37 * length, 1e-9);
            let at = |c: &dyn Curve| c.parameter_at_length(one, two).expect("a parameter");
            assert!((at(other) - at(&curve)).abs() < 1e-9);
            let spread = other.sample_by_length(50, 1e-8).expect("parameters");
            let truth = curve.sample_by_length(50, 1e-8).expect("parameters");
            // Where a curve is slow, a small length is a long way in the parameter.
            for (a, b) in spread.iter().zip(&truth) {
                let apart = curve.evaluate(*a, 0).expect("a point") - curve.evaluate(*b, 0).expect("a point");
                assert!(apart.norm() < 3e-8, "{a} {b}");
            }
        }
        assert!((plane.area().expect("an area") - curve.area().expect("an area")).abs() < 1e-10);
        assert!((plane.centroid().expect("it") - curve.centroid().expect("it")).norm() < 1e-11);
        assert!(space.area().is_err() && space.centroid().is_err());
        let (one, two) = (curve.bounds(), plane.bounds());
        for (a, b) in
            [(one.min_x, two.min_x), (one.max_x, two.max_x), (one.min_y, two.min_y), (one.max_y, two.max_y)]
        {
            assert!((a - b).abs() < 1e-12);
        }
    }
}

#[test]
fn boxes_in_space_are_those_of_dense_samples() {
    for (curve, _, space) in families() {
        let bounds = space.bounds();
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for k in 0..70_000 {
            let point = space.lift(curve.evaluate(f64::from(k) * 1e-4, 0).expect("a point"));
            for axis in 0..3 {
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
        }
        let found = [bounds.min_x, bounds.min_y, bounds.min_z];
        let top = [bounds.max_x, bounds.max_y, bounds.max_z];
        for axis in 0..3 {
            assert!(found[axis] <= low[axis] + 1e-12 && found[axis] > low[axis] - 1e-5);
            assert!(top[axis] >= high[axis] - 1e-12 && top[axis] < high[axis] + 1e-5);
        }
    }
}

#[test]
fn the_nearest_points_and_curvatures_are_the_same() {
    for (curve, plane, space) in families() {
        for k in 0..400 {
            let place = Point::new(f64::from(k % 20) * 5.0 - 50.0, f64::from(k / 20) * 5.0 - 50.0);
            let truth = curve.nearest(place).distance;
            assert!((plane.nearest(place).distance - truth).abs() < 1e-11);
            let lifted = space.lift(place);
            let found = space.nearest_in_space([lifted[0], lifted[1], lifted[2]]);
            assert!((found.distance - truth).abs() < 1e-11, "{place} {truth} {found:?}");
            let t = f64::from(k) * 0.017;
            let bend = curve.curvature(t).expect("in the domain").expect("moving");
            let same = |other: f64, truth: f64| (other - truth).abs() <= 1e-9 * (1.0 + truth.abs());
            assert!(same(plane.curvature(t).expect("in the domain").expect("moving"), bend));
            assert!(same(space.curvature(t).expect("in the domain").expect("moving"), bend.abs()));
        }
    }
}

/// The largest distance of the curve at dense parameters to a polyline in space or plane.
fn farthest(points: &[Vec<f64>], polyline: &[Vec<f64>]) -> f64 {
    let mut worst = 0.0_f64;
    for p in points {
        let mut least = f64::INFINITY;
        for pair in polyline.windows(2) {
            let [mut along, mut square, mut off] = [0.0; 3];
            for axis in 0..p.len() {
                let chord = pair[1][axis] - pair[0][axis];
                along += (p[axis] - pair[0][axis]) * chord;
                square += chord * chord;
            }
            let share = if square > 0.0 { (along / square).clamp(0.0, 1.0) } else { 0.0 };
            for axis in 0..p.len() {
                let foot = pair[0][axis] + share * (pair[1][axis] - pair[0][axis]);
                off += (p[axis] - foot) * (p[axis] - foot);
            }
            least = least.min(off);
        }
        worst = worst.max(least.sqrt());
    }
    worst
}

#[test]
fn polylines_and_cubics_of_polynomial_pieces_stay_within_their_proved_distance() {
    for (curve, plane, space) in families() {
        let dense: Vec<Vector> =
            (0..700).map(|k| curve.evaluate(f64::from(k) * 1e-2, 0).expect("a point")).collect();
        for other in [&plane, &space] {
            let truth: Vec<Vec<f64>> = dense.iter().map(|v| other.lift(*v)).collect();
            let dimension = other.dimension();
            let (line, proved) = other.flatten(0.05).expect("a polyline");
            let mut line: Vec<Vec<f64>> = line.chunks_exact(dimension).map(<[f64]>::to_vec).collect();
            line.push(line[0].clone());
            assert!(proved <= 0.05 && farthest(&truth, &line) <= proved);
            let cubics = other.to_cubics(0.01).expect("cubics");
            assert!(cubics.deviation <= 0.01);
            let mut fine = Vec::new();
            for cubic in cubics.path.chunks_exact(4 * dimension) {
                for k in 0..400 {
                    let s = f64::from(k) / 400.0;
                    let weights = [
                        (1.0 - s).powi(3),
                        3.0 * s * (1.0 - s) * (1.0 - s),
                        3.0 * s * s * (1.0 - s),
                        s * s * s,
                    ];
                    fine.push(
                        (0..dimension)
                            .map(|axis| (0..4).map(|j| weights[j] * cubic[dimension * j + axis]).sum())
                            .collect::<Vec<f64>>(),
                    );
                }
            }
            fine.push(fine[0].clone());
            assert!(farthest(&truth, &fine) <= cubics.deviation + 1e-4);
        }
        let (one, two) = (curve.to_cubics(0.01).expect("cubics"), plane.to_cubics(0.01).expect("cubics"));
        assert!(two.path.len() <= one.path.len() + 8, "{} {}", one.path.len(), two.path.len());
    }
}
