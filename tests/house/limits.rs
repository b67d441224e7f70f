//! Limits that the crate and the package both check are the same numbers: they are written in both, as each checks
//! before it allocates.

use std::fs;
use std::path::Path;

/// The file and the name of a limit in the crate, and its name in the package.
const SHARED: [(&str, &str, &str); 10] = [
    ("limits.rs", "LARGEST_COORDINATE", "LARGEST"),
    ("limits.rs", "MOST_EVALUATIONS", "MAX_EVALUATIONS"),
    ("limits.rs", "MOST_OUTPUT_POINTS", "MAX_OUTPUT"),
    ("limits.rs", "MOST_SURFACE_POINTS", "MAX_NET"),
    ("limits.rs", "MOST_FIT_POINTS", "MAX_SAMPLES"),
    ("limits.rs", "MOST_ROOTS", "MAX_ROOTS"),
    ("surface/axis.rs", "MOST_LEVELS", "MAX_LEVEL"),
    ("svg/parse.rs", "MOST_PATH_BYTES", "MAX_PATH"),
    ("trace/picture/gray.rs", "MOST_SIDE", "MAX_SIDE"),
    ("trace/picture/palette.rs", "MOST_COLORS", "MAX_COLORS"),
];

/// The number that a constant is: digits, a power of ten, or digits moved to the left.
fn number(text: &str) -> Option<f64> {
    let text = text.replace('_', "");
    match text.split_once("<<") {
        Some((digits, by)) => Some(digits.trim().parse::<f64>().ok()? * 2_f64.powi(by.trim().parse().ok()?)),
        None => text.trim().parse().ok(),
    }
}

/// The numbers of all constants of that name in a text of either language.
fn constants(text: &str, name: &str) -> Vec<f64> {
    let of_line = |line: &str| {
        let (_, rest) = line.split_once("const ")?;
        let (declared, value) = rest.split_once('=')?;
        let own = declared.split(':').next()?.trim() == name;
        if own { number(value.split(';').next()?) } else { None }
    };
    text.lines().filter_map(of_line).collect()
}

fn below(folder: &Path, text: &mut String) {
    for entry in fs::read_dir(folder).expect("the folder is there") {
        let path = entry.expect("it can be read").path();
        if path.is_dir() {
            below(&path, text);
        } else if path.extension().is_some_and(|extension| extension == "ts") {
            text.push_str(&fs::read_to_string(&path).expect("it is text"));
        }
    }
}

#[test]
fn limits_of_the_package_are_those_of_the_crate() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut face = String::new();
    below(&root.join("ts"), &mut face);
    for (file, in_crate, in_package) in SHARED {
        let source = fs::read_to_string(root.join("src").join(file)).expect("the file is there");
        let (ours, theirs) = (constants(&source, in_crate), constants(&face, in_package));
        assert_eq!(ours.len(), 1, "{file} has one {in_crate}");
        assert_eq!(ours, theirs, "{in_crate} of {file} and {in_package} of the package");
    }
}
