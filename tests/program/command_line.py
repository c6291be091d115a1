"""The executable `kerf` as its users meet it, for the tests beside this file: TEST.py KERF SOURCE_DIR [NAME...]

Exit statuses, streams, signals and files; the figures themselves are other tests' business.
"""
import concurrent.futures
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

KERF, SOURCE = sys.argv[1:3]

SQUARE = "G21 G90 G17 G61\nF3000\nG1 X20\nG1 Y20\nG1 X0\nG1 Y0\nM30\n"
LONG = "G21 G90\nF600\n" + "G1 X200\nG1 X0\n" * 50 + "M30\n"  # 2000 s
WRONG = "G21 G90\nG1 X1 F100\nG1 Xq\nG1 X3\nG77\n"
TOO_FAR = "G21 G90\nG1 X10 F1000\nG1 X1000\n"


class Case(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="kerf-test-"))
        self.addCleanup(shutil.rmtree, self.folder)

    def path(self, name, text=None):
        path = self.folder / name
        if text is not None:
            path.write_text(text)
        return str(path)

    def kerf(self, *words, status=0, stdin=None, env=None, text=True):
        done = in_time(lambda: subprocess.run([KERF, *words], input=stdin, capture_output=True, text=text, env=env, timeout=120), status)
        self.assertEqual(done.returncode, status, f"{words}\n{done.stdout}\n{done.stderr}")
        return done


def in_time(run, status=0):
    """What it gives; again where the computer was busy elsewhere: no tick for 0.25 s is a fault of the machine (4)."""
    for _ in range(10):
        done = run()
        if done.returncode == status or done.returncode != 4 or "no tick for" not in str(done.stderr):
            break
    return done


class AtOnce(unittest.TestSuite):
    def __init__(self, suite, count):
        super().__init__(suite)
        self.count = count

    def cases(self, suite):
        for test in suite:
            yield from self.cases(test) if isinstance(test, unittest.TestSuite) else [test]

    def run(self, result, debug=False):
        with concurrent.futures.ThreadPoolExecutor(self.count) as pool:
            list(pool.map(lambda case: case.run(result), self.cases(self)))
        return result


def main(at_once=1):
    """at_once: of cases that mostly wait for a run's own time, how many run beside each other."""
    class Runner(unittest.TextTestRunner):
        def run(self, test):
            return super().run(AtOnce(test, at_once))

    unittest.main(argv=sys.argv[:1] + sys.argv[3:], testRunner=Runner)
