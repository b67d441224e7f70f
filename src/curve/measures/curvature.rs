//! How strongly a curve bends.

use crate::curve::piece::Jet;
use crate::curve::pieces::{Pieces, in_space, space_piece};
use crate::error::Result;
use crate::numerics::plane::{cross, norm};

/// Speeds below this share of the largest a segment could have are roundings of zero.
const ZERO_SPEED: f64 = 1e-15;

pub(crate) fn curvature(curve: &dyn Pieces, t: f64) -> Result<Option<f64>> {
    let (i, x) = curve.find(t)?;
    if in_space(curve) {
        return Ok(space_piece(curve, i).curvature(x - 0.5, ZERO_SPEED));
    }
    let [leaving, arriving] = curve.tangents(i);
    let scale = norm(curve.start(i + 1) - curve.start(i)) + norm(leaving) + norm(arriving);
    let mut jet = curve.piece(i).jet(x - 0.5);
    if x == 0.0 {
        jet.first = leaving;
    } else if x == 1.0 {
        jet.first = arriving;
    }
    Ok(curvature_of(&jet, ZERO_SPEED * scale))
}

fn curvature_of(jet: &Jet, least_speed: f64) -> Option<f64> {
    let speed = norm(jet.first);
    if speed <= least_speed {
        return None;
    }
    let direction = jet.first / speed;
    let bend = cross(direction, jet.second / speed) / speed;
    if bend.is_finite() { Some(bend) } else { None }
}
