//! The same sparse fit by three solvers: ours, the paper's ADMM, and Clarabel, an interior point for cones in general.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettings, DefaultSolver, IPSolver, SupportedConeT};
use expline::fit::admm::Admm;
use expline::fit::{Problem, Settings, Solver};
use expline::numerics::Vector;

type Failure = Box<dyn std::error::Error>;

/// ADMM stops when its objective is this near the optimum, as a share of it …
const NEAR: f64 = 1e-3;
/// … or after so many iterations.
const MOST_ITERATIONS: usize = 4000;

/// A closed problem on uniform grids: points at the parameters 0, 1, 2 …; odd degrees.
#[derive(Default)]
pub(crate) struct Sparse {
    points: Vec<Vector>,
    splines: Vec<(usize, f64, usize)>,
    optimum: f64,
}

impl Sparse {
    /// How many splines; degree, λ and grid size of each; then x, y of every point.
    pub(crate) fn new(numbers: &[f64]) -> Result<Self, Failure> {
        let (count, rest) = numbers.split_first().ok_or("no numbers")?;
        let (splines, points) = rest.split_at_checked(3 * *count as usize).ok_or("too few numbers")?;
        let mut sparse = Self {
            points: points.chunks_exact(2).map(|p| Vector::new(p[0], p[1])).collect(),
            splines: splines.chunks_exact(3).map(|s| (s[0] as usize, s[1], s[2] as usize)).collect(),
            optimum: 0.0,
        };
        sparse.optimum = sparse.ours(1e-9)?;
        Ok(sparse)
    }

    fn problem(&self) -> Result<Problem, Failure> {
        Ok(Problem::of_points(&self.points, true, &self.splines)?)
    }

    fn ours(&self, gap: f64) -> Result<f64, Failure> {
        let mut solver = Solver::new(&self.problem()?, Settings { gap, ..Settings::default() })?;
        solver.run()?;
        Ok(solver.solution()?.objective)
    }

    /// How far above the optimum a solver ends, as a share of it.
    pub(crate) fn run(&self, name: &str) -> Result<f64, Failure> {
        let objective = match name {
            "expline" => self.ours(1e-6)?,
            "admm" => self.admm()?,
            "clarabel" => self.clarabel()?,
            _ => return Err(format!("no solver is called {name}").into()),
        };
        Ok(objective / self.optimum - 1.0)
    }

    fn admm(&self) -> Result<f64, Failure> {
        let mut admm = Admm::new(&self.problem()?)?;
        while admm.iterations() < MOST_ITERATIONS {
            admm.step();
            if admm.iterations().is_multiple_of(20) && admm.objective() <= self.optimum * (1.0 + NEAR) {
                break;
            }
        }
        Ok(admm.objective())
    }

    /// Unknowns: x coefficients of all splines, their y coefficients, then for each knot a bound on the length of its
    /// jump.
    fn clarabel(&self) -> Result<f64, Failure> {
        let count = self.points.len();
        let sizes: Vec<usize> = self.splines.iter().map(|s| s.2).collect();
        let total: usize = sizes.iter().sum();
        let mut squares = Triplets::default();
        let mut linear = vec![0.0; 3 * total];
        for (m, point) in self.points.iter().enumerate() {
            let row = self.row(m as f64, count as f64);
            for &(i, a) in &row {
                linear[i] -= 2.0 * a * point.x;
                linear[total + i] -= 2.0 * a * point.y;
                for &(j, b) in row.iter().filter(|&&(j, _)| j >= i) {
                    squares.add(i, j, 2.0 * a * b);
                    squares.add(total + i, total + j, 2.0 * a * b);
                }
            }
        }
        let (mut rows, mut cones) = (Triplets::default(), Vec::new());
        let mut height = 0;
        if self.splines.len() > 1 {
            // What both splines share belongs to the second: the first is 0 at the start.
            for &(i, a) in self.row(0.0, count as f64).iter().filter(|&&(i, _)| i < sizes[0]) {
                rows.add(0, i, a);
                rows.add(1, total + i, a);
            }
            cones.push(SupportedConeT::ZeroConeT(2));
            height = 2;
        }
        let mut first = 0;
        for &(degree, lambda, size) in &self.splines {
            let step = count as f64 / size as f64;
            for k in 0..size {
                linear[2 * total + first + k] = lambda;
                rows.add(height, 2 * total + first + k, -1.0);
                for (i, weight) in jump(degree, size, k) {
                    let weight = weight / step.powi(degree as i32);
                    rows.add(height + 1, first + i, -weight);
                    rows.add(height + 2, total + first + i, -weight);
                }
                cones.push(SupportedConeT::SecondOrderConeT(3));
                height += 3;
            }
            first += size;
        }
        let settings = DefaultSettings { verbose: false, ..DefaultSettings::default() };
        let (p, a) = (squares.matrix(3 * total, 3 * total), rows.matrix(height, 3 * total));
        let mut solver = DefaultSolver::new(&p, &linear, &a, &vec![0.0; height], &cones, settings)?;
        solver.solve();
        Ok(self.objective(&solver.solution.x))
    }

    /// The objective at coefficients, whatever a solver says of it.
    fn objective(&self, x: &[f64]) -> f64 {
        let length = self.points.len() as f64;
        let total: usize = self.splines.iter().map(|s| s.2).sum();
        let at = |i: usize| Vector::new(x[i], x[total + i]);
        let deviation = |(m, point): (usize, &Vector)| {
            let curve: Vector = self.row(m as f64, length).iter().map(|&(i, value)| at(i) * value).sum();
            (curve - point).norm_squared()
        };
        let mut objective: f64 = self.points.iter().enumerate().map(deviation).sum();
        let mut first = 0;
        for &(degree, lambda, size) in &self.splines {
            let step = length / size as f64;
            for k in 0..size {
                let jump: Vector = jump(degree, size, k).map(|(i, weight)| at(first + i) * weight).sum();
                objective += lambda * jump.norm() / step.powi(degree as i32);
            }
            first += size;
        }
        objective
    }

    /// The B-splines at a parameter: index among all coefficients, and value.
    fn row(&self, t: f64, length: f64) -> Vec<(usize, f64)> {
        let mut row = Vec::new();
        let mut first = 0;
        for &(degree, _, size) in &self.splines {
            let x = t * size as f64 / length;
            let reach = degree.div_ceil(2) as isize;
            for k in x.floor() as isize - reach + 1..=x.floor() as isize + reach {
                let value = b_spline(degree, x - k as f64);
                if value != 0.0 {
                    row.push((first + k.rem_euclid(size as isize) as usize, value));
                }
            }
            first += size;
        }
        row.sort_by_key(|&(i, _)| i);
        row
    }
}

/// The B-spline of a degree, centred at 0, its knots at whole numbers for odd degrees.
fn b_spline(degree: usize, x: f64) -> f64 {
    let half = 0.5 * (degree as f64 + 1.0);
    if degree == 0 {
        return f64::from(u8::from((-0.5..0.5).contains(&x)));
    }
    ((half + x) * b_spline(degree - 1, x + 0.5) + (half - x) * b_spline(degree - 1, x - 0.5)) / degree as f64
}

/// The jump at the k-th knot of a closed spline of odd degree on a grid of step 1: indices of coefficients, and their
/// weights.
fn jump(degree: usize, size: usize, k: usize) -> impl Iterator<Item = (usize, f64)> {
    let power = degree + 1;
    let mut weight = 1.0;
    (0..=power).map(move |j| {
        let own = weight;
        weight *= -((power - j) as f64) / (j + 1) as f64;
        ((k + size + power / 2 - j) % size, own)
    })
}

/// Entries of a sparse matrix; those of one place are added.
#[derive(Default)]
struct Triplets {
    rows: Vec<usize>,
    columns: Vec<usize>,
    values: Vec<f64>,
}

impl Triplets {
    fn add(&mut self, row: usize, column: usize, value: f64) {
        self.rows.push(row);
        self.columns.push(column);
        self.values.push(value);
    }

    fn matrix(self, height: usize, width: usize) -> CscMatrix {
        CscMatrix::new_from_triplets(height, width, self.rows, self.columns, self.values)
    }
}
