//! No two files of the core import each other, by whatever way round: one can be read before the other. Only a file and
//! what stands in its own folder may know each other, as a type and the parts of its work do.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// Modules by their paths (`curve::hermite`), with their code.
type House = BTreeMap<String, String>;

/// Which modules a module imports.
type Arrows = BTreeMap<String, BTreeSet<String>>;

fn house_below(folder: &Path, prefix: &str, house: &mut House) {
    for entry in fs::read_dir(folder).expect("the folder is there").flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        if entry.path().is_dir() {
            house_below(&entry.path(), &format!("{prefix}{name}::"), house);
        } else if let Some(stem) = name.strip_suffix(".rs") {
            let path = if stem == "mod" || stem == "lib" { String::new() } else { stem.to_owned() };
            let path = format!("{prefix}{path}");
            let text = fs::read_to_string(entry.path()).expect("the file is text");
            house.insert(path.trim_end_matches("::").to_owned(), code_of(&text));
        }
    }
}

/// The text without comments and inner tests.
fn code_of(text: &str) -> String {
    let lines = text.lines().map(|line| line.split("//").next().unwrap_or(""));
    let code: Vec<&str> = lines.collect();
    let code = code.join("\n");
    code.split("#[cfg(test)]\nmod ").next().unwrap_or("").to_owned()
}

/// `a::{b, c::{d}}` as `a::b` and `a::c::d`.
fn expanded(item: &str) -> Vec<String> {
    let item = item.trim();
    let Some(open) = item.find('{') else {
        return vec![item.split_whitespace().next().unwrap_or("").to_owned()];
    };
    let (mut depth, mut parts) = (0, vec![String::new()]);
    for c in item[open + 1..].trim_end().trim_end_matches('}').chars() {
        depth += i32::from(c == '{') - i32::from(c == '}');
        if c == ',' && depth == 0 {
            parts.push(String::new());
        } else if let Some(last) = parts.last_mut() {
            last.push(c);
        }
    }
    // A brace that was closed by the trimming above belongs to the last part.
    if let Some(last) = parts.last_mut() {
        last.push_str(&"}".repeat(depth.max(0) as usize));
    }
    let named = parts.iter().filter(|part| !part.trim().is_empty());
    named.flat_map(|part| expanded(&format!("{}{}", &item[..open], part.trim()))).collect()
}

/// What a module uses and what it hands on, as paths.
fn uses(code: &str) -> (Vec<String>, Vec<String>) {
    let (mut used, mut handed) = (Vec::new(), Vec::new());
    let flat = code.split_whitespace().collect::<Vec<_>>().join(" ");
    for statement in flat.split(';') {
        let statement =
            statement.rsplit("use ").next().filter(|_| statement.contains("use ")).map(str::to_owned);
        if let Some(item) = statement {
            used.extend(expanded(&item));
        }
    }
    for (i, _) in flat.match_indices("pub") {
        let rest = flat[i + 3..].trim_start();
        let rest =
            rest.strip_prefix('(').and_then(|rest| rest.split_once(')')).map_or(rest, |(_, rest)| rest);
        if let Some(item) = rest.trim_start().strip_prefix("use ") {
            handed.extend(expanded(item.split(';').next().unwrap_or("")));
        }
    }
    for start in ["crate::", "super::", "self::"] {
        for (i, _) in flat.match_indices(start) {
            let path: String =
                flat[i..].chars().take_while(|c| c.is_alphanumeric() || *c == '_' || *c == ':').collect();
            if !flat[..i].ends_with("::") {
                used.push(path);
            }
        }
    }
    (used, handed)
}

/// The module that a path leads to as it stands in a module, and the name in it.
fn led_to(house: &House, from: &str, path: &str) -> (String, Option<String>) {
    let mut at: Vec<&str> = from.split("::").filter(|part| !part.is_empty()).collect();
    let mut rest: Vec<&str> = path.split("::").filter(|part| !part.is_empty()).collect();
    match rest.first() {
        Some(&"crate") => (at, _) = (Vec::new(), rest.remove(0)),
        Some(&"self") => drop(rest.remove(0)),
        _ => {
            while rest.first() == Some(&"super") {
                let _ = (at.pop(), rest.remove(0));
            }
        }
    }
    while let Some(next) = rest.first() {
        let further = at.iter().copied().chain([*next]).collect::<Vec<_>>().join("::");
        if !house.contains_key(&further) {
            break;
        }
        at.push(rest.remove(0));
    }
    (at.join("::"), rest.first().map(|name| (*name).to_owned()))
}

/// Whether one module stands in the other's folder, at whatever depth.
fn is_family(one: &str, other: &str) -> bool {
    let within = |inner: &str, outer: &str| outer.is_empty() || inner.starts_with(&format!("{outer}::"));
    within(one, other) || within(other, one)
}

/// Imports of other files, traced to where names come from, but for those within a family.
fn arrows_of(house: &House) -> Arrows {
    let mut handed: BTreeMap<(String, String), String> = BTreeMap::new();
    for (module, code) in house {
        for path in uses(code).1 {
            if let (source, Some(name)) = led_to(house, module, &path) {
                handed.insert((module.clone(), name), source);
            }
        }
    }
    let mut arrows = Arrows::new();
    for (module, code) in house {
        for path in uses(code).0 {
            let (mut target, name) = led_to(house, module, &path);
            let mut passed = BTreeSet::new();
            while let Some(name) = &name
                && let Some(source) = handed.get(&(target.clone(), name.clone()))
                && passed.insert(target.clone())
            {
                target.clone_from(source);
            }
            if target != *module && !is_family(module, &target) {
                arrows.entry(module.clone()).or_default().insert(target);
            }
        }
    }
    arrows
}

/// Modules from which a way leads back to themselves: what is left when those that nothing leads on from are taken
/// away, one after the other, and those that nothing leads to.
fn in_circles(arrows: &Arrows) -> Vec<String> {
    let mut left = arrows.clone();
    loop {
        let count = left.len();
        let known: BTreeSet<String> = left.keys().cloned().collect();
        let reached: BTreeSet<String> = left.values().flatten().cloned().collect();
        left.retain(|module, targets| {
            targets.retain(|target| known.contains(target));
            !targets.is_empty() && reached.contains(module)
        });
        if left.len() == count {
            return left.iter().map(|(module, targets)| format!("{module} -> {targets:?}")).collect();
        }
    }
}

#[test]
fn no_files_import_each_other_but_a_type_and_the_parts_of_its_work() {
    let mut house = House::new();
    house_below(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), "", &mut house);
    let arrows = arrows_of(&house);
    let count: usize = arrows.values().map(BTreeSet::len).sum();
    assert!(house.len() > 200 && count > 800, "{} files and {count} arrows were found", house.len());
    let found = in_circles(&arrows);
    assert!(found.is_empty(), "these import each other:\n{}", found.join("\n"));
}

#[test]
fn a_planted_circle_is_found() {
    let circles = |files: &[(&str, &str)]| {
        let house = files.iter().map(|(path, text)| ((*path).to_owned(), code_of(text))).collect();
        in_circles(&arrows_of(&house)).len()
    };
    let room = ("fit", "mod a;\nmod b;\npub use b::B;");
    let plain = [room, ("fit::a", "use super::b::B;"), ("fit::b", "fn f() { crate::fit::a::g() }")];
    assert_eq!(circles(&plain), 2, "an import and a path");
    let handed = [room, ("fit::a", "use crate::fit::{B, C};"), ("fit::b", "use super::a::{self, A};")];
    assert_eq!(circles(&handed), 2, "a name that the room hands on");
    let list = [room, ("fit::a", "use super::{\n    b::{B, c::D},\n};"), ("fit::b", "use super::a::A;")];
    assert_eq!(circles(&list), 2, "a list");
    let long = [
        room,
        ("fit::a", "use super::b::B;"),
        ("fit::b", "use super::c::C;"),
        ("fit::c", "use super::a::A;"),
        ("fit::d", "use super::a::A;"),
    ];
    assert_eq!(circles(&long), 3, "three in a ring, and one that looks at it");
    let parts = [room, ("fit::a", "mod part;\nuse self::part::Part;"), ("fit::a::part", "use super::A;")];
    assert_eq!(circles(&parts), 0, "a type and a part of its work");
    let tests = [
        room,
        ("fit::a", "use super::b::B; // or super::c"),
        ("fit::b", "struct B;\n#[cfg(test)]\nmod tests {\n    use super::super::a::A;\n}"),
    ];
    assert_eq!(circles(&tests), 0, "what only an inner test or a comment says");
}
