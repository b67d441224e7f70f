//! Tubes by a walk from disc to disc: what it finds where it works, and that it never runs on.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use expline::numerics::Point;
use expline::trace::{Chain, DiscEnd, DiscRule, DiscTube};

fn covered(tubes: &[DiscTube]) -> usize {
    let mut all: Vec<usize> = tubes.iter().flat_map(|tube| tube.points.iter().copied()).collect();
    let count = all.len();
    all.sort_unstable();
    all.dedup();
    assert_eq!(all.len(), count, "no point belongs to two tubes");
    count
}

fn circle(radius: f64, count: usize) -> Chain {
    let angle = |i: usize| i as f64 / count as f64 * core::f64::consts::TAU;
    let place = |i: usize| Point::new(60.0 + radius * angle(i).cos(), 60.0 + radius * angle(i).sin());
    Chain::new((0..count).map(place).collect(), true).expect("a chain")
}

#[test]
fn a_circle_is_walked_round_once() {
    let chain = circle(40.0, 250);
    let rule = chain.discs(50_f64.to_radians()).expect("there is room");
    assert!(rule.smoothing < rule.step, "{rule:?}");
    let tubes = chain.walk_in_discs(0, &rule).expect("valid");
    assert_eq!(covered(&tubes), 250, "every point");
    assert_eq!(tubes.last().map(|tube| tube.end), Some(DiscEnd::Loop));
    assert!((6..=12).contains(&tubes.len()), "a full turn by 50 degrees: {}", tubes.len());
    assert!(tubes.iter().all(|tube| tube.is_graph(&chain)));
    for pair in tubes.windows(2) {
        assert_eq!(pair[0].ends[1], pair[1].ends[0], "neighbours share an end");
    }
}

#[test]
fn an_open_line_is_walked_both_ways() {
    let points = (0..100).map(|i| Point::new(f64::from(i), 8.0 * (f64::from(i) / 20.0).sin())).collect();
    let chain = Chain::new(points, false).expect("a chain");
    let rule = DiscRule { step: 6.0, smoothing: 2.0, angle: 0.9 };
    for start in [0, 50, 99] {
        let tubes = chain.walk_in_discs(start, &rule).expect("valid");
        assert!(covered(&tubes) >= 97, "start {start}: {}", covered(&tubes));
        assert!(tubes.iter().all(|tube| tube.end != DiscEnd::Loop));
    }
}

#[test]
fn strands_that_are_near_leave_no_radius_and_are_jumped_between() {
    // There and back, two pixels apart.
    let mut points: Vec<Point> = (0..60).map(|i| Point::new(f64::from(i), 0.0)).collect();
    points.extend((0..60).map(|i| Point::new(f64::from(59 - i), 2.0)));
    let chain = Chain::new(points, true).expect("a chain");
    assert_eq!(chain.discs(0.9), None, "no radius is safe");
    let tubes = chain.walk_in_discs(0, &DiscRule { step: 6.0, smoothing: 2.0, angle: 0.9 }).expect("valid");
    // Both strands are in the same discs: the two sides are one tube, and no graph.
    assert!(
        tubes.iter().any(|tube| tube.points.iter().any(|&i| i < 60) && tube.points.iter().any(|&i| i >= 60))
    );
}

#[test]
fn walks_end_whatever_they_are_asked() {
    for count in [2, 3, 5, 40] {
        let chain = circle(3.0, count);
        for step in [0.01, 1.0, 100.0] {
            let rule = DiscRule { step, smoothing: 0.5 * step, angle: 0.06 };
            let tubes = chain.walk_in_discs(count - 1, &rule).expect("valid");
            assert!(
                covered(&tubes) <= count && tubes.len() <= 2 * count + 2,
                "{count} {step}: {}",
                tubes.len()
            );
        }
    }
    let chain = circle(3.0, 12);
    let rule = DiscRule { step: 2.0, smoothing: 1.0, angle: 0.9 };
    let refused = |start: usize, rule: DiscRule| {
        chain.walk_in_discs(start, &rule).expect_err("refused").argument().map(str::to_owned)
    };
    assert_eq!(refused(12, rule).as_deref(), Some("start"));
    assert_eq!(refused(0, DiscRule { step: f64::NAN, ..rule }).as_deref(), Some("step"));
    assert_eq!(refused(0, DiscRule { smoothing: 3.0, ..rule }).as_deref(), Some("smoothing"));
    assert_eq!(refused(0, DiscRule { angle: 2.0, ..rule }).as_deref(), Some("angle"));
}
