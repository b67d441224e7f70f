//! The figures of the documentation are what the code draws.

#[path = "../../examples/figures/main.rs"]
mod program;

use std::path::Path;

fn kept(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/figures");
    std::fs::read_to_string(folder.join(format!("{name}.svg"))).expect("the figure is there")
}

/// A text's numbers, and what is between them.
fn parts(text: &str) -> (Vec<f64>, Vec<&str>) {
    let (mut numbers, mut between) = (Vec::new(), Vec::new());
    let mut rest = text;
    loop {
        let start = rest.find(|c: char| c.is_ascii_digit()).unwrap_or(rest.len());
        let sign = usize::from(rest[..start].ends_with('-'));
        between.push(&rest[..start - sign]);
        if start == rest.len() {
            return (numbers, between);
        }
        let digits =
            rest[start..].find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(rest.len() - start);
        numbers.push(rest[start - sign..start + digits].parse().expect("a number"));
        rest = &rest[start + digits..];
    }
}

#[test]
fn every_figure_of_the_documentation_is_the_one_that_the_code_draws() {
    for (name, draw) in program::FIGURES {
        let drawn = draw().expect("it can be drawn");
        assert!(drawn == kept(name), "draw {name} again with `cargo run --example figures` and look at it");
        assert!(drawn.len() < 150_000, "{name} has {} bytes", drawn.len());
    }
}

#[test]
fn the_figure_of_tracing_shows_what_is_traced_to_a_twentieth_of_a_pixel() {
    let (name, draw) = program::FITTED;
    let (drawn, kept) = (draw().expect("it can be drawn"), kept(name));
    let ((numbers, words), (kept_numbers, kept_words)) = (parts(&drawn), parts(&kept));
    assert_eq!(words, kept_words, "the same commands");
    assert_eq!(numbers.len(), kept_numbers.len(), "as many numbers");
    for (number, shown) in numbers.iter().zip(&kept_numbers) {
        // A pixel of the picture is ten units wide.
        assert!((number - shown).abs() <= 0.5, "draw {name} again: {number} is shown as {shown}");
    }
}
