//! Traces a binary PGM picture: `cargo run --release --example trace in.pgm out.svg`, with `edges` or `lines` behind it
//! for edges or the centre lines of strokes.

use expline::svg::{PrintOptions, to_path_d};
use expline::trace::{Gray, Source, TraceOptions, trace};
use std::error::Error;

/// Width, height and pixels of a `P5` picture of one byte per pixel, without comments.
fn read(bytes: &[u8]) -> Option<(usize, usize, &[u8])> {
    let mut rest = bytes.strip_prefix(b"P5")?;
    let mut numbers = [0; 3];
    for number in &mut numbers {
        rest = rest.trim_ascii_start();
        let digits = rest.iter().take_while(|byte| byte.is_ascii_digit()).count();
        *number = std::str::from_utf8(&rest[..digits]).ok()?.parse().ok()?;
        rest = &rest[digits..];
    }
    let [width, height, most] = numbers;
    (most == 255).then_some((width, height, rest.get(1..)?))
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut names = std::env::args().skip(1);
    let (Some(from), Some(to)) = (names.next(), names.next()) else {
        return Err("usage: trace in.pgm out.svg".into());
    };
    let source = match names.next().as_deref() {
        None => Source::Brightness,
        Some("edges") => Source::Edges,
        Some("lines") => Source::Lines,
        Some(_) => return Err("a picture is traced by its ink, its edges or its lines".into()),
    };
    let bytes = std::fs::read(from)?;
    let (width, height, pixels) = read(&bytes).ok_or("not a binary PGM picture of one byte per pixel")?;
    let drawing =
        trace(Gray::from_bytes(width, height, pixels)?, &TraceOptions { source, ..TraceOptions::default() })?;
    let options = PrintOptions { decimals: Some(2), relative: true, ..PrintOptions::default() };
    let mut d = String::new();
    for contour in &drawing.contours {
        d.push_str(&to_path_d(&contour.curve, &options)?.d);
    }
    let stroked = " fill=\"none\" stroke=\"black\"";
    let style = if source == Source::Brightness { "" } else { stroked };
    let size = format!("width=\"{width}\" height=\"{height}\"");
    std::fs::write(
        to,
        format!("<svg xmlns=\"http://www.w3.org/2000/svg\" {size}><path d=\"{d}\"{style}/></svg>\n"),
    )?;
    Ok(())
}
