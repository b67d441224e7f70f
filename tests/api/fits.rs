//! Nothing in the interface of fits, traces and their measures panics or runs on, whatever it is given: numbers of any
//! kind, lists that do not go together, results that somebody has changed.
#![cfg(not(target_arch = "wasm32"))]

use std::hint::black_box;
use std::panic::{AssertUnwindSafe, catch_unwind};

use expline::fit::certificate::verify;
use expline::fit::{Ask, Fitter, Options, Parametrisation, Problem, Samples, Settings, Solver, fit};
use expline::fit::{detail_of_lambda, lambda_max, lambda_of_detail, parametrise, uniform_grid};
use expline::numerics::{Point, Vector};
use expline::trace::{BlockScan, Census, Chain, DiscEnd, DiscTube, EdgeOptions, Gray, Knots, Method};
use expline::trace::{Joint, ProfileOptions, Rule, Tube, TubeFit, edges, fit_tube, profiles};

const NUMBERS: [f64; 12] =
    [f64::NAN, f64::INFINITY, -f64::INFINITY, 0.0, -0.0, 5e-324, 1e-60, 0.4, 3.0, 1e9, -1e10, f64::MAX];
const COUNTS: [usize; 10] = [0, 1, 2, 3, 5, 64, u32::MAX as usize, 1 << 53, isize::MAX as usize, usize::MAX];

/// Calls that panicked, by name.
#[derive(Default)]
struct Panics(Vec<&'static str>);

impl Panics {
    fn none<T>(&mut self, call: &'static str, of: impl FnOnce() -> T) -> Option<T> {
        let answer = catch_unwind(AssertUnwindSafe(|| black_box(of()))).ok();
        if answer.is_none() {
            self.0.push(call);
        }
        answer
    }

    fn check(mut self) {
        self.0.dedup();
        assert!(self.0.is_empty(), "these panicked: {:?}", self.0);
    }
}

/// Points of a bent line.
fn bent() -> Vec<Point> {
    (0..24_i32).map(|i| Point::new(f64::from(i), f64::from((i - 9).abs()))).collect()
}

#[test]
fn fits_take_any_number() {
    let mut panics = Panics::default();
    let points = bent();
    for x in NUMBERS {
        for ask in [
            Ask::Lambda(vec![x]),
            Ask::Lambda(vec![x, 1.0]),
            Ask::Smoothing(x),
            Ask::Tolerance(x),
            Ask::MeanSquare(x),
        ] {
            panics.none("fit", || fit(&points, ask.clone(), &Options::default()).is_ok());
        }
        let mut wild = points.clone();
        wild[7].y = x;
        panics.none("fit of wild points", || fit(&wild, Ask::Noise, &Options::default()).is_ok());
        let each = |change: &dyn Fn(&mut Options)| {
            let mut options = Options { most_iterations: Some(9), ..Options::default() };
            change(&mut options);
            options
        };
        for options in [
            each(&|o| o.parameters = vec![x; 24]),
            each(&|o| o.weights = vec![x; 24]),
            each(&|o| (o.mix, o.gap) = (x, x)),
            each(&|o| (o.noise, o.period) = (Some(x), Some(x))),
            each(&|o| o.least_turn = x),
        ] {
            panics.none("fit with options", || fit(&points, Ask::Smoothing(0.5), &options).is_ok());
        }
        panics.none("Fitter::step", || {
            let mut fitter = Fitter::new(&points, &Options::default())?;
            fitter.ask(Ask::Smoothing(0.4))?;
            fitter.step(x)?;
            fitter.fit()
        });
    }
    for count in COUNTS {
        let options = Options { degrees: vec![count], grid_size: Some(count), ..Options::default() };
        panics.none("fit on a grid", || fit(&points, Ask::Smoothing(0.5), &options).is_ok());
    }
    panics.check();
}

#[test]
fn problems_take_any_number_and_answer_soon() {
    let mut panics = Panics::default();
    let points: Vec<Vector> = bent();
    for degree in COUNTS {
        for size in COUNTS {
            panics.none("of_points", || Problem::of_points(&points, true, &[(degree, 1.0, size)]).is_ok());
        }
        panics.none("uniform_grid", || uniform_grid(degree, 9, 0.0, 5.0, true));
        let problem = Problem::of_points(&points, false, &[(1, 1.0, 24)]).expect("a problem");
        for x in NUMBERS {
            panics.none("lambda_of_detail", || lambda_of_detail(&problem, degree, x));
            panics.none("detail_of_lambda", || detail_of_lambda(&problem, degree, x));
        }
    }
    for x in NUMBERS {
        let problem = Problem::of_points(&points, false, &[(1, x, 24)]).ok();
        panics.none("lambda_max", || problem.as_ref().map(|problem| lambda_max(problem).is_ok()));
    }
    panics.check();
}

#[test]
fn a_solution_that_was_changed_is_refused_by_name() {
    let mut panics = Panics::default();
    for closed in [false, true] {
        let problem = Problem::of_points(&bent(), closed, &[(3, 0.5, 24)]).expect("a problem");
        let mut solver = Solver::new(&problem, Settings::default()).expect("a problem");
        solver.run().expect("memory");
        let solution = solver.solution().expect("memory");
        assert!(verify(&problem, &solution).is_ok() && solution.knot_count() > 1, "as it is");
        let mut wild = vec![solution.clone(); 6];
        wild[0].components[0].coefficients.pop();
        wild[1].components[0].knots.pop();
        wild[2].components[0].jumps.clear();
        wild[3].components[0].degree = usize::MAX;
        wild[4].components.clear();
        wild[5].domain.1 += 1.0;
        for (i, wild) in wild.iter().enumerate() {
            let refused = panics.none("verify", || verify(&problem, wild).is_err());
            assert_eq!(refused, Some(true), "change {i} goes unseen");
            let evaluated = panics.none("evaluate", || wild.evaluate(&[0.5, f64::NAN], 1).is_err());
            assert_eq!(evaluated, Some(i < 4), "change {i}");
        }
    }
    panics.check();
}

#[test]
fn samples_that_were_changed_do_no_harm() {
    let mut panics = Panics::default();
    let mut samples = Samples::new(&bent(), Some(false), false).expect("points");
    samples.points.clear();
    for kind in
        [Parametrisation::Auto, Parametrisation::Index, Parametrisation::Chord, Parametrisation::ArcLength]
    {
        panics.none("parametrise", || parametrise(&samples, kind, 0.1));
    }
    panics.check();
}

#[test]
fn chains_and_tubes_take_any_number() {
    let mut panics = Panics::default();
    let chain = Chain::new(bent(), false).expect("points");
    for first in COUNTS {
        for count in COUNTS {
            let tube = Tube { first, count, cusps: [false; 2] };
            let points = panics.none("tube_points", || chain.tube_points(&tube).len());
            assert!(points.is_none_or(|points| points <= 24), "no more than there are");
        }
        let disc = DiscTube { ends: [Point::zeros(); 2], points: vec![0, first], end: DiscEnd::Loop };
        panics.none("is_graph", || disc.is_graph(&chain));
        let knots = Knots::even(0.0, 4.0, 3, 2).expect("in range");
        panics.none("greville", || knots.greville(first));
    }
    let ends = [
        Joint { point: Point::zeros(), tangent: None },
        Joint { point: Point::new(23.0, 14.0), tangent: None },
    ];
    let tube: TubeFit = fit_tube(&bent(), ends, 3, Method::Mean(Rule::Least)).expect("a tube");
    assert!(tube.pieces().is_ok() && tube.knots.is_some(), "as it is");
    let mut wild = tube.clone();
    wild.control.pop();
    assert_eq!(panics.none("pieces", || wild.pieces().is_err()), Some(true), "a point is missing");
    for x in NUMBERS {
        panics.none("follow", || {
            chain.follow(&ProfileOptions { angle: x, window: Some(x), ..ProfileOptions::default() }).is_ok()
        });
    }
    panics.check();
}

#[test]
fn pictures_take_any_size_and_edges_that_are_outside_do_not_count() {
    let mut panics = Panics::default();
    let bytes: Vec<u8> = (0..256).map(|i| if i % 16 < 8 { 20 } else { 240 }).collect();
    for width in COUNTS {
        for each in COUNTS {
            panics.none("BlockScan", || {
                let mut scan = BlockScan::new(width);
                scan.push(&bytes, each);
                scan.end()
            });
        }
        panics.none("Gray", || Gray::from_bytes(width, 16, &bytes).is_ok());
        panics.none("Gray", || Gray::from_rgba(16, width, &bytes).is_ok());
    }
    for most in COUNTS {
        panics.none("Census", || Census::new(4).and_then(|mut census| census.palette(most)).is_ok());
    }
    let gray = Gray::from_bytes(16, 16, &bytes).expect("a picture");
    let found = edges(&gray, &EdgeOptions::default()).expect("edges");
    assert!(profiles(&found).is_ok() && found.points.len() > 3, "as they are");
    for (column, row) in [(16, 3), (3, 16), (u32::MAX, 0), (0, u32::MAX)] {
        let mut wild = found.clone();
        (wild.points[2].column, wild.points[2].row) = (column, row);
        let chains = panics.none("profiles", || profiles(&wild).ok()).flatten().unwrap_or_default();
        let mut places = chains.iter().flat_map(Chain::points);
        assert!(places.clone().count() > 3, "the others are there");
        assert!(places.all(|p| p.x.max(p.y) <= 16.0 && p.x.min(p.y) >= 0.0), "{column}, {row}");
    }
    panics.check();
}
