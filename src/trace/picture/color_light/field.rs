//! A smooth field over a picture, from what it differs by between places.

use crate::numerics::order::nth;
use crate::trace::picture::light::solve;

/// Cells along each side of a picture; between their corners the field is bilinear.
pub(super) const CELLS: usize = 8;
const SIDE: usize = CELLS + 1;
const NODES: usize = SIDE * SIDE;
/// Rounds in which differences that are far from the field lose weight.
const ROUNDS: usize = 4;
/// What counts as far, at least.
const FAR: f64 = 0.004;
/// Holds the mean, which differences do not say.
const MEAN: f64 = 1e-7;

/// A number for every node.
#[derive(Clone, Debug)]
pub(super) struct Field(pub(super) Vec<f64>);

/// What a field differs by from one place to another, in cells.
#[derive(Clone, Copy, Debug)]
pub(super) struct Difference {
    pub(super) places: [[f64; 2]; 2],
    pub(super) gap: f64,
    pub(super) weight: f64,
}

impl Field {
    /// The field that explains the differences and bends little. A robust fit: most differences have to agree.
    #[inline(never)]
    pub(super) fn fitted(differences: &[Difference], stiffness: f64) -> Self {
        let mut field = Self(vec![0.0; NODES]);
        let whole: f64 = differences.iter().map(|difference| difference.weight).sum();
        let mut far = f64::INFINITY;
        for _ in 0..ROUNDS {
            let mut rests: Vec<f64> =
                differences.iter().map(|d| (d.gap - field.along(&d.places)).abs()).collect();
            let mut system = vec![0.0; NODES * (NODES + 1)];
            for (difference, rest) in differences.iter().zip(&rests) {
                let weight = difference.weight / whole / (1.0 + (rest / far) * (rest / far));
                let [from, to] = difference.places.map(corners);
                let terms: [(usize, f64); 8] =
                    core::array::from_fn(|i| if i < 4 { (from[i].0, -from[i].1) } else { to[i - 4] });
                add(&mut system, &terms, difference.gap, weight);
            }
            stiffen(&mut system, stiffness / NODES as f64);
            if rests.is_empty() || !solve(&mut system, NODES) {
                break;
            }
            field.0.iter_mut().enumerate().for_each(|(i, v)| *v = system[i * (NODES + 1) + NODES]);
            for (rest, d) in rests.iter_mut().zip(differences) {
                *rest = (d.gap - field.along(&d.places)).abs();
            }
            let middle = rests.len() / 2;
            far = (3.0 * nth(&mut rests, middle)).max(FAR);
        }
        field
    }

    #[inline(never)]
    pub(super) fn at(&self, place: [f64; 2]) -> f64 {
        corners(place).iter().map(|&(node, share)| share * self.0[node]).sum()
    }

    /// What it differs by from one place to another.
    pub(super) fn along(&self, [from, to]: &[[f64; 2]; 2]) -> f64 {
        self.at(*to) - self.at(*from)
    }
}

/// The nodes around a place, and their shares in it.
pub(super) fn corners(place: [f64; 2]) -> [(usize, f64); 4] {
    let [x, y] = place.map(|at| (at as usize).min(CELLS - 1));
    let (s, t) = (place[0] - x as f64, place[1] - y as f64);
    let node = y * SIDE + x;
    [
        (node, (1.0 - s) * (1.0 - t)),
        (node + 1, s * (1.0 - t)),
        (node + SIDE, (1.0 - s) * t),
        (node + SIDE + 1, s * t),
    ]
}

/// Adds an equation to the normal equations.
#[inline(never)]
fn add(system: &mut [f64], terms: &[(usize, f64)], right: f64, weight: f64) {
    for &(i, a) in terms {
        let row = &mut system[i * (NODES + 1)..];
        for &(j, b) in terms {
            row[j] += weight * a * b;
        }
        row[NODES] += weight * a * right;
    }
}

/// Adds what holds the field where nothing is known: second differences cost.
fn stiffen(system: &mut [f64], stiffness: f64) {
    for i in 0..NODES {
        let (x, y) = (i % SIDE, i / SIDE);
        add(system, &[(i, 1.0)], 0.0, MEAN);
        for (at, step) in [(x, 1), (y, SIDE)] {
            if at > 0 && at < CELLS {
                add(system, &[(i - step, 1.0), (i, -2.0), (i + step, 1.0)], 0.0, stiffness);
            }
        }
        if x < CELLS && y < CELLS {
            let twist = [(i, 1.0), (i + 1, -1.0), (i + SIDE, -1.0), (i + SIDE + 1, 1.0)];
            add(system, &twist, 0.0, stiffness);
        }
    }
}
