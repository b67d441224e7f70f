//! A plane that is read only: two bytes a number.

use crate::error::Result;
use crate::limits::with_room;

/// Numbers of a range, each rounded to one of 65,536 levels of it: noise is hundreds of times as much.
#[derive(Debug, Default)]
pub(super) struct Levels {
    least: f32,
    step: f32,
    values: Vec<u16>,
}

impl Levels {
    /// Room for numbers that are between the least and the most of some.
    ///
    /// # Errors
    ///
    /// `OutOfMemory` only.
    pub(super) fn between(numbers: &[f32]) -> Result<Self> {
        let first = numbers.first().copied().unwrap_or_default();
        let (mut least, mut most) = (first, first);
        for &v in numbers {
            if v < least {
                least = v;
            } else if v > most {
                most = v;
            }
        }
        let step = (most - least) / f32::from(u16::MAX);
        Ok(Self { least, step, values: with_room(numbers.len())? })
    }

    /// Adds numbers of the range.
    #[inline(never)]
    pub(super) fn extend(&mut self, numbers: &[f32]) {
        let (least, inverse) = (self.least, if self.step > 0.0 { 1.0 / self.step } else { 0.0 });
        for v in numbers {
            self.values.push(((v - least) * inverse + 0.5) as u16);
        }
    }

    pub(super) fn len(&self) -> usize {
        self.values.len()
    }

    /// Numbers from one on, as many as there are fours of them.
    #[inline(never)]
    pub(super) fn read(&self, from: usize, numbers: &mut [f32]) {
        let fours = self.values[from..].as_chunks::<4>().0;
        for (numbers, levels) in numbers.as_chunks_mut().0.iter_mut().zip(fours) {
            *numbers = levels.map(|level| self.least + self.step * f32::from(level));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Levels;
    use crate::error::Result;
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    #[test]
    fn numbers_are_kept_to_half_a_level_and_the_ends_of_their_range_nearly_exactly() -> Result<()> {
        let numbers: Vec<f32> = (0..1000).map(|k| ((k * 619) % 1000) as f32 * 0.003 - 1.1).collect();
        let mut levels = Levels::between(&numbers)?;
        levels.extend(&numbers);
        assert_eq!(levels.len(), 1000);
        let mut read = [0.0; 1000];
        levels.read(0, &mut read);
        for (level, number) in read.iter().zip(&numbers) {
            // Half of 2.997 / 65,535, and the rounding of 24 bits.
            assert!((level - number).abs() < 2.31e-5, "{level} for {number}");
        }
        Ok(())
    }

    #[test]
    fn what_is_read_and_kept_again_is_the_same() -> Result<()> {
        let numbers: Vec<f32> = (0..1000).map(|k| ((k * 619) % 1000) as f32 * 0.003 - 1.1).collect();
        let mut levels = Levels::between(&numbers)?;
        levels.extend(&numbers);
        let [mut read, mut again] = [[0.0; 1000]; 2];
        levels.read(0, &mut read);
        levels.extend(&read);
        levels.read(1000, &mut again);
        assert_eq!(again, read);
        Ok(())
    }

    #[test]
    fn numbers_that_are_all_one_are_kept_exactly() -> Result<()> {
        let mut levels = Levels::between(&[0.3; 8])?;
        levels.extend(&[0.3; 8]);
        let mut read = [0.0; 8];
        levels.read(0, &mut read);
        assert_eq!(read, [0.3; 8]);
        Ok(())
    }
}
