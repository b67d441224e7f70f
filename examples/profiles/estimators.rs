//! Six estimators of a function from a tube's points. Each is chosen by its own criterion on all points; then every
//! point is left out once.

use expline::numerics::Point;
use expline::trace::{Cloud, End, Estimator, Knots, Method, ProfileOptions, QuasiInterpolant, Rule, choose};

type Outcome<T> = expline::error::Result<T>;

/// What an estimator says of a tube.
pub(crate) struct Followed {
    /// The curve in the tube's frame.
    pub(crate) value: Box<dyn Fn(f64) -> f64>,
    /// Errors of predicting each point from all others.
    pub(crate) left_out: Vec<f64>,
    /// How many numbers the curve is made of.
    pub(crate) numbers: usize,
}

type Follow = fn(&[Point], f64) -> Outcome<Followed>;

/// All estimators by name.
pub(crate) const ALL: [(&str, Follow); 6] = [
    ("quasi-interpolant, as printed", printed),
    ("quasi-interpolant, improved", improved),
    ("fit1: quadratic polynomial", quadratic),
    ("fit2: piecewise cubic", piecewise_cubic),
    ("fit3: smoothing spline", smoothing),
    ("least-squares B-spline", least_squares),
];

const FREE: [End; 2] = [End::Free, End::Free];

fn without(points: &[Point], i: usize) -> Vec<Point> {
    let mut rest = points.to_vec();
    rest.remove(i);
    rest
}

fn printed(points: &[Point], length: f64) -> Outcome<Followed> {
    quasi(points, length, Method::Mean(Rule::Least))
}

fn improved(points: &[Point], length: f64) -> Outcome<Followed> {
    quasi(points, length, ProfileOptions::default().method)
}

fn quasi(points: &[Point], length: f64, method: Method) -> Outcome<Followed> {
    let cloud = Cloud::new(points)?;
    let Some((choice, knots)) = choose(&cloud, 0.0, length, 2, FREE, method)? else {
        return quadratic(points, length);
    };
    let estimate = |cloud: &Cloud| {
        let estimator = match method {
            Method::Mean(_) => Estimator::Mean { k: choice.k.min(cloud.len()) },
            Method::Placed { .. } => Estimator::Projected { reach: 2 },
        };
        QuasiInterpolant::new(cloud, knots.clone(), estimator, FREE)
    };
    let mut left_out = Vec::new();
    for (i, p) in points.iter().enumerate() {
        left_out.push(p.y - estimate(&Cloud::new(&without(points, i))?)?.evaluate(p.x));
    }
    let fitted = estimate(&cloud)?;
    let numbers = fitted.coefficients().len();
    Ok(Followed { value: Box::new(move |x| fitted.evaluate(x)), left_out, numbers })
}

/// Solves a symmetric positive definite system for several right-hand sides, by Gauss's elimination.
fn solve(mut matrix: Vec<Vec<f64>>, mut right: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let n = matrix.len();
    for pivot in 0..n {
        let (done, rest) = matrix.split_at_mut(pivot + 1);
        let lead = &done[pivot];
        for (row, values) in (pivot + 1..n).zip(rest) {
            let factor = values[pivot] / lead[pivot];
            for (value, above) in values.iter_mut().zip(lead).skip(pivot) {
                *value -= factor * above;
            }
            for side in &mut right {
                side[row] -= factor * side[pivot];
            }
        }
    }
    for side in &mut right {
        for row in (0..n).rev() {
            let known: f64 = (row + 1..n).map(|c| matrix[row][c] * side[c]).sum();
            side[row] = (side[row] - known) / matrix[row][row];
        }
    }
    right
}

/// The quadratic B-splines on knots at x, by the recurrence of Cox and de Boor.
fn basis(knots: &[f64], x: f64) -> Vec<f64> {
    let n = knots.len() - 3;
    let span = (2..n).rev().find(|&i| x >= knots[i]).unwrap_or(2);
    let mut values = vec![0.0; knots.len() - 1];
    values[span] = 1.0;
    for degree in 1..=2 {
        for i in 0..knots.len() - 1 - degree {
            let part = |from: f64, to: f64, value: f64| if to > from { value / (to - from) } else { 0.0 };
            let left = part(knots[i], knots[i + degree], values[i]) * (x - knots[i]);
            let right =
                part(knots[i + 1], knots[i + degree + 1], values[i + 1]) * (knots[i + degree + 1] - x);
            values[i] = left + right;
        }
    }
    values.truncate(n);
    values
}

/// Least squares on `interior` even knots: coefficients, and the errors without each point, which for least squares are
/// r/(1 − h).
fn squares(points: &[Point], length: f64, interior: usize) -> Outcome<(Vec<f64>, Vec<f64>, Vec<f64>)> {
    let knots = Knots::even(0.0, length, interior, 2)?.as_slice().to_vec();
    let rows: Vec<Vec<f64>> = points.iter().map(|p| basis(&knots, p.x)).collect();
    let n = knots.len() - 3;
    let mut matrix = vec![vec![0.0; n]; n];
    let mut right = vec![0.0; n];
    for (row, p) in rows.iter().zip(points) {
        for a in 0..n {
            right[a] += row[a] * p.y;
            (0..n).for_each(|b| matrix[a][b] += row[a] * row[b]);
        }
    }
    (0..n).for_each(|a| matrix[a][a] += 1e-9);
    let coefficients = solve(matrix.clone(), vec![right]).remove(0);
    let inverse = solve(matrix, rows.clone());
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let left_out = rows
        .iter()
        .zip(&inverse)
        .zip(points)
        .map(|((row, turned), p)| (p.y - dot(row, &coefficients)) / (1.0 - dot(row, turned)).max(1e-3))
        .collect();
    Ok((knots, coefficients, left_out))
}

fn followed((knots, coefficients, left_out): (Vec<f64>, Vec<f64>, Vec<f64>)) -> Followed {
    let numbers = coefficients.len();
    let value = move |x: f64| basis(&knots, x).iter().zip(&coefficients).map(|(b, c)| b * c).sum();
    Followed { value: Box::new(value), left_out, numbers }
}

fn quadratic(points: &[Point], length: f64) -> Outcome<Followed> {
    Ok(followed(squares(points, length, 0)?))
}

fn least_squares(points: &[Point], length: f64) -> Outcome<Followed> {
    let mut best = squares(points, length, 0)?;
    let size = |left_out: &[f64]| left_out.iter().map(|r| r * r).sum::<f64>();
    for interior in 1..=8.min((points.len() / 3).saturating_sub(2)) {
        let next = squares(points, length, interior)?;
        if size(&next.2) < size(&best.2) {
            best = next;
        }
    }
    Ok(followed(best))
}

/// Points by abscissa, those of one abscissa as their mean, with how many they are.
fn distinct(points: &[Point]) -> Vec<(f64, f64, f64)> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a.x.total_cmp(&b.x));
    sorted
        .chunk_by(|a, b| (a.x - b.x).abs() < 1e-9)
        .map(|same| (same[0].x, same.iter().map(|p| p.y).sum::<f64>() / same.len() as f64, same.len() as f64))
        .collect()
}

/// The monotone cubic interpolant of Fritsch and Carlson, straight beyond its ends.
fn monotone(nodes: &[(f64, f64, f64)]) -> impl Fn(f64) -> f64 + use<> {
    let nodes = nodes.to_vec();
    let n = nodes.len();
    let secant = |i: usize| (nodes[i + 1].1 - nodes[i].1) / (nodes[i + 1].0 - nodes[i].0);
    let mut slopes = vec![0.0; n];
    for (i, slope) in slopes.iter_mut().enumerate() {
        *slope = if i == 0 {
            secant(0)
        } else if i + 1 == n {
            secant(n - 2)
        } else if secant(i - 1) * secant(i) > 0.0 {
            let (h0, h1) = (nodes[i].0 - nodes[i - 1].0, nodes[i + 1].0 - nodes[i].0);
            let (w0, w1) = (2.0 * h1 + h0, h1 + 2.0 * h0);
            (w0 + w1) / (w0 / secant(i - 1) + w1 / secant(i))
        } else {
            0.0
        };
    }
    move |x| {
        if x <= nodes[0].0 {
            return nodes[0].1 + slopes[0] * (x - nodes[0].0);
        }
        if x >= nodes[n - 1].0 {
            return nodes[n - 1].1 + slopes[n - 1] * (x - nodes[n - 1].0);
        }
        let i = nodes.partition_point(|node| node.0 <= x) - 1;
        let h = nodes[i + 1].0 - nodes[i].0;
        let t = (x - nodes[i].0) / h;
        let u = 1.0 - t;
        nodes[i].1 * u * u * (1.0 + 2.0 * t)
            + slopes[i] * h * u * u * t
            + nodes[i + 1].1 * t * t * (1.0 + 2.0 * u)
            - slopes[i + 1] * h * t * t * u
    }
}

fn piecewise_cubic(points: &[Point], _length: f64) -> Outcome<Followed> {
    let left_out =
        points.iter().enumerate().map(|(i, p)| p.y - monotone(&distinct(&without(points, i)))(p.x)).collect();
    let nodes = distinct(points);
    let numbers = nodes.len();
    Ok(Followed { value: Box::new(monotone(&nodes)), left_out, numbers })
}

/// The natural cubic spline that minimises squares and λ times the integral of its squared second derivative; λ by
/// generalised cross-validation.
fn smoothing(points: &[Point], _length: f64) -> Outcome<Followed> {
    let nodes = distinct(points);
    let n = nodes.len();
    let h: Vec<f64> = nodes.windows(2).map(|pair| pair[1].0 - pair[0].0).collect();
    // K = Q R⁻¹ Qᵀ with second differences Q and the second derivatives' inner products R.
    let inner = n - 2;
    let mut r = vec![vec![0.0; inner]; inner];
    let mut q = vec![vec![0.0; n]; inner];
    for i in 0..inner {
        r[i][i] = (h[i] + h[i + 1]) / 3.0;
        if i + 1 < inner {
            (r[i][i + 1], r[i + 1][i]) = (h[i + 1] / 6.0, h[i + 1] / 6.0);
        }
        (q[i][i], q[i][i + 1], q[i][i + 2]) = (1.0 / h[i], -1.0 / h[i] - 1.0 / h[i + 1], 1.0 / h[i + 1]);
    }
    let columns: Vec<Vec<f64>> = (0..n).map(|a| q.iter().map(|row| row[a]).collect()).collect();
    let turned = solve(r.clone(), columns.clone());
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let unit = |a: usize| (0..n).map(|b| f64::from(a == b)).collect::<Vec<f64>>();
    let total = points.len() as f64;
    let mut best: Option<(f64, Vec<f64>, Vec<f64>)> = None;
    for step in 0..30 {
        let lambda = 0.01 * libm::pow(10.0, f64::from(step) * 0.25);
        let mut matrix: Vec<Vec<f64>> =
            (0..n).map(|a| (0..n).map(|b| lambda * dot(&columns[a], &turned[b])).collect()).collect();
        (0..n).for_each(|a| matrix[a][a] += nodes[a].2);
        let inverse = solve(matrix, (0..n).map(unit).collect());
        let weighted: Vec<f64> = nodes.iter().map(|node| node.1 * node.2).collect();
        let values: Vec<f64> = inverse.iter().map(|row| dot(row, &weighted)).collect();
        let trace: f64 = (0..n).map(|a| inverse[a][a] * nodes[a].2).sum();
        let (mut squares, mut left_out) = (0.0, Vec::new());
        for p in points {
            let a = nodes.partition_point(|node| node.0 < p.x - 1e-9);
            let rest = p.y - values[a];
            squares += rest * rest;
            left_out.push(rest / (1.0 - inverse[a][a]).max(1e-3));
        }
        let freedom = 1.0 - trace / total;
        let score = squares / total / (freedom * freedom).max(1e-9);
        if best.as_ref().is_none_or(|best| score < best.0) {
            best = Some((score, values, left_out));
        }
    }
    let (_, values, left_out) = best.unwrap_or_default();
    let smooth: Vec<(f64, f64, f64)> = nodes.iter().zip(&values).map(|(node, &y)| (node.0, y, 1.0)).collect();
    let second: Vec<f64> = solve(r, vec![q.iter().map(|row| dot(row, &values)).collect()]).remove(0);
    Ok(Followed { value: Box::new(move |x| natural(&smooth, &second, x)), left_out, numbers: n })
}

/// A natural cubic spline by its values and inner second derivatives.
fn natural(nodes: &[(f64, f64, f64)], second: &[f64], x: f64) -> f64 {
    let n = nodes.len();
    let i = (nodes.partition_point(|node| node.0 <= x).max(1) - 1).min(n - 2);
    let bend = |i: usize| if i == 0 || i + 1 == n { 0.0 } else { second[i - 1] };
    let h = nodes[i + 1].0 - nodes[i].0;
    let x = x.clamp(nodes[0].0, nodes[n - 1].0);
    let (a, b) = ((nodes[i + 1].0 - x) / h, (x - nodes[i].0) / h);
    let cubic = ((a * a * a - a) * bend(i) + (b * b * b - b) * bend(i + 1)) * h * h / 6.0;
    a * nodes[i].1 + b * nodes[i + 1].1 + cubic
}
