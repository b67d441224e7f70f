import assert from "node:assert/strict";
import { test } from "node:test";
import { Problem } from "../src/document/problem.ts";
import { kindOfText } from "../src/io/import.ts";
import { readPoints } from "../src/io/points/points.ts";

const three = [[1.5, 2.5], [3.5, 4], [5, -6.25]];

/** The points of a text that is one stroke. */
function pointsOf(text: string): unknown {
  const { strokes } = readPoints(text);
  assert.equal(strokes.length, 1, JSON.stringify(text));
  return strokes[0]?.points;
}

function isRead(text: string): void {
  assert.equal(kindOfText(text), "points", JSON.stringify(text));
  assert.deepEqual(pointsOf(text), three, JSON.stringify(text));
}

test("points are read as tables of any country have them", () => {
  for (const text of [
    "1.5,2.5\n3.5,4\n5,-6.25", "1.5 2.5\n3.5 4\n5 -6.25\n", "x,y\n1.5,2.5\n3.5,4\n5,-6.25", "1.5\t2.5\r\n3.5\t4\r\n5\t-6.25\r\n", "1.5;2.5\n3.5;4\n5;-6.25",
    // With a comma in fractions, as spreadsheets write them in much of Europe, to files and to the clipboard.
    "1,5;2,5\n3,5;4\n5;-6,25", "x;y\n1,5;2,5\n3,5;4\n5;-6,25\n", "1,5\t2,5\n3,5\t4\n5\t-6,25", "1,5 2,5\n3,5 4\n5 -6,25",
    "1,500\t2,500\n3,500\t4,000\n5,000\t-6,250",
    // A minus as typesetters have it, numbers in quotation marks, a separator at the end, bars around.
    "1.5,2.5\n3.5,4\n5,\u22126.25", '"1.5","2.5"\n"3.5","4"\n"5","-6.25"', "1.5,2.5,\n3.5,4,\n5,-6.25,", "| x | y |\n|---|---|\n| 1.5 | 2.5 |\n| 3.5 | 4 |\n| 5 | -6.25 |",
  ]) isRead(text);
});

test("headings with units, in any language, and remarks are no points", () => {
  for (const above of ["x (mm),y (mm)", '"Time [s]","Value"', "Länge;Höhe", "m1,m2", "# measured in March", "Sensor A\nDate: 2024-01-01\nx,y", "% x y"]) isRead(`${above}\n1.5,2.5\n# a remark\n3.5,4\n5,-6.25`);
});

test("of more than two columns the named ones are x and y, else the first two that do not number the rows, and it is said", () => {
  const rows = (...extra: readonly ((i: number) => string | number)[]): string => three.map(([x, y], i) => [...extra.map((of) => of(i)), x, y].join(",")).join("\n");
  for (const text of [`i,x,y\n${rows((i) => i)}`, `,x,y\n${rows((i) => i)}`, `time,X [mm],Y [mm]\n${rows((i) => 7.5 * i)}`, `name,lon,lat\n${rows((i) => `"a${i}"`)}`]) {
    isRead(text);
    assert.deepEqual(readPoints(text).notes, [], text);
  }
  assert.deepEqual(pointsOf("y,x\n2.5,1.5\n4,3.5\n-6.25,5"), three);
  assert.deepEqual(pointsOf(rows((i) => i + 1)), three);
  assert.deepEqual(readPoints(rows((i) => i + 1)).notes, ["of 3 columns, 2 and 3 were read as x and y"]);
  assert.deepEqual(pointsOf(`Nr.;Weg;Höhe\n${rows((i) => i).replaceAll(",", ";")}`), three);
  assert.deepEqual(pointsOf("t;v;e\n0;5;1\n1;6;1\n2;7;1"), [[0, 5], [1, 6], [2, 7]], "a time is no number of a row");
  assert.deepEqual(pointsOf("1.5,2.5,0.1\n3.5,4,0.2\n5,-6.25,0.1"), three);
  assert.deepEqual(readPoints("date,value\n2024-01-01,5\n2024-01-02,7").strokes[0]?.points, [[1, 5], [2, 7]]);
  assert.equal(readPoints("5\n7\n6").notes.length, 1, "one column is drawn over the row's number, which is said");
});

test("a list of points is read however a program has set it", () => {
  const named = three.map(([x, y]) => ({ x, y }));
  const values = [
    three, named, three.map(([x, y]) => ({ y, x })), three.map(([x, y], t) => ({ t, x, y })), { points: three }, { x: three.map(([x]) => x), y: three.map(([, y]) => y) },
    { type: "LineString", coordinates: three }, three.flat(), [three],
  ];
  for (const value of values) for (const space of [0, 2, "\t"]) isRead(JSON.stringify(value, null, space));
  for (const text of [
    "[(1.5, 2.5), (3.5, 4), (5, -6.25)]", "(1.5, 2.5)\n(3.5, 4)\n(5, -6.25)", "[[ 1.5   2.5 ]\n [ 3.5   4.  ]\n [ 5.   -6.25]]", "array([[1.5, 2.5],\n       [3.5, 4. ],\n       [5., -6.25]], dtype=float32)",
    "[{ x: 1.5, y: 2.5 }, { x: 3.5, y: 4 }, { x: 5, y: -6.25 }];", "[[1.5, 2.5], [3.5, 4], [5, -6.25],]",
  ]) isRead(text);
});

test("the points of an SVG polyline are read, in one line or several", () => {
  for (const text of ["1.5,2.5 3.5,4 5,-6.25", "1.5 2.5 3.5 4 5 -6.25", "1.5,2.5,3.5,4,5,-6.25", "1.5,2.5 3.5,4 5,-6.25\n"]) isRead(text);
  assert.deepEqual(pointsOf("0,0 1,2 3,1\n4,4 5,0"), [[0, 0], [1, 2], [3, 1], [4, 4], [5, 0]]);
});

test("strokes are parted by a blank line or by lists of their own; a blank line after every row parts nothing", () => {
  const counts = (text: string): number[] => readPoints(text).strokes.map(({ points }) => points.length);
  assert.deepEqual(counts("0 0\n1 1\n\n5 5\n6 6\n7 5\n"), [2, 3]);
  assert.deepEqual(counts("[[[0,0],[1,1]],[[5,5],[6,6],[7,5]]]"), [2, 3]);
  assert.deepEqual(counts("0 0\n\n1 1\n\n2 0"), [3]);
});

test("places without a number are left out, and it is said which; a missing number is not 0", () => {
  for (const cell of ["", "NaN", "NA", "n/a", "-", "null"]) {
    const { strokes: [stroke], notes } = readPoints(`1,2\n3,${cell}\n5,6\n7,8`);
    assert.deepEqual(stroke?.points, [[1, 2], [5, 6], [7, 8]], cell);
    assert.deepEqual(notes, ["line 2 has no two numbers and was left out"]);
  }
  const { strokes, notes } = readPoints("[[1, 2], [null, 3], [5, 6]]");
  assert.deepEqual(strokes[0]?.points, [[1, 2], [5, 6]]);
  assert.equal(notes.length, 1);
});

test("rows of a function that are in no order are sorted by x, which is said; a way back and forth stays as it is", () => {
  const text = (points: readonly (readonly number[])[]): string => points.map((point) => point.join(",")).join("\n");
  const wave = Array.from({ length: 40 }, (_, i) => [10 * i, 100 * Math.sin(i / 6)]);
  const mixed = wave.map((_, i) => wave[(i * 17) % 40] ?? []);
  assert.deepEqual(pointsOf(text(mixed)), wave);
  assert.match(readPoints(text(mixed)).notes.join(), /sorted by x/u);
  const forth = Array.from({ length: 60 }, (_, i) => [Math.floor(i / 6) % 2 === 0 ? i % 6 : 5 - (i % 6), i / 1000]);
  const star = Array.from({ length: 40 }, (_, i) => [(i % 2 === 0 ? 180 : 75) * Math.cos(i * Math.PI / 20), (i % 2 === 0 ? 180 : 75) * Math.sin(i * Math.PI / 20)]);
  const zigzag = Array.from({ length: 40 }, (_, i) => [i % 2 === 0 ? 0 : 100, 5 * i]);
  for (const points of [wave, forth, star, zigzag]) assert.deepEqual(pointsOf(text(points)), points);
});

test("a row with words where numbers belong is named, and so is one where most have none", () => {
  for (const [text, line] of [["0,0\n100,north", 2], ["1\t2\n3\n", 2], ["1,\n2,\n3,4", 1], ["0,0\n1e12,5", 2], ["[[10, 20], [30, 40, 50]]", 2], ["[[1, 2], [3, 4e12]]", 2]] as const) {
    assert.throws(() => readPoints(text), (error) => error instanceof Problem && error.id === "points-rows" && error.details.line === line, JSON.stringify(text));
  }
});

test("rows of many columns, some with nothing in them, and rows of blanks are read at once", () => {
  // With a pattern that could part each cell in two ways, 24 columns took longer than anybody waits.
  const cells = Array.from({ length: 24 }, (_, i) => `0.${100_000 + i}`);
  const rows = [1, 2, 3, 4].map((x) => [10 * x, x, ...cells, "", 7].join(","));
  assert.deepEqual(readPoints(rows.join("\n")).strokes.map(({ points }) => points), [[[10, 1], [20, 2], [30, 3], [40, 4]]]);
  const blanks = " ".repeat(200_000);
  assert.deepEqual(readPoints(`1${blanks}2\n${blanks}3 4${blanks}\n5\t6`).strokes[0]?.points.length, 3);
});

test("what is no table is not taken for one", () => {
  for (const text of ["Hello world, this is it.\nThere are 3 apples\nand 4 pears", "north", "x,y", "{}"]) assert.notEqual(kindOfText(text), "points", text);
  for (const path of ["M 10 20\n30 40\n50 60", "m1,1 2,2", "M0 0L1 1"]) assert.equal(kindOfText(path), "path", path);
});

test("of a map in GeoJSON the lines are read, however its names are written, and neither boxes nor numbers that are known of a place", () => {
  const ring = [[0.5, 0.5], [4, 0.5], [4, 3.25], [0.5, 0.5]];
  const feature = (geometry: unknown, more: object = {}): object => ({ type: "Feature", bbox: [0, 0, 9, 9], properties: { heights: [1, 2, 3, 4] }, geometry, ...more });
  const lines = (value: unknown): unknown => {
    const text = JSON.stringify(value, null, 1);
    assert.equal(kindOfText(text), "points", text);
    return readPoints(text).strokes.map(({ points, closed }) => [points, closed]);
  };
  const open = { type: "LineString", coordinates: three };
  const both = [[ring.slice(0, 3), true], [three, false]];
  for (const features of [[feature({ type: "Polygon", coordinates: [ring] }), feature(open)], [feature({ type: "GeometryCollection", geometries: [{ type: "MultiPolygon", coordinates: [[ring]] }, open] })]]) {
    assert.deepEqual(lines({ type: "FeatureCollection", features }), both);
    // A name with an apostrophe and brackets, and a type that does not come first.
    assert.deepEqual(lines({ name: "L'Aquila (north)", crs: { type: "name", properties: {} }, bbox: [0, 0, 9, 9], type: "FeatureCollection", features }), both);
  }
  const places = three.map((coordinates) => feature({ type: "Point", coordinates }));
  assert.deepEqual(lines({ type: "FeatureCollection", features: places }), [[three, false]], "places alone are one line");
  const mixed = readPoints(JSON.stringify({ type: "FeatureCollection", features: [feature(open), ...places.slice(0, 2)] }));
  assert.deepEqual([mixed.strokes.map(({ points }) => points), mixed.notes], [[three], ["2 places on no line were left out"]]);
});
