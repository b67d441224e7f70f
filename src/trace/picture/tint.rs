//! Colours, opaque or not.

use super::mixture::{Premultiplied, premultiplied};

/// Red, green, blue.
pub type Color = [u8; 3];

/// A colour and how much of it is there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tint {
    /// Its own, as if all of it were there.
    pub color: Color,
    /// 255 where nothing shows through it.
    pub opacity: u8,
}

impl From<Color> for Tint {
    fn from(color: Color) -> Self {
        Self { color, opacity: 255 }
    }
}

impl Tint {
    /// The colour that it has on white paper.
    pub fn on_white(&self) -> Color {
        on_white(self.color.map(f64::from), f64::from(self.opacity)).map(rounded)
    }

    pub(super) fn premultiplied(&self) -> Premultiplied {
        let [red, green, blue] = self.color;
        premultiplied([red, green, blue, self.opacity])
    }
}

/// What a colour of some opacity is on white.
pub(super) fn on_white(rgb: [f64; 3], opacity: f64) -> [f64; 3] {
    rgb.map(|channel| 255.0 + (channel - 255.0) * (opacity / 255.0))
}

pub(super) fn rounded(channel: f64) -> u8 {
    (channel + 0.5) as u8
}
