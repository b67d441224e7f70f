//! expline's tracer as native code, asked line by line.
//!
//! In: `outlines WIDTH HEIGHT REFINED TIMES SHADES`, or `lines` for centre lines; shades as two hexadecimal digits for
//! each pixel. Out: nanoseconds for all the times together, the least of them, and path data, or `! ` and why there is
//! none.

use std::hint::black_box;
use std::io::{BufRead, Write};
use std::time::Instant;

use expline::svg::{PrintOptions, to_path_d};
use expline::trace::{Gray, Source, Trace, TraceOptions, trace};

type Failure = Box<dyn std::error::Error>;

struct Picture {
    width: usize,
    height: usize,
    shades: Vec<u8>,
}

fn digit(byte: u8) -> Result<u8, Failure> {
    Ok(char::from(byte).to_digit(16).ok_or("not a hexadecimal digit")? as u8)
}

fn picture(width: &str, height: &str, text: &str) -> Result<Picture, Failure> {
    let shades = text
        .as_bytes()
        .chunks_exact(2)
        .map(|pair| Ok(digit(pair[0])? << 4 | digit(pair[1])?))
        .collect::<Result<_, Failure>>()?;
    Ok(Picture { width: width.parse()?, height: height.parse()?, shades })
}

fn traced(picture: &Picture, source: Source, refined: bool) -> Result<Trace, Failure> {
    let gray = Gray::from_bytes(picture.width, picture.height, &picture.shades)?;
    Ok(trace(gray, &TraceOptions { source, refined, ..TraceOptions::default() })?)
}

fn path(drawing: &Trace) -> Result<String, Failure> {
    let options = PrintOptions { decimals: Some(2), relative: true, ..PrintOptions::default() };
    let mut d = String::new();
    for contour in &drawing.contours {
        d.push_str(&to_path_d(&contour.curve, &options)?.d);
    }
    Ok(d)
}

fn obey(line: &str) -> Result<String, Failure> {
    let parts: Vec<&str> = line.split(' ').collect();
    let [what, width, height, refined, times, shades] = parts[..] else {
        return Err("outlines WIDTH HEIGHT REFINED TIMES SHADES".into());
    };
    let source = match what {
        "outlines" => Source::Brightness,
        "lines" => Source::Lines,
        _ => return Err(format!("{what} is no command").into()),
    };
    let picture = picture(width, height, shades)?;
    let (mut total, mut least) = (0, u128::MAX);
    let mut d = String::new();
    for _ in 0..times.parse::<usize>()?.max(1) {
        let start = Instant::now();
        d = black_box(path(&traced(&picture, source, refined == "true")?)?);
        let taken = start.elapsed().as_nanos();
        total += taken;
        least = least.min(taken);
    }
    Ok(format!("{total} {least} {d}"))
}

fn main() -> Result<(), Failure> {
    let mut output = std::io::stdout().lock();
    for line in std::io::stdin().lock().lines() {
        let answer = obey(&line?).unwrap_or_else(|failure| format!("! {failure}"));
        writeln!(output, "{answer}")?;
        output.flush()?;
    }
    Ok(())
}
