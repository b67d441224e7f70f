//! The published way to divide a profile: a walk from disc to disc over points without order.
//!
//! It is here to be compared with. It jumps to strands that are near and leaves points out, which walking along the
//! chain cannot (D 14.7).

use super::chain::Chain;
use crate::error::Result;
use crate::limits::{LARGEST_COORDINATE, check, with_room};
use crate::numerics::order::{sort_by_number, sort_in_place};
use crate::numerics::plane::{dot, norm};
use crate::numerics::{Point, Vector};
use crate::trace::samples::{line_through, turn};

/// How far a walk goes at once and how it is smoothed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiscRule {
    /// The radius R₁ of a step.
    pub step: f64,
    /// The radius R₂ over which a place is smoothed.
    pub smoothing: f64,
    /// A tube ends where the tangent has turned by more, in radians.
    pub angle: f64,
}

/// Why a tube ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DiscEnd {
    /// The tangent had turned.
    Angle,
    /// There was no new point.
    Point,
    /// The walk was back where it began.
    Loop,
}

/// A tube that a walk found.
#[derive(Clone, Debug, PartialEq)]
pub struct DiscTube {
    /// Where its curve would begin and end.
    pub ends: [Point; 2],
    /// The points that belong to it and to no earlier tube, by index.
    pub points: Vec<usize>,
    /// Why it ended.
    pub end: DiscEnd,
}

impl DiscTube {
    /// Whether the tube's points look like a graph over its chord: those next to each other along it differ across it
    /// by at most two pixels, and twice what they are apart along it. Points that `chain` has not do not count.
    pub fn is_graph(&self, chain: &Chain) -> bool {
        let way = self.ends[1] - self.ends[0];
        let along = way / norm(way).max(f64::MIN_POSITIVE);
        let mut places: Vec<(f64, f64)> = Vec::new();
        for point in self.points.iter().filter_map(|&i| chain.points().get(i)) {
            let from = point - self.ends[0];
            places.push((dot(from, along), along.x * from.y - along.y * from.x));
        }
        sort_by_number(&mut places, &|place| place.0);
        places.windows(2).all(|pair| (pair[1].1 - pair[0].1).abs() <= 2.0 + 2.0 * (pair[1].0 - pair[0].0))
    }
}

/// The points of a chain by abscissa, and what has been walked over.
struct Ground<'a> {
    points: &'a [Point],
    sorted: Vec<usize>,
    seen: Vec<bool>,
    owned: Vec<bool>,
    /// Where the first step of all led.
    second: Option<Point>,
}

impl Ground<'_> {
    fn disc(&self, center: Point, radius: f64) -> impl Iterator<Item = usize> + '_ {
        let from = self.sorted.partition_point(|&i| self.points[i].x < center.x - radius);
        let near = self.sorted[from..].iter().copied();
        near.take_while(move |&i| self.points[i].x <= center.x + radius)
            .filter(move |&i| norm(self.points[i] - center) <= radius)
    }

    /// What the first disc has beyond the second one is new again, for the way back.
    fn turn_back(&mut self, first: Point, radius: f64) {
        if let Some(second) = self.second {
            for i in self.disc(first, radius).collect::<Vec<_>>() {
                self.seen[i] = norm(self.points[i] - second) <= radius;
            }
        }
    }

    fn see(&mut self, center: Point, radius: f64) {
        for i in self.disc(center, radius).collect::<Vec<_>>() {
            self.seen[i] = true;
        }
    }

    /// The next place of a walk: the farthest new point, smoothed.
    fn next(&self, here: Point, rule: &DiscRule) -> Option<Point> {
        let mut far: Option<(f64, usize)> = None;
        for i in self.disc(here, rule.step).filter(|&i| !self.seen[i]) {
            let distance = norm(self.points[i] - here);
            if distance > 0.0 && far.is_none_or(|(most, at)| distance > most || (distance == most && i < at))
            {
                far = Some((distance, i));
            }
        }
        let around = self.points[far?.1];
        let (mut sum, mut count) = (Vector::zeros(), 0.0);
        for i in self.disc(around, rule.smoothing) {
            sum += self.points[i] - around;
            count += 1.0;
        }
        let middle = around + sum / f64::max(count, 1.0);
        let mut best = around;
        for i in self.disc(middle, rule.smoothing) {
            if norm(self.points[i] - middle) < norm(best - middle) {
                best = self.points[i];
            }
        }
        // A place that smoothing takes back to where the walk is would be no step.
        Some(if norm(best - here) > 0.25 * rule.step { best } else { around })
    }

    /// The direction of the points in a disc, the way that leads on.
    fn tangent(&self, here: Point, way: Vector, rule: &DiscRule) -> Vector {
        let near: Vec<Point> = self.disc(here, rule.step).map(|i| self.points[i]).collect();
        let direction = line_through(&near).direction;
        if dot(direction, way) < 0.0 { -direction } else { direction }
    }

    fn own(&mut self, discs: &[Point], rule: &DiscRule) -> Vec<usize> {
        let mut points = Vec::new();
        for &center in discs {
            for i in self.disc(center, rule.step).collect::<Vec<_>>() {
                if !core::mem::replace(&mut self.owned[i], true) {
                    points.push(i);
                }
            }
        }
        sort_in_place(&mut points);
        points
    }

    /// One tube from `start`; `first` is where the whole walk began, `walked` how far it has come.
    fn tube(&mut self, start: Point, first: Point, walked: &mut f64, rule: &DiscRule) -> DiscTube {
        let mut places = vec![start];
        let mut leaving: Option<Vector> = None;
        loop {
            let here = places[places.len() - 1];
            let Some(next) = self.next(here, rule) else {
                let points = self.own(&places, rule);
                self.see(here, rule.step);
                // The first disc is seen already: where it and the last one meet, the walk is round.
                let round = *walked > 4.0 * rule.step && norm(first - here) <= 2.0 * rule.step;
                let (last, end) = if round { (first, DiscEnd::Loop) } else { (here, DiscEnd::Point) };
                return DiscTube { ends: [start, last], points, end };
            };
            let way = next - here;
            let from = *leaving.get_or_insert_with(|| self.tangent(start, way, rule));
            let turned = turn(from, self.tangent(next, way, rule)).abs();
            if places.len() > 1 && turned > rule.angle {
                // The last disc belongs to the next tube, which begins in its middle.
                let points = self.own(&places[..places.len() - 1], rule);
                return DiscTube { ends: [start, here], points, end: DiscEnd::Angle };
            }
            *walked += norm(way);
            // The walk does not turn back: the disc before the last one counts as seen.
            self.see(here, rule.step);
            self.second.get_or_insert(next);
            places.push(next);
            if *walked > 4.0 * rule.step && norm(first - next) <= rule.step {
                let points = self.own(&places, rule);
                return DiscTube { ends: [start, first], points, end: DiscEnd::Loop };
            }
        }
    }
}

impl Chain {
    /// Radii for a walk in discs: three times a smoothing radius that covers the noise, but less than half of the way
    /// to the nearest other strand; `None` where strands are so near that no radius is safe.
    ///
    /// # Cost
    ///
    /// O(N·m) for m points within the distance of the nearest strand in x.
    pub fn discs(&self, angle: f64) -> Option<DiscRule> {
        let noise = 3.0 * self.noise() + 1.0;
        let smoothing = if noise > 4.0 { 4.0 } else { noise.max(1.5) };
        let (apart, length) = self.separation();
        let most = (0.5 * apart).min(length / 12.0);
        (most >= 2.0 * smoothing).then(|| DiscRule {
            step: most.min((3.0 * smoothing).max(4.0)),
            smoothing,
            angle,
        })
    }

    /// The least distance of points that are more than four times as far from each other along the chain, and the
    /// chain's length.
    fn separation(&self) -> (f64, f64) {
        let points = self.points();
        let mut travelled = Vec::new();
        let mut length = 0.0;
        for i in 0..points.len() {
            travelled.push(length);
            if let Some(next) = self.step(i, true) {
                length += norm(points[next] - points[i]);
            }
        }
        let mut sorted: Vec<usize> = (0..points.len()).collect();
        sort_by_number(&mut sorted, &|&i| points[i].x);
        let mut least = length;
        for (k, &a) in sorted.iter().enumerate() {
            for &b in &sorted[k + 1..] {
                if points[b].x - points[a].x >= least {
                    break;
                }
                let apart = norm(points[b] - points[a]);
                let along = (travelled[a] - travelled[b]).abs();
                let along = if self.is_closed() { along.min(length - along) } else { along };
                if along > 4.0 * apart {
                    least = least.min(apart);
                }
            }
        }
        (least, length)
    }

    /// Divides the points by walking from disc to disc, from point `start` on, and, where the walk ends without coming
    /// back, from there the other way.
    ///
    /// # Errors
    ///
    /// Radii or an angle out of range.
    ///
    /// # Cost
    ///
    /// O(N log N), and the points in all discs.
    ///
    /// # Source
    ///
    /// \[RB21, section 3.2.1\], read as (D 14.12).
    pub fn walk_in_discs(&self, start: usize, rule: &DiscRule) -> Result<Vec<DiscTube>> {
        check("step", None, rule.step, 1e-9, LARGEST_COORDINATE)?;
        check("smoothing", None, rule.smoothing, 0.0, rule.step)?;
        check("angle", None, rule.angle, 0.05, core::f64::consts::FRAC_PI_2)?;
        let points = self.points();
        check("start", None, start as f64, 0.0, points.len() as f64 - 1.0)?;
        let mut sorted = with_room(points.len())?;
        sorted.extend(0..points.len());
        sort_by_number(&mut sorted, &|&i: &usize| points[i].x);
        let [seen, owned] = [vec![false; points.len()], vec![false; points.len()]];
        let mut ground = Ground { points, sorted, seen, owned, second: None };
        let first = points[start];
        let mut tubes: Vec<DiscTube> = Vec::new();
        for _ in 0..2 {
            let (mut from, mut walked) = (first, 0.0);
            loop {
                let tube = ground.tube(from, first, &mut walked, rule);
                from = tube.ends[1];
                let end = tube.end;
                // A walk that never leaves its first disc has nothing to say.
                if tube.ends[0] != tube.ends[1] || !tube.points.is_empty() {
                    tubes.push(tube);
                }
                if end == DiscEnd::Loop {
                    return Ok(tubes);
                }
                if end == DiscEnd::Point {
                    break;
                }
            }
            ground.turn_back(first, rule.step);
        }
        Ok(tubes)
    }
}
