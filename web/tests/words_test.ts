import assert from "node:assert/strict";
import { test } from "node:test";
import { luminance, mixed, rgbOf, scaleColour, visibleOn, type Rgb } from "../src/colours.ts";
import type { TextFile } from "../src/plan/browser_kernel.ts";
import { programFirst } from "../src/plan/program_files.ts";
import { Store, fromFragment, initialState, toFragment } from "../src/state.ts";
import { clock, lengthText, percent, plain, shortTime, unitOf } from "../src/units.ts";

test("the program is the file that no other calls", () => {
  const file = (name: string, text: string): TextFile => ({ name, text });
  const firstOf = (...files: [TextFile, ...TextFile[]]): string[] => programFirst(files).map(({ name }) => name);
  const part = file("part.ngc", "G21\no<bolt.circle> call [3]\nO <drill>  CALL\nM2\n");
  assert.deepEqual(firstOf(file("bolt.circle.ngc", "o<bolt.circle> sub"), file("drill.ngc", "o<drill> sub"), part), ["part.ngc", "bolt.circle.ngc", "drill.ngc"]);
  assert.deepEqual(firstOf(file("O0100.nc", "M99"), file("a.nc", "M98 P100 L2\nM30")), ["a.nc", "O0100.nc"]);
  assert.deepEqual(firstOf(file("O0100.nc", "M99"), file("a.nc", "M98 P1000\nM30")), ["O0100.nc", "a.nc"], "another number");
  assert.deepEqual(firstOf(file("a.ngc", "M2"), file("b.ngc", "M2")), ["a.ngc", "b.ngc"], "nothing is called");
  assert.deepEqual(firstOf(file("a.ngc", "o<b> call"), file("b.ngc", "o<a> call")), ["a.ngc", "b.ngc"]);
});

test("times are read as clocks", () => {
  assert.equal(clock(5.19), "5.190 s");
  assert.equal(clock(105.986), "1:45.99");
  assert.equal(clock(3600 + 119.96), "1:02:00.0", "rounded before it is divided");
  assert.equal(shortTime(0.0354), "0.035");
  assert.equal(shortTime(2.534), "2.53");
  assert.equal(shortTime(123.4), "2:03");
  assert.deepEqual([59.94, 59.95, 59.999, 60, 119.4, 119.99, 3599.6].map(shortTime), ["59.9", "1:00", "1:00", "1:00", "1:59", "2:00", "1:00:00"]);
});

test("figures have the digits that can be read, and a minus sign", () => {
  assert.equal(plain(1234.5678), "1235");
  assert.equal(plain(-0.0123456), "\u22120.01235");
  assert.equal(plain(0), "0");
  assert.equal(plain(-1e-9), "0");
  assert.equal(plain(NaN), "\u2013");
  assert.equal(percent(1), "100\u00a0%");
  assert.equal(percent(0.0314), "3.1\u00a0%");
});

test("units are those that are asked for", () => {
  const inch = { length: "inch", time: "min" } as const;
  // 254 mm/s are 10 in/s, 600 in/min.
  assert.equal(254 * unitOf("v", "mm", inch).factor, 600);
  assert.equal(unitOf("v", "mm", inch).unit, "in/min");
  assert.equal(unitOf("a", "mm", { length: "mm", time: "min" }).factor, 1, "only feeds are told per minute");
  assert.deepEqual(unitOf("v", "deg", { length: "inch", time: "s" }), { factor: 1, unit: "\u00b0/s" });
  assert.equal(lengthText(25.4, inch), "1.0000");
});

test("the fragment brings back what it was made from, and what is wrong in it is left out", () => {
  const state = { ...initialState(), plan: 1, tick: 77, colourBy: "limit", shown: [3, 12], speed: 0.25, track: "y", span: [10, 900.25], tab: "answer", theme: "dark", camera: "1,2,3,0,0,0,9.5" } as const;
  const back = { ...initialState(), ...fromFragment(`#${toFragment(state)}`) };
  assert.deepEqual(back, state);
  assert.equal(toFragment(initialState()), "");
  const wrong = fromFragment("#tick=-4&span=9,3&tab=<b>&colour=<b>&theme=pink&view=alert(1)&plan=x&shown=1,b&speed=3");
  assert.deepEqual(wrong, { units: { length: "mm", time: "min" } });
});

test("the scale gets lighter evenly on both grounds", () => {
  for (const dark of [false, true]) {
    let last = -1;
    for (let i = 0; i <= 20; ++i) {
      const light = luminance(scaleColour(i / 20, dark));
      assert.ok(light > last, `${i} of 20`);
      last = light;
    }
  }
});

test("what stands out from its ground stays lighter or darker than the others", () => {
  // A rest, the programmed feedrate and the path's acceleration: on white ground all are too light as they are.
  const [rest, feed, acceleration] = ["#e3e6ea", "#9aa3ad", "#a878cc"].map(rgbOf) as [Rgb, Rgb, Rgb];
  for (const ground of ["#ffffff", "#171c24"].map(rgbOf)) {
    const [a, b, c] = [rest, feed, acceleration].map((colour) => luminance(visibleOn(colour, ground))) as [number, number, number];
    assert.ok((a + 0.05) / (b + 0.05) > 1.5 && b > c, `${a}, ${b}, ${c}`);
  }
});

test("colours of parts stand out from their ground by 3 to 1", () => {
  for (const ground of ["#ffffff", "#171c24"].map(rgbOf)) {
    for (const colour of ["#e3e6ea", "#333333", "#1b5aa8", "#9aa3ad", "#ffffff", "#000000"].map(rgbOf)) {
      const shown = visibleOn(colour, ground);
      const [a, b] = [luminance(shown), luminance(ground)].sort((x, y) => y - x);
      assert.ok((a! + 0.05) / (b! + 0.05) >= 3);
    }
  }
  assert.deepEqual(mixed([0, 0, 0], [1, 1, 1], 0.5), [0.5, 0.5, 0.5]);
});

test("another program in place of the one that is shown is seen from its own begin, the same one as it was", () => {
  const seen = { tick: 77, shown: [3], span: [10, 90] as const, camera: "1,2,3,0,0,0,9.5" };
  const after = (isSameProgram: boolean): unknown => {
    const store = new Store({ ...initialState(), ...seen, hover: 5, playing: true });
    store.replacePlans(isSameProgram, "page");
    const { tick, shown, camera, hover, span, playing } = store.state;
    assert.deepEqual({ hover, playing }, { hover: null, playing: false });
    return { tick, shown, span, camera };
  };
  assert.deepEqual(after(true), seen);
  assert.deepEqual(after(false), { tick: 0, shown: null, span: null, camera: "" });
});
