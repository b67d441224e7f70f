//! Which knots are in play: those where the dual curve is longest join.

use super::cone::{Lorentz, norm, typical_length};
use super::dual::maxima;
use super::iterate::{Iterate, Pair};
use super::reduced::{Reduced, transfer};
use super::run::Run;
use crate::error::Result;
use crate::limits;
use crate::numerics::Vector;

impl Run {
    /// Puts the places where the dual curve is longest into play.
    pub(crate) fn insert_knots(&mut self) -> Result<()> {
        let Some(sets) = self.longest_places() else { return Ok(()) };
        let old = &self.iterate;
        let mut reduced = Reduced::new(&self.data, sets, &old.reduced.elements)?;
        let unknowns = transfer(&old.reduced, &mut reduced, &old.unknowns);
        let mut cones = self.cones_of(&reduced)?;
        let mut jumps = Vec::new();
        reduced.jumps(&unknowns, &mut jumps);
        for (pair, jump) in cones.iter_mut().zip(&jumps) {
            pair.s.plane = *jump;
            let least = norm(pair.s.plane) * (1.0 + 1e-12);
            pair.s.height = pair.s.height.max(least);
        }
        // The same curve, seen from other elements.
        let moments = &mut self.buffers.element_forces;
        let _ = reduced.residuals(&self.data, &unknowns, &mut self.weighted, moments);
        self.iterate = Iterate { reduced, unknowns, jumps, cones };
        Ok(())
    }

    /// The knots in play of each spline and the places where its dual curve is longest; `None` where none of them is
    /// new.
    fn longest_places(&self) -> Option<Vec<Vec<usize>>> {
        let (longest, gap) = (self.measure.longest, self.measure.gap);
        // What the knots that are missing cost is little beside what is asked for.
        if longest - 1.0 < 0.2 * self.settings.gap {
            return None;
        }
        let threshold = (1.0 - 3.0 * (longest - 1.0) - gap).max(0.8);
        let mut sets = Vec::new();
        let mut any = false;
        for (part, eta) in self.iterate.reduced.parts.iter().zip(&self.eta) {
            let mut set = part.chosen.clone();
            for k in maxima(eta, self.data.closed, threshold) {
                if let Err(at) = set.binary_search(&k) {
                    set.insert(at, k);
                    any = true;
                }
            }
            sets.push(set);
        }
        any.then_some(sets)
    }

    /// The pairs of the knots of `reduced`: known ones as they are, new ones with the force of the dual curve, as
    /// central as the others are in the mean.
    fn cones_of(&self, reduced: &Reduced) -> Result<Vec<Pair>> {
        let old = &self.iterate;
        let rank = old.cones.len().max(1) as f64;
        let mean = old.cones.iter().map(|pair| pair.s.dot(pair.z)).sum::<f64>() / rank;
        let mut cones = limits::with_room(reduced.parts.iter().map(|p| p.chosen.len()).sum())?;
        let mut knot = 0;
        for (i, part) in reduced.parts.iter().enumerate() {
            let lambda = self.data.components[i].lambda;
            let before = &old.reduced.parts[i].chosen;
            let typical = typical_length(&old.jumps[knot..knot + before.len()]);
            let margin = (0.5 * mean / (lambda * typical).max(f64::MIN_POSITIVE)).min(0.1);
            let mut known = 0;
            for &k in &part.chosen {
                if before.get(known) == Some(&k) {
                    cones.push(old.cones[knot + known]);
                    known += 1;
                    continue;
                }
                let plane = self.eta[i][k] * -lambda;
                let length = norm(plane);
                let z = Lorentz::new(lambda.max(length / (1.0 - margin)), plane);
                let inverse = mean * z.height / ((z.height - length) * (z.height + length));
                let s = Lorentz::new(inverse.min(20.0 * mean / z.height), Vector::zeros());
                cones.push(Pair { s, z, lambda });
            }
            knot += before.len();
        }
        Ok(cones)
    }
}
