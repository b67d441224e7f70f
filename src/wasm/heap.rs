//! The allocator: talc, which is smaller and faster than Rust's own one for wasm (2.7 kB less after gzip).

use talc::wasm::{WasmDynamicTalc, new_wasm_dynamic_allocator};

#[global_allocator]
static HEAP: WasmDynamicTalc = new_wasm_dynamic_allocator();
