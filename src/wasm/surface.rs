//! Surfaces: resident in places of their own, asked and derived as curves are.
//!
//! A surface crosses as one run of numbers: for u and for v the count of points, closed, level, how many roots; how
//! many patches; the roots in pairs; the net; and for every patch its two windows (level, first, count) and its
//! displacements.

use super::kernel::{Kernel, PATCH, SURFACES, grow, run, times};
use super::numbers::Numbers;
use super::roots::{push_roots, roots_of};
use crate::numerics::Vector3;
use crate::surface::{Direction, Grid, Region};
use crate::{Error, Result, TensorSurface};
use wasm_bindgen::prelude::wasm_bindgen;

/// Numbers of the header.
const HEADER: usize = 9;

const NOT_RESIDENT: Error =
    Error::Degenerate { argument: "slot", index: None, reason: "no surface is resident" };

fn resident(kernel: &Kernel, slot: u32) -> Result<&TensorSurface> {
    kernel.surfaces.get(slot as usize).and_then(Option::as_ref).ok_or_else(|| Box::new(NOT_RESIDENT))
}

/// Runs a body with the surface taken out of its place, so that the buffers are free.
fn with(slot: u32, body: &mut dyn FnMut(&mut TensorSurface, &mut Kernel) -> Result<usize>) -> i32 {
    run(&mut |kernel| {
        resident(kernel, slot)?;
        let place = slot as usize % SURFACES;
        let Some(mut surface) = kernel.surfaces[place].take() else { return Ok(0) };
        let result = body(&mut surface, kernel);
        kernel.surfaces[place] = Some(surface);
        result
    })
}

/// A surface from the run of numbers that describes it; `patch` counts the patches that are read.
fn read(numbers: &[f64], patch: &mut f64) -> Result<TensorSurface> {
    let mut rest = Numbers(numbers);
    let mut header = Numbers(rest.take(HEADER));
    let mut counts = || (header.count(), header.flag(), header.count(), header.count());
    let (of_u, of_v) = (counts(), counts());
    let patches = header.count();
    let mut direction = |(count, closed, level, roots): (usize, bool, usize, usize), name| {
        let roots = roots_of(rest.take(2 * roots)).map_err(|error| error.about(name))?;
        Ok::<_, Box<Error>>(Direction { roots, count, closed, level: level as u32 })
    };
    let (u, v) = (direction(of_u, "u.roots")?, direction(of_v, "v.roots")?);
    let net = rest.take(u.count.saturating_mul(v.count).saturating_mul(3));
    let mut surface = TensorSurface::new(net.to_vec(), u, v)?;
    for _ in 0..patches {
        *patch += 1.0;
        let mut window = || (rest.count() as u32, rest.count(), rest.count());
        let (u, v) = (window(), window());
        let displacements = rest.take(u.2.saturating_mul(v.2).saturating_mul(3));
        surface.push_patch(u, v, displacements)?;
    }
    Ok(surface)
}

/// Leaves a surface in the output.
fn describe(kernel: &mut Kernel, surface: &TensorSurface) -> Result<usize> {
    let output = &mut kernel.output;
    output.clear();
    for direction in surface.directions() {
        let Direction { roots, count, closed, level } = direction;
        output.extend([*count as f64, f64::from(u8::from(*closed)), f64::from(*level), roots.order() as f64]);
    }
    output.push(surface.patch_count() as f64);
    for direction in surface.directions() {
        push_roots(output, &direction.roots);
    }
    // Adding 0 turns −0 into 0, so that JSON can carry every number.
    output.extend(surface.net().iter().map(|x| x + 0.0));
    for patch in 0..surface.patch_count() {
        for (level, first, count) in surface.patch_window(patch)? {
            output.extend([f64::from(level), first as f64, count as f64]);
        }
        output.extend(surface.displacements(patch)?.iter().map(|x| x + 0.0));
    }
    record_ends(kernel, surface);
    Ok(kernel.output.len())
}

/// Leaves the ends of a surface's domain and the parameters of its first point in the record.
#[inline(never)]
fn record_ends(kernel: &mut Kernel, surface: &TensorSurface) {
    let ([u, v], [first_u, first_v]) = (surface.domain(), surface.parameters(0, 0));
    kernel.record([u, v, first_u, first_v]);
}

/// Makes the surface that the input's `count` numbers describe resident. Leaves the ends of its domain and the
/// parameters of its first point in the record.
#[wasm_bindgen]
pub fn surface_load(slot: u32, count: u32) -> i32 {
    run(&mut |kernel| {
        let given = &kernel.input[..(count as usize).min(kernel.input.len())];
        let surface = read(given, &mut kernel.record[PATCH])?;
        record_ends(kernel, &surface);
        kernel.surfaces[slot as usize % SURFACES] = Some(surface);
        Ok(0)
    })
}

/// Points or derivatives at the `count` parameters u in the input and as many v after them; where `du` is 255, unit
/// normals.
#[wasm_bindgen]
pub fn surface_evaluate(slot: u32, count: u32, du: u32, dv: u32) -> i32 {
    with(slot, &mut |surface, kernel| {
        let numbers = times(count, 3);
        grow(&mut kernel.output, numbers, 0.0)?;
        let (u, rest) = kernel.input.split_at((count as usize).min(kernel.input.len()));
        let (v, out) = (&rest[..u.len().min(rest.len())], &mut kernel.output[..numbers]);
        if du == 255 {
            surface.normals_into(u, v, out)?;
        } else {
            surface.evaluate_into(u, v, du as usize, dv as usize, out)?;
        }
        Ok(numbers)
    })
}

/// Gaussian curvature, then mean curvature, at the `count` parameters u in the input and as many v after them.
#[wasm_bindgen]
pub fn surface_curvature(slot: u32, count: u32) -> i32 {
    with(slot, &mut |surface, kernel| {
        let count = count as usize;
        grow(&mut kernel.output, 2 * count, 0.0)?;
        let (u, rest) = kernel.input.split_at(count.min(kernel.input.len()));
        surface.curvatures_into(u, &rest[..u.len().min(rest.len())], &mut kernel.output[..2 * count])?;
        Ok(2 * count)
    })
}

/// Positions, then normals, of a region of a mesh; leaves how many vertices have no normal in the record.
#[wasm_bindgen]
pub fn surface_mesh(
    slot: u32,
    rows: u32,
    cols: u32,
    row: u32,
    row_count: u32,
    col: u32,
    col_count: u32,
) -> i32 {
    with(slot, &mut |surface, kernel| {
        let (grid, region, vertices) = part([rows, cols], [row, row_count], [col, col_count])?;
        grow(&mut kernel.output, 6 * vertices, 0.0)?;
        let (positions, normals) = kernel.output[..6 * vertices].split_at_mut(3 * vertices);
        let without = surface.mesh_into(grid, &region, positions, normals)?;
        kernel.record([without as f64]);
        Ok(6 * vertices)
    })
}

/// Gaussian curvatures, then mean ones, of a region of a mesh.
#[wasm_bindgen]
pub fn surface_mesh_curvature(
    slot: u32,
    rows: u32,
    cols: u32,
    row: u32,
    row_count: u32,
    col: u32,
    col_count: u32,
) -> i32 {
    with(slot, &mut |surface, kernel| {
        let (grid, region, vertices) = part([rows, cols], [row, row_count], [col, col_count])?;
        grow(&mut kernel.output, 2 * vertices, 0.0)?;
        surface.mesh_curvatures_into(grid, &region, &mut kernel.output[..2 * vertices])?;
        Ok(2 * vertices)
    })
}

/// A grid that may be, a region of it from a first row and a first column on, and how many vertices that has.
fn part(grid: [u32; 2], rows: [u32; 2], cols: [u32; 2]) -> Result<(Grid, Region, usize)> {
    let [all_rows, all_cols] = grid.map(|count| count as usize);
    let range = |[first, count]: [u32; 2]| first as usize..first as usize + count as usize;
    let grid = Grid { rows: all_rows, cols: all_cols };
    grid.check()?;
    Ok((grid, Region { rows: range(rows), cols: range(cols) }, times(rows[1], cols[1] as usize)))
}

/// The vertex numbers of a mesh's triangles, two in the place of each number. Returns how many places; the count is in
/// the record.
#[wasm_bindgen]
pub fn surface_indices(slot: u32, rows: u32, cols: u32) -> i32 {
    with(slot, &mut |surface, kernel| {
        let indices = surface.indices(Grid { rows: rows as usize, cols: cols as usize })?;
        kernel.output.clear();
        let pairs = indices.chunks(2).map(|pair| {
            let [low, high] = [0, 1].map(|i| pair.get(i).map_or(0, |index| u64::from(*index)));
            f64::from_bits(low | high << 32)
        });
        kernel.output.extend(pairs);
        kernel.record([indices.len() as f64]);
        Ok(kernel.output.len())
    })
}

/// First row, rows, first column and columns of the part of a mesh that a point of the net (patch −1) or of a patch
/// moves, in the record.
#[wasm_bindgen]
pub fn surface_touched(slot: u32, rows: u32, cols: u32, patch: i32, i: u32, j: u32) -> i32 {
    with(slot, &mut |surface, kernel| {
        let grid = Grid { rows: rows as usize, cols: cols as usize };
        let (i, j) = (i as usize, j as usize);
        let Region { rows, cols } = match usize::try_from(patch) {
            Ok(patch) => surface.touched_by_patch(grid, patch, i, j)?,
            Err(_) => surface.touched(grid, i, j)?,
        };
        let numbers = [rows.start, rows.len(), cols.start, cols.len()];
        kernel.record(numbers.map(|n| n as f64));
        Ok(4)
    })
}

/// Moves a point; leaves the net in the output where other points moved along.
#[wasm_bindgen]
pub fn surface_set_point(slot: u32, i: u32, j: u32, x: f64, y: f64, z: f64) -> i32 {
    with(slot, &mut |surface, kernel| {
        let others = surface.set_point(i as usize, j as usize, Vector3::new(x, y, z))?;
        Ok(if others { kernel.give(surface.net().iter().map(|x| x + 0.0).collect()) } else { 0 })
    })
}

/// Moves a control point of a patch; leaves its displacement in the record.
#[wasm_bindgen]
pub fn surface_set_patch_point(slot: u32, patch: u32, i: u32, j: u32, x: f64, y: f64, z: f64) -> i32 {
    with(slot, &mut |surface, kernel| {
        let (patch, i, j) = (patch as usize, i as usize, j as usize);
        surface.set_patch_point(patch, i, j, Vector3::new(x, y, z))?;
        let [_, (_, _, columns)] = surface.patch_window(patch)?;
        if let [x, y, z] = surface.displacements(patch)?[3 * (i * columns + j)..][..3] {
            kernel.record([x + 0.0, y + 0.0, z + 0.0]);
        }
        Ok(3)
    })
}

/// The control points of a patch.
#[wasm_bindgen]
pub fn surface_patch_points(slot: u32, patch: u32) -> i32 {
    with(slot, &mut |surface, kernel| {
        let points = surface.patch_points(patch as usize)?;
        Ok(kernel.give(points))
    })
}

/// The same surface with a finer net.
#[wasm_bindgen]
pub fn surface_refine(slot: u32, levels_u: u32, levels_v: u32) -> i32 {
    with(slot, &mut |surface, kernel| describe(kernel, &surface.refine(levels_u, levels_v)?))
}

/// The nearest surface with a coarser net; how far away it is follows what `describe` leaves in the record.
#[wasm_bindgen]
pub fn surface_reduce(slot: u32, levels_u: u32, levels_v: u32) -> i32 {
    with(slot, &mut |surface, kernel| {
        let (coarse, deviation) = surface.reduce(levels_u, levels_v)?;
        let count = describe(kernel, &coarse)?;
        kernel.record[4] = deviation;
        Ok(count)
    })
}

/// The same surface with one more patch.
#[wasm_bindgen]
pub fn surface_refine_at(slot: u32, u: f64, v: f64, levels: u32, reach: f64) -> i32 {
    with(slot, &mut |surface, kernel| describe(kernel, &surface.refine_at(u, v, levels, reach)?))
}

/// One of the shapes: sphere or ellipsoid (a, b, c), torus (a, b), cylinder (a, b), Roman surface (a), hyperbolic
/// paraboloid (a, b, c), character.
#[wasm_bindgen]
pub fn surface_shape(shape: u32, a: f64, b: f64, c: f64, m: u32, n: u32) -> i32 {
    run(&mut |kernel| {
        let segments = [m as usize, n as usize];
        let surface = match shape {
            0 => TensorSurface::sphere(a, segments),
            1 => TensorSurface::ellipsoid(Vector3::new(a, b, c), segments),
            2 => TensorSurface::torus(a, b, segments),
            3 => TensorSurface::cylinder(a, b, segments),
            4 => TensorSurface::roman_surface(a, segments),
            5 => TensorSurface::hyperbolic_paraboloid([a, b, c], segments),
            _ => TensorSurface::character(),
        }?;
        describe(kernel, &surface)
    })
}
