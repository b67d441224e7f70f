//! kurbo and expline as native code, asked line by line, so that the benchmark can take turns between them and the
//! rest.
//!
//! In: `cubics N…`, `hermite OMEGA N…`, `exponential OMEGA N…`, `queries N…`, `sparse N…`, `text D`, `run NAME TIMES`.
//! Out, for `run` only: nanoseconds for all the times together, and the result's numbers.

mod fitted;
mod sparse;

use std::hint::black_box;
use std::io::{BufRead, Write};
use std::time::Instant;

use expline::curve::NearestFinder;
use expline::numerics::{Point, Vector};
use expline::svg::{PrintOptions, to_path_d};
use expline::{Curve as _, HermiteCurve, HermiteOptions, Space};
use expline_peers::Curve;

use sparse::Sparse;

const SAMPLES: usize = 1_000_000;
const FEW_SAMPLES: usize = 1024;
const TOLERANCE: f64 = 0.1;
const CUBIC_TOLERANCE: f64 = 1e-3;
const LENGTH_TOLERANCE: f64 = 1e-9;

#[derive(Default)]
struct Bench {
    kurbo: Curve,
    exact: Option<HermiteCurve>,
    /// The curve whose segments are no cubics.
    exponential: Option<HermiteCurve>,
    queries: Vec<f64>,
    text: String,
    parsed: Option<HermiteCurve>,
    kurbo_text: kurbo::BezPath,
    out: Vec<f64>,
    sparse: Sparse,
}

type Failure = Box<dyn std::error::Error>;

impl Bench {
    fn curve(&self) -> Result<&HermiteCurve, Failure> {
        self.exact.as_ref().ok_or_else(|| "no curve yet".into())
    }

    fn exponential(&self) -> Result<&HermiteCurve, Failure> {
        self.exponential.as_ref().ok_or_else(|| "no exponential curve yet".into())
    }

    fn expline(&mut self, name: &str) -> Result<f64, Failure> {
        let mut out = std::mem::take(&mut self.out);
        let curve = self.curve()?;
        let answer = match name {
            "evaluate" | "evaluate-few" => {
                let count = if name == "evaluate" { SAMPLES } else { FEW_SAMPLES };
                out.resize(2 * count, 0.0);
                curve.sample_range(count, 0, &mut out);
                out[out.len() - 2]
            }
            "bounds" => {
                let b = curve.bounds();
                b.min_x + b.min_y + b.max_x + b.max_y
            }
            "length" => curve.length(LENGTH_TOLERANCE)?,
            "nearest" => {
                let finder = NearestFinder::new(curve);
                let distances =
                    self.queries.chunks_exact(2).map(|q| finder.nearest(Point::new(q[0], q[1])).distance);
                distances.fold(0.0, f64::max)
            }
            "flatten" => (curve.flatten(TOLERANCE)?.0.len() / 2) as f64,
            "cubics" => (self.exponential()?.to_cubics(CUBIC_TOLERANCE)?.path.len() / 8) as f64,
            "by-length" => curve.sample_by_length(1000, LENGTH_TOLERANCE)?.len() as f64,
            "parse" => expline::svg::parse_path(&self.text)?.curves.len() as f64,
            "print" => {
                let options = PrintOptions { decimals: Some(3), ..PrintOptions::default() };
                to_path_d(self.parsed.as_ref().ok_or("no path yet")?, &options)?.d.len() as f64
            }
            _ => return Err(format!("expline has no {name}").into()),
        };
        self.out = out;
        Ok(answer)
    }

    fn kurbo(&mut self, name: &str) -> Result<f64, Failure> {
        let curve = &self.kurbo;
        Ok(match name {
            "evaluate" | "evaluate-few" => {
                curve.evaluate(if name == "evaluate" { SAMPLES } else { FEW_SAMPLES }, &mut self.out);
                self.out[self.out.len() - 2]
            }
            "tangents" => {
                curve.evaluate_with_tangents(SAMPLES, &mut self.out);
                self.out[self.out.len() - 2]
            }
            "bounds" => {
                curve.bounds(&mut self.out);
                self.out.iter().sum()
            }
            "length" => curve.length(LENGTH_TOLERANCE),
            "length-loose" => curve.length(1e-6),
            "nearest" | "nearest-pruned" => {
                let distance = |q: &[f64]| {
                    let p = kurbo::Point::new(q[0], q[1]);
                    if name == "nearest" { curve.nearest(p, 1e-6) } else { curve.nearest_pruned(p, 1e-6) }
                };
                self.queries.chunks_exact(2).map(distance).fold(0.0, f64::max)
            }
            "flatten" => {
                curve.flatten(TOLERANCE, &mut self.out);
                (self.out.len() / 2) as f64
            }
            "cubics" | "cubics-fewest" => {
                fitted::cubics(self.exponential()?.segments(), CUBIC_TOLERANCE, name == "cubics-fewest")
                    as f64
            }
            "parse" => {
                expline_peers::parse(&self.text).ok_or("kurbo cannot read this")?.elements().len() as f64
            }
            "print" => self.kurbo_text.to_svg().len() as f64,
            _ => return Err(format!("kurbo has no {name}").into()),
        })
    }

    fn run(&mut self, name: &str, times: usize) -> Result<(u128, f64), Failure> {
        let (library, operation) = name.split_once(':').ok_or("which library?")?;
        let start = Instant::now();
        let mut answer = 0.0;
        for _ in 0..times {
            answer = black_box(match library {
                "kurbo" => self.kurbo(operation)?,
                "sparse" => self.sparse.run(operation)?,
                _ => self.expline(operation)?,
            });
        }
        Ok((start.elapsed().as_nanos(), answer))
    }

    fn obey(&mut self, line: &str) -> Result<Option<String>, Failure> {
        let (command, rest) = line.split_once(' ').ok_or("a command and what it is about")?;
        let numbers = || rest.split(' ').map(str::parse).collect::<Result<Vec<f64>, _>>();
        match command {
            "cubics" => self.kurbo = Curve::new(&numbers()?),
            "hermite" => self.exact = Some(hermite(&numbers()?)?),
            "exponential" => self.exponential = Some(hermite(&numbers()?)?),
            "queries" => self.queries = numbers()?,
            "sparse" => self.sparse = Sparse::new(&numbers()?)?,
            "text" => {
                self.text = rest.to_owned();
                self.kurbo_text = expline_peers::parse(rest).ok_or("kurbo cannot read this")?;
                self.parsed = expline::svg::parse_path(rest)?.curves.into_iter().next();
            }
            "run" => {
                let (name, times) = rest.split_once(' ').ok_or("how many times?")?;
                let (nanoseconds, answer) = self.run(name, times.parse()?)?;
                return Ok(Some(format!("{nanoseconds} {answer}")));
            }
            _ => return Err(format!("{command} is no command").into()),
        }
        Ok(None)
    }
}

/// ω and, per point, x, y, dx, dy.
fn hermite(numbers: &[f64]) -> Result<HermiteCurve, Failure> {
    let (omega, rest) = numbers.split_first().ok_or("no numbers")?;
    let points = rest.chunks_exact(4).map(|c| Point::new(c[0], c[1])).collect();
    let tangents = rest.chunks_exact(4).map(|c| Vector::new(c[2], c[3])).collect();
    let space = if *omega == 0.0 { Space::Polynomial } else { Space::Trigonometric };
    let options = HermiteOptions {
        points,
        tangents,
        closed: true,
        space: Some(space),
        omega: vec![*omega],
        ..HermiteOptions::default()
    };
    Ok(HermiteCurve::new(options)?)
}

fn main() -> Result<(), Failure> {
    let mut bench = Bench::default();
    let mut output = std::io::stdout().lock();
    for line in std::io::stdin().lock().lines() {
        if let Some(answer) = bench.obey(&line?)? {
            writeln!(output, "{answer}")?;
            output.flush()?;
        }
    }
    Ok(())
}
