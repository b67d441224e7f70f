//! Which nodes of a long outline move together.

use super::coverage::Part;
use super::refine::Shape;

/// Nodes of a long outline that move together, and about how many parts beside them do.
pub(super) const BLOCK: usize = 512;
const PARTS: usize = 32_768;

/// The end of the nodes that move together, from one on: all, if they are not too many.
pub(super) fn block_end(shape: &Shape, first: usize) -> usize {
    let parts: usize = shape.parts.iter().map(Vec::len).sum();
    let count = shape.outline.len();
    if count <= 2 * BLOCK && parts <= 2 * PARTS {
        return count;
    }
    let mut room = PARTS;
    let fits = |parts: &&Vec<Part>| {
        room = room.saturating_sub(parts.len());
        room > 0
    };
    first + shape.parts[first..].iter().take(BLOCK).take_while(fits).count().max(1)
}
