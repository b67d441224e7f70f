//! Uneven light: a sheet that was photographed is darker where less light falls on it, and that is neither ink nor
//! noise.
//!
//! Functions here are called from two kinds of work and are not inlined: they take a thousandth of the time, and would
//! be in the wasm thrice.

use super::gray::Gray;
use crate::error::Result;
use crate::limits::filled;
use crate::numerics::order::nth;

/// Terms of a quadratic polynomial in two coordinates.
const TERMS: usize = 6;
/// Pixels that are averaged: the brightest of so many single ones would follow noise.
const RUN: usize = 8;
/// One row in so many is looked at.
const EVERY: usize = 4;
/// About so many tiles along the longer side.
const TILES: usize = 24;
/// Fewer tiles along a side say too little of the light.
const FEWEST: usize = 6;
/// The first look finds the light, the second finds it without what it varies by within a tile.
const LOOKS: usize = 2;
/// Rounds of fitting from above, then of leaving out.
const ROUNDS: usize = 8;
/// What a tile below the light counts beside one above it: ink darkens, nothing brightens.
const BELOW: f64 = 0.05;
/// Tiles that are farther from the light than so many of the usual distances are not paper.
const FAR: f64 = 3.0;
/// The share of tiles that must be paper, and the share that may be brighter than paper.
const PAPER: f64 = 0.6;
const BRIGHTER: f64 = 0.02;
/// How far paper may be from a smooth light, as a share of it.
const SMOOTH: f64 = 0.03;
/// Light that nowhere falls below this share of its most is even; below the other, too little of the picture is left.
const EVEN: f64 = 0.9;
const DARK: f64 = 0.2;
/// Rows that are lit or looked at in one step.
const ROWS: usize = 64;

/// Light on paper, as a quadratic polynomial (D 14.24).
#[derive(Clone, Copy, Debug, PartialEq)]
struct Light {
    terms: [f64; TERMS],
    /// The most there is in the picture.
    most: f64,
    /// From −1 to 1 in so many pixels along each side: as many as whole tiles have.
    size: [usize; 2],
}

/// What tiles say, paper or not.
struct Paper {
    terms: [f64; TERMS],
    /// 1 for tiles that are paper, 0 for others.
    weights: Vec<f64>,
    /// How far paper is from the polynomial, as a standard deviation.
    spread: f64,
    /// How many tiles are brighter than paper.
    brighter: usize,
}

/// A picture whose light is looked at, and made even where it is not: some rows at a time.
///
/// Every tile's brightest run of pixels is what paper looks like there. A quadratic polynomial is fitted to them from
/// above, then without the tiles that are far from it. Only where most tiles in every part of the picture are paper by
/// it, and hardly any are brighter, is it light: shades are then divided by it. A drawing on a sheet of one shade, a
/// large shape, a photograph keep all their shades.
#[derive(Debug)]
pub(in crate::trace) struct Evening {
    tile: usize,
    columns: usize,
    rows: usize,
    brightest: Vec<f64>,
    row: usize,
    /// How often all rows were looked at.
    looks: usize,
    light: Option<Light>,
}

impl Gray {
    /// Makes the shades what they were if as much light fell on all of the paper; whether that changed anything. A
    /// picture that is not dark ink on paper, most of it paper, and one in even light stay as they are (D 14.24).
    /// [`crate::trace::trace`] does this by itself.
    ///
    /// # Errors
    ///
    /// No memory, for less than a thousand numbers.
    ///
    /// # Cost
    ///
    /// O(pixels).
    pub fn even_light(&mut self) -> Result<bool> {
        let mut evening = Evening::new(self)?;
        while !evening.step(self) {}
        Ok(evening.is_needed())
    }
}

impl Evening {
    #[inline(never)]
    pub(in crate::trace) fn new(gray: &Gray) -> Result<Self> {
        let longer = gray.width().max(gray.height());
        let tile = longer.div_ceil(TILES * RUN).max(2) * RUN;
        let (columns, rows) = (gray.width() / tile, gray.height() / tile);
        let brightest = if columns.min(rows) < FEWEST { Vec::new() } else { filled(0.0, columns * rows)? };
        Ok(Self { tile, columns, rows, brightest, row: 0, looks: 0, light: None })
    }

    /// Some rows more; whether they were the last.
    #[inline(never)]
    pub(in crate::trace) fn step(&mut self, gray: &mut Gray) -> bool {
        if self.brightest.is_empty() {
            return true;
        }
        let last = (self.row + ROWS).min(gray.height());
        for row in self.row..last {
            if self.looks == LOOKS {
                self.light.iter().for_each(|light| light.even(gray, row));
            } else if row % EVERY == 0 {
                self.look(gray.row(row), row);
            }
        }
        self.row = last % gray.height();
        if self.row > 0 {
            return false;
        }
        if self.looks == LOOKS {
            return true;
        }
        self.light = self.found();
        self.looks += 1;
        if self.looks < LOOKS {
            self.brightest.fill(0.0);
        }
        self.light.is_none()
    }

    /// Whether the light was uneven, once all rows were looked at.
    pub(super) fn is_needed(&self) -> bool {
        self.light.is_some()
    }

    #[inline(never)]
    fn look(&mut self, shades: &[u16], row: usize) {
        let first = (row / self.tile).min(self.rows - 1) * self.columns;
        let [width, height] = self.size();
        let v = across(row, height);
        for (i, run) in shades.as_chunks::<RUN>().0.iter().enumerate() {
            let mut mean = run.iter().map(|&shade| f64::from(shade)).sum::<f64>() / RUN as f64;
            let tile = first + (i * RUN / self.tile).min(self.columns - 1);
            // The brightest place of a tile is where most light falls; with a first light known, it is as if it were in
            // the middle.
            if let Some(Light { terms, .. }) = &self.light {
                let u = across(i * RUN + RUN / 2, width);
                mean *= value(terms, self.place(tile)) / value(terms, [u, v]);
            }
            self.brightest[tile] = self.brightest[tile].max(mean);
        }
    }

    fn size(&self) -> [usize; 2] {
        [self.columns * self.tile, self.rows * self.tile]
    }

    /// The middle of a tile, from −1 to 1 on both axes.
    fn place(&self, tile: usize) -> [f64; 2] {
        [across(tile % self.columns, self.columns), across(tile / self.columns, self.rows)]
    }

    /// The light, if there is one and it is uneven.
    #[inline(never)]
    fn found(&self) -> Option<Light> {
        let count = self.brightest.len();
        let most = self.brightest.iter().fold(0.0, |a: f64, &b| a.max(b));
        // Paper of one shade is what most pictures have.
        let alike = self.brightest.iter().filter(|&&shade| shade > most - 512.0).count();
        if alike as f64 >= PAPER * count as f64 {
            return None;
        }
        let paper = self.paper()?;
        let lights = (0..count).map(|tile| value(&paper.terms, self.place(tile)));
        let (least, most) = lights.fold((f64::INFINITY, 0.0_f64), |(a, b), v| (a.min(v), b.max(v)));
        let is_light = least > DARK * most
            && paper.spread <= SMOOTH * least
            && paper.brighter as f64 <= BRIGHTER * count as f64
            && self.is_paper_everywhere(&paper.weights);
        (is_light && least < EVEN * most).then_some(Light {
            terms: paper.terms,
            most: most.min(65_280.0),
            size: self.size(),
        })
    }

    /// Fits a polynomial from above, so that ink counts little, then without the tiles that are far from it, which are
    /// not paper.
    #[inline(never)]
    fn paper(&self) -> Option<Paper> {
        let count = self.brightest.len();
        let mut weights = vec![1.0; count];
        let mut rests = vec![0.0; count];
        let mut spread = 0.0;
        for round in 0..2 * ROUNDS {
            let terms = self.fitted(&weights)?;
            for (tile, rest) in rests.iter_mut().enumerate() {
                *rest = self.brightest[tile] - value(&terms, self.place(tile));
            }
            if round < ROUNDS {
                weights
                    .iter_mut()
                    .zip(&rests)
                    .for_each(|(w, &rest)| *w = if rest > 0.0 { 1.0 } else { BELOW });
                continue;
            }
            let mut sizes: Vec<f64> = rests.iter().map(|rest| rest.abs()).collect();
            // The median of what is normal, over its deviation; a shade of the picture is the least there is.
            spread = (1.5 * nth(&mut sizes, count / 2)).max(256.0);
            let is_paper = |rest: f64| if rest.abs() <= FAR * spread { 1.0 } else { 0.0 };
            weights.iter_mut().zip(&rests).for_each(|(w, &rest)| *w = is_paper(rest));
        }
        let terms = self.fitted(&weights)?;
        let brighter = rests.iter().filter(|&&rest| rest > FAR * spread).count();
        Some(Paper { terms, weights, spread, brighter })
    }

    /// Whether most tiles are paper, and a good part of them in every ninth of the picture.
    #[inline(never)]
    fn is_paper_everywhere(&self, weights: &[f64]) -> bool {
        let mut parts = [(0.0, 0.0); 9];
        for (tile, weight) in weights.iter().enumerate() {
            let (column, row) = (tile % self.columns, tile / self.columns);
            let part = &mut parts[3 * row / self.rows * 3 + 3 * column / self.columns];
            *part = (part.0 + weight, part.1 + 1.0);
        }
        let paper: f64 = parts.iter().map(|part| part.0).sum();
        paper >= PAPER * weights.len() as f64 && parts.iter().all(|part| part.0 >= 0.25 * part.1)
    }

    /// Weighted least squares.
    #[inline(never)]
    fn fitted(&self, weights: &[f64]) -> Option<[f64; TERMS]> {
        let mut system = [0.0; TERMS * (TERMS + 1)];
        for (tile, (&shade, &weight)) in self.brightest.iter().zip(weights).enumerate() {
            let [one, x, y, xx, xy, yy] = powers(self.place(tile));
            add_square(&mut system, &[one, x, y, xx, xy, yy, shade], weight);
        }
        solve(&mut system, TERMS).then(|| core::array::from_fn(|i| system[i * (TERMS + 1) + TERMS]))
    }
}

impl Light {
    /// One row as if there were as much light everywhere as there is at the most.
    #[inline(never)]
    fn even(&self, gray: &mut Gray, row: usize) {
        let [width, height] = self.size;
        let v = across(row, height);
        let [one, x, y, xx, xy, yy] = self.terms;
        let [constant, linear] = [one + v * (y + v * yy), x + v * xy];
        let step = 2.0 / width as f64;
        for (column, shade) in gray.row_mut(row).iter_mut().enumerate() {
            let u = (column as f64 + 0.5) * step - 1.0;
            let light = constant + u * (linear + u * xx);
            // Beyond the middles of the outermost tiles the polynomial goes on; light does not end there.
            let even = f64::from(*shade) * self.most / light.max(0.5 * DARK * self.most);
            *shade = (even.min(65_280.0) + 0.5) as u16;
        }
    }
}

/// The middle of part i of so many, from −1 to 1.
fn across(i: usize, count: usize) -> f64 {
    (2 * i + 1) as f64 / count as f64 - 1.0
}

fn powers([u, v]: [f64; 2]) -> [f64; TERMS] {
    [1.0, u, v, u * u, u * v, v * v]
}

#[inline(never)]
fn value(terms: &[f64; TERMS], place: [f64; 2]) -> f64 {
    terms.iter().zip(powers(place)).map(|(a, b)| a * b).sum()
}

/// Adds the products of a list, whose last number is the right side, to the rows of a system. A function of its own, so
/// that it stays a loop.
#[inline(never)]
fn add_square(system: &mut [f64], list: &[f64], weight: f64) {
    for (row, a) in system.chunks_exact_mut(list.len()).zip(list) {
        for (entry, b) in row.iter_mut().zip(list) {
            *entry += weight * a * b;
        }
    }
}

/// Solves `n` positive definite equations, the right sides in the last column, by elimination; false if they are not.
/// For six unknowns once a picture; nalgebra's decompositions would be 3 kB of the tracer's wasm.
#[inline(never)]
pub(super) fn solve(system: &mut [f64], n: usize) -> bool {
    let width = n + 1;
    for i in 0..n {
        let pivot = system[i * width + i];
        if pivot.is_nan() || pivot <= 1e-9 {
            return false;
        }
        for k in i..width {
            system[i * width + k] /= pivot;
        }
        for other in (0..n).filter(|&other| other != i) {
            let share = system[other * width + i];
            for k in i..width {
                system[other * width + k] -= share * system[i * width + k];
            }
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use crate::trace::Gray;

    const SIDE: usize = 256;

    /// Whether a picture keeps all its shades; it is given as shares of white, x and y from 0 to 1.
    fn is_kept(shade: &dyn Fn(f64, f64) -> f64) -> bool {
        let place = |i: usize| (i as f64 + 0.5) / SIDE as f64;
        let bytes: Vec<u8> = (0..SIDE * SIDE)
            .map(|i| (255.0 * shade(place(i % SIDE), place(i / SIDE))).round() as u8)
            .collect();
        let before = Gray::from_bytes(SIDE, SIDE, &bytes).expect("a picture");
        let mut after = before.clone();
        let changed = after.even_light().expect("room");
        assert_eq!(changed, after != before);
        !changed
    }

    #[test]
    fn shades_that_are_no_light_on_paper_stay() {
        let disc = |x: f64, y: f64, r: f64| (x - 0.5).hypot(y - 0.5) < r;
        assert!(is_kept(&|_, _| 1.0), "paper");
        assert!(is_kept(&|x, y| if disc(x, y, 0.3) { 0.1 } else { 1.0 }), "a shape");
        assert!(
            is_kept(&|x, y| if disc(x, y, 0.45) { 0.2 + 0.6 * x } else { 1.0 }),
            "a large shape with a gradient"
        );
        assert!(is_kept(&|x, _| if x < 0.6 { 0.3 + 0.2 * x } else { 0.9 }), "two halves");
        assert!(
            is_kept(&|x, y| if disc(x, y, 0.25) { 1.0 } else { 0.2 + 0.3 * y }),
            "a light shape on a gradient"
        );
        assert!(is_kept(&|x, y| 0.5 + 0.4 * (9.0 * x).sin() * (7.0 * y).cos()), "a photograph");
        assert!(
            is_kept(&|x, y| if disc(x, y, 0.1) { 0.1 } else { 0.95 - 0.05 * x }),
            "light that is almost even"
        );
    }

    #[test]
    fn uneven_light_goes() {
        let thin = |x: f64, y: f64| ((x - 0.5).hypot(y - 0.5) - 0.3).abs() < 0.02;
        assert!(
            !is_kept(&|x, y| (1.0 - 0.4 * x - 0.2 * y) * if thin(x, y) { 0.2 } else { 0.95 }),
            "from one side"
        );
        let lamp = |x: f64, y: f64| 1.0 - 0.9 * ((x - 0.4).powi(2) + (y - 0.3).powi(2));
        assert!(!is_kept(&|x, y| lamp(x, y) * if thin(x, y) { 0.3 } else { 0.9 }), "around a lamp");
    }
}
