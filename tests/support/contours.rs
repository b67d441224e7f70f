//! Recorded contours that fits are measured on.

use super::golden;
use expline::numerics::Point;
use serde::Deserialize;
use std::collections::BTreeMap;

#[derive(Deserialize)]
struct Recorded {
    sets: BTreeMap<String, Vec<f64>>,
}

/// The points of one of them.
pub(crate) fn contour(name: &str) -> Vec<Point> {
    let recorded: Recorded = golden::parse(include_str!("../golden/sparse/grid.json"));
    recorded.sets[name].chunks_exact(2).map(|p| Point::new(p[0], p[1])).collect()
}
