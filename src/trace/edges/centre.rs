//! Centre lines of strokes: a skeleton says how they run, outlines say where.

use super::beyond::{go_on, inside, outside};
use super::centering::{Side, centred};
use super::graph::{Branch, Graph, Pixel, graph};
use super::strands::{StrandRule, join};
use crate::error::Result;
use crate::limits::with_room;
use crate::numerics::order::{sort_in_place, sort_numbers};
use crate::numerics::plane::smaller;
use crate::numerics::{Point, Vector};
use crate::trace::picture::bitmap::Bitmap;
use crate::trace::picture::contour::Contour;
use crate::trace::picture::gray::Gray;
use crate::trace::samples::{Samples, unit};
use crate::trace::tubes::chain::Chain;

/// Centre lines, and half the width of most strokes.
pub(in crate::trace) struct CentreLines {
    pub(in crate::trace) chains: Vec<Chain>,
    pub(in crate::trace) half_width: f64,
}

/// The ink of a picture, from 1 at the outline upwards.
struct Ink<'a> {
    gray: &'a Gray,
    level: f64,
    sign: f64,
    /// How far the first pixel lies before the places, in x and in y.
    margin: f64,
}

/// What the ink is beyond the border, for each pixel.
const DEEPEST: f64 = 65_280.0;

impl Ink<'_> {
    /// How far a place is on the ink's side of the level, between four pixels; the picture lies on paper.
    fn at(&self, p: Point) -> f64 {
        let p = p + Vector::new(self.margin, self.margin);
        let paper = -DEEPEST * outside(p, Vector::new(self.gray.width() as f64, self.gray.height() as f64));
        smaller(self.sign * (self.level - self.gray.between(p)), paper)
    }

    /// The way through the ink from a place on the outline.
    fn across(&self, p: Point, inward: Vector, most: f64) -> f64 {
        let (mut travelled, mut before) = (0.5, self.at(p + inward * 0.5));
        while travelled < most {
            let here = self.at(p + inward * (travelled + 0.5));
            if here <= 0.0 {
                return travelled + if before > here { 0.5 * before.max(0.0) / (before - here) } else { 0.0 };
            }
            travelled += 0.5;
            before = here;
        }
        most
    }
}

/// The centre lines of the strokes that contours enclose.
///
/// # Cost
///
/// O(pixels + length of the outlines times the strokes' width).
pub(in crate::trace) fn centre_lines(
    gray: &Gray,
    level: f64,
    inverted: bool,
    contours: &mut [Contour],
) -> Result<CentreLines> {
    let sign = if inverted { -1.0 } else { 1.0 };
    let wide = go_on(gray, sign, contours)?;
    let (ink, margin) = match &wide {
        Some((wide, margin)) => (wide, *margin as f64),
        None => (gray, 0.0),
    };
    let ink = Ink { gray: ink, level, sign, margin };
    let (lines, deepest) = skeleton(&ink)?;
    let (sides, half_width) = sides(&ink, contours, deepest)?;
    let graph = merged(graph(&lines)?, 1.2 * half_width);
    let rule = StrandRule {
        spur: 1.4 * half_width + 1.0,
        straight: 40_f64.to_radians(),
        gap: 0.0,
        agree: 0.1,
        least: 1,
        skip: (0.8 * half_width) as usize,
        reach: (2.0 * half_width) as usize + 4,
    };
    let place =
        |(column, row): Pixel| Point::new(f64::from(column) + 0.5 - margin, f64::from(row) + 0.5 - margin);
    let chains = join(&graph, &place, &rule)?;
    // In ink that is no stroke, as a sheet of it with holes, middles of what are no two sides may lie beyond the
    // picture, too.
    let chains = inside(centred(&chains, &sides, half_width)?, gray)?;
    Ok(CentreLines { chains, half_width })
}

/// The ink thinned to lines, from the outline inwards, and how deep the ink is in pixels.
fn skeleton(ink: &Ink) -> Result<(Bitmap, f64)> {
    let (width, height) = (ink.gray.width(), ink.gray.height());
    let mut lines = Bitmap::new(width, height)?;
    for row in 0..height {
        for (column, &shade) in ink.gray.row(row).iter().enumerate() {
            lines.set(column, row, ink.sign * (ink.level - f64::from(shade)) > 0.0);
        }
    }
    let depth = depths(&lines)?;
    let mut order: Vec<(u16, u32)> = with_room(lines.count())?;
    order.extend(lines.pixels().map(|(c, r)| (depth[r * width + c], (r * width + c) as u32)));
    sort_in_place(&mut order);
    let mut layer: Vec<(u32, u32)> = Vec::new();
    for same in order.chunk_by(|a, b| a.0 == b.0) {
        layer.clear();
        layer.extend(same.iter().map(|&(_, pixel)| (pixel % width as u32, pixel / width as u32)));
        lines.thin(&mut layer);
    }
    Ok((lines, f64::from(order.last().map_or(0, |&(depth, _)| depth)) / 5.0))
}

/// The distance of every pixel to the paper in fifths of a pixel: 5 to a side, 7 to a corner, two passes.
fn depths(ink: &Bitmap) -> Result<Vec<u16>> {
    let (width, height) = (ink.width(), ink.height());
    let mut depth: Vec<u16> = with_room(width * height)?;
    depth.resize(width * height, 0);
    // Neighbours that a pass has seen: four of the directions of Bitmap::beside.
    for (backwards, seen) in [(false, [4, 5, 6, 7]), (true, [0, 1, 2, 3])] {
        for step in 0..width * height {
            let at = if backwards { width * height - 1 - step } else { step };
            let (column, row) = (at % width, at / width);
            if !ink.get(column, row) {
                continue;
            }
            let mut best = if backwards { depth[at] } else { u16::MAX };
            for direction in seen {
                let way = if direction % 2 == 0 { 5 } else { 7 };
                let there = ink.beside(column, row, direction).map_or(0, |(c, r)| depth[r * width + c]);
                best = best.min(there.saturating_add(way));
            }
            depth[at] = best;
        }
    }
    Ok(depth)
}

/// Places of the outlines with the centres that they stand for, and half the width of the strokes.
fn sides(ink: &Ink, contours: &[Contour], deepest: f64) -> Result<(Vec<Side>, f64)> {
    let mut places: Vec<(Point, Vector, f64)> = Vec::new();
    for contour in contours {
        let samples = Samples::new(&contour.points)?;
        for i in 0..samples.len() as isize {
            let (before, here, after) = (samples.at(i - 4), samples.at(i), samples.at(i + 4));
            let bend = crate::trace::samples::turn(here - before, after - here);
            let along = unit(after - before);
            let inward = Vector::new(-along.y, along.x);
            // Pixels round the inner side of corners and junctions.
            if bend > -0.5 {
                places.push((here, inward, ink.across(here, inward, 4.0 * deepest + 4.0)));
            }
        }
    }
    let mut widths: Vec<f64> = places.iter().map(|place| place.2).collect();
    sort_numbers(&mut widths);
    let middle = 0.5 * widths.get(widths.len() / 2).copied().unwrap_or(2.0);
    let usual = |width: f64| (0.5 * width - middle).abs() < (0.08 * middle).max(0.25);
    let even = 2 * widths.iter().filter(|&&width| usual(width)).count() > widths.len();
    let mut sides = with_room(places.len())?;
    for (p, inward, width) in places {
        // Strokes of one width have it at their ends and junctions too, where the way across is another.
        let half = if even || width > 3.0 * middle { middle } else { 0.5 * width };
        sides.push(Side { centre: p + inward * half, inward });
    }
    Ok((sides, middle))
}

/// Junctions of a skeleton that are nearer to each other than `reach` are one: thick strokes cross at one place.
fn merged(graph: Graph, reach: f64) -> Graph {
    let mut degree = vec![0_usize; graph.nodes.len()];
    for node in graph.branches.iter().filter_map(|branch| branch.nodes).flatten() {
        degree[node] += 1;
    }
    let mut into: Vec<usize> = (0..graph.nodes.len()).collect();
    let root = |into: &[usize], mut node: usize| {
        while into[node] != node {
            node = into[node];
        }
        node
    };
    let mut branches: Vec<Branch> = Vec::new();
    for branch in graph.branches {
        if let Some([a, b]) = branch.nodes
            && degree[a] > 2
            && degree[b] > 2
            && a != b
            && (branch.pixels.len() as f64) < reach
        {
            let (a, b) = (root(&into, a), root(&into, b));
            into[a.max(b)] = a.min(b);
        } else {
            branches.push(branch);
        }
    }
    let mut nodes: Vec<Vec<Pixel>> = vec![Vec::new(); graph.nodes.len()];
    for (node, pixels) in graph.nodes.into_iter().enumerate() {
        // A lone pixel is a dot: a line of no length.
        if degree[node] == 0 {
            let (column, row) = pixels[0];
            branches.push(Branch { pixels: vec![(column, row), (column + 1, row)], nodes: None });
        }
        nodes[root(&into, node)].extend(pixels);
    }
    for branch in &mut branches {
        branch.nodes = branch.nodes.map(|pair| pair.map(|node| root(&into, node)));
    }
    let kept = nodes.into_iter().map(|pixels| if pixels.is_empty() { vec![(0, 0)] } else { pixels });
    Graph { nodes: kept.collect(), branches }
}
