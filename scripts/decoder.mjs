// The wasm that reads inlined wasm: what inline-wasm.mjs, copy-runs.mjs and split-wasm.mjs made of it, undone.

import { OPERATIONS } from "./split-wasm.mjs";

/** Where the decoder puts together what split-wasm.mjs took apart; before it are its own tables. */
export const STREAMS = 32768;

/**
 * Bytes below this and multiples of eight are 128 and the most frequent: they are the code points that UTF-8 writes as
 * one byte, in their order but begun with another.
 */
export const FREQUENT = 110;

/**
 * `plain` reads the text's UTF-8 where JavaScript has put it and writes its bytes over it: every code point is below
 * 256, so one or two bytes become one, and what is written never overtakes what is read. Which byte each code point
 * stands for is in a table at 16384.
 *
 * `fill` copies runs from those bytes and from another wasm's to STREAMS, and returns where they end. `decode` puts
 * together what is there, from `out` on, and returns where that ends.
 *
 * At 0 it keeps where each row begins, and at 1024 how far each stream is read; 1428 is where the types of functions
 * begin in what it has written, and 1432 how far the list of the functions' types is read there. For each type of
 * locals (0x7b to 0x7f, four bytes each) it keeps after 1536 where its list ends. The lists themselves, of those in
 * use, are at 256 times the type. From 4096 on it writes what a function's locals are; how many there are one after the
 * other of one type, and which, is at 8192. Doubles are at 16384, the first one of its own.
 */
const DECODER = `
(module
  (memory (import "" "memory") 0)
  (func (export "plain") (param $from i32) (param $end i32) (param $shift i32)
    (local $to i32) (local $byte i32) (local $others i32)
    (loop $letter
      (if (i32.and (i32.ge_u (local.get $byte) (i32.const ${FREQUENT})) (i32.ne (i32.and (local.get $byte) (i32.const 7)) (i32.const 0)))
        (then
          (i32.store8 offset=16512 (local.get $others) (local.get $byte))
          (local.set $others (i32.add (local.get $others) (i32.const 1))))
        (else
          (i32.store8 offset=16384 (i32.and (local.get $shift) (i32.const 127)) (local.get $byte))
          (local.set $shift (i32.add (local.get $shift) (i32.const 1)))))
      (local.set $byte (i32.add (local.get $byte) (i32.const 1)))
      (br_if $letter (i32.lt_u (local.get $byte) (i32.const 256))))
    (local.set $to (local.get $from))
    (loop $next
      (local.set $byte (i32.load8_u (local.get $from)))
      (if (i32.ge_u (local.get $byte) (i32.const 128))
        (then
          (local.set $from (i32.add (local.get $from) (i32.const 1)))
          (local.set $byte
            (i32.or (i32.shl (local.get $byte) (i32.const 6)) (i32.and (i32.load8_u (local.get $from)) (i32.const 63))))))
      (i32.store8 (local.get $to) (i32.load8_u offset=16384 (i32.and (local.get $byte) (i32.const 255))))
      (local.set $to (i32.add (local.get $to) (i32.const 1)))
      (local.set $from (i32.add (local.get $from) (i32.const 1)))
      (br_if $next (i32.lt_u (local.get $from) (local.get $end)))))

  ;; The bytes begin with the runs; $own is where those begin that the other has not.
  (func (export "fill") (param $from i32) (param $other i32) (result i32)
    (local $to i32) (local $length i32) (local $own i32) (local $end i32)
    (local.set $to (i32.const ${STREAMS}))
    (i32.store offset=1024 (i32.const 0) (local.get $from))
    (local.set $end (call $number (i32.const 0)))
    (local.set $end (i32.add (local.get $end) (i32.load offset=1024 (i32.const 0))))
    (local.set $own (local.get $end))
    (loop $run
      (local.set $length (call $number (i32.const 0)))
      (memory.copy (local.get $to) (local.get $own) (local.get $length))
      (local.set $to (i32.add (local.get $to) (local.get $length)))
      (local.set $own (i32.add (local.get $own) (local.get $length)))
      (local.set $other (i32.add (local.get $other) (local.get $length)))
      ;; How far on, or how far back: the lowest bit says.
      (local.set $length (call $number (i32.const 0)))
      (local.set $other
        (i32.add
          (local.get $other)
          (i32.xor
            (i32.shr_u (local.get $length) (i32.const 1))
            (i32.sub (i32.const 0) (i32.and (local.get $length) (i32.const 1))))))
      (local.set $length (call $number (i32.const 0)))
      (memory.copy (local.get $to) (local.get $other) (local.get $length))
      (local.set $to (i32.add (local.get $to) (local.get $length)))
      (local.set $other (i32.add (local.get $other) (local.get $length)))
      (br_if $run (i32.lt_u (i32.load offset=1024 (i32.const 0)) (local.get $end))))
    (local.get $to))

  (func (export "decode") (param $out i32) (result i32)
    (local $from i32) (local $to i32) (local $i i32) (local $streams i32) (local $mode i32) (local $end i32)
    (local $bytes i32) (local $items i32) (local $value i32) (local $body i32) (local $place i32) (local $row i32)
    (local $signature i32) (local $start i32) (local $fresh i32) (local $group i32) (local $doubles i32)
    (local.set $start (local.get $out))

    ;; Where rows and streams begin.
    (local.set $streams (i32.shl (i32.load8_u (i32.const ${STREAMS})) (i32.const 2)))
    (local.set $from (i32.add (i32.const ${STREAMS + 2}) (local.get $streams)))
    (loop $row
      (i32.store (local.get $i) (local.get $from))
      (local.set $bytes (i32.load8_u (local.get $from)))
      (local.set $from
        (i32.add
          (i32.add (local.get $from) (i32.const 1))
          (i32.add (i32.and (local.get $bytes) (i32.const 15)) (i32.shr_u (local.get $bytes) (i32.const 4)))))
      (local.set $i (i32.add (local.get $i) (i32.const 4)))
      (br_if $row
        (i32.ne
          (i32.and (i32.shr_u (local.get $i) (i32.const 2)) (i32.const 255))
          (i32.load8_u (i32.const ${STREAMS + 1})))))
    (local.set $i (i32.const 0))
    (loop $stream
      (i32.store offset=1024 (local.get $i) (local.get $from))
      (local.set $from (i32.add (local.get $from) (i32.and (i32.load offset=${STREAMS + 2} (local.get $i)) (i32.const 0xffffff))))
      (local.set $i (i32.add (local.get $i) (i32.const 4)))
      (br_if $stream (i32.lt_u (local.get $i) (local.get $streams))))

    (local.set $row (i32.load (i32.const ${1024 + 4 * OPERATIONS})))
    (local.set $end (i32.load (i32.const ${1028 + 4 * OPERATIONS})))
    (loop $operation
      (local.set $to (i32.load (i32.shl (i32.load8_u (local.get $row)) (i32.const 2))))
      (local.set $bytes (i32.and (i32.load8_u (local.get $to)) (i32.const 15)))
      (local.set $items (i32.shr_u (i32.load8_u (local.get $to)) (i32.const 4)))
      (loop $byte
        (if (local.get $bytes)
          (then
            (i32.store8 (local.get $out) (i32.load8_u offset=1 (local.get $to)))
            (local.set $to (i32.add (local.get $to) (i32.const 1)))
            (local.set $out (i32.add (local.get $out) (i32.const 1)))
            (local.set $bytes (i32.sub (local.get $bytes) (i32.const 1)))
            (br $byte))))
      (loop $item
        (if (local.get $items)
          (then
            (local.set $items (i32.sub (local.get $items) (i32.const 1)))
            (local.set $to (i32.add (local.get $to) (i32.const 1)))
            (local.set $i (i32.shl (i32.load8_u (local.get $to)) (i32.const 2)))
            (local.set $mode (i32.load8_u offset=${STREAMS + 5} (local.get $i)))
            (if (i32.eq (i32.shr_u (local.get $mode) (i32.const 3)) (i32.const 15))
              (then
                ;; A local: the next new one, or one from the list of its type, where it is the last one from now on.
                (local.set $mode (i32.shl (local.get $mode) (i32.const 2)))
                (local.set $place (i32.load offset=1536 (local.get $mode)))
                (local.set $bytes (call $next (local.get $i)))
                (if (local.get $bytes)
                  (then
                    (local.set $from (i32.sub (local.get $place) (local.get $bytes)))
                    (local.set $value (i32.load8_u (local.get $from)))
                    (loop $closer
                      (i32.store8 (local.get $from) (i32.load8_u offset=1 (local.get $from)))
                      (local.set $from (i32.add (local.get $from) (i32.const 1)))
                      (br_if $closer (i32.lt_u (local.get $from) (local.get $place))))
                    (local.set $place (i32.sub (local.get $place) (i32.const 1))))
                  (else
                    (local.set $value (local.get $fresh))
                    (local.set $fresh (i32.add (local.get $fresh) (i32.const 1)))
                    (if (i32.ne (local.get $mode) (i32.load offset=4 (local.get $group)))
                      (then
                        (local.set $group (i32.add (local.get $group) (i32.const 8)))
                        (i64.store (local.get $group) (i64.shl (i64.extend_i32_u (local.get $mode)) (i64.const 32)))))
                    (i32.store (local.get $group) (i32.add (i32.load (local.get $group)) (i32.const 1)))))
                (i32.store8 (local.get $place) (local.get $value))
                (i32.store offset=1536 (local.get $mode) (i32.add (local.get $place) (i32.const 1)))
                (local.set $bytes (i32.const 0))
                ;; Of two bytes the first is the number itself.
                (i32.store8 (local.get $out) (local.get $value))
                (local.set $out (i32.add (local.get $out) (i32.const 1)))
                (br_if $item (i32.lt_u (local.get $value) (i32.const 128)))
                (i32.store8 (local.get $out) (i32.const 1))
                (local.set $out (i32.add (local.get $out) (i32.const 1)))
                (br $item)))
            (if (i32.eq (local.get $mode) (i32.const 254))
              (then
                ;; A number in units of the alignment, which was written last.
                (local.set $out
                  (call $write
                    (local.get $out)
                    (i32.shl (call $number (local.get $i)) (i32.load8_u (i32.sub (local.get $out) (i32.const 1))))))
                (br $item)))
            (if (i32.eq (local.get $mode) (i32.const 253))
              (then
                ;; How long the function is and what its locals are comes before it.
                (local.set $to (call $write (i32.const 4096) (i32.shr_u (i32.sub (local.get $group) (i32.const 8184)) (i32.const 3))))
                (local.set $from (i32.const 8192))
                (loop $groups
                  (if (i32.le_u (local.get $from) (local.get $group))
                    (then
                      (local.set $to (call $write (local.get $to) (i32.load (local.get $from))))
                      (i32.store8 (local.get $to) (i32.shr_u (i32.load offset=4 (local.get $from)) (i32.const 2)))
                      (local.set $to (i32.add (local.get $to) (i32.const 1)))
                      (local.set $from (i32.add (local.get $from) (i32.const 8)))
                      (br $groups))))
                (local.set $value (i32.sub (local.get $to) (i32.const 4096)))
                (local.set $bytes (i32.sub (local.get $out) (local.get $body)))
                (local.set $from (i32.add (local.get $value) (local.get $bytes)))
                (local.set $place (i32.sub (call $write (local.get $to) (local.get $from)) (i32.const 4096)))
                (memory.copy (i32.add (local.get $body) (local.get $place)) (local.get $body) (local.get $bytes))
                (memory.copy (call $write (local.get $body) (local.get $from)) (i32.const 4096) (local.get $value))
                (local.set $out (i32.add (local.get $out) (local.get $place)))
                (br $item)))
            (if (i32.eq (local.get $mode) (i32.const 252))
              (then
                (if (i32.eqz (local.get $body)) (then (call $sections (local.get $start))))
                (local.set $body (local.get $out))
                (local.set $from (i32.const 0x7b))
                (loop $list
                  (i32.store offset=1536 (i32.shl (local.get $from) (i32.const 2)) (i32.shl (local.get $from) (i32.const 8)))
                  (local.set $from (i32.add (local.get $from) (i32.const 1)))
                  (br_if $list (i32.lt_u (local.get $from) (i32.const 0x80))))
                ;; Parameters: of the function's type, after those that come before it.
                (local.set $signature (i32.load (i32.const 1428)))
                (local.set $value (call $number (i32.const 408)))
                (loop $skipped
                  (local.set $signature (i32.add (local.get $signature) (i32.const 1)))
                  (local.set $from (i32.load8_u (local.get $signature)))
                  (if (local.get $value)
                    (then
                      (local.set $value (i32.sub (local.get $value) (i32.const 1)))
                      (local.set $signature (i32.add (i32.add (local.get $signature) (local.get $from)) (i32.const 1)))
                      (local.set $signature (i32.add (i32.add (local.get $signature) (i32.load8_u (local.get $signature))) (i32.const 1)))
                      (br $skipped))))
                (loop $parameter
                  (if (i32.lt_u (local.get $value) (local.get $from))
                    (then
                      (local.set $signature (i32.add (local.get $signature) (i32.const 1)))
                      (local.set $mode (i32.shl (i32.load8_u (local.get $signature)) (i32.const 2)))
                      (local.set $place (i32.load offset=1536 (local.get $mode)))
                      (i32.store8 (local.get $place) (local.get $value))
                      (i32.store offset=1536 (local.get $mode) (i32.add (local.get $place) (i32.const 1)))
                      (local.set $value (i32.add (local.get $value) (i32.const 1)))
                      (br $parameter))))
                (local.set $fresh (local.get $value))
                (local.set $group (i32.const 8184))
                (br $item)))
            (if (i32.eq (local.get $mode) (i32.const 251))
              (then
                ;; A double by its number, or a new one, from the stream after this.
                (local.set $value (i32.shl (call $next (local.get $i)) (i32.const 3)))
                (if (i32.eqz (local.get $value))
                  (then
                    (local.set $doubles (local.tee $value (i32.add (local.get $doubles) (i32.const 8))))
                    (local.set $from (i32.load offset=1028 (local.get $i)))
                    (i32.store offset=1028 (local.get $i) (i32.add (local.get $from) (i32.const 8)))
                    (i64.store offset=16376 (local.get $value) (i64.load (local.get $from)))))
                (i64.store (local.get $out) (i64.load offset=16376 (local.get $value)))
                (local.set $out (i32.add (local.get $out) (i32.const 8)))
                (br $item)))
            (if (i32.eq (local.get $mode) (i32.const 255))
              (then (local.set $mode (call $next (local.get $i)))))
            ;; A LEB128 goes on as long as its bytes say, anything else $mode bytes long.
            (loop $copy
              (local.set $value (call $next (local.get $i)))
              (i32.store8 (local.get $out) (local.get $value))
              (local.set $out (i32.add (local.get $out) (i32.const 1)))
              (br_if $copy
                (select
                  (local.tee $mode (i32.sub (local.get $mode) (i32.const 1)))
                  (i32.and (local.get $value) (i32.const 128))
                  (i32.ge_s (local.get $mode) (i32.const 0)))))
            (br $item))))
      (local.set $row (i32.add (local.get $row) (i32.const 1)))
      (br_if $operation (i32.lt_u (local.get $row) (local.get $end))))
    (local.get $out))

  ;; Where types of functions are, and the types of the functions one by one, which are as streams are.
  (func $sections (param $start i32)
    (local $section i32) (local $end i32)
    (i32.store (i32.const 1432) (i32.add (local.get $start) (i32.const 8)))
    (loop $next
      (local.set $section (call $next (i32.const 408)))
      (local.set $end (call $number (i32.const 408)))
      (local.set $end (i32.add (local.get $end) (i32.load (i32.const 1432))))
      (if (i32.eq (local.get $section) (i32.const 1))
        (then
          (drop (call $number (i32.const 408)))
          (i32.store (i32.const 1428) (i32.load (i32.const 1432)))))
      (if (i32.ne (local.get $section) (i32.const 3))
        (then
          (i32.store (i32.const 1432) (local.get $end))
          (br $next))))
    (drop (call $number (i32.const 408))))

  ;; The next byte of a stream.
  (func $next (param $i i32) (result i32)
    (local $from i32)
    (local.set $from (i32.load offset=1024 (local.get $i)))
    (i32.store offset=1024 (local.get $i) (i32.add (local.get $from) (i32.const 1)))
    (i32.load8_u (local.get $from)))

  ;; The next number of a stream.
  (func $number (param $i i32) (result i32)
    (local $byte i32) (local $value i32) (local $shift i32)
    (loop $read
      (local.set $byte (call $next (local.get $i)))
      (local.set $value
        (i32.or (local.get $value) (i32.shl (i32.and (local.get $byte) (i32.const 127)) (local.get $shift))))
      (local.set $shift (i32.add (local.get $shift) (i32.const 7)))
      (br_if $read (i32.and (local.get $byte) (i32.const 128))))
    (local.get $value))

  ;; Writes a number, and returns where it ends.
  (func $write (param $out i32) (param $value i32) (result i32)
    (local $byte i32)
    (loop $write
      (local.set $byte (i32.and (local.get $value) (i32.const 127)))
      (local.set $value (i32.shr_u (local.get $value) (i32.const 7)))
      (if (local.get $value) (then (local.set $byte (i32.or (local.get $byte) (i32.const 128)))))
      (i32.store8 (local.get $out) (local.get $byte))
      (local.set $out (i32.add (local.get $out) (i32.const 1)))
      (br_if $write (local.get $value)))
    (local.get $out)))
`;

/** The decoder's bytes. The package is asked for here: in a fresh clone it comes after this file. */
export async function decoderBytes() {
  const { default: binaryen } = await import("binaryen");
  const module = binaryen.parseText(DECODER);
  module.setFeatures(binaryen.Features.BulkMemory | binaryen.Features.BulkMemoryOpt);
  if (!module.validate()) throw new Error("the decoder is not valid");
  binaryen.setOptimizeLevel(3);
  binaryen.setShrinkLevel(0);
  module.optimize();
  return module.emitBinary();
}
