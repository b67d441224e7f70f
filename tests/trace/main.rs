//! Traces of drawings of two tones, whatever became of them on the way.

#[path = "../support/mod.rs"]
mod support;

mod border;
mod compressed;
mod corners;
mod dots;
mod drawings;
mod enlarged;
mod grain;
mod hairlines;
mod hostile;
mod ink;
mod letters;
mod light;
mod scans;
mod small;
mod soft;
mod steps;
mod symmetry;
mod thin;
mod tones;
mod two_shades;
