"""Tests what needs NumPy, pytest, Hypothesis and setuptools: `./test release -L python`."""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

import fixproof
import page
import subjects

ROOT = Path(__file__).parents[3]
FEW = 20_000


class Arrays(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        import numpy
        cls.np = numpy

    def floor(self, a, b):
        self.seen = a.dtype, b.dtype
        return ((a.astype(self.np.int64) * b) >> 16).astype(self.np.int32)

    def test_agree_with_the_same_function_of_integers(self):
        whole = fixproof.judge(self.floor, "mul", rounding="half-up", cases=FEW, arrays=True)
        self.assertEqual(self.seen, (self.np.dtype("int32"),) * 2)
        single = fixproof.judge(subjects.floor, "mul", rounding="half-up", cases=FEW)
        self.assertEqual(whole, single)

    def test_scalars_of_numpy_are_results(self):
        self.assertTrue(fixproof.judge(lambda a, b: self.np.int32(subjects.floor(a, b)), "mul",
                                       rounding="floor", cases=1000))

    def test_masked_elements_are_divide_errors(self):
        def divide(a, b):
            zero = b == 0
            words = (a.astype(self.np.int64) << 16) // self.np.where(zero, 1, b)
            return self.np.ma.array(words.astype(self.np.int32), mask=zero)
        self.assertTrue(fixproof.judge(divide, "div", rounding="floor", cases=FEW, arrays=True))

    def test_formats_of_other_types(self):
        def high(a, b):
            self.seen = a.dtype
            return ((a.astype(self.np.uint32) * b) >> 8).clip(max=65535)
        self.assertTrue(fixproof.judge(high, "mul", format="u8_8", rounding="floor",
                                       overflow="saturate", cases=FEW, arrays=True))
        self.assertEqual(self.seen, self.np.dtype("uint16"))

    def test_results_that_are_no_words(self):
        np = self.np
        for function, format, message in [
                (lambda a, b: a * 0.5, "q16_16",
                 "returned an array of float64; return integers in units"),
                (lambda a, b: a[1:], "q16_16", "shape (99,) for operands of shape (100,)"),
                (lambda a, b: 3, "q16_16", "shape () for operands of shape (100,)"),
                (lambda a, b: None, "q16_16", "shape () for operands"),
                (lambda a, b: a.astype(np.int64) * b, "q16_16", "wrap or saturate it"),
                # As floats, 2**63 and 2**63 - 1 are equal.
                (lambda a, b: np.full(a.shape, 2**63, np.uint64), "q32_32",
                 "case 1: <lambda> returned 9223372036854775808 for (4, -2047), which is no word"),
                (lambda a, b: np.full(a.shape, -1, np.int64), "u0_64", "returned -1 for ("),
                (lambda a, b: 1 // 0, "q16_16",
                 "raised ZeroDivisionError for a whole array; return a mask")]:
            with self.assertRaises(fixproof.Error) as caught:
                fixproof.judge(function, "mul", format=format, cases=100, arrays=True)
            self.assertIn(message, str(caught.exception))


class Pytest(unittest.TestCase):
    def test_a_failure_shows_the_verdict_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "test_mine.py").write_text(
                "import fixproof, subjects\n"
                "def test_right():\n"
                "    fixproof.assert_right(subjects.floor, 'mul', rounding='floor',"
                " cases=2000)\n"
                "def test_wrong():\n    fixproof.assert_right(subjects.lost_carry, 'mul',"
                " rounding='half-up', cases=2000)\n")
            run = subprocess.run([sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider"],
                                 cwd=folder, capture_output=True, text=True,
                                 env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)})
        self.assertEqual(run.returncode, 1, run.stdout + run.stderr)
        self.assertIn("lost_carry is not right", run.stdout)
        self.assertIn("as if a carry from the fraction were lost", run.stdout)
        self.assertIn("1 failed, 1 passed", run.stdout)
        self.assertNotIn("_judge.py", run.stdout)


class Strategies(unittest.TestCase):
    def drawn(self, strategy, count=500):
        from hypothesis import HealthCheck, given, seed, settings
        seen = []

        @seed(1994)
        @settings(max_examples=count, database=None, deadline=None,
                  suppress_health_check=list(HealthCheck))
        @given(strategy)
        def take(one):
            seen.append(one)
        take()
        return seen

    def test_words_are_of_the_format_and_at_its_ends(self):
        from fixproof import strategies
        for name in ("q16_16", "u8_8", "q2_16", "q20_-2", "d64_8", "q0_2"):
            format = fixproof.Format(name)
            seen = self.drawn(strategies.words(name))
            self.assertTrue(all(word in format for word in seen), name)
            self.assertTrue({format.lowest, format.highest} <= set(seen), name)

    def test_operands_of_a_product_have_ties_neighbours_and_wraps(self):
        from fixproof import strategies
        seen = self.drawn(strategies.operands("mul"))
        products = [a * b for a, b in seen]
        fractions = {product & 0xFFFF for product in products}
        self.assertTrue({0x7FFF, 0x8000, 0x8001} <= fractions)
        bounds = [abs(abs(product) - (1 << 47)) < 1 << 17 for product in products]
        self.assertTrue(any(bounds))

    def test_operands_find_the_planted_defects(self):
        from hypothesis import given, settings
        from fixproof import strategies
        for wrong in (subjects.lost_carry, subjects.ties_wrong_below_zero, subjects.floor):
            @settings(database=None, deadline=None, derandomize=True)
            @given(strategies.operands("mul"))
            def agrees(pair):
                self.assertEqual(wrong(*pair), subjects.half_up(*pair))
            with self.assertRaises(AssertionError, msg=wrong.__name__):
                agrees()

    def test_operands_of_other_operations(self):
        from fixproof import strategies
        self.assertTrue(all(len(one) == 1 for one in self.drawn(strategies.operands("sqrt"), 50)))
        self.assertTrue(all(isinstance(one[0], float)
                            for one in self.drawn(strategies.operands("from_binary64"), 50)))
        with self.assertRaisesRegex(fixproof.Error, "unknown operation 'mull'"):
            strategies.operands("mull")


class Page(unittest.TestCase):
    def test_all_examples_say_what_they_show(self):
        tries, failures = page.failures(more=True)
        self.assertGreaterEqual(tries, 21)
        self.assertFalse(failures, failures)


class Wheel(unittest.TestCase):
    def test_is_built_offline_and_imports(self):
        parts = re.findall(r"^#define FIXED_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)",
                           (ROOT / "fixed/version.hpp").read_text(), re.M)
        name = f"fixproof-{'.'.join(parts)}-py3-none-any.whl"
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(ROOT / "judge/python", Path(folder, "source"),
                            ignore=shutil.ignore_patterns("build", "*.egg-info", "__pycache__"))
            run = subprocess.run([sys.executable, "-m", "pip", "wheel", "--no-build-isolation",
                                  "--no-deps", "--no-index", "-w", folder,
                                  str(Path(folder, "source"))],
                                 capture_output=True, text=True)
            self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
            wheel = Path(folder, name)
            files = set(zipfile.ZipFile(wheel).namelist())
            package = ROOT / "judge/python/fixproof"
            sources = {f"fixproof/{file.name}" for file in package.iterdir() if file.is_file()}
            self.assertEqual({file for file in files if ".dist-info/" not in file}, sources)
            said = subprocess.run(
                [sys.executable, "-c", "import fixproof, sys; print(fixproof.__file__, fixproof."
                 "__version__, next(fixproof.cases('mul')), 'numpy' in sys.modules)"], cwd=folder,
                env={**os.environ, "PYTHONPATH": str(wheel)}, capture_output=True, text=True)
            self.assertEqual(said.stdout.split(" ", 1)[1:], [f"{'.'.join(parts)} (0, 0) False\n"],
                             said.stderr)
            self.assertIn(name, said.stdout)


if __name__ == "__main__":
    unittest.main()
