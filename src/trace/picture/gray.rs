//! A picture as shades of one quantity.

use super::blocks::{BlockScan, Blocks, MOST_SHADES};
use crate::error::{Error, Result};
use crate::limits::{check, with_room};
use crate::numerics::Point;

/// The most columns or rows of a picture.
pub const MOST_SIDE: usize = 16_384;
/// The most pixels of a picture.
pub const MOST_PIXELS: usize = 67_108_864;

/// A drawing lies on nothing where one part in so many of the picture's pixels are transparent,
const LEAST_CLEAR: u64 = 10;
/// and is light where no more than one part in so many of what is there is dark.
const LEAST_LIGHT: u64 = 50;
/// Pixels that are read together; the sum of their shades has room in 32 bits.
const BLOCK: usize = 4096;

/// Shades from 0 (black) to 65,280 (white): two bytes for every pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Gray {
    width: usize,
    height: usize,
    values: Vec<u16>,
    /// Whether all that is there is light, on a transparent ground.
    light_on_nothing: bool,
    /// The squares that it is made of.
    blocks: Option<Blocks>,
    /// Whether it was drawn pixel by pixel, which are squares then, too.
    pub(in crate::trace) by_pixels: bool,
}

/// A picture that is being given row by row, so that nobody holds all of its colours at once.
///
/// The shade is the luma of Rec. 709. Where something is transparent, that is paper: black where all that is there is
/// light, or where it is and light ink is asked for; else white. Which ink it is shows at the end only, so opacity is
/// kept until then, from the first transparent pixel on.
#[derive(Clone, Debug)]
pub struct GrayRows {
    width: usize,
    height: usize,
    /// Luma, as if on black where `opacity` is kept.
    values: Vec<u16>,
    opacity: Vec<u8>,
    light: u64,
    opaque: u64,
    /// As much of `opaque` as is darker than the middle.
    dark: u64,
    scan: BlockScan,
}

impl Gray {
    /// Begins a picture that is given row by row.
    ///
    /// # Errors
    ///
    /// A side of 0 or beyond 16,384, more than 67,108,864 pixels, no memory.
    pub fn begin(width: usize, height: usize) -> Result<GrayRows> {
        let values = with_room(count(width, height)?)?;
        Ok(GrayRows {
            width,
            height,
            values,
            opacity: Vec::new(),
            light: 0,
            opaque: 0,
            dark: 0,
            scan: BlockScan::new(width),
        })
    }

    /// A picture from one byte per pixel, row by row.
    ///
    /// # Errors
    ///
    /// As [`Gray::begin`], and a list of another length.
    pub fn from_bytes(width: usize, height: usize, bytes: &[u8]) -> Result<Self> {
        let mut rows = Self::begin(width, height)?;
        if bytes.len() != width * height {
            return Err(Error::wrong_length("data", bytes.len(), width * height));
        }
        rows.push_gray_rows(bytes)?;
        rows.finish()
    }

    /// A picture from red, green, blue and opacity, a byte each: see [`GrayRows`].
    ///
    /// # Errors
    ///
    /// As [`Gray::from_bytes`].
    pub fn from_rgba(width: usize, height: usize, bytes: &[u8]) -> Result<Self> {
        let mut rows = Self::begin(width, height)?;
        if bytes.len() != 4 * width * height {
            return Err(Error::wrong_length("data", bytes.len(), 4 * width * height));
        }
        rows.push_rgba_rows(bytes)?;
        rows.finish()
    }

    /// Columns.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> usize {
        self.height
    }

    /// Whether all that is there is light, on a transparent ground: then that is the ink.
    pub(in crate::trace) fn is_light_on_nothing(&self) -> bool {
        self.light_on_nothing
    }

    /// The shade of a pixel.
    pub(in crate::trace) fn shade(&self, column: usize, row: usize) -> f64 {
        f64::from(self.values[row * self.width + column])
    }

    /// The shade of a place, from the centres of the four pixels around it; beyond the outermost ones it is theirs.
    #[inline(never)]
    pub(in crate::trace) fn between(&self, p: Point) -> f64 {
        let (x, y) = (p.x - 0.5, p.y - 0.5);
        let (column, row) = (x.floor(), y.floor());
        let shade = |dx: f64, dy: f64| {
            let inside = |v: f64, most: usize| v.max(0.0).min(most as f64 - 1.0) as usize;
            self.shade(inside(column + dx, self.width), inside(row + dy, self.height))
        };
        let (u, v) = (x - column, y - row);
        let above = shade(0.0, 0.0) * (1.0 - u) + shade(1.0, 0.0) * u;
        let below = shade(0.0, 1.0) * (1.0 - u) + shade(1.0, 1.0) * u;
        above * (1.0 - v) + below * v
    }

    /// The picture in the middle of a wider one.
    pub(in crate::trace) fn framed(&self, margin: usize, shade: u16) -> Result<Self> {
        let (width, height) = (self.width + 2 * margin, self.height + 2 * margin);
        let mut values = with_room(width * height)?;
        values.resize(width * height, shade);
        for row in 0..self.height {
            let start = (margin + row) * width + margin;
            values[start..start + self.width].copy_from_slice(self.row(row));
        }
        Ok(Self {
            width,
            height,
            values,
            light_on_nothing: self.light_on_nothing,
            blocks: None,
            by_pixels: false,
        })
    }

    /// The squares that the picture was made of, which are its pixels from now on.
    pub(in crate::trace) fn take_blocks(&mut self) -> Option<Blocks> {
        let blocks = self.blocks.take()?;
        [self.width, self.height] = blocks.extent();
        let count = self.width * self.height;
        for square in 0..count {
            self.values[square] = self.values[blocks.pixel(square)];
        }
        self.values.truncate(count);
        Some(blocks)
    }

    /// One row of shades.
    pub(in crate::trace) fn row(&self, row: usize) -> &[u16] {
        &self.values[row * self.width..(row + 1) * self.width]
    }

    /// Gives all pixels back.
    pub(in crate::trace) fn clear(&mut self) {
        (self.width, self.height, self.values) = (0, 0, Vec::new());
    }

    /// One row of shades, to be changed.
    pub(in crate::trace) fn row_mut(&mut self, row: usize) -> &mut [u16] {
        &mut self.values[row * self.width..(row + 1) * self.width]
    }

    /// Shades of some rows as bytes: 0 is black, 255 white.
    pub fn bytes(&self, rows: core::ops::Range<usize>) -> impl Iterator<Item = u8> + '_ {
        let last = rows.end.min(self.height);
        self.values[rows.start.min(last) * self.width..last * self.width]
            .iter()
            .map(|&value| (value >> 8) as u8)
    }
}

impl GrayRows {
    /// More rows, from red, green, blue and opacity, a byte each.
    ///
    /// # Errors
    ///
    /// A list that is not whole rows, or more rows than the picture has; nothing is taken then.
    pub fn push_rgba_rows(&mut self, bytes: &[u8]) -> Result<()> {
        self.room(bytes.len(), 4)?;
        self.scan.look(bytes, 4);
        for block in bytes.chunks(4 * BLOCK) {
            if self.opacity.capacity() == 0 && is_opaque(block) {
                self.push_opaque(block);
            } else {
                self.push_clear(block)?;
            }
        }
        Ok(())
    }

    /// Some pixels without transparency: the most usual ones.
    fn push_opaque(&mut self, pixels: &[u8]) {
        let start = self.values.len();
        self.values.extend(pixels.as_chunks::<4>().0.iter().map(|&pixel| luma(pixel) as u16));
        let sum: u32 = self.values[start..].iter().map(|&value| u32::from(value)).sum();
        self.light += u64::from(sum) * 255;
        self.dark +=
            self.values[start..].iter().filter(|&&value| is_dark(u32::from(value))).count() as u64 * 255;
        self.opaque += (self.values.len() - start) as u64 * 255;
    }

    fn push_clear(&mut self, pixels: &[u8]) -> Result<()> {
        for &pixel in pixels.as_chunks::<4>().0 {
            let (luma, alpha) = (luma(pixel), u32::from(pixel[3]));
            self.light += u64::from(luma * alpha);
            self.opaque += u64::from(alpha);
            self.dark += if is_dark(luma) { u64::from(alpha) } else { 0 };
            if alpha < 255 && self.opacity.is_empty() {
                self.opacity = with_room(self.width * self.height)?;
                self.opacity.resize(self.values.len(), 255);
            }
            if self.opacity.capacity() > 0 {
                self.opacity.push(pixel[3]);
            }
            self.values.push(((luma * alpha + 127) / 255) as u16);
        }
        Ok(())
    }

    /// More rows, from one byte per pixel: 0 is black.
    ///
    /// # Errors
    ///
    /// As [`GrayRows::push_rgba_rows`].
    pub fn push_gray_rows(&mut self, bytes: &[u8]) -> Result<()> {
        self.room(bytes.len(), 1)?;
        self.scan.look(bytes, 1);
        self.values.extend(bytes.iter().map(|&byte| u16::from(byte) << 8));
        if self.opacity.capacity() > 0 {
            self.opacity.resize(self.values.len(), 255);
        }
        self.opaque += 255 * bytes.len() as u64;
        self.dark += bytes.iter().filter(|&&byte| byte < 128).count() as u64 * 255;
        self.light += bytes.iter().map(|&byte| u64::from(byte)).sum::<u64>() * 65_280;
        Ok(())
    }

    /// The picture, once all rows are there.
    ///
    /// # Errors
    ///
    /// Missing rows.
    pub fn finish(self) -> Result<Gray> {
        self.finish_for(false)
    }

    /// The picture, once all rows are there, for tracing with [`inverted`](crate::trace::TraceOptions::inverted) ink or
    /// not.
    ///
    /// # Errors
    ///
    /// Missing rows.
    pub fn finish_for(mut self, inverted: bool) -> Result<Gray> {
        let pixels = self.width * self.height;
        if self.values.len() != pixels {
            return Err(Error::wrong_length("data", self.values.len(), pixels));
        }
        let light = self.light > self.opaque * 32_640;
        let clear = 255 * pixels as u64 - self.opaque;
        let light_on_nothing =
            light && LEAST_CLEAR * clear >= 255 * pixels as u64 && LEAST_LIGHT * self.dark <= self.opaque;
        // Light ink lies on black: what is there already. But dark ink on something light is ink there too, and would
        // be one with a black ground.
        let on_black = light_on_nothing || light && inverted;
        if !on_black {
            for (value, &alpha) in self.values.iter_mut().zip(&self.opacity) {
                *value += (u16::from(255 - alpha)) << 8;
            }
        }
        let blocks = self.scan.blocks_of(MOST_SHADES);
        Ok(Gray {
            width: self.width,
            height: self.height,
            values: self.values,
            light_on_nothing,
            blocks,
            by_pixels: false,
        })
    }

    fn room(&self, bytes: usize, each: usize) -> Result<()> {
        let (row, rest) = (each * self.width, self.width * self.height - self.values.len());
        if !bytes.is_multiple_of(row) || bytes / each > rest {
            return Err(Error::wrong_length("data", bytes, (bytes / row * row).min(each * rest)));
        }
        Ok(())
    }
}

/// 54 + 183 + 19 = 256: 0.2126, 0.7152 and 0.0722 to a thousandth.
#[inline]
fn luma(pixel: [u8; 4]) -> u32 {
    let all = u32::from_le_bytes(pixel);
    54 * (all & 255) + 183 * (all >> 8 & 255) + 19 * (all >> 16 & 255)
}

fn is_dark(luma: u32) -> bool {
    luma < 32_640
}

fn is_opaque(pixels: &[u8]) -> bool {
    // Whole pixels lie side by side; their fourth bytes do not.
    let all = pixels.as_chunks::<4>().0.iter().fold(u32::MAX, |all, &pixel| all & u32::from_le_bytes(pixel));
    all >> 24 == 255
}

/// Columns times rows, if a picture may have as many.
#[inline(never)]
pub(super) fn count(width: usize, height: usize) -> Result<usize> {
    check("width", None, width as f64, 1.0, MOST_SIDE as f64)?;
    check("height", None, height as f64, 1.0, MOST_SIDE as f64)?;
    let pixels = width * height;
    if pixels > MOST_PIXELS {
        return Err(Error::limit("data", "maxPixels", MOST_PIXELS, pixels as f64));
    }
    Ok(pixels)
}
