#!/usr/bin/env python3
"""The trace: which ticks have a row, and the same rows as an array of NumPy."""
import ast
import csv
import math
import pathlib
import struct

from command_line import Case, SQUARE, main

CURVE = "G0 X0 Y0\nG6.2 P3 K0 X0 Y0 F1000\nX10 Y10 K0\nX20 Y0 K0\nX30 Y5 K1\nK2\nK2\nK2\nM2\n"


def read_npy(path):
    """The records as dicts, by the description of the format (NPY 1.0) alone."""
    data = pathlib.Path(path).read_bytes()
    assert data[:8] == b"\x93NUMPY\x01\x00", data[:8]
    (length,) = struct.unpack("<H", data[8:10])
    assert (10 + length) % 64 == 0 and data[9 + length:10 + length] == b"\n"
    head = ast.literal_eval(data[10:10 + length].decode("ascii"))
    assert head["fortran_order"] is False
    layout = struct.Struct("<" + "".join({"<f8": "d", "<u4": "I"}.get(kind) or kind[1:] + "s" for _, kind in head["descr"]))
    body = data[10 + length:]
    assert len(body) == layout.size * head["shape"][0], (len(body), head["shape"])
    return [dict(zip((name for name, _ in head["descr"]), row)) for row in layout.iter_unpack(body)]


class Trace(Case):
    def rows(self, program, *options, name="trace.csv"):
        trace = self.path(name)
        self.kerf("dry-run", "-q", program, "--trace", trace, *options)
        if name.lower().endswith(".npy"):
            return read_npy(trace)
        with open(trace) as file:
            return list(csv.DictReader(file))

    def test_is_the_same_as_an_array_of_numpy(self):
        for text, options in ((SQUARE, ()), (CURVE, ("--explain-speed",)), (SQUARE, ("--trace-every", "7"))):
            program = self.path("a.ngc", text)
            rows = self.rows(program, *options)
            records = self.rows(program, *options, name="trace.npy")
            self.assertEqual(len(records), len(rows))
            self.assertEqual(list(records[0]), list(rows[0]))
            for row, record in zip(rows, records):
                for name, written in row.items():
                    value = record[name]
                    if name == "limit":
                        self.assertEqual(value.rstrip(b"\0").decode(), written)
                    elif written == "":
                        self.assertTrue(math.isnan(value), name)
                    else:
                        self.assertAlmostEqual(value, float(written), delta=0.6 * 10 ** -len(written.partition(".")[2]) * bool("." in written), msg=name)

    def test_has_every_nth_tick_of_a_time(self):
        program = self.path("a.ngc", SQUARE)
        whole = self.rows(program)
        self.assertEqual(self.rows(program, "--trace-every", "10"), whole[::10])
        self.assertEqual(self.rows(program, "--trace-from", "0.25", "--trace-to", "0.3s"), whole[250:301])
        self.assertEqual(self.rows(program, "--trace-from", "0.0104", "--trace-to", "0.0126"), whole[11:13])
        self.assertEqual(self.rows(program, "--trace-every", "100", "--trace-from", "0.25"), whole[300::100])
        self.assertEqual(self.rows(program, "--trace-from", "1h"), [])
        self.assertEqual(self.rows(program, "--trace-from", "1h", name="none.NPY"), [])

    def test_tells_how_many_rows_there_are_where_it_ends_early(self):
        trace = self.path("cut.npy")
        done = self.kerf("dry-run", "-q", self.path("a.ngc", SQUARE), "--trace", trace, "--max-trace", "20kB", status=5)
        records = read_npy(str(trace) + ".incomplete")
        self.assertGreater(len(records), 100)
        self.assertAlmostEqual(records[-1]["t_s"], 0.001 * (len(records) - 1))

    def test_refuses_what_means_nothing(self):
        program = self.path("a.ngc", SQUARE)
        for options in (("--trace-every", "0", "--trace", "a.csv"), ("--trace-every", "10"), ("--trace-from", "2"), ("--max-trace", "1MB"),
                        ("--trace-from", "2", "--trace-to", "1", "--trace", "a.csv"), ("--trace-to", "soon", "--trace", "a.csv")):
            done = self.kerf("dry-run", program, *options, status=2)
            self.assertRegex(done.stderr, "--(max-)?trace")


if __name__ == "__main__":
    main()
