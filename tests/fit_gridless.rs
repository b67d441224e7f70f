//! Knots off the grid: the optimum of the continuous problem, certified on the continuum.
#![cfg(not(target_arch = "wasm32"))]

mod support;

use expline::fit::gridless::gridless;
use expline::fit::{Problem, Settings, Solver};
use expline::numerics::Point;
use serde::Deserialize;
use support::golden;

#[derive(Deserialize)]
struct Continuous {
    name: String,
    source: String,
    closed: bool,
    degree: usize,
    lam: f64,
    upper: f64,
    lower: f64,
    knots: Vec<f64>,
}

#[derive(Deserialize)]
struct Grid {
    sets: std::collections::BTreeMap<String, Vec<f64>>,
}

fn points(name: &str) -> Vec<Point> {
    let grid: Grid = golden::parse(include_str!("golden/sparse/grid.json"));
    grid.sets[name].chunks_exact(2).map(|p| Point::new(p[0], p[1])).collect()
}

#[test]
fn three_slides_certify_the_continuous_optimum() {
    let cases: Vec<Continuous> = golden::parse(include_str!("golden/sparse/continuous.json"));
    assert_eq!(cases.len(), 4, "all problems are there");
    for case in cases {
        let points = points(&case.source);
        let steps = if case.closed { points.len() } else { points.len() - 1 };
        let problem = Problem::of_points(&points, case.closed, &[(case.degree, case.lam, steps)])
            .expect("the problem is fine");
        let settings = Settings { gap: 1e-8, most_iterations: 200 };
        let mut solver = Solver::new(&problem, settings).expect("the problem is fine");
        solver.run().expect("there is memory");
        let solution = solver.solution().expect("there is memory");
        let found = gridless(&problem, &solution, 1e-4, 3).expect("the problem is fine");
        assert!(found.gap <= 1e-4, "{}: gap {:e} after {} slides", case.name, found.gap, found.slides);
        let bound = case.upper * (1.0 + 1e-4);
        assert!(found.solution.objective <= bound, "{}: {}", case.name, found.solution.objective);
        // Nothing is better than the certified bound of the reference.
        let least = case.lower * (1.0 - 1e-9);
        assert!(found.solution.objective >= least, "{}: {}", case.name, found.solution.objective);
        let (got, expected) = (found.solution.knot_count(), case.knots.len());
        assert!(got.abs_diff(expected) <= 1, "{}: {got} knots for {expected}", case.name);
    }
}
