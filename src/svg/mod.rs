//! SVG path data in and out; no XML.
//!
//! [`parse_path`] turns every subpath into one [`HermiteCurve`](crate::HermiteCurve) without approximating
//! anything; [`to_path_d`] goes back, with arcs as `A`, lines as `L` and all else as cubic Béziers within a tolerance.
//!
//! ```
//! use expline::svg::{PrintOptions, parse_path, to_path_d};
//!
//! let ring = &parse_path("M10 50a40 40 0 1 1 80 0a40 40 0 1 1-80 0z")?.curves[0];
//! let printed = to_path_d(ring, &PrintOptions { decimals: Some(1), ..PrintOptions::default() })?;
//! assert!(printed.d.contains('A') && !printed.d.contains('C'), "arcs came in, arcs go out");
//! # Ok::<(), expline::Error>(())
//! ```

mod arc;
mod arc_text;
mod number;
mod parse;
mod print;
mod returning;
mod subpath;
mod text;

#[cfg(all(target_arch = "wasm32", feature = "wasm"))]
pub(crate) use parse::parse_bytes;
pub use parse::{MOST_PATH_BYTES, MOST_PATH_POINTS, MOST_SUBPATHS, ParsedPath, Truncation, parse_path};
#[cfg(all(target_arch = "wasm32", feature = "wasm-spline"))]
pub(crate) use print::outline;
#[cfg(all(target_arch = "wasm32", feature = "wasm"))]
pub(crate) use print::print_hermite;
pub use print::{PrintOptions, Printed, to_path_d};
