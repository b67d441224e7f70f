//! The rooms of the tests are whole: a file that its room does not name, or that no runner in wasm sees, would keep its
//! promises to nobody.

use std::fs;
use std::path::{Path, PathBuf};

/// The rooms of this folder, each with the text of its door and the names and texts of its other files.
fn rooms() -> Vec<(String, Vec<(String, String)>)> {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let read = |path: &PathBuf| fs::read_to_string(path).expect("a file of a room can be read");
    let listed = |folder: &Path| -> Vec<PathBuf> {
        let entries = fs::read_dir(folder).expect("a folder of tests can be read");
        entries.map(|entry| entry.expect("an entry of a folder can be read").path()).collect()
    };
    let mut rooms = Vec::new();
    for folder in listed(&tests).into_iter().filter(|path| path.join("main.rs").is_file()) {
        let files = listed(&folder).into_iter().filter(|path| !path.ends_with("main.rs"));
        let named = files.map(|path| {
            let name = path.file_stem().expect("a file has a name").to_string_lossy().into_owned();
            (name, read(&path))
        });
        rooms.push((read(&folder.join("main.rs")), named.collect()));
    }
    rooms
}

/// What a file that runs only on this machine begins with.
const HOST_ONLY: &str = "\n#![cfg(not(target_arch = \"wasm32\"))]\n";
/// What makes the tests of a file visible to the runner in wasm.
const IN_WASM: &str = "\nuse wasm_bindgen_test::wasm_bindgen_test as test;\n";

#[test]
fn every_file_is_named_by_its_room() {
    let rooms = rooms();
    assert!(rooms.len() > 5, "the rooms were found");
    for (door, files) in rooms {
        for (name, _) in files {
            assert!(
                door.contains(&format!("\nmod {name};\n")),
                "{name}.rs is in a room that does not name it"
            );
        }
    }
}

#[test]
fn every_file_runs_in_wasm_or_says_that_it_does_not() {
    for (door, files) in rooms() {
        for (name, text) in files {
            let runs = text.contains(IN_WASM);
            let stays = door.contains(HOST_ONLY) || text.contains(HOST_ONLY);
            assert!(
                runs != stays,
                "{name}.rs must alias wasm_bindgen_test as test, or say that it is for the host only"
            );
        }
    }
}
