import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import test from "node:test";
import { count, say, speak } from "./words.js";

const files = readdirSync(".").filter(f => /^(?!.*test).*\.(js|html)$/.test(f) && f !== "words.js");
const text = files.map(f => readFileSync(f, "utf8")).join("\n");

test("every word that the page asks for is there", () => {
  const asked = [...text.matchAll(/data-(?:say|tip|label)="(\w+)"/g), ...text.matchAll(/\bsay\("(\w+)"/g)].map(m => m[1]);
  assert.ok(asked.length > 100);
  assert.deepEqual(asked.filter(name => say(name) === name), []);
});

test("values are put in, one and many are told apart, another language takes over", () => {
  assert.equal(say("pages", { n: 2, of: 7 }), "Page 2 of 7");
  assert.match(count("loose", 1), /^1 loose end$/);
  assert.match(count("loose", 3), /^3 loose ends$/);
  speak({ pen: "Stift" });
  assert.equal(say("pen"), "Stift");
  assert.equal(say("erase"), "Erase");
});
