//! Fields that become as blurred as their pictures, some tiles at a time.

use super::blurred::{Blur, EMPTY, Gaussian, Region};
use super::levels::Levels;
use super::{AREA, Field};
use crate::error::Result;
use crate::limits::{refill, with_room};

/// Tiles of one bit of work.
const TILES: usize = 1024;
/// Blurs that are tried for a picture that is blurred already, every so many pixels from none on.
const BLURS: usize = 12;
const STEP: f64 = 0.25;

/// How a picture and what covers it come to be blurred alike.
#[derive(Clone, Copy, Debug)]
pub(in crate::trace::refinement) enum Alike {
    /// Both are blurred by a Gaussian of a deviation in pixels, so that a picture says where an edge is by more than
    /// the pixels that the edge is in.
    Both(f64),
    /// The picture is blurred already, and once more by a Gaussian of a deviation, which may be 0; outlines are, by as
    /// much as makes them most like it.
    Found(f64),
}

/// A field that is being blurred.
#[derive(Debug)]
pub(in crate::trace::refinement) struct Blurring {
    /// What the picture shows, blurred as far as it is to be.
    target: Levels,
    /// What it shows before that, if it is to be blurred, and by what.
    sharp: Vec<f32>,
    more: Gaussian,
    /// What of it outlines cover.
    cover: Vec<f32>,
    /// The tile that is next.
    slot: usize,
    gaussian: Gaussian,
    /// What the blurs that were tried leave, and the one that is being tried; none when a blur is found.
    squares: Option<Vec<f64>>,
}

impl Blurring {
    /// Begins with a field that nothing covers yet.
    ///
    /// # Errors
    ///
    /// `OutOfMemory` only.
    pub(in crate::trace::refinement) fn new(field: &mut Field, alike: Alike) -> Result<Self> {
        let mut target = Levels::between(&field.rest)?;
        let mut sharp = Vec::new();
        let (deviation, found) = match alike {
            Alike::Both(deviation) => (deviation, None),
            Alike::Found(deviation) => (deviation, Some(vec![0.0])),
        };
        if deviation > 0.0 {
            sharp = with_room(field.rest.len())?;
            sharp.extend_from_slice(&field.rest);
        } else {
            target.extend(&field.rest);
            // Both are the same numbers.
            target.read(0, &mut field.rest);
        }
        let more = Gaussian::new(deviation);
        let gaussian = if found.is_some() { Gaussian::new(0.0) } else { more };
        Ok(Self { target, sharp, more, cover: Vec::new(), slot: 0, gaussian, squares: found })
    }

    /// Some tiles more, now that outlines cover the field; whether these were the last.
    ///
    /// # Errors
    ///
    /// `OutOfMemory` only.
    pub(in crate::trace::refinement) fn step(&mut self, field: &mut Field) -> Result<bool> {
        if self.cover.is_empty() {
            refill(&mut self.cover, 0.0, field.rest.len())?;
            if self.sharp.is_empty() {
                self.target.read(0, &mut self.cover);
            } else {
                self.cover.copy_from_slice(&self.sharp);
            }
            self.cover.iter_mut().zip(&field.rest).for_each(|(cover, rest)| *cover -= rest);
        }
        let tiles = self.slot..(self.slot + TILES).min(field.tiles());
        let last = tiles.end == field.tiles();
        self.slot = if last { 0 } else { tiles.end };
        for slot in tiles {
            self.look(field, slot);
        }
        if self.squares.is_some() {
            return Ok(last && self.choose() && self.sharp.is_empty());
        }
        if last {
            let [cover, mut lead] = [&mut self.cover, &mut self.sharp].map(core::mem::take);
            // What it holds does not matter before it is heard.
            refill(&mut lead, 0.0, cover.len())?;
            field.blur = Some(Blur::new(self.gaussian, core::mem::take(&mut self.target), [cover, lead]));
        }
        Ok(last)
    }

    /// What is left in one tile: how much, while a blur is on trial, and then in each pixel.
    fn look(&mut self, field: &mut Field, slot: usize) {
        let (mut block, mut target) = (EMPTY, [0.0; AREA]);
        let here = slot * AREA..(slot + 1) * AREA;
        let mut blur = |plane: &[f32], gaussian| {
            field.blurred(&mut block, plane, (slot as u32, Region::ALL), gaussian, true)
        };
        let covered = blur(&self.cover, &self.gaussian);
        if self.target.len() < here.end {
            let shown = blur(&self.sharp, &self.more);
            self.target.extend(shown.as_flattened());
        }
        self.target.read(here.start, &mut target);
        let left = target.iter_mut().zip(covered.as_flattened());
        left.for_each(|(left, value)| *left -= value);
        if let Some(sum) = self.squares.as_mut().and_then(|squares| squares.last_mut()) {
            *sum = target.iter().fold(*sum, |sum, &left| sum + f64::from(left) * f64::from(left));
        } else {
            field.rest[here].copy_from_slice(&target);
        }
    }

    /// Goes on with the next blur, or with the best of all; whether that is none.
    fn choose(&mut self) -> bool {
        let Some(squares) = self.squares.as_mut().filter(|squares| squares.len() == BLURS) else {
            let tried = self.squares.get_or_insert_default();
            self.gaussian = Gaussian::new(STEP * tried.len() as f64);
            tried.push(0.0);
            return false;
        };
        let best = (0..BLURS).fold(0, |best, i| if squares[i] < squares[best] { i } else { best });
        let mut sigma = STEP * best as f64;
        if (1..BLURS - 1).contains(&best) {
            let (before, after) = (squares[best - 1] - squares[best], squares[best + 1] - squares[best]);
            sigma += STEP * 0.5 * (before - after) / (before + after).max(1e-12);
        }
        self.gaussian = Gaussian::new(sigma);
        self.squares = None;
        best == 0
    }
}

#[cfg(test)]
mod tests {
    use super::{Alike, Blurring, TILES};
    use crate::error::Result;
    use crate::numerics::{Point, Vector};
    use crate::trace::Gray;
    use crate::trace::outline::cubic::Cubic;
    use crate::trace::picture::blur::half_gaussian;
    use crate::trace::refinement::coverage::parts;
    use crate::trace::refinement::field::{AREA, Field, Shading};
    use crate::trace::refinement::sweep::Sweep;
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    const SIDE: usize = 360;

    /// All tiles of a picture of stripes aslant.
    fn striped() -> Result<Field> {
        let stripe = |i: usize| if (3 * (i % SIDE) + 5 * (i / SIDE)) % 90 < 40 { 0 } else { 255 };
        let bytes: Vec<u8> = (0..SIDE * SIDE).map(stripe).collect();
        let gray = Gray::from_bytes(SIDE, SIDE, &bytes)?;
        let shading = Shading { ink: 0.0, paper: 65_280.0, level: 32_640.0, inverted: false };
        let middle = 0.5 * SIDE as f64;
        let all = [Point::new(middle, middle)];
        Field::new(&gray, &shading, [all.as_slice()].into_iter(), middle)
    }

    /// Takes some ink of every pixel, as outlines would.
    fn cover(field: &mut Field) {
        field.rest.iter_mut().enumerate().for_each(|(i, rest)| *rest -= ((i * 37) % 101) as f32 / 101.0);
    }

    fn steps(blurring: &mut Blurring, field: &mut Field) -> Result<usize> {
        let mut steps = 1;
        while !blurring.step(field)? {
            steps += 1;
        }
        Ok(steps)
    }

    #[test]
    fn a_field_is_blurred_some_tiles_at_a_time_and_every_pixel_is_the_mean_of_those_around_it() -> Result<()>
    {
        let mut field = striped()?;
        let mut blurring = Blurring::new(&mut field, Alike::Both(1.2))?;
        cover(&mut field);
        let before = field.rest.clone();
        assert_eq!(steps(&mut blurring, &mut field)?, field.tiles().div_ceil(TILES));
        let half = half_gaussian(1.2);
        let weight = |d: usize| half[d.abs_diff(4)];
        for (x, y) in [(60, 61), (127, 128), (200, 33), (333, 300)] {
            let at = |k: usize| f64::from(before[field.pixel(x + k % 9 - 4, y + k / 9 - 4) as usize]);
            let mean: f64 = (0..81).map(|k| weight(k % 9) * weight(k / 9) * at(k)).sum();
            let found = f64::from(field.rest[field.pixel(x, y) as usize]);
            // Half a level of 65,536, and sums of 81 products of numbers with 24 bits.
            assert!((found - mean).abs() < 8.7e-6, "{found} and {mean} at ({x}, {y})");
        }
        // What is blurred again when all has been touched is the same to the last bit.
        let blurred = field.rest.clone();
        (0..field.tiles()).for_each(|slot| field.touch(slot, &[[9.0; 4]; AREA / 4]));
        assert_eq!((field.settle(), &field.rest), (0.0, &blurred));
        Ok(())
    }

    #[test]
    fn a_sharp_picture_is_found_to_be_sharp_some_tiles_at_a_time() -> Result<()> {
        let mut field = striped()?;
        let mut blurring = Blurring::new(&mut field, Alike::Found(0.0))?;
        // Outlines cover all ink but a little.
        field.rest.iter_mut().for_each(|rest| *rest *= 0.01);
        let before = field.rest.clone();
        assert_eq!(steps(&mut blurring, &mut field)?, 12 * field.tiles().div_ceil(TILES), "twelve blurs");
        assert_eq!(field.rest, before);
        Ok(())
    }

    #[test]
    fn what_is_taken_back_leaves_every_bit_of_what_is_blurred_as_it_was() -> Result<()> {
        let wave = Cubic {
            start: Point::new(-12.0, 220.3),
            leaving: Vector::new(200.0, -255.0),
            arriving: Vector::new(150.0, -100.0),
            end: Point::new(337.4, 222.1),
        };
        for deviation in [1.2, 2.0] {
            let mut field = striped()?;
            let mut blurring = Blurring::new(&mut field, Alike::Both(deviation))?;
            cover(&mut field);
            steps(&mut blurring, &mut field)?;
            let all = 0..field.rest.len() as u32;
            // Some of it is heard before, and some is not.
            field.hear(all.clone().filter(|pixel| !(pixel / AREA as u32).is_multiple_of(3)));
            let (mut sweep, mut list) = (Sweep::default(), Vec::new());
            parts(&wave, &field, &mut list);
            let before = field.rest.clone();
            sweep.note(&field, &list, 1.0);
            sweep.cover(&mut field);
            assert_ne!(field.settle(), 0.0);
            assert_ne!(field.rest, before, "nothing was covered");
            sweep.take_back(&mut field);
            field.unsettle();
            assert_eq!(field.rest, before);
            // Nor does a trial leave anything.
            field.begin_trial();
            sweep.note(&field, &list, 1.0);
            sweep.cover(&mut field);
            field.settle();
            field.hear(all.clone().step_by(5));
            field.revert();
            assert_eq!(field.rest, before);
            field.hear(all.clone());
            let heard = field.lead().to_vec();
            // All of it found anew is the same.
            field.rest.fill(9.0);
            (0..field.tiles()).for_each(|slot| field.touch(slot, &[[9.0; 4]; AREA / 4]));
            field.settle();
            field.hear(all);
            assert_eq!(field.rest, before);
            assert_eq!(field.lead(), heard);
        }
        Ok(())
    }
}
