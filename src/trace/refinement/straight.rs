//! Sides that are straight as far as a picture of sampled or compressed edges tells (D 14.23).

use super::left::Left;
use super::trial::Trial;
use super::window::{Stretch, Window};
use crate::error::Result;
use crate::numerics::Vector;
use crate::numerics::plane::{cross, larger, norm};
use crate::trace::outline::{Node, Outline, Piece};
use crate::trace::samples::{turn, unit};

/// How far a piece may be from its chord before it is refined, in pixels, and as a share of its length.
const MOST: f64 = 0.4;
const SHARE: f64 = 0.06;
/// Shorter pieces are what is next to them, in pixels.
const LEAST: f64 = 3.0;
/// How much neighbours may turn where they follow the chord.
const SWING: f64 = 0.6;
/// By how many squares of the noise a line may explain less, by how many of its ends are corners: a smooth outline is
/// rather none (D 14.23).
const SHARES: [f64; 3] = [2.0, 4.0, 8.0];
const STEPS: (usize, f64) = (8, 5e-4);

/// The cubics of an outline, one after another.
#[derive(Debug, Default)]
pub(super) struct Straightening {
    at: usize,
}

impl Straightening {
    /// Tries the next piece that hardly bends: it becomes a line where the picture does not tell the two apart. Whether
    /// there was one.
    ///
    /// # Cost
    ///
    /// O(length of the pieces beside it).
    pub(super) fn step(&mut self, trial: &mut Trial) -> Result<bool> {
        while self.at < trial.shape.outline.len() {
            let piece = self.at;
            self.at += 1;
            if nearly_straight(&trial.shape.outline, piece) {
                trial.straighten(piece)?;
                return Ok(true);
            }
        }
        Ok(false)
    }
}

fn nearly_straight(outline: &Outline, i: usize) -> bool {
    let Piece::Cubic { leaving, arriving } = outline.pieces[i] else { return false };
    let chord = outline.nodes[outline.next(i)].point - outline.nodes[i].point;
    let (along, length) = (unit(chord), norm(chord));
    let bend = 0.75 * larger(cross(along, leaving).abs(), cross(along, arriving).abs());
    length >= LEAST && bend <= MOST.min(SHARE * length) && norm(leaving) + norm(arriving) < 1.5 * length
}

impl Trial<'_> {
    /// Puts a line in place of piece i and of straight ones that lead into it, and turns what is beside them; if that
    /// explains the picture worse, all is as it was. Whether it did not.
    fn straighten(&mut self, i: usize) -> Result<bool> {
        let outline = &self.shape.outline;
        let (mut first, mut end, mut count) = (i, outline.next(i), 1);
        if outline.nodes[first].smooth && outline.is_line(outline.before(first)) {
            (first, count) = (outline.before(first), count + 1);
        }
        if outline.nodes[end].smooth && outline.is_line(end) {
            (end, count) = (outline.next(end), count + 1);
        }
        if outline.len() < count + 2 {
            return Ok(false);
        }
        let before = outline.before(first);
        let along = unit(outline.nodes[end].point - outline.nodes[first].point);
        let Some(arriving) = beside(outline, before, first, along) else { return Ok(false) };
        let Some(leaving) = beside(outline, end, end, along) else { return Ok(false) };
        let ends = [first, end].into_iter().filter(|&node| !outline.nodes[node].smooth).count();
        if ends < 2 && self.limits.grain == 0.0 {
            // Noise of single pixels hides too much of what bends smoothly.
            return Ok(false);
        }
        let between = [first, end].map(|node| Node { kept: false, ..outline.nodes[node] }).to_vec();
        let mut old = Left::default();
        let mut piece = before;
        for _ in 0..count + 2 {
            old.add(&self.shape.parts[piece], self.field);
            piece = outline.next(piece);
        }
        let pieces = vec![arriving, Piece::Line, leaving];
        let stretch = Stretch { first: before, count: count + 2, pieces, between };
        let mut window = Window::open(self.refiner, self.field, self.shape, stretch);
        let nodes = [0, 1, 2, 3];
        let count = window.shape.outline.len().min(4);
        self.refiner.refine(self.field, &mut window.shape, &nodes[..count], STEPS)?;
        let mut new = Left::default();
        (0..3).for_each(|piece| new.add(&window.shape.parts[piece], self.field));
        let mut own = Left::default();
        own.add(&window.shape.parts[1], self.field);
        let noise = self.limits.noise * self.limits.noise;
        let enough = old.square + SHARES[ends] * noise + self.limits.grain * self.limits.grain * own.count;
        let good = new.square <= enough;
        if good {
            window.keep(self.field, self.shape);
        } else {
            window.close(self.refiner, self.field);
        }
        Ok(good)
    }
}

/// Piece `other` beside a joint where a line along `along` begins or ends; nothing if it would have to turn too much.
fn beside(outline: &Outline, other: usize, joint: usize, along: Vector) -> Option<Piece> {
    let Piece::Cubic { leaving, arriving } = outline.pieces[other] else { return Some(Piece::Line) };
    if !outline.nodes[joint].smooth {
        return Some(outline.pieces[other]);
    }
    let (way, leaves) = if other == joint { (leaving, true) } else { (arriving, false) };
    let turned = along * norm(way);
    if turn(way, along).abs() * norm(way) > SWING {
        return None;
    }
    Some(if leaves {
        Piece::Cubic { leaving: turned, arriving }
    } else {
        Piece::Cubic { leaving, arriving: turned }
    })
}
