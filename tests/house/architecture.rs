//! The rooms keep to the drawing: who imports whom, how long a file may be, what may not be named, and that every
//! citation resolves. The drawing is in ARCHITECTURE.md.

use std::fs;
use std::path::Path;

/// Every room and the rooms that it may import.
const DRAWING: [(&str, &[&str]); 11] = [
    ("error", &[]),
    ("limits", &["error"]),
    ("numerics", &["error", "limits"]),
    ("generator", &["error", "limits", "numerics"]),
    ("refine", &["error", "limits", "numerics", "generator"]),
    ("curve", &["error", "limits", "numerics", "generator", "refine"]),
    ("surface", &["error", "limits", "numerics", "generator", "refine"]),
    ("fit", &["error", "limits", "numerics", "generator", "refine", "curve"]),
    ("svg", &["error", "limits", "numerics", "generator", "refine", "curve"]),
    ("trace", &["error", "limits", "numerics", "generator", "refine", "curve", "fit"]),
    (
        "wasm",
        &["error", "limits", "numerics", "generator", "refine", "curve", "surface", "fit", "svg", "trace"],
    ),
];

/// Rooms within rooms, and the neighbours that each may import; what stands beside them in the same room is open to
/// all.
const INNER: [(&str, &[&str]); 12] = [
    ("curve/hermite", &[]),
    ("curve/spline_curve", &[]),
    ("curve/measures", &[]),
    ("fit/convex", &[]),
    ("fit/knots", &["convex"]),
    ("fit/interior", &["convex", "knots"]),
    ("trace/picture", &[]),
    ("trace/outline", &[]),
    ("trace/refinement", &["picture", "outline"]),
    ("trace/quasi_interpolant", &[]),
    ("trace/tubes", &["quasi_interpolant"]),
    ("trace/edges", &["picture", "tubes"]),
];

/// Names that the crate's root gives again, and the rooms that they come from.
const ROOT_NAMES: [(&str, &str); 10] = [
    ("Error", "error"),
    ("Result", "error"),
    ("Space", "generator"),
    ("HermiteCurve", "curve"),
    ("HermiteOptions", "curve"),
    ("Curve", "curve"),
    ("InterpolatingCurve", "curve"),
    ("BSplineCurve", "curve"),
    ("LocalCurve", "curve"),
    ("TensorSurface", "surface"),
];

/// Packages that know JavaScript: named in the wasm room only.
const HOST_PACKAGES: [&str; 5] = ["wasm_bindgen", "js_sys", "web_sys", "serde_wasm_bindgen", "serde"];

const LONGEST_FILE: usize = 600;
const FORBIDDEN_WORDS: [&str; 5] = ["utils", "util", "helpers", "common", "misc"];

/// A source file: its path below src, with slashes, and its text.
struct Source {
    path: String,
    text: String,
}

impl Source {
    fn new(path: &str, text: &str) -> Self {
        Self { path: path.to_owned(), text: text.to_owned() }
    }

    /// The module path: `curve/hermite.rs` is `["curve", "hermite"]`, `curve/mod.rs` is `["curve"]`.
    fn module(&self) -> Vec<&str> {
        let stem = self.path.trim_end_matches(".rs").trim_end_matches("/mod");
        if stem == "lib" { Vec::new() } else { stem.split('/').collect() }
    }

    /// The lines without comments.
    fn code(&self) -> impl Iterator<Item = &str> {
        self.text
            .lines()
            .map(|line| line.split("//").next().unwrap_or(""))
            .filter(|line| !line.trim().is_empty())
    }
}

/// The identifier at the start of `text`.
fn identifier(text: &str) -> &str {
    let end = text.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(text.len());
    &text[..end]
}

/// The names that follow `crate::`, the path of the module that encloses a source in so many steps from the root, or a
/// chain of `super::` that ends there.
fn names_in(source: &Source, steps: usize) -> Vec<String> {
    let code = source.code().collect::<Vec<_>>().join("\n");
    let mut names = Vec::new();
    let mut push = |rest: &str| match rest.strip_prefix('{') {
        None => names.push(identifier(rest).to_owned()),
        Some(list) => {
            let mut depth = 0;
            let mut start = true;
            for (i, c) in list.char_indices() {
                match c {
                    '{' => depth += 1,
                    '}' if depth == 0 => break,
                    '}' => depth -= 1,
                    ',' if depth == 0 => start = true,
                    c if start && depth == 0 && !c.is_whitespace() => {
                        names.push(identifier(&list[i..]).to_owned());
                        start = false;
                    }
                    _ => {}
                }
            }
        }
    };
    let module = source.module();
    let prefix: String = ["crate"].iter().chain(&module[..steps]).map(|part| format!("{part}::")).collect();
    for (i, _) in code.match_indices(&prefix) {
        push(&code[i + prefix.len()..]);
    }
    let climb = "super::".repeat(module.len() - steps);
    if !climb.is_empty() {
        for (i, _) in code.match_indices(&climb) {
            if !code[..i].ends_with("super::") {
                push(&code[i + climb.len()..]);
            }
        }
    }
    names
}

fn room_of(name: &str) -> Option<&str> {
    let again = ROOT_NAMES.iter().find(|(again, _)| *again == name).map(|(_, room)| *room);
    again.or_else(|| DRAWING.iter().map(|(room, _)| *room).find(|room| *room == name))
}

fn import_violations(source: &Source) -> Vec<String> {
    let Some(&room) = source.module().first() else {
        return Vec::new();
    };
    let Some((_, allowed)) = DRAWING.iter().find(|(name, _)| *name == room) else {
        return vec![format!("{}: {room} is not a room of the drawing", source.path)];
    };
    let mut found = Vec::new();
    for name in names_in(source, 0) {
        match room_of(&name) {
            Some(target) if target == room || allowed.contains(&target) => {}
            Some(target) => found.push(format!("{}: {room} -> {target}", source.path)),
            // An inner test module's `super::*` and its like climb no further than their own file.
            None if name.is_empty() || source.module().len() == 1 => {}
            None => found.push(format!("{}: {name} is not known at the crate's root", source.path)),
        }
    }
    if room != "wasm" {
        for package in HOST_PACKAGES {
            let path = format!("{package}::");
            if source.code().any(|line| line.contains(&path)) {
                found.push(format!("{}: names {package}, which only wasm may", source.path));
            }
        }
    }
    found
}

/// Neighbours within a room that the drawing does not allow.
fn inner_violations(source: &Source) -> Vec<String> {
    let module = source.module();
    let [room, inner, ..] = module[..] else { return Vec::new() };
    let rooms = |name: &str| INNER.iter().find(|(path, _)| *path == format!("{room}/{name}"));
    let Some((_, allowed)) = rooms(inner) else { return Vec::new() };
    let names = names_in(source, 1).into_iter();
    let barred =
        names.filter(|name| name != inner && rooms(name).is_some() && !allowed.contains(&name.as_str()));
    barred.map(|name| format!("{}: {room}/{inner} -> {room}/{name}", source.path)).collect()
}

fn shape_violations(source: &Source) -> Vec<String> {
    let mut found = Vec::new();
    let lines = source.text.lines().count();
    if lines > LONGEST_FILE {
        found.push(format!("{}: {lines} lines, at most {LONGEST_FILE} are allowed", source.path));
    }
    for part in source.module() {
        if FORBIDDEN_WORDS.contains(&part) {
            found.push(format!("{}: {part} says nothing about what is inside", source.path));
        }
    }
    for line in source.code() {
        let words = line.split(|c: char| !(c.is_alphanumeric() || c == '_'));
        for word in words.filter(|word| word.ends_with("Manager") || word.ends_with("Helper")) {
            found.push(format!("{}: {word} says nothing about what it does", source.path));
        }
        if let Some(name) = line.trim_start().trim_start_matches("pub ").strip_prefix("mod ")
            && FORBIDDEN_WORDS.contains(&identifier(name))
        {
            found.push(format!("{}: mod {name} says nothing about what is inside", source.path));
        }
    }
    found
}

/// Closures that are owned behind a pointer, or called once: the build cuts what would call them out of the wasm
/// (scripts/snip.mjs).
fn closure_violations(source: &Source) -> Vec<String> {
    let owned = source.code().filter(|line| line.contains("<dyn Fn") || line.contains("dyn FnOnce"));
    owned.map(|line| format!("{}: {} would trap in the wasm", source.path, line.trim())).collect()
}

/// Citations `[Key, …]` or `[Key\]`, where a key is letters with two digits of a year, and `(D n.m)`.
fn citations(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    for (i, _) in text.match_indices('[') {
        let key = identifier(&text[i + 1..]);
        let digits = key.chars().rev().take_while(char::is_ascii_digit).count();
        let letters = &key[..key.len() - digits];
        let rest = &text[i + 1 + key.len()..];
        let is_key = digits == 2
            && !letters.is_empty()
            && letters.starts_with(|c: char| c.is_ascii_uppercase())
            && letters.chars().all(|c| c.is_ascii_alphabetic());
        if is_key && (rest.starts_with(',') || rest.starts_with(']') || rest.starts_with("\\]")) {
            found.push(format!("[{key}]"));
        }
    }
    for (i, _) in text.match_indices("(D ") {
        let rest = &text[i + 1..];
        if let Some(end) = rest.find(')')
            && rest[2..end].chars().all(|c| c.is_ascii_digit() || c == '.')
        {
            found.push(format!("({})", &rest[..end]));
        }
    }
    found
}

fn citation_violations(source: &Source, bibliography: &str, derivations: &str) -> Vec<String> {
    let resolves = |citation: &String| {
        if citation.starts_with('[') {
            bibliography.contains(&format!("**{citation}**"))
        } else {
            derivations.lines().any(|line| line.starts_with(citation.as_str()))
        }
    };
    let unresolved = citations(&source.text).into_iter().filter(|citation| !resolves(citation));
    unresolved.map(|citation| format!("{}: {citation} does not resolve", source.path)).collect()
}

fn sources_below(folder: &Path, prefix: &str) -> Vec<Source> {
    let mut found = Vec::new();
    let mut entries: Vec<_> = fs::read_dir(folder).expect("the folder is there").flatten().collect();
    entries.sort_by_key(fs::DirEntry::file_name);
    for entry in entries {
        let name = format!("{prefix}{}", entry.file_name().to_string_lossy());
        if entry.path().is_dir() {
            found.extend(sources_below(&entry.path(), &format!("{name}/")));
        } else if name.ends_with(".rs") {
            found.push(Source::new(&name, &fs::read_to_string(entry.path()).expect("the file is text")));
        }
    }
    found
}

fn repository() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn document(name: &str) -> String {
    fs::read_to_string(repository().join("docs").join(name)).expect("the document is there")
}

#[test]
fn imports_follow_the_drawing() {
    let sources = sources_below(&repository().join("src"), "");
    assert!(sources.len() > 20, "the sources were found");
    let found: Vec<_> = sources.iter().flat_map(import_violations).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
    for (path, _) in INNER {
        assert!(sources.iter().any(|source| source.path.starts_with(&format!("{path}/"))), "{path} is there");
    }
    let found: Vec<_> = sources.iter().flat_map(inner_violations).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn files_are_short_and_named_for_what_is_in_them() {
    let sources = sources_below(&repository().join("src"), "");
    let found: Vec<_> = sources.iter().flat_map(shape_violations).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn closures_that_are_passed_on_are_borrowed() {
    let sources = sources_below(&repository().join("src"), "");
    let found: Vec<_> = sources.iter().flat_map(closure_violations).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
    let planted = |text: &str| closure_violations(&Source::new("curve/area.rs", text)).len();
    assert_eq!(planted("fn f(g: Box<dyn Fn(f64) -> f64>) {}\nfn h(g: &dyn Fn(f64)) {}"), 1, "an owned one");
    assert_eq!(planted("fn f(g: Option<Box<dyn FnOnce()>>) {}"), 1, "one that is called once");
}

#[test]
fn every_citation_resolves() {
    let (bibliography, derivations) = (document("SOURCES.md"), document("DERIVATIONS.md"));
    let mut sources = sources_below(&repository().join("src"), "");
    sources.extend(
        sources_below(&repository().join("tests"), "")
            .into_iter()
            .filter(|s| s.path != "house/architecture.rs"),
    );
    let cited: usize = sources.iter().map(|source| citations(&source.text).len()).sum();
    assert!(cited > 20, "the citations were found");
    let found: Vec<_> =
        sources.iter().flat_map(|s| citation_violations(s, &bibliography, &derivations)).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn every_test_that_the_documents_name_is_there() {
    let sources = sources_below(&repository().join("tests"), "");
    for name in ["SOURCES.md", "DERIVATIONS.md"] {
        for quoted in document(name).split('`').skip(1).step_by(2).filter(|q| q.matches('_').count() >= 3) {
            let function = format!("fn {quoted}()");
            assert!(sources.iter().any(|s| s.text.contains(&function)), "{name}: there is no test {quoted}");
        }
    }
}

#[test]
fn a_planted_import_is_found() {
    let found = |path: &str, text: &str| import_violations(&Source::new(path, text));
    assert_eq!(found("numerics/sums.rs", "use crate::curve::Segment;").len(), 1, "a plain import");
    assert_eq!(
        found("curve/area.rs", "use crate::{\n    error::Error,\n    svg::{parse_path, Printed},\n};").len(),
        1,
        "a list"
    );
    assert_eq!(found("svg/print.rs", "fn f() { crate::fit::solve() }").len(), 1, "a path");
    assert_eq!(found("fit/mod.rs", "use super::surface;").len(), 1, "by way of super");
    assert_eq!(found("svg/deep/print.rs", "use super::super::super::wasm::slot;").len(), 1, "further up");
    assert_eq!(
        found("refine/mask.rs", "use crate::HermiteCurve;").len(),
        1,
        "a name given again by the root"
    );
    assert_eq!(found("curve/area.rs", "use wasm_bindgen::prelude::*;").len(), 1, "a host package");
    assert_eq!(found("helpers.rs", "").len(), 1, "a room that is not drawn");
    let fine = "//! crate::svg is mentioned only.\nuse crate::error::{Error, Result};\nuse super::limits::X;\nuse crate::Space;";
    assert!(found("curve/area.rs", fine).is_empty(), "{:?}", found("curve/area.rs", fine));
    assert!(
        found("wasm/mod.rs", "use crate::svg::parse_path;\nuse wasm_bindgen::JsValue;").is_empty(),
        "wasm may"
    );
}

#[test]
fn a_planted_import_within_a_room_is_found() {
    let found = |path: &str, text: &str| inner_violations(&Source::new(path, text)).len();
    let judge = "fit/convex/certificate.rs";
    assert_eq!(
        found(judge, "use crate::fit::interior::solver::Solver;"),
        1,
        "the certificate and the solver"
    );
    assert_eq!(found(judge, "use super::super::interior::cone::dot;"), 1, "by way of super");
    assert_eq!(found(judge, "use crate::fit::{knots::breaks::Breaks, samples::Samples};"), 1, "a list");
    assert_eq!(found("fit/knots.rs", "use super::interior::polish::Fixed;"), 1, "the door of a room");
    assert_eq!(
        found("trace/tubes/chain.rs", "use crate::trace::quasi_interpolant::cloud::Cloud;"),
        0,
        "an arrow"
    );
    assert_eq!(found(judge, "use super::problem::Problem;\nuse crate::fit::samples::Samples;"), 0, "at home");
    assert_eq!(found("fit/report.rs", "use super::knots::breaks::HIGHEST;"), 0, "beside the rooms");
}

#[test]
fn a_planted_long_file_or_empty_name_is_found() {
    let found = |path: &str, text: &str| shape_violations(&Source::new(path, text)).len();
    assert_eq!(found("curve/area.rs", &"\n".repeat(601)), 1, "601 lines");
    assert_eq!(found("curve/area.rs", &"\n".repeat(600)), 0, "600 lines");
    assert_eq!(found("curve/utils.rs", ""), 1, "a file called utils");
    assert_eq!(found("curve/area.rs", "mod helpers;"), 1, "a module called helpers");
    assert_eq!(found("curve/area.rs", "struct CurveManager;"), 1, "a manager");
}

#[test]
fn a_planted_citation_that_leads_nowhere_is_found() {
    let (bibliography, derivations) = ("* **[CRU15]** The paper", "(D 2.5) Near the start\n");
    let found = |text: &str| citation_violations(&Source::new("a.rs", text), bibliography, derivations);
    assert!(
        found("/// [CRU15, eq. 5], in the form (D 2.5); [0, 1], a[n], H[n].").is_empty(),
        "these resolve"
    );
    assert_eq!(found("/// [XYZ99, p. 3] and \\[Abc12\\]").len(), 2, "unknown keys");
    assert_eq!(found("/// (D 9.9)").len(), 1, "an unknown equation");
}
