//! Nothing in the public interface panics, whatever numbers it is given: what cannot be answered is an error, nothing,
//! or a number that is none.
#![cfg(not(target_arch = "wasm32"))]

use std::f64::consts::TAU;
use std::hint::black_box;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use crate::support::curves::{Random, random_curve};
use expline::curve::{LengthTable, NearestFinder, Sampler, Scheme, Side, SplineSampler};
use expline::generator::{Basis, ExponentialBSpline, HermiteGenerators, Interpolator, Root, Roots};
use expline::numerics::{Point, Vector, Vector3};
use expline::refine::{HermiteData, MatrixMask, ScalarMask, control_polygon, extended, finer, from_points};
use expline::refine::{subdivide_hermite, subdivide_scalar};
use expline::surface::{Direction, Grid, Region};
use expline::svg::{PrintOptions, to_path_d};
use expline::{BSplineCurve, Curve, HermiteCurve, HermiteOptions, InterpolatingCurve, LocalCurve};
use expline::{Space, TensorSurface};

/// Numbers that somebody hands in: none, infinite, next to nothing, ordinary, next to a pole, beyond what is allowed.
const NUMBERS: [f64; 20] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    0.0,
    -0.0,
    5e-324,
    1e-160,
    1e-60,
    1e-12,
    0.3,
    1.0,
    -1.5,
    3.0,
    TAU,
    TAU - 1e-6,
    1e4,
    1e9,
    -1e10,
    1e300,
    f64::MAX,
];
/// Counts, indices and orders.
const COUNTS: [usize; 13] =
    [0, 1, 2, 3, 4, 7, 64, 1025, u32::MAX as usize, 1 << 53, isize::MAX as usize, usize::MAX - 1, usize::MAX];
const SPACES: [Space; 3] = [Space::Trigonometric, Space::Hyperbolic, Space::Polynomial];

/// Calls that panicked, by name.
#[derive(Default)]
struct Panics(Vec<String>);

impl Panics {
    fn none<T>(&mut self, call: &str, of: impl FnOnce() -> T) {
        if catch_unwind(AssertUnwindSafe(|| drop(black_box(of())))).is_err() {
            self.0.push(call.into());
        }
    }

    fn check(mut self) {
        self.0.dedup();
        assert!(self.0.is_empty(), "these panicked: {:#?}", self.0);
    }
}

fn closed_and_open() -> [HermiteCurve; 2] {
    let mut random = Random::new(3);
    let mut one = |closed: bool| {
        (0..).map(|case| random_curve(&mut random, case)).find(|curve| curve.is_closed() == closed)
    };
    [one(true).expect("half of them"), one(false).expect("half of them")]
}

fn roots(zeros: usize, im: f64) -> Roots {
    let mut list = vec![Root::default(); zeros];
    if im != 0.0 {
        list.extend([Root { re: 0.0, im }, Root { re: 0.0, im: -im }]);
    }
    Roots::new(&list, "roots").expect("conjugates are there")
}

#[test]
fn curves_with_tangents_take_any_number() {
    let mut panics = Panics::default();
    let other = HermiteCurve::ellipse(Point::zeros(), Vector::new(2.0, 1.0), 0.0, 9).expect("in range");
    for curve in closed_and_open() {
        for i in COUNTS {
            panics.none("segment", || curve.segment(i).is_ok());
            panics.none("with_point", || curve.with_point(i, Point::zeros()));
            panics.none("with_tangent", || curve.with_tangent(i, Point::zeros(), Side::Both));
            panics.none("remove", || curve.remove(i));
            panics.none("refine", || curve.refine(i));
            panics.none("evaluate", || curve.evaluate(0.5, i));
            panics.none("evaluate_into", || curve.evaluate_into(&[0.5], i, &mut [0.0; 2]));
            panics.none("evaluate_into a short list", || {
                curve.evaluate_into(&[0.5], 0, &mut vec![0.0; i.min(9)])
            });
            for j in COUNTS {
                panics.none("subdivide", || curve.subdivide(i, j, Scheme::Hermite));
                panics.none("subdivide scalar", || curve.subdivide(i, j, Scheme::Scalar));
                for room in [0, 1, 2, 3, 5, 64] {
                    let mut out = vec![0.0; room];
                    panics.none("sample_range", || curve.sample_range(i, j, &mut out));
                    let mut sampler = Sampler::new();
                    panics.none("points", || sampler.points(&curve, i, j, &mut out));
                    panics
                        .none("points_and_tangents", || sampler.points_and_tangents(&curve, i, j, &mut out));
                    panics.none("blocks", || sampler.blocks(&curve, i, j, true, &mut out));
                }
            }
        }
        for x in NUMBERS {
            panics.none("locate", || curve.locate(x));
            panics.none("split", || curve.split(x));
            panics.none("insert", || curve.insert(x));
            panics.none("transformed", || curve.transformed([x, 0.0, 1.0, 1.0, 0.0, x]));
            panics.none("as_ellipse", || curve.as_ellipse(x).map(|arc| arc.point(x)));
            panics
                .none("through", || HermiteCurve::through(curve.points().to_vec(), true, Some(x), SPACES[0]));
            for segment in curve.segments().take(2) {
                panics.none("position", || (segment.position(x), segment.derivative(x, 9)));
                panics.none("as_line", || segment.as_line(x));
                panics.none("as_ellipse_arc", || segment.as_ellipse_arc(x));
                for (k, space) in SPACES.into_iter().enumerate() {
                    let mut wild = segment;
                    let basis = Basis::new(space, x);
                    wild.basis = &basis;
                    wild.length = NUMBERS[9 + k];
                    wild.end.x = x;
                    panics.none("as_ellipse_arc of any", || (wild.as_ellipse_arc(0.1), wild.as_line(0.1)));
                }
            }
            for y in NUMBERS {
                panics.none("trim", || curve.trim(x, y));
                panics.none("ellipse", || HermiteCurve::ellipse(Point::new(x, y), Vector::new(y, x), x, 3));
                panics.none("arc", || HermiteCurve::arc(Point::zeros(), Vector::new(x, 1.0), 0.0, y, x));
                for space in SPACES {
                    panics.none("new", || {
                        HermiteCurve::new(HermiteOptions {
                            points: vec![Point::new(x, 0.0), Point::new(1.0, y)],
                            tangents: vec![Point::new(1.0, y), Point::new(x, 0.0)],
                            omega: vec![x],
                            lengths: vec![y],
                            space: Some(space),
                            ..Default::default()
                        })
                    });
                }
            }
        }
        measures(&mut panics, &curve);
        let mut table = LengthTable::new(&other, 0.1).expect("in range");
        panics.none("a table of another curve", || table.parameters(&curve, 5).is_ok());
        panics.none("points of another curve", || table.points(&curve, 5).is_ok());
    }
    panics.check();
}

/// What every kind of curve answers.
fn measures(panics: &mut Panics, curve: &dyn Curve) {
    let finder = NearestFinder::new(curve);
    for x in NUMBERS {
        panics.none("curvature", || curve.curvature(x));
        panics.none("length", || curve.length(x));
        panics.none("flatten", || curve.flatten(x));
        panics.none("to_cubics", || curve.to_cubics(x));
        panics.none("to_hermite", || curve.to_hermite(x));
        for y in NUMBERS {
            panics.none("nearest", || (curve.nearest(Point::new(x, y)), finder.nearest(Point::new(y, x))));
        }
        panics.none("parameter_at_length", || {
            (curve.parameter_at_length(x, 0.1), curve.parameter_at_length(0.3, x))
        });
        panics.none("sample_by_length", || curve.sample_by_length(9, x));
        let options = PrintOptions { tolerance: x, ..PrintOptions::default() };
        panics.none("to_path_d", || to_path_d(curve, &options).map(|printed| printed.d));
    }
    for count in COUNTS {
        panics.none("sample_by_length", || curve.sample_by_length(count, 0.1));
        let options =
            PrintOptions { decimals: Some(count as u32), relative: true, ..PrintOptions::default() };
        panics.none("to_path_d", || to_path_d(curve, &options).map(|printed| printed.d));
    }
}

#[test]
fn curves_of_roots_take_any_number() {
    let mut panics = Panics::default();
    let points: Vec<f64> = (0..12).map(|i| f64::from(i * i % 7)).collect();
    for (closed, roots) in [(true, roots(1, 1.0)), (false, roots(4, 0.0)), (false, roots(2, 0.3))] {
        let curve =
            InterpolatingCurve::new(points.clone(), 2, closed, Some(roots.clone())).expect("in range");
        let spline = curve.refine(2, 2, 2).expect("in range");
        let local = LocalCurve::new(curve.clone()).refine_at(1.5, 2, 0.5).expect("in range");
        for i in COUNTS {
            let mut out = Vec::new();
            panics.none("piece_into", || curve.piece_into(i, &mut out).is_ok());
            panics.none("piece_into", || spline.piece_into(i, &mut out).is_ok());
            panics.none("knot", || (curve.knot(i), spline.knot(i)));
            panics.none("with_point", || {
                (curve.with_point(i, &[0.0; 2]), curve.with_point(0, &vec![0.0; i.min(5)]))
            });
            panics.none("evaluate", || {
                (curve.evaluate(0.5, i), spline.evaluate(0.5, i), local.evaluate(0.5, i))
            });
            panics.none("refine", || (spline.refine(i).is_ok(), spline.reduce(i).is_ok()));
            panics.none("patch", || (local.patch_window(i), local.patch_points(i), local.without_patch(i)));
            panics.none("with_patch_point", || {
                (local.with_patch_point(i, 0, &[0.0; 2]), local.with_patch_point(0, i, &[0.0; 2]))
            });
            for j in COUNTS {
                panics.none("new", || InterpolatingCurve::new(vec![0.0; i.min(9)], j, closed, None));
                panics.none("sample", || curve.sample(i.min(1 << 20), j));
                panics.none("sample a part", || SplineSampler::new().points(&curve, i, j, 0, &mut [0.0; 8]));
                panics.none("add_patch", || {
                    for k in [0, 1, 2, usize::MAX] {
                        drop((local.add_patch((k, i, j), &[]), local.add_patch((i, j, k), &[0.0; 4])));
                    }
                });
                panics.none("refine", || curve.refine(i, j, 2).is_ok());
                panics.none("refine by", || curve.refine(2, i, j).is_ok());
            }
        }
        for x in NUMBERS {
            panics.none("refine_at", || (local.refine_at(x, 2, 0.5), local.refine_at(1.0, 2, x)));
            panics.none("transformed", || {
                (spline.transformed(&[x; 6]), local.transformed(&[1.0, x, 0.0, 1.0, 0.0, 0.0]))
            });
            for y in NUMBERS {
                panics.none("BSplineCurve", || {
                    let made = BSplineCurve::new(points.clone(), 2, closed, roots.clone(), x, y)?;
                    let (start, _) = made.domain();
                    drop((made.interpolating(), made.refine(2), made.to_hermite(0.1), made.length(0.1)));
                    made.with_domain(start, y)
                });
            }
        }
        measures(&mut panics, &curve);
        measures(&mut panics, &spline);
        measures(&mut panics, &local);
    }
    panics.check();
}

#[test]
fn exponential_generators_take_any_number() {
    let mut panics = Panics::default();
    let spline = ExponentialBSpline::new(&roots(2, 1.0)).expect("in range");
    let phi = Interpolator::new(&roots(2, 1.0)).expect("it exists");
    for i in COUNTS {
        panics.none("piece", || spline.piece(i).len());
        panics.none("half_piece", || {
            (phi.half_piece(i as isize).len(), phi.half_piece(-(i as isize >> 1)).len())
        });
        panics.none("filters", || (spline.refinement_filter(i), spline.affine_refinement_filter(i)));
        panics.none("filters", || (phi.pre_filter(i), phi.affine_pre_filter(i)));
        panics.none("lists", || {
            (Roots::polynomials(i), Roots::ellipse(i), Roots::harmonics(i, 2), Roots::harmonics(9, i))
        });
        panics.none("for_ellipse", || Interpolator::for_ellipse(i).is_ok());
        for j in COUNTS {
            for list in [vec![], vec![1.0; 6], vec![0.5; 7]] {
                panics.none("from_points", || from_points(&list, i, true, &phi, j));
                panics.none("from_points", || from_points(&list, i, false, &phi, j));
                panics.none("finer", || finer(&list, i, i % 2 == 0, phi.roots(), j));
                panics.none("extended", || extended(&list, i, phi.roots()));
            }
        }
        for x in NUMBERS {
            panics.none("at", || {
                (spline.at(x, i), phi.at(x, i), spline.evaluate(&[x], i), phi.evaluate(&[x], i))
            });
            panics.none("scaled", || phi.roots().scaled(x).map(|roots| ExponentialBSpline::new(&roots)));
        }
    }
    panics.check();
}

#[test]
fn interpolators_of_few_roots_panic_nowhere() {
    let mut panics = Panics::default();
    panics.none("an interpolator of few roots", || {
        for order in 1..3 {
            let made = Interpolator::new(&roots(order, 0.0)).map(Arc::new)?;
            let _ = black_box(from_points(&[1.0; 8], 2, false, &made, 2));
            let _ = black_box(from_points(&[1.0; 8], 2, true, &made, 2));
            for closed in [false, true] {
                let curve = InterpolatingCurve::with_interpolator(vec![1.0; 8], 2, closed, made.clone())?;
                let _ = black_box((curve.refine(2, 2, 2).is_ok(), curve.evaluate(0.3, 0), curve.length(0.1)));
            }
        }
        Ok::<(), Box<expline::Error>>(())
    });
    panics.check();
}

#[test]
fn lists_of_roots_take_any_number() {
    let mut panics = Panics::default();
    for x in NUMBERS {
        for y in NUMBERS {
            panics.none("Roots", || {
                let roots =
                    Roots::new(&[Root { re: x, im: y }, Root { re: x, im: -y }, Root::default()], "roots")?;
                let _ = black_box((Roots::hyperbola(x), Roots::union(&[roots.clone(), roots.clone()])));
                let _ =
                    black_box((Interpolator::new(&roots).is_ok(), Interpolator::beyond_pi(&roots).is_ok()));
                ExponentialBSpline::new(&roots).map(|spline| (spline.at(0.1, 1), spline.riesz_bounds()))
            });
        }
    }
    panics.check();
}

#[test]
fn hermite_generators_and_masks_take_any_number() {
    let mut panics = Panics::default();
    for i in COUNTS {
        for x in NUMBERS {
            for space in SPACES {
                panics.none("generators", || {
                    let generators = HermiteGenerators::new(x, space)?;
                    let _ = black_box((
                        generators.mask(i, 1).is_ok(),
                        generators.mask(2, i),
                        generators.greens(&[x]),
                    ));
                    let _ = black_box((
                        generators.at(0.3, i),
                        generators.b_spline4(0.3, i),
                        generators.b_spline3(x, i),
                    ));
                    let _ = black_box((
                        generators.gram(),
                        generators.riesz_bounds(),
                        generators.gram().eigenvalues(x),
                    ));
                    generators.evaluate(&[x], i)
                });
                panics.none("Basis", || {
                    (Basis::new(space, x).weights(0.3, i), Basis::new(space, 1.0).weights(x, i))
                });
                panics.none("MatrixMask", || {
                    MatrixMask::new(space, x, 1.0, i).map(|mask| mask.matrix(i as isize))
                });
                panics.none("ScalarMask", || {
                    ScalarMask::new(space, x)
                        .and_then(|mask| mask.apply(&vec![Point::zeros(); i.min(9)], x > 0.0))
                });
                let data = HermiteData {
                    space,
                    closed: i % 2 == 0,
                    points: vec![Point::new(x, 1.0); i.min(3)],
                    leaving: vec![Point::new(x, 1.0); 3],
                    arriving: vec![Point::new(x, 1.0); 3],
                    omega: vec![x; if i % 2 == 0 { 3 } else { 2 }],
                    lengths: vec![1.0; if i % 2 == 0 { 3 } else { 2 }],
                };
                panics.none("subdivide", || {
                    let _ = black_box((
                        control_polygon(&data),
                        subdivide_scalar(&data, i),
                        subdivide_hermite(&data, i, 1),
                    ));
                    subdivide_hermite(&data, 2, i)
                });
            }
        }
    }
    panics.check();
}

#[test]
fn surfaces_take_any_number() {
    let mut panics = Panics::default();
    let direction = |count, closed, level| Direction { roots: roots(3, 0.0), count, closed, level };
    let patched = TensorSurface::torus(3.0, 1.0, [5, 4])
        .expect("in range")
        .refine_at(1.0, 1.0, 2, 1.0)
        .expect("in range");
    let sphere = TensorSurface::sphere(1.0, [4, 3]).expect("in range");
    for surface in [patched, sphere] {
        for i in COUNTS {
            let (levels, grid) = (i as u32, Grid { rows: i, cols: 5 });
            panics.none("refine", || (surface.refine(levels, 0).is_ok(), surface.refine(0, levels).is_ok()));
            panics.none("reduce", || (surface.reduce(levels, 0).is_ok(), surface.reduce(1, levels).is_ok()));
            panics.none("refine_at", || surface.refine_at(1.0, 1.0, levels, 0.5).is_ok());
            panics.none("evaluate", || (surface.evaluate(1.0, 1.0, i, 0), surface.evaluate(1.0, 1.0, 0, i)));
            panics.none("indices", || (surface.indices(grid).is_ok(), surface.touched(grid, 1, 1)));
            panics.none("patch", || {
                (surface.patch_window(i), surface.displacements(i), surface.patch_points(i))
            });
            panics.none("touched_by_patch", || surface.touched_by_patch(Grid { rows: 5, cols: 5 }, i, 0, 0));
            for j in COUNTS {
                panics.none("parameters", || surface.parameters(i, j));
                panics.none("set_point", || surface.clone().set_point(i, j, Vector3::zeros()));
                panics.none("set_patch_point", || surface.clone().set_patch_point(0, i, j, Vector3::zeros()));
                panics.none("touched", || surface.touched(Grid { rows: 5, cols: 5 }, i, j));
                panics.none("add_patch", || surface.add_patch((levels, i, j), (2, j, i), &[0.0; 3]));
                panics.none("new", || {
                    TensorSurface::new(vec![0.0; 3], direction(i, true, 0), direction(j, false, levels))
                        .is_ok()
                });
                panics.none("shapes", || {
                    let _ = black_box((
                        TensorSurface::sphere(1.0, [i, j]).is_ok(),
                        TensorSurface::torus(2.0, 1.0, [i, j]).is_ok(),
                    ));
                    let _ = black_box(TensorSurface::cylinder(1.0, 1.0, [i, j]).is_ok());
                    let _ = black_box(TensorSurface::roman_surface(1.0, [i, j]).is_ok());
                    TensorSurface::hyperbolic_paraboloid([1.0; 3], [i, j]).is_ok()
                });
                for region in [
                    Region { rows: i..j, cols: 0..5 },
                    Region { rows: 2..4, cols: j..i },
                    Region { rows: i..i.saturating_add(2), cols: j..j.saturating_add(2) },
                ] {
                    let grid = Grid { rows: 5, cols: 5 };
                    panics.none("mesh_into", || {
                        surface.mesh_into(grid, &region, &mut [0.0; 12], &mut [0.0; 12])
                    });
                    panics.none("mesh_curvatures_into", || {
                        drop((
                            surface.mesh_curvatures_into(grid, &region, &mut []),
                            surface.mesh_curvatures_into(grid, &region, &mut [0.0; 8]),
                        ));
                    });
                }
            }
        }
        for x in NUMBERS {
            panics.none("refine_at", || {
                (surface.refine_at(x, 1.0, 2, 0.5).is_ok(), surface.refine_at(1.0, 1.0, 2, x).is_ok())
            });
            panics.none("set_point", || surface.clone().set_point(1, 1, Vector3::new(x, 0.0, 0.0)));
            panics.none("transformed", || (surface.transformed(&[x; 16]), surface.transformed(&[x; 5])));
            for y in NUMBERS {
                panics.none("evaluate", || {
                    (surface.evaluate(x, y, 0, 0), surface.normal(x, y), surface.curvature(x, y))
                });
                panics.none("shapes", || {
                    (
                        TensorSurface::torus(x, y, [4, 4]).is_ok(),
                        TensorSurface::ellipsoid(Vector3::new(x, y, 1.0), [4, 4]).is_ok(),
                    )
                });
            }
        }
    }
    panics.check();
}

#[test]
fn messages_say_a_range_in_a_line() {
    let point = Point::zeros();
    let curve = HermiteCurve::ellipse(point, Vector::new(2.0, 1.0), 0.0, 4).expect("in range");
    let said = |error: Box<expline::Error>| error.to_string();
    let radii = HermiteCurve::ellipse(point, Vector::new(-1.0, 1.0), 0.0, 4).map_err(said);
    assert_eq!(radii.err().as_deref(), Some("radii[0] is -1; expected a number above 0, at most 1000000000"));
    let far = curve.with_point(0, Point::new(1e300, 0.0)).map_err(said);
    assert_eq!(
        far.err().as_deref(),
        Some("points[0] is 1e300; expected a number from -1000000000 to 1000000000")
    );
    let tolerance = curve.length(-1e-300).map_err(said);
    assert_eq!(tolerance.err().as_deref(), Some("tolerance is -1e-300; expected a number above 0"));
    let one = HermiteCurve::through(vec![point], true, None, Space::Polynomial).map_err(said);
    assert_eq!(one.err().as_deref(), Some("points has 1 point; at least 2 are needed"));
}
