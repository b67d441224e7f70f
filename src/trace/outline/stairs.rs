//! The outline of squares.

use super::{Node, Outline, Piece};
use crate::numerics::Point;

/// The outline along pixels' sides whose middles are given in their order, straight from corner to corner.
///
/// # Cost
///
/// O(points).
pub(in crate::trace) fn stairs(middles: &[Point]) -> Outline {
    let mut nodes = Vec::new();
    let mut before = middles[middles.len() - 1];
    for &here in middles {
        if here.x != before.x && here.y != before.y {
            // An upright side is at a whole x.
            let upright = before.x == before.x.floor();
            let point = if upright { Point::new(before.x, here.y) } else { Point::new(here.x, before.y) };
            nodes.push(Node { point, smooth: false, kept: true });
        }
        before = here;
    }
    Outline { pieces: vec![Piece::Line; nodes.len()], nodes }
}
