//! The binding as JavaScript meets it: exported functions of numbers, a record and buffers in memory.
//!
//! What the face makes of it is tested in `tests/js`.

#![cfg(target_arch = "wasm32")]

use expline as _;
use js_sys::{Float64Array, Function, Reflect, Uint8Array};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::wasm_bindgen_test as test;

/// Calls an exported function, as JavaScript does.
fn call(name: &str, arguments: &[f64]) -> f64 {
    let function: Function =
        Reflect::get(&wasm_bindgen::exports(), &name.into()).expect("exports are an object").unchecked_into();
    let arguments: js_sys::Array = arguments.iter().map(|&n| JsValue::from_f64(n)).collect();
    let answer =
        function.apply(&JsValue::UNDEFINED, &arguments).expect("no exported function may stop the instance");
    answer.as_f64().unwrap_or(f64::NAN)
}

fn buffer() -> JsValue {
    Reflect::get(&wasm_bindgen::memory(), &"buffer".into()).expect("a memory has a buffer")
}

/// Number i of the record.
fn record(i: u32) -> f64 {
    let address = call("record_address", &[]) as u32;
    Float64Array::new(&buffer()).get_index(address / 8 + i)
}

fn text(address: f64, bytes: f64) -> String {
    let (start, end) = (address as u32, (address + bytes) as u32);
    String::from_utf8(Uint8Array::new(&buffer()).slice(start, end).to_vec()).expect("words are UTF-8")
}

fn write(numbers: &[f64]) {
    let address = call("input_address", &[numbers.len() as f64]) as u32;
    assert!(address > 0, "there is memory for {} numbers", numbers.len());
    Float64Array::new(&buffer()).set(&Float64Array::from(numbers), address / 8);
}

/// A circle of radius 5 through two points, into a slot.
fn load_circle(slot: f64) -> f64 {
    let pi = core::f64::consts::PI;
    write(&[5.0, 0.0, -5.0, 0.0, 0.0, 5.0 * pi, 0.0, -5.0 * pi]);
    call("load", &[slot, 2.0, 0.0, 0.0, 0.0, 0.0, 1.0])
}

#[test]
fn a_loaded_curve_answers_and_tells_its_frequency() {
    assert_eq!(load_circle(3.0), 1.0, "one ω stands for all");
    assert_eq!(record(0), 2.0, "the end of the domain");
    assert_eq!(call("evaluate_one", &[3.0, 0.5, 0.0]), 2.0, "two numbers in the record");
    // Four roundings of the radius.
    assert!((record(0).hypot(record(1)) - 5.0).abs() < 4.0 * f64::EPSILON * 5.0, "a point of the circle");
}

#[test]
fn a_refusal_says_what_was_wrong_where() {
    write(&[0.0, 0.0, 1.0, f64::NAN, 0.0, 0.0, 0.0, 0.0]);
    assert_eq!(call("load", &[0.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0]), -1.0, "failed");
    assert_eq!((record(0), record(1)), (1.0, 3.0), "not finite, at 3");
    assert_eq!(text(record(5), record(6)), "points", "the argument's name");
}

#[test]
fn a_failed_load_leaves_the_slot_as_it_was() {
    load_circle(1.0);
    write(&[0.0, 0.0, 1e300, 0.0, 0.0, 0.0, 0.0, 0.0]);
    assert_eq!(call("load", &[1.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0]), -1.0, "failed");
    assert_eq!(call("evaluate_one", &[1.0, 0.0, 0.0]), 2.0, "the circle is still there");
    assert_eq!((record(0), record(1)), (5.0, 0.0), "and starts where it started");
}

#[test]
fn slots_without_a_curve_and_numbers_that_wrap_are_refused_not_followed() {
    call("forget", &[]);
    for slot in [0.0, 15.0, 16.0, 4_294_967_295.0, -1.0] {
        for name in ["area", "bounds", "reverse", "bezier_points", "centroid"] {
            assert_eq!(call(name, &[slot]), -1.0, "{name} of slot {slot}");
        }
        assert_eq!(call("nearest", &[slot, 0.0, 0.0]), -1.0, "nearest of slot {slot}");
        assert_eq!(call("evaluate_many", &[slot, 1e6, 0.0]), -1.0, "evaluate_many of slot {slot}");
        assert_eq!(call("sample", &[slot, 10.0, 0.0, 10.0, 1.0]), -1.0, "sample of slot {slot}");
    }
}

#[test]
fn claims_of_more_numbers_than_were_written_are_an_error() {
    write(&[0.0; 4]);
    assert_eq!(call("load", &[0.0, 4e9, 0.0, 0.0, 0.0, 0.0, 1.0]), -1.0, "more points than there are");
    assert!(call("nearest_many", &[0.0, 4e9]) <= 4e9, "no more answers than places");
    assert!(call("through", &[4e9, 1.0, -1.0, 0.0]) >= -1.0, "no more points than there are");
    assert!(call("parse_path", &[4e9]) <= 0.0, "no text, no curves");
}

#[test]
fn the_record_stays_where_it_is_when_the_memory_grows() {
    let before = call("record_address", &[]);
    let size = || Uint8Array::new(&buffer()).length();
    let small = size();
    assert!(call("input_address", &[2e6]) > 0.0, "16 MB are there");
    assert!(size() > small, "the memory has grown");
    assert_eq!(call("record_address", &[]), before, "a fixed address");
    call("input_address", &[0.0]);
    load_circle(0.0);
    assert_eq!(call("evaluate_one", &[0.0, 0.0, 0.0]), 2.0, "and it works as before");
    assert_eq!(record(0), 5.0, "at the same place");
}

#[test]
fn memory_that_cannot_be_had_is_refused() {
    assert_eq!(call("input_address", &[4e8]), 0.0, "3.2 GB of a memory of at most 512 MiB");
    load_circle(0.0);
    assert_eq!(call("evaluate_one", &[0.0, 0.0, 0.0]), 2.0, "the instance lives");
}
