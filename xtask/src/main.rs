//! `xtask bindgen …` is wasm-bindgen's command line, `xtask test-runner …` its test runner.

fn main() -> anyhow::Result<()> {
    let mut arguments = std::env::args_os();
    let program = arguments.next().unwrap_or_default();
    let command = arguments.next().unwrap_or_default();
    let rest = std::iter::once(program).chain(arguments);
    match command.to_str() {
        Some("bindgen") => wasm_bindgen_cli::wasm_bindgen::run_cli_with_args(rest),
        Some("test-runner") => wasm_bindgen_cli::wasm_bindgen_test_runner::run_cli_with_args(rest),
        _ => anyhow::bail!("usage: xtask bindgen|test-runner …"),
    }
}
