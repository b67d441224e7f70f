//! The allocator of the wasm: freed blocks are kept by size, ready for the next of that size.
//!
//! Rust's own allocator for wasm joins and splits blocks so that memory of any history can be used again, and is a
//! tenth of the download. Here a handful of curves lives at a time and a call's buffers are gone when it returns.
//! Sizes are rounded up to powers of two, so that memory in use is at most twice what the busiest moment of each
//! size needed, however many calls there are.

#![allow(unsafe_code, reason = "an allocator hands out raw memory")]

use core::alloc::{GlobalAlloc, Layout};
use core::arch::wasm32::{memory_grow, memory_size};
use core::cell::Cell;
use core::ptr::null_mut;

const PAGE: usize = 1 << 16;
/// The smallest block: 16 bytes, which is also the largest alignment that anything here asks for.
const SMALLEST: u32 = 4;
const SIZES: usize = 28;

struct Heap {
    /// The first free block of every size; each begins with the address of the next.
    free: [Cell<usize>; SIZES],
    /// The end of what was handed out, and of the memory.
    top: Cell<usize>,
}

// SAFETY: this wasm has one thread.
unsafe impl Sync for Heap {}

#[global_allocator]
static HEAP: Heap = Heap { free: [const { Cell::new(0) }; SIZES], top: Cell::new(0) };

/// The number of the size that fits `layout`; the block has `1 << (size + SMALLEST)` bytes.
fn size_of(layout: Layout) -> usize {
    let bytes = layout.size().max(layout.align()).max(1 << SMALLEST);
    (usize::BITS - (bytes - 1).leading_zeros() - SMALLEST) as usize
}

impl Heap {
    /// A new block of so many bytes at the end, growing the memory where it has to; 0 where there is none.
    fn extend(&self, bytes: usize) -> usize {
        let end = memory_size(0) * PAGE;
        let start = if self.top.get() == 0 { end } else { self.top.get() };
        let Some(next) = start.checked_add(bytes) else { return 0 };
        if next > end && memory_grow(0, (next - end).div_ceil(PAGE)) == usize::MAX {
            return 0;
        }
        self.top.set(next);
        start
    }
}

// SAFETY: blocks come from memory that nothing else uses, have at least the size and alignment asked for (powers of
// two, taken one after the other from a page's start, 16 bytes at the least), and are in one place at a time: in use
// or on the list of their size.
unsafe impl GlobalAlloc for Heap {
    #[inline(never)]
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let size = size_of(layout);
        let Some(first) = self.free.get(size) else { return null_mut() };
        let block = first.get() as *mut usize;
        if block.is_null() {
            return self.extend(1 << (size as u32 + SMALLEST)) as *mut u8;
        }
        // SAFETY: a block on the list is free and begins with the next one's address.
        first.set(unsafe { *block });
        block.cast()
    }

    #[inline(never)]
    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        let Some(first) = self.free.get(size_of(layout)) else { return };
        // SAFETY: the block is at least 16 bytes, aligned to 16, and no longer in use.
        unsafe { *block.cast::<usize>() = first.get() };
        first.set(block as usize);
    }

    #[inline(never)]
    unsafe fn realloc(&self, block: *mut u8, layout: Layout, bytes: usize) -> *mut u8 {
        // SAFETY: the alignment is that of a layout already, and callers keep sizes below isize::MAX.
        let wanted = unsafe { Layout::from_size_align_unchecked(bytes, layout.align()) };
        if size_of(layout) == size_of(wanted) {
            return block;
        }
        // SAFETY: both blocks hold the smaller of the two sizes, and the new one is not the old one.
        unsafe {
            let moved = self.alloc(wanted);
            if !moved.is_null() {
                moved.copy_from_nonoverlapping(block, layout.size().min(bytes));
                self.dealloc(block, layout);
            }
            moved
        }
    }
}
