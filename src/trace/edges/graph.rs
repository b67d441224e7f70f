//! Thin lines of pixels as a graph: ends and junctions, and the branches between them.

use crate::error::Result;
use crate::limits::with_room;
use crate::numerics::order::sort_in_place;
use crate::trace::picture::bitmap::Bitmap;

/// A pixel (column, row).
pub(super) type Pixel = (u32, u32);

/// A row of pixels between two nodes, without theirs; a ring has no nodes.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Branch {
    pub(super) pixels: Vec<Pixel>,
    pub(super) nodes: Option<[usize; 2]>,
}

/// Nodes with their pixels, and branches.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Graph {
    pub(super) nodes: Vec<Vec<Pixel>>,
    pub(super) branches: Vec<Branch>,
}

struct Builder<'a> {
    lines: &'a Bitmap,
    /// Pixels of nodes by number, with the node.
    owner: Vec<(usize, usize)>,
    seen: Bitmap,
    graph: Graph,
}

/// The graph of lines that are one pixel wide: pixels with one joined neighbour are ends, with three or more junctions;
/// junction pixels side by side are one node.
///
/// # Cost
///
/// O(pixels set).
pub(super) fn graph(lines: &Bitmap) -> Result<Graph> {
    let seen = Bitmap::new(lines.width(), lines.height())?;
    let graph = Graph { nodes: Vec::new(), branches: Vec::new() };
    let mut builder = Builder { lines, owner: Vec::new(), seen, graph };
    builder.find_nodes()?;
    builder.walk_branches();
    builder.walk_rings();
    Ok(builder.graph)
}

impl Builder<'_> {
    fn number(&self, (column, row): Pixel) -> usize {
        row as usize * self.lines.width() + column as usize
    }

    fn degree(&self, (column, row): Pixel) -> u32 {
        self.lines.joined(column as usize, row as usize).count_ones()
    }

    fn neighbours(&self, (column, row): Pixel) -> impl Iterator<Item = Pixel> {
        let (column, row) = (column as usize, row as usize);
        let bits = self.lines.joined(column, row);
        (0..8)
            .filter(move |d| bits >> d & 1 == 1)
            .filter_map(move |d| self.lines.beside(column, row, d))
            .map(|(c, r)| (c as u32, r as u32))
    }

    fn node_of(&self, pixel: Pixel) -> Option<usize> {
        let number = self.number(pixel);
        self.owner.binary_search_by_key(&number, |&(n, _)| n).ok().map(|i| self.owner[i].1)
    }

    fn take(&mut self, (column, row): Pixel) -> bool {
        let fresh = !self.seen.get(column as usize, row as usize);
        self.seen.set(column as usize, row as usize, true);
        fresh
    }

    fn find_nodes(&mut self) -> Result<()> {
        let mut owner = with_room(0)?;
        for (column, row) in self.lines.pixels() {
            let start = (column as u32, row as u32);
            let degree = self.degree(start);
            if degree == 2 || !self.take(start) {
                continue;
            }
            let mut node = vec![start];
            let mut at = 0;
            while degree > 2 && at < node.len() {
                let beside: Vec<Pixel> =
                    self.neighbours(node[at]).filter(|&pixel| self.degree(pixel) > 2).collect();
                for pixel in beside {
                    if self.take(pixel) {
                        node.push(pixel);
                    }
                }
                at += 1;
            }
            owner.extend(node.iter().map(|&pixel| (self.number(pixel), self.graph.nodes.len())));
            self.graph.nodes.push(node);
        }
        sort_in_place(&mut owner);
        self.owner = owner;
        Ok(())
    }

    fn walk_branches(&mut self) {
        for node in 0..self.graph.nodes.len() {
            for at in 0..self.graph.nodes[node].len() {
                let start = self.graph.nodes[node][at];
                let beside: Vec<Pixel> = self.neighbours(start).collect();
                for first in beside {
                    if let Some(other) = self.node_of(first) {
                        if node < other {
                            self.graph
                                .branches
                                .push(Branch { pixels: Vec::new(), nodes: Some([node, other]) });
                        }
                    } else if self.take(first) {
                        self.walk(node, start, first);
                    }
                }
            }
        }
    }

    /// Follows a branch from a node's pixel to the next node.
    fn walk(&mut self, node: usize, start: Pixel, first: Pixel) {
        let mut pixels = vec![first];
        let (mut before, mut at) = (start, first);
        let mut end = node;
        loop {
            let next = self.neighbours(at).find(|&pixel| pixel != before);
            let Some(next) = next else { break };
            if let Some(other) = self.node_of(next) {
                end = other;
                break;
            }
            if !self.take(next) {
                break;
            }
            pixels.push(next);
            (before, at) = (at, next);
        }
        // A few pixels from a junction back to itself are its own thickness.
        if node != end || pixels.len() > 3 {
            self.graph.branches.push(Branch { pixels, nodes: Some([node, end]) });
        }
    }

    fn walk_rings(&mut self) {
        let lines = self.lines;
        for (column, row) in lines.pixels() {
            let start = (column as u32, row as u32);
            if !self.take(start) {
                continue;
            }
            let mut pixels = vec![start];
            let mut at = start;
            loop {
                let fresh = |&(c, r): &Pixel| !self.seen.get(c as usize, r as usize);
                let next = self.neighbours(at).find(fresh);
                let Some(next) = next else { break };
                self.take(next);
                pixels.push(next);
                at = next;
            }
            self.graph.branches.push(Branch { pixels, nodes: None });
        }
    }
}
