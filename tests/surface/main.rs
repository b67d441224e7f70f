//! Surfaces: points, normals and curvatures, meshes, and finer nets.

#[path = "../support/mod.rs"]
mod support;

mod reference;
mod refinement;
mod shape;
