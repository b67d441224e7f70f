//! How many knots and neighbours: every point left out once, in closed form.

use super::choice::{Choice, Rule, Score};
use super::cloud::Cloud;
use super::knots::Knots;
use super::local::LocalFit;
use super::placement::Placement;
use super::{End, Estimator, QuasiInterpolant, check_digits, held};
use crate::error::Result;
use crate::limits::{check, filled, with_room};
use crate::trace::metrics::{mean_absolute, root_mean_square};

/// The exact leave-one-out scores of the mean estimator for k = 1 … `most`, without fitting anything twice.
///
/// A point that is left out matters only to coefficients among whose neighbours it is; there the next neighbour takes
/// its place (D 14.1). Coefficients that `ends` hold stay held.
///
/// # Errors
///
/// `most` of 0, or of the number of points or more: one more neighbour has to be there.
///
/// # Cost
///
/// O(n·most² + N·most·p).
pub fn leave_one_out(cloud: &Cloud, knots: &Knots, most: usize, ends: [End; 2]) -> Result<Vec<Score>> {
    check("neighbours", None, most as f64, 1.0, (cloud.len() - 1) as f64)?;
    // Row i holds the errors at point i for all k: first the ordinate, then all that is predicted is taken off.
    let mut errors = filled(0.0, cloud.len() * most)?;
    let mut means = filled(0.0, knots.count() * most)?;
    let mut order = with_room(most + 1)?;
    for q in 0..knots.count() {
        let means = &mut means[q * most..(q + 1) * most];
        if let Some(value) = held(knots, q, ends) {
            means.fill(value);
            continue;
        }
        cloud.nearest(knots.abscissa(q), most + 1, &mut order);
        let mut sum = 0.0;
        for (mean, (&i, count)) in means.iter_mut().zip(order.iter().zip(1_usize..)) {
            sum += cloud.y()[i];
            *mean = sum / count as f64;
        }
        for (rank, &i) in order[..most].iter().enumerate() {
            let (first, values) = knots.values(cloud.x()[i]);
            if !(first..=first + knots.degree()).contains(&q) {
                continue;
            }
            for count in rank + 1..=most {
                let change = (cloud.y()[order[count]] - cloud.y()[i]) / count as f64;
                errors[i * most + count - 1] -= values[q - first] * change;
            }
        }
    }
    for i in 0..cloud.len() {
        let (first, values) = knots.values(cloud.x()[i]);
        for (at, error) in errors[i * most..(i + 1) * most].iter_mut().enumerate() {
            let local = means[first * most..].chunks_exact(most).zip(&values[..=knots.degree()]);
            *error += cloud.y()[i] - local.map(|(means, value)| means[at] * value).sum::<f64>();
        }
    }
    let mut scores = with_room(most)?;
    for at in 0..most {
        let column = || errors[at..].iter().step_by(most).copied();
        scores.push(Score { rmse: root_mean_square(column()), mae: mean_absolute(column()) });
    }
    Ok(scores)
}

/// Generalised cross-validation of the local estimator: the root mean square of the residuals over 1 − tr H/N, and tr
/// H, where H takes ordinates to values.
///
/// # Errors
///
/// As [`QuasiInterpolant::new`].
pub fn generalised_cross_validation(
    cloud: &Cloud,
    knots: &Knots,
    k: usize,
    ends: [End; 2],
) -> Result<(f64, f64)> {
    let fitted = QuasiInterpolant::new(cloud, knots.clone(), Estimator::Local { k }, ends)?;
    let mut local = LocalFit::new(k)?;
    let mut trace = 0.0;
    for q in (0..knots.count()).filter(|&q| held(knots, q, ends).is_none()) {
        local.weigh(cloud, knots, q);
        for (i, share) in local.influence() {
            let (first, values) = knots.values(cloud.x()[i]);
            if (first..=first + knots.degree()).contains(&q) {
                trace += share * values[q - first];
            }
        }
    }
    let freedom = 1.0 - trace / cloud.len() as f64;
    let residuals = fitted.residuals(cloud)?;
    let score = root_mean_square(residuals.iter().copied());
    check_digits((score + trace).is_finite())?;
    Ok((if freedom > 1e-6 { score / freedom } else { f64::MAX }, trace))
}

/// How the spline of a tube is estimated, and how many knots and neighbours it gets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// Means of the nearest, chosen by leaving out every point once.
    Mean(Rule),
    /// Projections onto splines whose knots are where they are needed (D 14.11): of all that are tried the ones with
    /// the least ln(max(error, `floor`)) + `price`·knots/points, the error being that of predicting each point from all
    /// the others.
    Placed {
        /// 1.5 makes a knot pay for three times the noise of a point, in squares.
        price: f64,
        /// Errors below are as good as none, in the unit of the ordinates.
        floor: f64,
    },
}

/// The root mean square error of predicting each point from the others by the local estimator, its weights kept:
/// r/(1 − h) with h the share of a point's ordinate in its own value.
///
/// # Errors
///
/// As [`QuasiInterpolant::new`].
pub fn left_out_locally(cloud: &Cloud, knots: &Knots, k: usize, ends: [End; 2]) -> Result<f64> {
    let fitted = QuasiInterpolant::new(cloud, knots.clone(), Estimator::Local { k }, ends)?;
    let mut local = LocalFit::new(k)?;
    let mut own = filled(0.0, cloud.len())?;
    for q in (0..knots.count()).filter(|&q| held(knots, q, ends).is_none()) {
        local.weigh(cloud, knots, q);
        for (i, share) in local.influence() {
            let (first, values) = knots.values(cloud.x()[i]);
            if (first..=first + knots.degree()).contains(&q) {
                own[i] += share * values[q - first];
            }
        }
    }
    let residuals = fitted.residuals(cloud)?;
    let score = root_mean_square(residuals.iter().zip(&own).map(|(r, h)| r / (1.0 - h).max(0.05)));
    check_digits(score.is_finite())?;
    Ok(score)
}

/// The knots of a tube and its number of neighbours, by the method's rule: even ones, up to the least of 8 and a third
/// of the points less two, with 1 … 9 neighbours, for means; or placed ones.
///
/// `None` where there are fewer than 3 points: such a tube is a line.
///
/// # Errors
///
/// As [`Knots::even`]; a price or a floor that is negative.
///
/// # Source
///
/// \[RB21, section 3.3\], with the ranges of (D 14.1).
pub fn choose(
    cloud: &Cloud,
    start: f64,
    end: f64,
    degree: usize,
    ends: [End; 2],
    method: Method,
) -> Result<Option<(Choice, Knots)>> {
    if cloud.len() < 3 {
        return Ok(None);
    }
    let least = usize::from(ends.iter().all(|end| matches!(end, End::Tangent(_))));
    let rule = match method {
        Method::Mean(rule) => rule,
        Method::Placed { price, floor } => {
            check("price", None, price, 0.0, f64::MAX)?;
            check("floor", None, floor, 0.0, f64::MAX)?;
            Knots::even(start, end, least, degree)?;
            let floor = floor.max(f64::MIN_POSITIVE);
            return Placement { cloud, start, end, degree, ends, least, price, floor }.place().map(Some);
        }
    };
    let most = 8.min((cloud.len() / 3).saturating_sub(2)).max(least);
    let mut best: Vec<Choice> = with_room(most + 1)?;
    for interior in least..=most {
        let knots = Knots::even(start, end, interior, degree)?;
        best.push(best_mean(cloud, &knots, interior, ends)?);
    }
    let lowest = best.iter().fold(f64::MAX, |lowest, choice| lowest.min(choice.score));
    let limit = match rule {
        Rule::Least => lowest,
        Rule::Parsimonious { share, slack } => lowest + (share * lowest).max(slack),
    };
    match best.into_iter().find(|choice| choice.score <= limit) {
        Some(choice) => Ok(Some((choice, Knots::even(start, end, choice.interior, degree)?))),
        None => Ok(None),
    }
}

fn best_mean(cloud: &Cloud, knots: &Knots, interior: usize, ends: [End; 2]) -> Result<Choice> {
    let scores = leave_one_out(cloud, knots, 9.min(cloud.len() - 1), ends)?;
    let mut choice = Choice { interior, k: 1, score: scores[0].rmse };
    for (score, k) in scores.iter().zip(1..) {
        if score.rmse <= choice.score {
            choice = Choice { interior, k, score: score.rmse };
        }
    }
    Ok(choice)
}
