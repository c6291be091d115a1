// Which files the page takes for a machine's.
import assert from "node:assert/strict";
import { test } from "node:test";
import { isToml, names } from "../src/plan/machine_files.ts";

test("a machine file names what stands in it as a string, whatever folder it is in", () => {
  const machine = '[tools]\nfile = "tables/shop.tbl" # or "old.tbl"?\n[probe]\nheight_map = \'bed.xyz\'\n';
  assert.ok(names(machine, "shop.tbl"));
  assert.ok(names(machine, "bed.xyz"));
  for (const other of ["shop", "tables", "part.ngc", "bed", ""]) assert.ok(!names(machine, other), other);
  assert.ok(isToml({ name: "Mill.TOML" }) && !isToml({ name: "toml.ngc" }));
});
