//! Thin strokes in noise: where pictures are blurred for it, they may be half-way to ink nowhere.

use super::blur::Blurring;
use super::gray::Gray;
use super::tones::Tones;
use crate::error::Result;
use crate::limits::with_room;
use crate::numerics::plane::larger;

/// Paper is looked for so many pixels to both sides: a stroke of two is blurred over six, and seen aslant.
const REACH: usize = 5;
const KEPT: usize = 2 * REACH + 1;
/// Less ink is paper.
const CLEAR: f64 = 0.2;
/// As much is that of something broader.
const FULL: f64 = 0.8;
/// Ink on a ridge is followed as if there were so many times as much of it.
const TIMES: f64 = 2.0;

/// A blurred picture whose ridges are counted, or lifted, while contours are looked for: rows are kept for as long as
/// they are needed.
#[derive(Debug)]
pub(in crate::trace) struct Ridges {
    paper: f64,
    /// From paper to ink.
    way: f64,
    blurring: Blurring,
    /// Blurred rows, by their number modulo [`KEPT`].
    ring: [Vec<u16>; KEPT],
    given: usize,
    done: usize,
    /// The last two rows.
    rows: [Vec<u16>; 2],
    lifts: bool,
    faint: usize,
}

impl Ridges {
    /// Begins to blur a picture by a Gaussian of deviation `sigma` pixels, and to count its ridges, or to lift them.
    ///
    /// # Errors
    ///
    /// `OutOfMemory` only.
    pub(in crate::trace) fn new(
        width: usize,
        sigma: f64,
        tones: &Tones,
        (inverted, lifts): (bool, bool),
    ) -> Result<Self> {
        let blurring = Blurring::new(width, sigma)?;
        let [ink, paper] = if inverted { [tones.paper, tones.ink] } else { [tones.ink, tones.paper] };
        let mut ring: [Vec<u16>; KEPT] = Default::default();
        for row in &mut ring {
            *row = with_room(width)?;
        }
        let rows = [with_room(width)?, with_room(width)?];
        Ok(Self { paper, way: ink - paper, blurring, ring, given: 0, done: 0, rows, lifts, faint: 0 })
    }

    /// How many pixels on top of ridges were less than half ink, of those that were counted.
    pub(in crate::trace) fn faint(&self) -> usize {
        self.faint
    }

    /// The next row, if there is one: the row before it, and itself. Beyond the picture rows are empty.
    pub(in crate::trace) fn step(&mut self, gray: &Gray) -> [&[u16]; 2] {
        self.rows.swap(0, 1);
        self.rows[1].clear();
        if self.done < gray.height() {
            while self.given < (self.done + REACH + 1).min(gray.height()) {
                let [_, row] = self.blurring.step(gray);
                let kept = &mut self.ring[self.given % KEPT];
                kept.clear();
                kept.extend_from_slice(row);
                self.given += 1;
            }
            for column in 0..gray.width() {
                let shade = self.look(column);
                self.rows[1].push(shade);
            }
            self.done += 1;
        }
        let [before, here] = &self.rows;
        [before, here]
    }

    /// The shade of the next row there, lifted if it is to be.
    fn look(&mut self, column: usize) -> u16 {
        let shade = self.ring[self.done % KEPT][column];
        let here = self.share(shade);
        let (most, rising) = if self.lifts { (FULL, 1) } else { (1.0 / TIMES, 0) };
        if here > CLEAR && here < most && self.is_ridge(here, column, rising) {
            if self.lifts {
                return (self.paper + (TIMES * here).min(1.0) * self.way) as u16;
            }
            self.faint += usize::from(TIMES * here >= 0.5);
        }
        shade
    }

    fn share(&self, shade: u16) -> f64 {
        (f64::from(shade) - self.paper) / self.way
    }

    /// The ink of a place that was blurred; beyond the border all is paper.
    fn ink(&self, column: usize, row: usize) -> f64 {
        let is_there = row < self.given;
        let shade = self.ring[row % KEPT].get(column).filter(|_| is_there);
        shade.map_or(0.0, |&shade| self.share(shade))
    }

    /// Whether there is paper on both sides, and more ink on no more than so many of them: between two strokes there is
    /// more on both, on top of one on neither.
    fn is_ridge(&self, here: f64, column: usize, most_rising: usize) -> bool {
        let is_across = |right: usize, down: usize| {
            let mut rising = 0;
            [1, usize::MAX].into_iter().all(|sign| {
                let mut most = here;
                let end = (1..=REACH).map(|k| sign.wrapping_mul(k)).find_map(|k| {
                    let place = [
                        column.wrapping_add(right.wrapping_mul(k)),
                        self.done.wrapping_add(down.wrapping_mul(k)),
                    ];
                    let ink = self.ink(place[0], place[1]);
                    most = larger(most, ink);
                    (!(CLEAR..FULL).contains(&ink)).then_some(ink)
                });
                rising += usize::from(most > here);
                end.is_some_and(|ink| ink < CLEAR)
            }) && rising <= most_rising
        };
        is_across(1, 0) || is_across(0, 1)
    }
}
