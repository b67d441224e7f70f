//! Many points seen from afar: averages of neighbours, to look for knots with.

use super::breaks::Breaks;
use super::free_knots::Located;
use crate::numerics::Point;

/// Averages of neighbouring points, about `count` of them, each with the weight of all that it stands for.
pub(super) fn averages(data: &Located, count: usize) -> Located {
    let size = data.points.len().div_ceil(count.max(1)).max(1);
    let mut bins = Located::default();
    for from in (0..data.points.len()).step_by(size) {
        let to = (from + size).min(data.points.len());
        let (mut point, mut t, mut weight) = (Point::zeros(), 0.0, 0.0);
        for m in from..to {
            let w = data.weight(m);
            point += data.points[m] * w;
            t += data.parameters[m] * w;
            weight += w;
        }
        if weight > 0.0 {
            bins.points.push(point / weight);
            bins.parameters.push(t / weight);
            bins.weights.push(weight);
        }
    }
    bins
}

/// The parameters of points whose averages, about `count` of them, had those of `before` once and have those of `after`
/// now: between the middles of two averages points move as both do.
pub(super) fn followed(
    data: &Located,
    count: usize,
    [before, after]: [&[f64]; 2],
    breaks: &Breaks,
) -> Vec<f64> {
    let mut parameters = data.parameters.clone();
    let (bins, size) = (before.len(), data.points.len().div_ceil(count.max(1)).max(1));
    // Averages without weight are not there: neighbours are not known then.
    if after.len() != bins || bins == 0 || data.points.len().div_ceil(size) != bins {
        return parameters;
    }
    let moved = |bin: usize| {
        let by = after[bin] - before[bin];
        if breaks.closed { by - breaks.end * libm::round(by / breaks.end) } else { by }
    };
    let mut moves = Vec::with_capacity(bins + 2);
    moves.push(moved(if breaks.closed { bins - 1 } else { 0 }));
    moves.extend((0..bins).map(moved));
    moves.push(moved(if breaks.closed { 0 } else { bins - 1 }));
    for (m, t) in parameters.iter_mut().enumerate() {
        let place = (2 * m + 1 + size) as f64 / (2 * size) as f64;
        let bin = place as usize;
        *t += moves[bin] + (moves[bin + 1] - moves[bin]) * (place - bin as f64);
        *t = if breaks.closed { breaks.wrapped(*t) } else { t.max(0.0).min(breaks.end) };
    }
    parameters
}

#[cfg(test)]
mod tests {
    use super::{averages, followed};
    use crate::fit::knots::breaks::Breaks;
    use crate::fit::knots::free_knots::Located;
    use crate::numerics::Point;

    #[test]
    fn points_follow_their_averages() {
        let end = 100.0;
        let parameters: Vec<f64> = (0..100).map(f64::from).collect();
        let data = Located { points: vec![Point::zeros(); 100], parameters, weights: Vec::new() };
        let before = averages(&data, 16).parameters;
        for closed in [true, false] {
            let moved = |t: f64| t + 3.0 * (t / end * core::f64::consts::TAU).sin();
            let after: Vec<f64> = before.iter().map(|&t| moved(t)).collect();
            let found = followed(&data, 16, [&before, &after], &Breaks::even(3, closed, end, 4));
            for (t, &got) in data.parameters.iter().zip(&found) {
                let off = (got - moved(*t)).abs();
                assert!(off.min(end - off) < 0.6 && (0.0..=end).contains(&got), "{got} for {}", moved(*t));
            }
        }
        // Over the seam and back.
        let after: Vec<f64> = before.iter().map(|&t| (t + 97.0) % end).collect();
        let round = Breaks::even(3, true, end, 4);
        for (t, got) in data.parameters.iter().zip(followed(&data, 16, [&before, &after], &round)) {
            let off = (got - (t + 97.0) % end).abs();
            assert!(off.min(end - off) < 1e-9, "{got} for {t}");
        }
    }
}
