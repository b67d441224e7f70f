//! Golden data: JSON computed at 50 digits and more, parsed by the host (`serde_json` natively, the JavaScript
//! engine's own parser in wasm).

use serde::de::DeserializeOwned;

/// The data in `text`, which is a file of `tests/golden` taken in by `include_str!`.
#[cfg(not(target_arch = "wasm32"))]
pub(crate) fn parse<T: DeserializeOwned>(text: &str) -> T {
    serde_json::from_str(text).expect("golden data is well-formed JSON of the expected shape")
}

/// The data in `text`, which is a file of `tests/golden` taken in by `include_str!`.
#[cfg(target_arch = "wasm32")]
pub(crate) fn parse<T: DeserializeOwned>(text: &str) -> T {
    let value = js_sys::JSON::parse(text).expect("golden data is well-formed JSON");
    serde_wasm_bindgen::from_value(value).expect("golden data has the expected shape")
}
