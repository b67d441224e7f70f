//! Pictures of a few flat colours: how much of which colour every pixel has (D 14.20).

mod mixing;
mod rows;

pub use self::rows::LayerRows;
use super::gray::count;
use super::mixture::Premultiplied;
use super::palette::MOST_COLORS;
use super::tint::{Color, Tint};
use crate::error::Result;
use crate::limits::{check, with_room};

/// In a picture that was drawn pixel by pixel one side in so many may be a mixture's,
const MIXTURES: usize = 20;
/// and one in so many at least is that of something one pixel wide.
const SINGLE: usize = 5;
/// In a picture of more pixels single ones may be dithering, and are too many to be contours each.
const SMALL: usize = 64 * 64;

/// How much of which colour every pixel has: three bytes each.
#[derive(Clone, Debug)]
pub struct Layers {
    pub(super) width: usize,
    pub(super) colors: Vec<Color>,
    palette: Vec<Premultiplied>,
    /// The colour that a pixel has most of; what comes after the palette is nothing.
    pub(super) first: Vec<u8>,
    /// Another one, and its share in 255.
    pub(super) second: Vec<u8>,
    pub(super) share: Vec<u8>,
    /// Pixels of each colour.
    areas: Vec<usize>,
}

impl Layers {
    /// Begins a picture of those colours that is given row by row. Layers are opaque: those of translucent colours look
    /// as these do on white.
    ///
    /// # Errors
    ///
    /// A palette with fewer than 1 or more than 64 colours; sides and pixels as
    /// [`Gray::begin`](crate::trace::Gray::begin).
    pub fn begin<T: Copy + Into<Tint>>(width: usize, height: usize, colors: &[T]) -> Result<LayerRows> {
        Self::with_tints(width, height, &colors.iter().map(|&color| color.into()).collect::<Vec<Tint>>())
    }

    fn with_tints(width: usize, height: usize, colors: &[Tint]) -> Result<LayerRows> {
        check("colors", None, colors.len() as f64, 1.0, MOST_COLORS as f64)?;
        let mut palette: Vec<Premultiplied> = colors.iter().map(Tint::premultiplied).collect();
        palette.push([0; 4]);
        let pixels = count(width, height)?;
        let layers = Self {
            width,
            colors: colors.iter().map(Tint::on_white).collect(),
            areas: vec![0; palette.len()],
            palette,
            first: with_room(pixels)?,
            second: with_room(pixels)?,
            share: with_room(pixels)?,
        };
        Ok(LayerRows::new(height, layers))
    }

    /// Colours as they lie on one another, the lowest first: what covers most lies lowest, and nothing, the last
    /// number, below all.
    pub(super) fn order(&self) -> Vec<u8> {
        let nothing = self.colors.len();
        let mut order: Vec<u8> = Vec::new();
        for label in 0..nothing {
            if self.areas[label] == 0 {
                continue;
            }
            let below = order.iter().position(|&other| self.areas[usize::from(other)] < self.areas[label]);
            order.insert(below.unwrap_or(order.len()), label as u8);
        }
        if self.areas[nothing] > 0 {
            order.insert(0, nothing as u8);
        }
        order
    }

    /// Whether its pixels are so few that single ones may be contours each.
    pub(in crate::trace) fn is_small(&self) -> bool {
        self.first.len() <= SMALL
    }

    /// Whether the picture was drawn pixel by pixel, as sprites are: without mixtures, and many of the sides between
    /// colours are those of something one pixel wide.
    pub(in crate::trace) fn is_by_pixels(&self) -> bool {
        let (width, count) = (self.width, self.first.len());
        let differ = |at: usize, step: usize| self.first[at] != self.first[at + step];
        let (mut mixed, mut sides, mut single) = (0, 0, 0);
        for at in 0..count {
            mixed += usize::from(self.share[at] > 0);
            for (step, fits) in [(1, at % width + 2 < width), (width, at + 2 * width < count)] {
                if fits && differ(at, step) {
                    sides += 1;
                    single += usize::from(differ(at + step, step));
                }
            }
        }
        MIXTURES * mixed <= sides && SINGLE * single >= sides
    }
}
