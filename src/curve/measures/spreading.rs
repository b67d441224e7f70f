//! How many parts, and where they end: evenly over a density that says how many are wanted where.

/// So many parts that each holds at most one of the `total`.
pub(super) fn part_count(total: f64) -> usize {
    (total + 1.0).max(1.0) as usize
}

/// So many equal parts that a bound with the power `order` of their number is within the tolerance.
pub(super) fn equal_parts(bound: f64, tolerance: f64, order: i32) -> f64 {
    let root = (bound / tolerance).sqrt();
    (if order == 2 { root } else { root.sqrt() }).ceil().max(1.0)
}

/// Fills in the places that divide what is wanted evenly, of which there are `before` before each edge.
#[inline(never)]
pub(super) fn spread(edges: &[f64], before: &[f64], places: &mut [f64]) {
    let cells = before.len() - 1;
    let edges = &edges[..=cells];
    let step = before[cells] / (places.len() + 1) as f64;
    let (mut cell, mut target) = (0, 0.0);
    let mut rise = 1.0 / (before[1] - before[0]);
    for place in places {
        target += step;
        while cell + 1 < cells && target > before[cell + 1] {
            cell += 1;
            rise = 1.0 / (before[cell + 1] - before[cell]);
        }
        let share = (target - before[cell]) * rise;
        let share = if share < 1.0 { share } else { 1.0 };
        *place = edges[cell] + share * (edges[cell + 1] - edges[cell]);
    }
}
