//! Where a spline breaks: knots of any multiplicity.
//!
//! A knot of multiplicity m lets the derivatives from order degree + 1 − m on jump: one is the smoothest, as many as
//! the degree is a corner.

/// The largest degree.
pub(crate) const HIGHEST: usize = 5;

/// Where a spline of one degree breaks, in ascending order.
#[derive(Clone, Debug, PartialEq)]
pub struct Breaks {
    /// The degree, 1 to 5.
    pub degree: usize,
    /// Whether the parameter is periodic.
    pub closed: bool,
    /// The parameter runs from 0 to here.
    pub end: f64,
    /// The knots: in [0, end) on closed curves, inside (0, end) on open ones.
    pub at: Vec<f64>,
    /// How often each knot counts, 1 to `sharpest`.
    pub multiplicity: Vec<usize>,
    /// How often a knot may count at most; the degree allows corners.
    pub sharpest: usize,
    /// How often a knot counts at least.
    pub smoothest: usize,
    /// Which pieces are to be straight; empty where none is.
    pub(super) straight: Vec<bool>,
}

impl Breaks {
    /// `count` simple knots, evenly spread.
    pub fn even(degree: usize, closed: bool, end: f64, count: usize) -> Self {
        let steps = if closed { count } else { count + 1 };
        let shift = if closed { 0.5 } else { 1.0 };
        let at = (0..count).map(|i| (i as f64 + shift) * end / steps as f64).collect();
        Self::simple(degree, closed, end, at)
    }

    /// Simple knots at these places.
    pub(in crate::fit) fn simple(degree: usize, closed: bool, end: f64, at: Vec<f64>) -> Self {
        let multiplicity = vec![1; at.len()];
        Self { degree, closed, end, at, multiplicity, sharpest: degree, smoothest: 1, straight: Vec::new() }
    }

    /// The same without knots.
    pub(super) fn bare(&self) -> Self {
        let (at, multiplicity, straight) = (Vec::new(), Vec::new(), Vec::new());
        Self { at, multiplicity, straight, ..*self }
    }

    /// How many knots there are, each counted once.
    pub fn len(&self) -> usize {
        self.at.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.at.is_empty()
    }

    /// How many pieces the curve has.
    pub fn pieces(&self) -> usize {
        if self.closed { self.len().max(1) } else { self.len() + 1 }
    }

    /// How many coefficients the space has.
    pub fn coefficients(&self) -> usize {
        let inner: usize = self.multiplicity.iter().sum();
        if self.closed { inner } else { inner + self.degree + 1 }
    }

    /// Adds knots as smooth as they may be. No piece is straight then.
    pub(super) fn add(&mut self, added: &[f64]) {
        self.straight.clear();
        for &t in added {
            let t = if t >= self.end { t - self.end } else { t };
            self.insert(self.at.partition_point(|&other| other < t), t, self.smoothest);
        }
    }

    /// Makes a knot the one of number k, where no piece is straight.
    #[inline(never)]
    pub(super) fn insert(&mut self, k: usize, t: f64, multiplicity: usize) {
        self.at.insert(k, t);
        self.multiplicity.insert(k, multiplicity);
    }

    /// Takes knot k away: what it parted stays straight if both were.
    #[inline(never)]
    pub fn remove(&mut self, k: usize) {
        if !self.straight.is_empty() {
            let after = if self.closed { k } else { k + 1 };
            let before = if after > 0 { after - 1 } else { self.straight.len() - 1 };
            self.straight[before] &= self.straight[after];
            self.straight.remove(after);
        }
        self.at.remove(k);
        self.multiplicity.remove(k);
    }

    /// The same without these knots, which are listed in ascending order.
    #[inline(never)]
    pub(super) fn without(&self, knots: &[usize]) -> Self {
        let mut fewer = self.clone();
        knots.iter().rev().for_each(|&k| fewer.remove(k));
        fewer
    }

    /// Whether piece s is to be straight.
    pub(super) fn is_straight(&self, s: usize) -> bool {
        self.straight.get(s) == Some(&true)
    }

    /// A parameter brought back over the seam of a closed curve, if it is beyond it by less than a whole round.
    #[inline(always)]
    pub(super) fn wrapped(&self, t: f64) -> f64 {
        if !self.closed {
            t
        } else if t < 0.0 {
            t + self.end
        } else if t >= self.end {
            t - self.end
        } else {
            t
        }
    }

    /// The distance from knot k to the next one; the last knot's is to the first one or to the end.
    pub(in crate::fit) fn gap_after(&self, k: usize) -> f64 {
        match self.at.get(k + 1) {
            Some(next) => next - self.at[k],
            None if self.closed => self.at[0] + self.end - self.at[k],
            None => self.end - self.at[k],
        }
    }

    /// The distance to knot k from the one before.
    pub(in crate::fit) fn gap_before(&self, k: usize) -> f64 {
        match k.checked_sub(1) {
            Some(before) => self.gap_after(before),
            None if self.closed => self.gap_after(self.len() - 1),
            None => self.at[0],
        }
    }
}
