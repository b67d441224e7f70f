//! Branches become profiles: spurs go, through lines go on through junctions, small gaps close.

use super::canny::Edges;
use super::graph::{Graph, Pixel, graph};
use super::maxima::EdgePoint;
use crate::error::Result;
use crate::limits::with_room;
use crate::numerics::order::{key_of, sort_by_keys, sort_by_number};
use crate::numerics::plane::norm;
use crate::numerics::{Point, Vector};
use crate::trace::picture::bitmap::Bitmap;
use crate::trace::samples::{turn, unit};
use crate::trace::tubes::chain::Chain;

/// How branches are joined, in pixels and radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct StrandRule {
    /// Branches to an end that are shorter than this are spurs.
    pub(super) spur: f64,
    /// At junctions a line goes on where it turns by less.
    pub(super) straight: f64,
    /// Ends that are nearer than this are joined if they agree.
    pub(super) gap: f64,
    /// How much the tangents of joined ends may differ.
    pub(super) agree: f64,
    /// Profiles of fewer points are left out.
    pub(super) least: usize,
    /// How many points next to an end say nothing of its direction, and how many after them do.
    pub(super) skip: usize,
    pub(super) reach: usize,
}

/// Points in order; a ring's last point leads to the first.
#[derive(Clone, Debug)]
struct Strand {
    points: Vec<Point>,
    ring: bool,
}

/// The profiles of a picture: edge points in order, one chain for every line of them, through lines going on through
/// junctions.
///
/// Lines are thinned to one pixel. Branches to an end shorter than 5 pixels, or three deviations of the blur, go; at a
/// junction the straightest pairs go on as each other if they turn by less than 30°; lines of fewer than 6 points go;
/// ends within 3 pixels whose tangents agree within 25° are joined. Points that lie outside the picture do not count.
///
/// # Errors
///
/// Where the allocator says no.
///
/// # Cost
///
/// O(n log n) for n edge points, and a bit for each pixel.
pub fn profiles(edges: &Edges) -> Result<Vec<Chain>> {
    let mut lines = Bitmap::new(edges.width, edges.height)?;
    let mut pixels = with_room(edges.points.len())?;
    for &EdgePoint { column, row, .. } in &edges.points {
        if (column as usize) < edges.width && (row as usize) < edges.height {
            lines.set(column as usize, row as usize, true);
            pixels.push((column, row));
        }
    }
    lines.thin(&mut pixels);
    let place = |(column, row): (u32, u32)| match edges.find(column as usize, row as usize) {
        Some(i) => edges.points[i].point,
        None => Point::new(f64::from(column) + 0.5, f64::from(row) + 0.5),
    };
    let rule = StrandRule {
        spur: (3.0 * edges.sigma).max(5.0),
        straight: 30_f64.to_radians(),
        gap: 3.0,
        agree: 25_f64.to_radians(),
        least: 6,
        skip: 0,
        reach: 8,
    };
    join(&graph(&lines)?, &place, &rule)
}

/// The profiles of a graph. `place` says where a pixel's point is.
pub(super) fn join(graph: &Graph, place: &dyn Fn(Pixel) -> Point, rule: &StrandRule) -> Result<Vec<Chain>> {
    let centers: Vec<Point> = graph.nodes.iter().map(|pixels| mean(pixels, place)).collect();
    let mut ends: Vec<[usize; 2]> = Vec::new();
    let mut strands: Vec<Strand> = Vec::new();
    for branch in &graph.branches {
        let mut points: Vec<Point> = branch.pixels.iter().map(|&pixel| place(pixel)).collect();
        if let Some([first, last]) = branch.nodes {
            points.insert(0, centers[first]);
            points.push(centers[last]);
        }
        ends.push(branch.nodes.unwrap_or([usize::MAX; 2]));
        strands.push(Strand { points, ring: branch.nodes.is_none() });
    }
    prune(&mut strands, &mut ends, centers.len(), rule.spur);
    let partners = continuations(&strands, &ends, centers.len(), rule);
    let mut joined = assemble(&strands, &partners);
    joined.retain(|strand| strand.points.len() >= rule.least);
    let partners = bridges(&joined, rule);
    let whole = assemble(&joined, &partners);
    whole.into_iter().filter(|s| s.points.len() >= 2).map(|s| Chain::new(s.points, s.ring)).collect()
}

fn mean(pixels: &[Pixel], place: &dyn Fn(Pixel) -> Point) -> Point {
    let mut sum = Point::zeros();
    for &pixel in pixels {
        sum += place(pixel);
    }
    sum / pixels.len() as f64
}

fn length(points: &[Point]) -> f64 {
    points.windows(2).map(|pair| norm(pair[1] - pair[0])).sum()
}

/// Takes the shortest spurs away first, as long as there is a junction left to be cleaned.
fn prune(strands: &mut Vec<Strand>, ends: &mut Vec<[usize; 2]>, nodes: usize, spur: f64) {
    let mut degree = vec![0_usize; nodes];
    for node in ends.iter().flatten().filter(|&&node| node != usize::MAX) {
        degree[*node] += 1;
    }
    let mut order: Vec<(f64, usize)> = Vec::new();
    for (i, strand) in strands.iter().enumerate() {
        let long = length(&strand.points);
        let loose = !strand.ring && ends[i].iter().any(|&node| degree[node] == 1);
        if loose && long < spur {
            order.push((long, i));
        }
    }
    sort_by_number(&mut order, &|one| one.0);
    let mut gone = vec![false; strands.len()];
    for (_, i) in order {
        if ends[i].iter().any(|&node| degree[node] >= 3) {
            gone[i] = true;
            ends[i].iter().for_each(|&node| degree[node] -= 1);
        }
    }
    let mut i = 0;
    strands.retain(|_| {
        i += 1;
        !gone[i - 1]
    });
    i = 0;
    ends.retain(|_| {
        i += 1;
        !gone[i - 1]
    });
}

/// The direction in which a strand leaves one of its ends.
fn leaving(strand: &Strand, last: bool, rule: &StrandRule) -> Vector {
    let n = strand.points.len();
    let far = (rule.skip + rule.reach).min(n - 1);
    let near = rule.skip.min(far / 2);
    if last {
        unit(strand.points[n - 1 - far] - strand.points[n - 1 - near])
    } else {
        unit(strand.points[far] - strand.points[near])
    }
}

/// At every node the ends that go on as each other: the two at a bend, and the straightest pairs at a junction. Ends
/// are numbered two to a strand.
fn continuations(
    strands: &[Strand],
    ends: &[[usize; 2]],
    nodes: usize,
    rule: &StrandRule,
) -> Vec<Option<usize>> {
    let mut partners = vec![None; 2 * strands.len()];
    let mut at: Vec<Vec<usize>> = vec![Vec::new(); nodes];
    for (i, pair) in ends.iter().enumerate().filter(|(i, _)| !strands[*i].ring) {
        at[pair[0]].push(2 * i);
        at[pair[1]].push(2 * i + 1);
    }
    for meeting in at.iter().filter(|meeting| meeting.len() >= 2) {
        let mut pairs: Vec<(f64, usize, usize)> = Vec::new();
        for (k, &a) in meeting.iter().enumerate() {
            for &b in &meeting[k + 1..] {
                let out = leaving(&strands[a / 2], a % 2 == 1, rule);
                let other = leaving(&strands[b / 2], b % 2 == 1, rule);
                pairs.push((turn(out, -other).abs(), a, b));
            }
        }
        sort_by_keys(&mut pairs, &|&(angle, a, b)| [key_of(angle), (a as u64) << 32 | b as u64]);
        for (angle, a, b) in pairs {
            let bend = meeting.len() == 2;
            if (bend || angle < rule.straight) && partners[a].is_none() && partners[b].is_none() {
                (partners[a], partners[b]) = (Some(b), Some(a));
            }
        }
    }
    partners
}

/// Ends with a small gap between them and tangents that agree.
fn bridges(strands: &[Strand], rule: &StrandRule) -> Vec<Option<usize>> {
    let mut partners = vec![None; 2 * strands.len()];
    let mut loose: Vec<(Point, Vector, usize)> = Vec::new();
    for (i, strand) in strands.iter().enumerate().filter(|(_, strand)| !strand.ring) {
        let n = strand.points.len();
        loose.push((strand.points[0], leaving(strand, false, rule), 2 * i));
        loose.push((strand.points[n - 1], leaving(strand, true, rule), 2 * i + 1));
    }
    sort_by_number(&mut loose, &|end| end.0.x);
    let mut pairs: Vec<(f64, usize, usize)> = Vec::new();
    for (k, (p, out, a)) in loose.iter().enumerate() {
        for (q, other, b) in loose[k + 1..].iter().take_while(|(q, _, _)| q.x - p.x <= rule.gap) {
            let gap = norm(q - p);
            let whole = a / 2 != b / 2 || strands[a / 2].points.len() > 2 * rule.reach;
            let ahead = gap < 1.5 || turn(-*out, unit(q - p)).abs() < 2.0 * rule.agree;
            if gap <= rule.gap && whole && ahead && turn(-*out, *other).abs() < rule.agree {
                pairs.push((gap, *a.min(b), *a.max(b)));
            }
        }
    }
    sort_by_keys(&mut pairs, &|&(gap, a, b)| [key_of(gap), (a as u64) << 32 | b as u64]);
    for (_, a, b) in pairs {
        if partners[a].is_none() && partners[b].is_none() {
            (partners[a], partners[b]) = (Some(b), Some(a));
        }
    }
    partners
}

/// Joins strands end to end.
fn assemble(strands: &[Strand], partners: &[Option<usize>]) -> Vec<Strand> {
    let mut done = vec![false; strands.len()];
    let mut whole = Vec::new();
    // Lines begin at a loose end; what is left are rings.
    for rings in [false, true] {
        for i in 0..strands.len() {
            let loose = (0..2).find(|end| partners[2 * i + end].is_none());
            let start = match (rings, loose) {
                (true, _) => 2 * i,
                (false, Some(end)) => 2 * i + end,
                (false, None) => continue,
            };
            if !done[i] {
                whole.push(follow(strands, partners, start, &mut done));
            }
        }
    }
    whole
}

fn follow(strands: &[Strand], partners: &[Option<usize>], start: usize, done: &mut [bool]) -> Strand {
    let mut points: Vec<Point> = Vec::new();
    let mut at = start;
    let mut ring = strands[start / 2].ring;
    loop {
        let strand = &strands[at / 2];
        done[at / 2] = true;
        let mut add = |p: Point| {
            if points.last() != Some(&p) {
                points.push(p);
            }
        };
        if at.is_multiple_of(2) {
            strand.points.iter().for_each(|&p| add(p));
        } else {
            strand.points.iter().rev().for_each(|&p| add(p));
        }
        let Some(next) = partners[at ^ 1] else { break };
        if done[next / 2] {
            ring = true;
            break;
        }
        at = next;
    }
    if ring && points.len() > 1 && points.first() == points.last() {
        points.pop();
    }
    Strand { points, ring }
}
