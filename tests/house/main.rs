//! The house itself: its rooms, its limits in two languages, and the figures and tables of its pages.
#![cfg(not(target_arch = "wasm32"))]

mod architecture;
mod circles;
mod figures;
mod fit_figures;
mod limits;
mod paper_tables;
mod rooms;
