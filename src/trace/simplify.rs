//! Fewer pieces: joints that the picture does not ask for are taken away.

use super::coverage::{Band, Coverage};
use super::cubic::{Cubic, Tangent};
use super::outline::{Node, Outline, Piece};
use super::refine::{refine, residual};
use super::samples::{turn, unit};
use crate::error::Result;
use crate::numerics::Point;
use crate::numerics::plane::dot;

/// What a merged piece may leave of the picture.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    /// The root mean square of coverage that is always allowed.
    pub(super) rms: f64,
    /// The largest difference of coverage in a pixel that is always allowed.
    pub(super) most: f64,
    /// The noise of one pixel; 0 for a clean picture.
    pub(super) noise: f64,
    /// How much the sum of squares may grow, in squares of the noise.
    pub(super) share: f64,
}

/// What is left of the picture in the pixels of one piece.
#[derive(Clone, Copy, Debug, Default)]
struct Left {
    square: f64,
    count: f64,
    most: f64,
}

/// A joint that was taken away, as it was.
struct Merged {
    outline: usize,
    /// The piece that is there instead.
    piece: usize,
    node: Node,
    pieces: [Piece; 2],
    left: Left,
    /// Whether one of the pieces was no piece at all.
    forced: bool,
}

/// Rounds of merging; each takes away up to every third joint.
const MOST_ROUNDS: usize = 12;

/// Takes joints away while the picture stays as well explained as `limits` say, after so many steps of refinement.
fn simplify(outlines: &mut [Outline], band: &Band, limits: &Limits, steps: usize) -> Result<()> {
    outlines.iter_mut().for_each(|outline| outline.nodes.iter_mut().for_each(|node| node.kept = false));
    let mut restored = false;
    for _ in 0..MOST_ROUNDS {
        // What was put back has to settle before anything is compared with it.
        if restored {
            refine(outlines, band, steps.min(4))?;
        }
        restored = false;
        let lefts = measure(&band.cover(outlines)?, band);
        let mut merged = Vec::new();
        let mut first = 0;
        for (i, outline) in outlines.iter_mut().enumerate() {
            let count = outline.len();
            merge(outline, i, &lefts[first..first + count], &mut merged);
            first += count;
        }
        if merged.is_empty() {
            break;
        }
        refine(outlines, band, steps)?;
        let lefts = measure(&band.cover(outlines)?, band);
        let starts: Vec<usize> = outlines
            .iter()
            .scan(0, |sum, outline| {
                let start = *sum;
                *sum += outline.len();
                Some(start)
            })
            .collect();
        // From the back, so that places in front stay.
        for merge in merged.iter().rev() {
            let now = lefts[starts[merge.outline] + merge.piece];
            let outline = &mut outlines[merge.outline];
            if good(&now, &merge.left, merge.forced, limits) {
                // What is longer now may grow further.
                let next = outline.next(merge.piece);
                outline.nodes[merge.piece].kept = false;
                outline.nodes[next].kept = false;
            } else {
                restore(outline, merge);
                restored = true;
            }
        }
        outlines.iter_mut().for_each(Outline::align);
    }
    Ok(())
}

/// The root mean square of what is left in the pixels of every outline.
fn by_outline(outlines: &[Outline], band: &Band) -> Result<Vec<f64>> {
    let lefts = measure(&band.cover(outlines)?, band);
    let mut first = 0;
    Ok(outlines
        .iter()
        .map(|outline| {
            let own = &lefts[first..first + outline.len()];
            first += outline.len();
            let (square, count) = own
                .iter()
                .fold((0.0, 0.0), |(square, count), left| (square + left.square, count + left.count));
            (square / f64::max(count, 1.0)).sqrt()
        })
        .collect())
}

/// Fewer pieces, then a last refinement. An outline that lost its way is as it was before. Returns what is left of the picture.
pub(super) fn finish(outlines: &mut [Outline], band: &Band, limits: &Limits) -> Result<f64> {
    let start = outlines.to_vec();
    let before = by_outline(outlines, band)?;
    simplify(outlines, band, limits, 3)?;
    simplify(outlines, band, limits, 8)?;
    outlines.iter_mut().for_each(Outline::straighten);
    let left = refine(outlines, band, 8)?;
    let after = by_outline(outlines, band)?;
    let mut lost = false;
    for (i, outline) in outlines.iter_mut().enumerate() {
        if after[i] > (1.5 * before[i]).max(2.0 * limits.rms) {
            *outline = start[i].clone();
            lost = true;
        }
    }
    if lost { refine(outlines, band, 8) } else { Ok(left) }
}

fn good(now: &Left, before: &Left, forced: bool, limits: &Limits) -> bool {
    if now.square <= before.square + limits.share * limits.noise * limits.noise {
        return true;
    }
    let rms = (now.square / now.count.max(1.0)).sqrt();
    // Joints that slid past each other hide their own cost.
    let ease = if forced { 3.0 } else { 1.0 };
    rms <= ease * limits.rms && now.most <= ease * limits.most
}

fn measure(coverage: &Coverage, band: &Band) -> Vec<Left> {
    let rest = residual(coverage, band);
    let mut first = 0;
    coverage
        .ends
        .iter()
        .map(|&end| {
            let mut left = Left::default();
            for touch in &coverage.touches[first..end] {
                let value = f64::from(rest[touch.pixel as usize]);
                left.square += value * value;
                left.count += 1.0;
                left.most = left.most.max(value.abs());
            }
            first = end;
            left
        })
        .collect()
}

/// Merges pieces at joints that are not next to each other, the likeliest first.
fn merge(outline: &mut Outline, index: usize, lefts: &[Left], merged: &mut Vec<Merged>) {
    let count = outline.len();
    let mut candidates = Vec::new();
    for i in 0..count {
        if let Some((piece, off)) = candidate(outline, i) {
            candidates.push((i, piece, off));
        }
    }
    candidates.sort_by(|a, b| a.2.total_cmp(&b.2).then(a.0.cmp(&b.0)));
    let mut taken = vec![false; count];
    let mut chosen: Vec<Option<Piece>> = vec![None; count];
    let mut left = count;
    for (i, piece, _) in candidates {
        let around = [outline.before(outline.before(i)), outline.before(i), i, outline.next(i)];
        if around.iter().any(|&j| taken[j]) || left <= 2 {
            continue;
        }
        taken[outline.before(i)] = true;
        taken[i] = true;
        taken[outline.next(i)] = true;
        chosen[i] = Some(piece);
        left -= 1;
    }
    let (mut nodes, mut pieces): (Vec<Node>, Vec<Piece>) = (Vec::new(), Vec::new());
    // If the first joint goes, the last piece takes its place.
    for ((piece, &node), &old) in chosen.iter().zip(&outline.nodes).zip(&outline.pieces) {
        if piece.is_none() {
            nodes.push(node);
            pieces.push(old);
        }
    }
    let mut place = 0;
    for (i, &piece) in chosen.iter().enumerate() {
        let Some(piece) = piece else {
            place += 1;
            continue;
        };
        let before = outline.before(i);
        let at = if place == 0 { pieces.len() - 1 } else { place - 1 };
        pieces[at] = piece;
        let sum = Left {
            square: lefts[before].square + lefts[i].square,
            count: lefts[before].count + lefts[i].count,
            most: lefts[before].most.max(lefts[i].most),
        };
        let old = [outline.pieces[before], outline.pieces[i]];
        let forced = stunted(outline, before) || stunted(outline, i);
        merged.push(Merged {
            outline: index,
            piece: at,
            node: outline.nodes[i],
            pieces: old,
            left: sum,
            forced,
        });
    }
    // Restoring goes from the back: the one that wraps around is last.
    let from = merged.iter().position(|m| m.outline == index).unwrap_or(merged.len());
    merged[from..].sort_by_key(|m| m.piece);
    outline.nodes = nodes;
    outline.pieces = pieces;
}

/// Whether a piece runs against its own tangents: its joints slid past each other.
fn stunted(outline: &Outline, i: usize) -> bool {
    let Cubic { start, leaving, arriving, end } = outline.cubic(i);
    let chord = end - start;
    let smooth = outline.nodes[i].smooth && outline.nodes[outline.next(i)].smooth;
    smooth && dot(chord, leaving) < 0.0 && dot(chord, arriving) < 0.0
}

/// The piece in place of the two at joint i, and how far it is from them.
fn candidate(outline: &Outline, i: usize) -> Option<(Piece, f64)> {
    let node = outline.nodes[i];
    let before = outline.before(i);
    let stunted = node.smooth && (stunted(outline, before) || stunted(outline, i));
    if (node.kept && !stunted) || outline.len() <= 2 {
        return None;
    }
    let (first, second) = (outline.cubic(before), outline.cubic(i));
    let bend = turn(first.velocity(1.0), second.velocity(0.0)).abs();
    if !node.smooth && bend > 0.2 {
        return None;
    }
    let whole = turn(unit(first.velocity(0.0)), unit(first.velocity(0.5))).abs()
        + turn(unit(first.velocity(0.5)), unit(second.velocity(0.5))).abs()
        + turn(unit(second.velocity(0.5)), unit(second.velocity(1.0))).abs();
    if whole > 2.6 && !stunted {
        return None;
    }
    let mut places: Vec<Point> = Vec::with_capacity(32);
    for cubic in [first, second] {
        places.extend((0..16).map(|k| cubic.point((f64::from(k) + 0.5) / 16.0)));
    }
    let tangent = |at: usize, line: bool, direction| {
        if outline.nodes[at].smooth && !line { Tangent::Along(unit(direction)) } else { Tangent::Free }
    };
    if outline.is_line(before) && outline.is_line(i) {
        let fitted = Cubic::fit(first.start, second.end, &places, [Tangent::Free; 2]);
        return (bend < 0.1).then_some((Piece::Line, fitted.rms));
    }
    let tangents = [
        tangent(before, outline.is_line(before), first.velocity(0.0)),
        tangent(outline.next(i), outline.is_line(i), second.velocity(1.0)),
    ];
    let fitted = Cubic::fit(first.start, second.end, &places, tangents);
    let Cubic { leaving, arriving, .. } = fitted.cubic;
    (fitted.rms < 0.4 || stunted).then_some((Piece::Cubic { leaving, arriving }, fitted.rms))
}

/// Puts a joint back where it was.
fn restore(outline: &mut Outline, merge: &Merged) {
    let node = Node { kept: true, ..merge.node };
    outline.pieces[merge.piece] = merge.pieces[0];
    outline.nodes.insert(merge.piece + 1, node);
    outline.pieces.insert(merge.piece + 1, merge.pieces[1]);
}
