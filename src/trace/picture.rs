//! Pictures and what is seen in them without curves: shades, light, tones, the iso-contours of ink, marks of single
//! pixels, colours in layers.

pub(super) mod bitmap;
pub(super) mod blocks;
pub(super) mod blur;
pub(super) mod census;
pub(super) mod color_light;
mod compression;
pub(super) mod contour;
pub(super) mod gray;
mod hues;
pub(super) mod layers;
pub(super) mod lifting;
pub(super) mod light;
mod mixture;
pub(super) mod palette;
pub(super) mod pitch;
pub(super) mod ridges;
pub(super) mod shape;
pub(super) mod softness;
pub(super) mod steps;
pub(super) mod tint;
pub(super) mod tones;
