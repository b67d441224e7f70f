//! A duckling: a modelled shape, to show that a net is more than quadrics.

use super::axis::Direction;
use super::poles::ends;
use super::shapes::turn;
use super::tensor::TensorSurface;
use crate::error::Result;
use crate::generator::{Root, Roots};
use crate::limits::with_room;

/// Points round each ring; number 0 looks forward, along x.
const ROUND: usize = 12;
/// Rings from the lower pole to the upper one: height, where the middle is along x, half axes along x and across.
const RINGS: [[f64; 4]; 11] = [
    [0.00, 0.00, 0.00, 0.00],
    [0.04, 0.00, 0.46, 0.42],
    [0.24, 0.00, 0.80, 0.66],
    [0.50, -0.02, 0.92, 0.74],
    [0.78, 0.00, 0.78, 0.66],
    [1.00, 0.16, 0.46, 0.44],
    [1.18, 0.26, 0.37, 0.38],
    [1.40, 0.30, 0.43, 0.44],
    [1.64, 0.30, 0.44, 0.45],
    [1.84, 0.26, 0.29, 0.30],
    [1.93, 0.22, 0.00, 0.00],
];
/// What makes it a duckling: ring, point of the ring, and by how much it is moved along x and upwards.
const FEATURES: [(usize, usize, f64, f64); 12] = [
    // The bill.
    (7, 0, 0.42, 0.02),
    (7, 1, 0.02, 0.00),
    (7, 11, 0.02, 0.00),
    (8, 0, -0.02, -0.02),
    // The chest.
    (4, 0, 0.10, -0.04),
    (3, 0, 0.06, 0.00),
    // The tail.
    (4, 6, -0.34, 0.20),
    (4, 5, -0.06, 0.06),
    (4, 7, -0.06, 0.06),
    (3, 6, -0.06, 0.06),
    (5, 6, 0.02, -0.04),
    // A tuft.
    (9, 6, -0.06, 0.10),
];

impl TensorSurface {
    /// A duckling, about 2 high, standing on the xy plane and looking along x: 12 × 11 points on the surface, twice
    /// continuously differentiable. u runs round on \[0, 12\], v upwards from pole to pole on \[0, 10\]. Normals point
    /// outwards.
    ///
    /// # Errors
    ///
    /// None in practice; those of [`TensorSurface::new`].
    pub fn character() -> Result<Self> {
        let round = Roots::union(&[Roots::ellipse(ROUND)?, Roots::new(&[Root::default(); 2], "roots")?])?;
        let up = Roots::polynomials(3)?;
        let beyond = up.order() - 2;
        let count = RINGS.len() + 2 * beyond;
        let mut net = with_room(3 * ROUND * count)?;
        for k in 0..ROUND {
            for j in 0..count {
                // The rows beyond the poles are filled in below.
                let ring = j.saturating_sub(beyond).min(RINGS.len() - 1);
                net.extend(point(ring, k));
            }
        }
        let u = Direction { roots: round, count: ROUND, closed: true, level: 0 };
        let v = Direction { roots: up, count, closed: false, level: 0 };
        let mut surface = Self::new(net, u, v)?;
        let poles = ends(false, &surface.base().v, &surface.base().u);
        for pole in poles.into_iter().flatten() {
            for r in 1..=beyond {
                surface.mirror(pole, r);
            }
        }
        Ok(surface)
    }
}

/// Point k of a ring.
fn point(ring: usize, k: usize) -> [f64; 3] {
    let [height, middle, along, across] = RINGS[ring];
    let angle = turn(k as f64, ROUND);
    let mut point = [middle + along * angle.cos, across * angle.sin, height];
    for (_, _, x, z) in FEATURES.iter().filter(|feature| (feature.0, feature.1) == (ring, k)) {
        point[0] += x;
        point[2] += z;
    }
    point
}
