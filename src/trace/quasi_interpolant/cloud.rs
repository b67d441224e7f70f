//! Points of one tube in its own frame, sorted, and the nearest of them to a place.

use crate::error::{Error, Result};
use crate::limits::{LARGEST_COORDINATE, MOST_POINTS, check, too_many, with_room};
use crate::numerics::Point;
use crate::numerics::order::sort_by_number;

/// Abscissae and ordinates, sorted by abscissa; equal abscissae keep the order in which they were given.
#[derive(Clone, Debug, PartialEq)]
pub struct Cloud {
    x: Vec<f64>,
    y: Vec<f64>,
}

impl Cloud {
    /// A cloud of at least one point.
    ///
    /// # Errors
    ///
    /// No point, more than 16,777,216 points, a coordinate that is not finite or not within ±1e9.
    pub fn new(points: &[Point]) -> Result<Self> {
        if points.is_empty() {
            return Err(Error::too_few("points", 0, 1));
        }
        if points.len() > MOST_POINTS {
            return Err(too_many("points", "maxPoints", MOST_POINTS, points.len()));
        }
        for (i, point) in points.iter().enumerate() {
            check("points", Some(2 * i), point.x, -LARGEST_COORDINATE, LARGEST_COORDINATE)?;
            check("points", Some(2 * i + 1), point.y, -LARGEST_COORDINATE, LARGEST_COORDINATE)?;
        }
        let mut order: Vec<usize> = with_room(points.len())?;
        order.extend(0..points.len());
        sort_by_number(&mut order, &|&i| points[i].x);
        let (x, y) = order.iter().map(|&i| (points[i].x + 0.0, points[i].y)).unzip();
        Ok(Self { x, y })
    }

    /// The abscissae, ascending.
    pub fn x(&self) -> &[f64] {
        &self.x
    }

    /// The ordinates in the order of the abscissae.
    pub fn y(&self) -> &[f64] {
        &self.y
    }

    /// How many points there are.
    #[allow(clippy::len_without_is_empty, reason = "a cloud is never empty")]
    pub fn len(&self) -> usize {
        self.x.len()
    }

    /// The `count` points nearest to u in abscissa, nearest first; of equally near ones the smaller abscissa first,
    /// of equal abscissae the one given first.
    ///
    /// # Cost
    ///
    /// O(log N + count): two pointers walk away from u. On the left a run of equal distances is read forwards.
    pub(super) fn nearest(&self, u: f64, count: usize, order: &mut Vec<usize>) {
        order.clear();
        let mut right = self.x.partition_point(|&x| x < u);
        // The run on the left that is being read: `next` of `run`, below which `left` points remain.
        let mut left = right;
        let (mut next, mut run) = (right, right);
        while order.len() < count {
            if next == run {
                run = left;
                while left > 0 && (left == run || u - self.x[left - 1] == u - self.x[run - 1]) {
                    left -= 1;
                }
                next = left;
            }
            let before = (next < run).then(|| u - self.x[next]);
            let after = self.x.get(right).map(|&x| x - u);
            match (before, after) {
                (Some(before), Some(after)) if before <= after => {
                    order.push(next);
                    next += 1;
                }
                (_, Some(_)) => {
                    order.push(right);
                    right += 1;
                }
                (Some(_), None) => {
                    order.push(next);
                    next += 1;
                }
                (None, None) => return,
            }
        }
    }
}
