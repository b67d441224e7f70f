//! Many points seen from afar: averages of neighbours, to look for knots with.

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
