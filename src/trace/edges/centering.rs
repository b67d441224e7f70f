//! Lines of a skeleton moved to where the outlines on both sides say that the centre is.

use crate::error::Result;
use crate::limits::with_room;
use crate::numerics::order::{sort_by_number, sort_in_place};
use crate::numerics::plane::{cross, dot, norm, smaller, square};
use crate::numerics::{Point, Vector};
use crate::trace::samples::{line_through, unit};
use crate::trace::tubes::chain::Chain;

/// A place on an outline.
pub(super) struct Side {
    /// Where the centre of the stroke is, as this side has it.
    pub(super) centre: Point,
    /// Towards the ink, of length 1.
    pub(super) inward: Vector,
}

/// A skeleton line: smoothed points, tangents, distances along it.
struct Spine {
    points: Vec<Point>,
    tangents: Vec<Vector>,
    travelled: Vec<f64>,
    closed: bool,
}

/// What the outlines say of a line: centres beside it by their distance along it, and those of its two ends.
#[derive(Clone, Default)]
struct Evidence {
    beside: Vec<(f64, Point)>,
    ends: [Vec<(Point, Vector)>; 2],
}

/// Every line where the outlines have it: means of the centres along it, out to the middles of round ends and to where
/// lines meet.
pub(super) fn centred(lines: &[Chain], sides: &[Side], half_width: f64) -> Result<Vec<Chain>> {
    let spines: Vec<Spine> = lines.iter().map(|line| Spine::new(line, half_width)).collect();
    let evidence = gather(&spines, sides, half_width);
    let mut found: Vec<(Vec<Point>, [bool; 2])> = with_room(lines.len())?;
    for (spine, evidence) in spines.iter().zip(&evidence) {
        found.push(spine.moved(evidence, half_width));
    }
    // Ends without a cap are on another line, or their stroke is too thin for one.
    // A closed one may begin where another meets it.
    let known: Vec<Vec<Point>> = found
        .iter()
        .zip(&spines)
        .map(|((points, _), spine)| {
            points.iter().chain(points.first().filter(|_| spine.closed)).copied().collect()
        })
        .collect();
    let mut chains = with_room(lines.len())?;
    for (i, (mut points, capped)) in found.into_iter().enumerate() {
        let spine = &spines[i];
        if let Some(ring) = spine.filled_ring(&evidence[i], half_width) {
            chains.push(Chain::new(ring, true)?);
            continue;
        }
        if !spine.closed {
            for last in [false, true] {
                if !capped[usize::from(last)] {
                    if spine.is_free(last, i, &spines, half_width) {
                        spine.end_freely(&mut points, last, &evidence[i], half_width);
                    } else {
                        reach_out(&mut points, last, spine.end(last), i, &known, half_width);
                    }
                }
            }
        }
        if points.len() < 2 || norm(points[points.len() - 1] - points[0]) < 0.05 && points.len() == 2 {
            let dot = points.first().copied().unwrap_or(spine.points[0]);
            points = vec![dot, dot + Vector::new(0.1, 0.0)];
        }
        chains.push(Chain::new(points, spine.closed)?);
    }
    Ok(chains)
}

impl Spine {
    fn new(line: &Chain, half_width: f64) -> Self {
        let window = half_width.clamp(3.0, 8.0);
        let count = line.points().len();
        let (mut points, mut tangents, mut travelled) = (Vec::new(), Vec::new(), Vec::new());
        let mut sum = 0.0;
        for i in 0..count {
            let place = line.place(i, window);
            let end = !line.is_closed() && (i == 0 || i + 1 == count);
            let point = if end { line.points()[i] } else { place.point };
            if let Some(&before) = points.last() {
                sum += norm(point - before);
            }
            points.push(point);
            tangents.push(place.tangent);
            travelled.push(sum);
        }
        Self { points, tangents, travelled, closed: line.is_closed() && count > 2 }
    }

    fn length(&self) -> f64 {
        let last = self.points.len() - 1;
        let close = if self.closed { norm(self.points[0] - self.points[last]) } else { 0.0 };
        self.travelled[last] + close
    }

    /// The line's points from its evidence, and which ends have a cap.
    fn moved(&self, evidence: &Evidence, half_width: f64) -> (Vec<Point>, [bool; 2]) {
        let mut beside = evidence.beside.clone();
        sort_by_number(&mut beside, &|near| near.0);
        let mut points: Vec<Point> = Vec::new();
        for near in beside.chunk_by(|a, b| a.0.floor() == b.0.floor()) {
            let mut sum = Point::zeros();
            near.iter().for_each(|(_, p)| sum += p);
            points.push(sum / near.len() as f64);
        }
        let mut capped = [false; 2];
        if self.closed {
            return (points, capped);
        }
        for last in [false, true] {
            let centres = &evidence.ends[usize::from(last)];
            if (centres.len() as f64) < half_width.max(3.0) {
                continue;
            }
            capped[usize::from(last)] = true;
            let outward = self.outward(last, half_width);
            end_at(&mut points, last, cap(centres, outward, half_width), outward, 0.5, half_width);
        }
        (points, capped)
    }

    /// Whether an end is on no line, as a stroke's own end.
    fn is_free(&self, last: bool, own: usize, spines: &[Self], half_width: f64) -> bool {
        let (node, reach) = (self.end(last), half_width + 2.0);
        spines.iter().enumerate().all(|(k, spine)| {
            let length = spine.length();
            spine.points.iter().zip(&spine.travelled).all(|(p, &travelled)| {
                let from_end = if last { length - travelled } else { travelled };
                k == own && from_end < 3.0 * reach || square(p - node) > reach * reach
            })
        })
    }

    fn end(&self, last: bool) -> Point {
        self.points[if last { self.points.len() - 1 } else { 0 }]
    }

    /// Ends a stroke so thin that few places of its outline are about its end: straight on, as far as these or the
    /// skeleton have it.
    fn end_freely(&self, points: &mut Vec<Point>, last: bool, evidence: &Evidence, half_width: f64) {
        let (centres, outward) = (&evidence.ends[usize::from(last)], self.outward(last, half_width));
        let mut end = if centres.is_empty() { self.end(last) } else { cap(centres, outward, half_width) };
        if points.len() > 1 {
            let line = line_through(&stretch(points, last, half_width));
            end = line.middle + line.direction * dot(end - line.middle, line.direction);
        }
        end_at(points, last, end, outward, 0.5, half_width);
    }

    /// A disc wider than the strokes is a ring whose hole is filled: its centre line is a circle. `None` for other
    /// lines.
    fn filled_ring(&self, evidence: &Evidence, half_width: f64) -> Option<Vec<Point>> {
        let ends = evidence.ends.iter().flatten().map(|&(centre, _)| centre);
        let mut centres: Vec<Point> = ends.chain(evidence.beside.iter().map(|&(_, p)| p)).collect();
        if self.length() > 0.4 * half_width + 3.0 || centres.len() < 16 {
            return None;
        }
        let count = centres.len() as f64;
        let mut middle = Point::zeros();
        centres.iter().for_each(|p| middle += p / count);
        let radius = centres.iter().map(|p| norm(p - middle)).sum::<f64>() / count;
        let round = centres.iter().all(|p| (norm(p - middle) - radius).abs() < 0.25 * radius);
        if radius < 0.1 * half_width + 0.4 || !round {
            return None;
        }
        let angle = |p: &Point| libm::atan2(p.y - middle.y, p.x - middle.x);
        sort_by_number(&mut centres, &angle);
        Some(centres)
    }

    /// Where the line leads at an end. A skeleton ends in a corner of its stroke, so what is before that says it.
    fn outward(&self, last: bool, half_width: f64) -> Vector {
        let length = self.travelled[self.travelled.len() - 1];
        let before = smaller(1.5 * half_width + 2.0, 0.5 * length);
        let at = if last { length - before } else { before };
        let i = self.travelled.partition_point(|&travelled| travelled < at);
        if last { self.tangents[i] } else { -self.tangents[i] }
    }
}

/// The middle of a round end, or the middle of a flat one.
fn cap(centres: &[(Point, Vector)], outward: Vector, half_width: f64) -> Point {
    let (mut sum, mut flat, mut facing) = (Point::zeros(), Point::zeros(), 0.0);
    for (centre, inward) in centres {
        sum += centre;
        flat += centre - inward * half_width;
        facing -= dot(*inward, outward);
    }
    let count = centres.len() as f64;
    // A round end seen over ±40° faces outwards by 0.91 on average, a flat one by 1.
    if facing > 0.985 * count { flat / count } else { sum / count }
}

/// Gives every place of an outline to the nearest line.
fn gather(spines: &[Spine], sides: &[Side], half_width: f64) -> Vec<Evidence> {
    let reach = 0.7 * half_width + 2.0;
    let mut index: Vec<(i32, i32, u32, u32)> = Vec::new();
    let cell = |p: Point| ((p.x / reach).floor() as i32, (p.y / reach).floor() as i32);
    for (k, spine) in spines.iter().enumerate() {
        for (i, &p) in spine.points.iter().enumerate() {
            let (x, y) = cell(p);
            index.push((x, y, k as u32, i as u32));
        }
    }
    sort_in_place(&mut index);
    let mut evidence = vec![Evidence::default(); spines.len()];
    for side in sides {
        let (x, y) = cell(side.centre);
        let mut best = (reach * reach, 0, 0);
        for column in x - 1..=x + 1 {
            let from = index.partition_point(|entry| (entry.0, entry.1) < (column, y - 1));
            for &(c, r, k, i) in &index[from..] {
                if (c, r) > (column, y + 1) {
                    break;
                }
                let off = square(spines[k as usize].points[i as usize] - side.centre);
                if off < best.0 {
                    best = (off, k as usize, i as usize + 1);
                }
            }
        }
        if best.2 > 0 {
            place(&spines[best.1], best.2 - 1, side, half_width, &mut evidence[best.1]);
        }
    }
    evidence
}

/// Counts a side of the ink at the place of the line that it is nearest to, or as a part of the line's end.
fn place(spine: &Spine, i: usize, side: &Side, half_width: f64, evidence: &mut Evidence) {
    let tangent = spine.tangents[i];
    let length = spine.length();
    if !spine.closed {
        for last in [false, true] {
            let from_end = if last { length - spine.travelled[i] } else { spine.travelled[i] };
            if from_end < half_width + 3.0 && dot(side.inward, spine.outward(last, half_width)) < -0.75 {
                evidence.ends[usize::from(last)].push((side.centre, side.inward));
                return;
            }
        }
    }
    if dot(side.inward, tangent).abs() < 0.6 {
        let mut s = spine.travelled[i] + dot(side.centre - spine.points[i], tangent);
        if spine.closed {
            s -= length * (s / length).floor();
        }
        evidence.beside.push((s, side.centre));
    }
}

/// The last places of a line, the last one last.
fn stretch(points: &[Point], last: bool, half_width: f64) -> Vec<Point> {
    let tail = ((1.2 * half_width) as usize + 5).min(points.len());
    if last { points[points.len() - tail..].to_vec() } else { points[..tail].iter().rev().copied().collect() }
}

/// Lengthens a line straight on to the line that it meets, or to the skeleton's junction.
fn reach_out(
    points: &mut Vec<Point>,
    last: bool,
    node: Point,
    own: usize,
    known: &[Vec<Point>],
    half_width: f64,
) {
    if points.len() < 2 {
        points.push(node);
        return;
    }
    let stretch = stretch(points, last, half_width);
    let tail = stretch.len();
    let line = line_through(&stretch);
    let end = stretch[tail - 1];
    let mut best = (3.0 * half_width + 3.0, None);
    for (k, other) in known.iter().enumerate() {
        let skip = if k == own { 2 * tail } else { 0 };
        let within = match (skip, last) {
            (0, _) => &other[..],
            (skip, true) => &other[..other.len().saturating_sub(skip)],
            (skip, false) => &other[skip.min(other.len())..],
        };
        for pair in within.windows(2) {
            if let Some((ahead, point)) = crossing(end, line.direction, pair[0], pair[1])
                && ahead > -half_width
                && ahead.abs() < best.0
            {
                best = (ahead.abs(), Some(point));
            }
        }
    }
    let target = best.1.unwrap_or(node);
    if norm(target - end) > 3.5 * half_width + 3.0 {
        return;
    }
    end_at(points, last, target, unit(line.direction), 0.3, half_width);
}

/// Ends a line at a place: points near it go that are not at least `before` it, seen along the way outwards.
fn end_at(points: &mut Vec<Point>, last: bool, end: Point, outward: Vector, before: f64, half_width: f64) {
    points.retain(|p| dot(p - end, outward) < -before || norm(p - end) > 2.0 * half_width);
    points.insert(if last { points.len() } else { 0 }, end);
}

/// Where a ray meets a segment, and how far ahead.
fn crossing(from: Point, direction: Vector, a: Point, b: Point) -> Option<(f64, Point)> {
    let (side, other) = (cross(direction, a - from), cross(direction, b - from));
    if side * other > 0.0 || side == other {
        return None;
    }
    let point = a + (b - a) * (side / (side - other));
    Some((dot(point - from, direction), point))
}
