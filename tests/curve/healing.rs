//! Promises about a removed point: no other speeds at the ends of what heals the gap leave the shape much nearer.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::curves::Random;
use core::f64::consts::PI;
use expline::curve::{NearestFinder, Side};
use expline::{Curve, HermiteCurve, HermiteOptions, Space};
use nalgebra::Vector2;

type Point = Vector2<f64>;

/// Places at which two curves are compared, and a multiple of it: chords of the one that they are compared with.
const PLACES: usize = 40;
const CHORDS: usize = 4 * PLACES;

fn sampled(curve: &HermiteCurve, count: usize) -> Vec<Point> {
    let numbers = curve.sample(count + 1).expect("few enough");
    numbers.chunks_exact(2).map(|pair| Point::new(pair[0], pair[1])).collect()
}

fn distance(point: Point, way: &[Point]) -> f64 {
    let to = |chord: &[Point]| {
        let along = chord[1] - chord[0];
        let part = (point - chord[0]).dot(&along) / along.norm_squared().max(f64::MIN_POSITIVE);
        (point - chord[0] - along * part.clamp(0.0, 1.0)).norm_squared()
    };
    way.windows(2).map(to).fold(f64::INFINITY, f64::min).sqrt()
}

/// The larger of both directed distances, by chords.
fn apart(one: &[Point], other: &[Point]) -> f64 {
    let directed = |from: &[Point], to: &[Point]| {
        from.iter().step_by(CHORDS / PLACES).map(|&point| distance(point, to)).fold(0.0, f64::max)
    };
    directed(one, other).max(directed(other, one))
}

/// How much a polyline turns, to and fro.
fn turning(way: &[Point]) -> f64 {
    let chords: Vec<Point> =
        way.windows(2).map(|pair| pair[1] - pair[0]).filter(|chord| chord.norm() > 0.0).collect();
    chords.windows(2).map(|pair| pair[0].perp(&pair[1]).atan2(pair[0].dot(&pair[1])).abs()).sum()
}

/// How near any speeds at the ends of the healed curve bring it to the old one without a loop: a lattice of speeds, and
/// on from its best.
fn least_apart(old: &HermiteCurve, healed: &HermiteCurve) -> f64 {
    let way = sampled(old, CHORDS);
    let size: f64 = way.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum();
    let (out, inn) = (healed.tangents()[0].normalize(), healed.tangents_in()[1].normalize());
    let cost = |[a, b]: [f64; 2]| {
        // Handles of less than a thirtieth of the length are as good as none.
        if a.min(b).exp() < 0.1 {
            return f64::INFINITY;
        }
        let turned = healed.with_tangent(0, out * (a.exp() * size / healed.domain().1), Side::Out);
        let turned = turned
            .and_then(|turned| turned.with_tangent(1, inn * (b.exp() * size / healed.domain().1), Side::In));
        let new = sampled(&turned.expect("finite"), CHORDS);
        if turning(&new) > turning(&way) + 0.9 { f64::INFINITY } else { apart(&way, &new) }
    };
    let lattice = (0..121).map(|k| [f64::from(k % 11) * 0.45 - 3.0, f64::from(k / 11) * 0.45 - 3.0]);
    let (mut best, mut at) = (f64::INFINITY, [0.0; 2]);
    for speeds in lattice {
        let there = cost(speeds);
        if there < best {
            (best, at) = (there, speeds);
        }
    }
    let mut step = 0.25;
    while step > 0.004 {
        let around = (0..8)
            .map(|k| f64::from(k) * 0.25 * PI)
            .map(|turn| [at[0] + step * turn.cos(), at[1] + step * turn.sin()]);
        let better = around.map(|speeds| (cost(speeds), speeds)).find(|(there, _)| *there < best);
        match better {
            Some((there, speeds)) => (best, at) = (there, speeds),
            None => step *= 0.5,
        }
    }
    best
}

/// Two segments whose tangents in the middle make an angle.
fn bend(random: &mut Random, space: Space, angle: f64, handles: f64) -> HermiteCurve {
    let points = vec![
        Point::zeros(),
        Point::new(1.0, 0.3 * random.symmetric()),
        Point::new(1.0, 0.0) + random.vector(0.9),
    ];
    let ways = [points[1] - points[0], points[2] - points[1]];
    let turned = |way: Point, by: f64| {
        Point::new(way.x * by.cos() - way.y * by.sin(), way.x * by.sin() + way.y * by.cos())
    };
    let mut speed = || handles * (1.0 + 0.6 * random.symmetric());
    let middle = turned(ways[0] + ways[1], 0.2).normalize();
    HermiteCurve::new(HermiteOptions {
        tangents: vec![
            turned(ways[0], 0.5) * speed(),
            turned(middle, 0.5 * angle) * ways[1].norm() * speed(),
            ways[1] * speed(),
        ],
        tangents_in: vec![
            Point::zeros(),
            turned(middle, -0.5 * angle) * ways[0].norm() * speed(),
            turned(ways[1], 0.7) * speed(),
        ],
        points,
        closed: false,
        space: Some(space),
        omega: vec![if space == Space::Polynomial { 0.0 } else { 1.2 }],
        ..HermiteOptions::default()
    })
    .expect("in range")
}

#[test]
fn no_other_speeds_at_its_ends_would_heal_a_gap_much_better() {
    let mut random = Random::new(29);
    let mut healable = 0;
    for case in 0..72 {
        let space = [Space::Polynomial, Space::Trigonometric, Space::Hyperbolic][case % 3];
        let angle = [0.0, 0.0, 0.3, 1.0, 1.6, 2.4][case / 3 % 6];
        let handles = [0.5, 1.0, 1.6, 1.0][case / 18];
        let old = bend(&mut random, space, angle, handles);
        let (healed, deviation) = old.remove(1).expect("three points");
        let way: f64 = sampled(&old, CHORDS).windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum();
        for tangent in [healed.tangents()[0], healed.tangents_in()[1]] {
            // Chords between 48 places are a little shorter than these; handles that were as short may stay.
            let speed = tangent.norm() * healed.domain().1 / way;
            assert!(speed > 0.095 || handles < 1.0, "case {case}: a handle that is as good as none, {speed}");
        }
        let least = least_apart(&old, &healed);
        // Where nothing comes near, as around a hairpin, what is nearest is a matter of taste.
        if least < 0.1 {
            healable += 1;
            // The least sum of eighth powers over 48 places: its largest is at most 48^(1/8) = 1.62 times the least of
            // all.
            assert!(deviation <= 1.62 * least, "case {case}: {deviation}, and {least} with other speeds");
        }
    }
    assert!(healable > 24, "{healable} of 72 can be healed");
}

#[test]
fn a_corner_that_is_removed_stays_nearly_where_it_was() {
    for angle in [0.3_f64, 0.25 * PI, 0.5 * PI, 0.75 * PI] {
        for second in [1.0, 0.5, 0.2] {
            let points = vec![
                Point::zeros(),
                Point::new(1.0, 0.0),
                Point::new(1.0, 0.0) + Point::new(angle.cos(), angle.sin()) * second,
            ];
            let ways = [points[1] - points[0], points[2] - points[1]];
            let old = HermiteCurve::new(HermiteOptions {
                tangents: vec![ways[0], ways[1], ways[1]],
                tangents_in: vec![ways[0], ways[0], ways[1]],
                points,
                closed: false,
                space: Some(Space::Polynomial),
                ..HermiteOptions::default()
            })
            .expect("in range");
            let (healed, deviation) = old.remove(1).expect("three points");
            // Handles of the legs' own length, which end at the corner, pass it at an eighth of their sum.
            let by_the_legs = 0.125 * (ways[1] - ways[0]).norm();
            assert!(deviation < by_the_legs, "{angle}, {second}: {deviation} for {by_the_legs}");
            let way = sampled(&healed, 1000);
            assert!(turning(&way) < angle + 1.1, "{angle}, {second}: no loop, but {}", turning(&way));
        }
    }
}

#[test]
fn a_tiny_segment_beside_a_long_one_goes_without_a_trace() {
    // Of a logo: the end of the long one hardly matters, so steps from the best pair of speeds once grew it into a
    // loop, and what came instead was twelve times as far away.
    let tiny = Point::new(0.016, -0.03);
    let old = HermiteCurve::new(HermiteOptions {
        points: vec![Point::new(7.742, 14.76), Point::new(7.758, 14.73), Point::new(17.013, 17.686)],
        tangents: vec![tiny, Point::new(9.255, 2.956), Point::new(9.255, 2.956)],
        tangents_in: vec![tiny, tiny, Point::new(9.255, 2.956)],
        closed: false,
        space: Some(Space::Polynomial),
        ..HermiteOptions::default()
    })
    .expect("in range");
    let (healed, deviation) = old.remove(1).expect("three points");
    // The least handle, a thirtieth of 9.75, leads off the old way at an angle of 100°; the curve has turned by about
    // 4/9 of it.
    assert!(deviation < 4.0 / 9.0 * 9.75 / 30.0, "{deviation}");
    assert!(turning(&sampled(&healed, 1000)) < 2.0, "no loop");
}

/// One cubic with a point more, inserted at t and moved to the right by so much, and how far the curve is from that
/// without it.
fn gone_again(ends: [Point; 2], tangents: [Point; 2], t: f64, moved: f64) -> f64 {
    let options = HermiteOptions {
        points: ends.to_vec(),
        tangents: tangents.to_vec(),
        tangents_in: tangents.to_vec(),
        closed: false,
        space: Some(Space::Polynomial),
        ..HermiteOptions::default()
    };
    let curve = HermiteCurve::new(options).and_then(|curve| curve.insert(t)).expect("in range");
    let curve = curve.with_point(1, curve.points()[1] + Point::new(moved, 0.0)).expect("in range");
    curve.remove(1).expect("three points").1
}

#[test]
fn an_inserted_point_goes_without_a_trace_also_beside_a_sharp_bend_and_far_from_the_origin() {
    // A bend that the chords of two segments show and those of one cut off, so that the old curve itself seemed to turn
    // too much: what came instead was a thousandth of the way farther.
    let ends =
        [Point::new(-10.301112818, 0.042129198590161954), Point::new(0.194157092, -0.9161077671418427)];
    let tangents = [
        Point::new(-1.547310756450926, -2.898871357105918),
        Point::new(-2.160832571744362, 0.4083312533071899),
    ];
    for far in [0.0, 1e5, 1e7] {
        let deviation = gone_again(ends.map(|end| end + Point::new(far, 0.0)), tangents, 0.895, 0.0);
        // A few roundings of the coordinates.
        assert!(deviation <= 1e-15 * (far + 10.0) * 4.0, "{far}: {deviation:e}");
    }
}

#[test]
fn an_inserted_point_goes_without_a_trace_between_points_with_hardly_any_handles_far_from_the_origin() {
    // Roundings of the coordinates were taken for a change of the curve, and what was measured then was how badly the
    // foot of a perpendicular is found where a curve hardly moves: up to 2e-4 of the size.
    let mut random = Random::new(50);
    for case in 0..200 {
        let far = random.vector(1e5);
        let ends = [random.vector(10.0) + far, random.vector(10.0) + far];
        let tangents = [random.vector(0.1), random.vector(0.1)];
        let deviation = gone_again(ends, tangents, random.unit(), 0.0);
        assert!(deviation <= 1e-15 * 1e5 * 4.0, "case {case}: {deviation:e}");
    }
}

/// The largest distance of many places on one curve from the other one.
fn farthest(from: &HermiteCurve, to: &HermiteCurve) -> f64 {
    let finder = NearestFinder::new(to);
    sampled(from, 1000).iter().map(|&place| finder.nearest(place).distance).fold(0.0, f64::max)
}

#[test]
fn what_a_removal_moves_is_no_less_than_it_is_where_it_is_farthest_between_two_places() {
    // Only from places that were farther than all before them was there a look uphill: of two hills the second one may
    // be higher, and its places lower.
    let mut random = Random::new(51);
    for case in 0..300 {
        let mut vectors = || (0..3).map(|_| random.vector(10.0)).collect::<Vec<Point>>();
        let (points, tangents, tangents_in) = (vectors(), vectors(), vectors());
        let lengths: Vec<f64> = (0..2).map(|_| libm::pow(10.0, 0.7 * random.symmetric())).collect();
        let omega: Vec<f64> = lengths.iter().map(|length| 3.0 * random.unit() / length).collect();
        let space = [Space::Polynomial, Space::Trigonometric, Space::Hyperbolic][case % 3];
        let options = HermiteOptions {
            points,
            tangents,
            tangents_in,
            lengths,
            omega,
            closed: false,
            space: Some(space),
        };
        let old = HermiteCurve::new(options).expect("in range");
        let (new, deviation) = old.remove(1).expect("three points");
        let apart = farthest(&old, &new).max(farthest(&new, &old));
        // Uphill it is looked to a millionth of a segment.
        let way = old.length(0.1).expect("in range");
        assert!(apart <= deviation + 1e-5 * way, "case {case}: {deviation} instead of {apart} of {way}");
    }
}

#[test]
fn beside_a_point_without_a_handle_a_removal_is_measured_as_what_it_is() {
    // The foot of the perpendicular was looked for from the cusp itself, where there is no step: it stayed there.
    for (t, handle) in [(0.05, 6.0), (0.1, 40.0), (0.3, 24.0)] {
        let ends = [Point::zeros(), Point::new(1.0, 0.0)];
        let deviation = gone_again(ends, [Point::zeros(), Point::new(3.0, handle)], t, 1e-6);
        // The old curve before the point was moved is one of those that are looked at.
        assert!(deviation <= 1.001e-6, "{t}, {handle}: {deviation:e}");
    }
}

/// Two segments as an hour of dragging leaves them: handles of any length and direction, one segment far shorter than
/// the other.
fn dragged(random: &mut Random, space: Space) -> HermiteCurve {
    let points: Vec<Point> = (0..3).map(|_| random.vector(50.0)).collect();
    let lengths: Vec<f64> = (0..2).map(|_| libm::pow(10.0, random.symmetric() - 1.0)).collect();
    let mut speed = || libm::pow(10.0, 3.0 + random.symmetric());
    let speeds = [(); 6].map(|()| speed());
    let mut tangents: Vec<Point> = speeds.iter().map(|&speed| random.vector(speed)).collect();
    let tangents_in = tangents.split_off(3);
    let omega = vec![if space == Space::Polynomial { 0.0 } else { 1.0 }];
    let options =
        HermiteOptions { points, tangents, tangents_in, closed: false, space: Some(space), omega, lengths };
    HermiteCurve::new(options).expect("in range")
}

#[test]
fn a_removed_point_takes_no_place_farther_than_a_straight_line_would() {
    let mut random = Random::new(31);
    for case in 0..240 {
        let old =
            dragged(&mut random, [Space::Polynomial, Space::Trigonometric, Space::Hyperbolic][case % 3]);
        let removed = old.remove(1);
        assert!(removed.is_ok(), "case {case}: {:?}", removed.err());
        let (_, deviation) = removed.expect("three points");
        let way: f64 = sampled(&old, 4 * CHORDS).windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum();
        // Every place is within half of the way of an end; a line with the shortest handles, a tenth of the way for
        // each unit, leaves its chord by 4/27 of that at each end.
        let most = (0.5 + 2.0 * 0.1 * 4.0 / 27.0) * way;
        assert!(deviation <= most, "case {case}: {deviation} of a way of {way}");
    }
}
