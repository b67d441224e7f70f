import assert from "node:assert/strict";
import { test } from "node:test";
import { fileInText } from "../src/io/data-url.ts";

const png = "iVBORw0KGgo=";

test("a picture that is copied as text is a file: bare, in quotation marks, of a style sheet and of a page", async () => {
  const address = `data:image/png;base64,${png}`;
  for (const text of [address, ` ${address}\n`, `"${address}"`, `url(${address})`, `url("${address}");`, `<img alt="a" src="${address}">`, `<img src='${address}' />`]) {
    const file = fileInText(text);
    assert.ok(file !== null, text);
    assert.equal(file.type, "image/png");
    assert.deepEqual([...new Uint8Array(await file.arrayBuffer())], [...Buffer.from(png, "base64")], text);
  }
});

test("a drawing is one escaped or not, in either quotation marks", async () => {
  const svg = "<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0h9v9z'/></svg>";
  for (const text of [`data:image/svg+xml,${encodeURIComponent(svg)}`, `url("data:image/svg+xml;utf8,${svg}")`, `data:image/svg+xml;base64,${Buffer.from(svg).toString("base64")}`]) {
    const file = fileInText(text);
    assert.equal(file?.type, "image/svg+xml");
    assert.equal(await file?.text(), svg);
  }
});

test("other texts are none, nor is what cannot be decoded", () => {
  for (const text of ["", "M0 0L1 1", "data", "data:text/plain,hello", "1,2\n3,4", '<svg xmlns="http://www.w3.org/2000/svg"/>', "data:image/png;base64,%%%", "url(https://example.com/a.png)"]) {
    assert.equal(fileInText(text), null, text);
  }
});
