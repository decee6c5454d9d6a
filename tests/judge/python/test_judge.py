"""Tests fixproof.judge and check with the standard library alone."""
import os
import signal
import subprocess
import sys
import textwrap
import time
import unittest
from pathlib import Path
from unittest import mock

import fixproof
import page
import subjects

FEW = 20_000


class Verdicts(unittest.TestCase):
    def test_right_results_and_the_rounding_that_was_asked(self):
        verdict = fixproof.judge(subjects.half_up, "mul", rounding="half-up", cases=FEW)
        self.assertTrue(verdict)
        self.assertEqual((verdict.cases, verdict.wrong, verdict.examples), (FEW, 0, ()))
        self.assertEqual(verdict.rounding, "half-up")
        self.assertIn("half-up on all 12,347 cases in range", str(verdict))

    def test_the_rounding_that_fits_best_is_found(self):
        verdict = fixproof.judge(subjects.floor, "mul", cases=FEW)
        self.assertTrue(verdict.right)
        self.assertEqual((verdict.rounding, verdict.exceptions), ("floor", 0))
        self.assertIn("doom", verdict.follows)
        self.assertTrue(verdict.text.startswith("mul: floor, overflow wrap; "), verdict.text)

    def test_a_lost_carry_is_named(self):
        verdict = fixproof.judge(subjects.lost_carry, "mul", rounding="half-up", cases=FEW)
        self.assertFalse(verdict)
        self.assertIn("1.0 too low, as if a carry from the fraction were lost: all ", verdict.text)

    def test_ties_that_are_wrong_below_zero_are_named(self):
        verdict = fixproof.judge(subjects.ties_wrong_below_zero, "mul", rounding="half-up",
                                 overflow="any", cases=FEW)
        self.assertFalse(verdict)
        self.assertIn("rounding         half-away on all ", verdict.text)
        self.assertTrue(all(one.kind == "tie" for one in verdict.examples), verdict.examples)

    def test_floor_for_half_up_is_named(self):
        verdict = fixproof.judge(subjects.floor, "mul", rounding="half-up", cases=FEW)
        self.assertFalse(verdict)
        self.assertIn("every wrong result is 1 ulp too low: all ", verdict.text)
        self.assertIn("rounding         floor on all ", verdict.text)
        self.assertEqual(verdict.rounding, "floor")

    def test_an_example_has_the_operands_as_the_function_took_them(self):
        verdict = fixproof.check("mul", [(98304, 131072), (-1, 32768)], [196608, -1],
                                 rounding="half-up")
        (one,) = verdict.examples
        self.assertEqual((one.case, one.operands, one.expected, one.said, one.kind),
                         (2, (-1, 32768), 0, -1, "tie"))
        self.assertEqual(one.stream, "yours")
        self.assertIn(one.text, verdict.text)
        self.assertEqual(str(one), one.text)

    def test_an_exception_of_division_is_a_divide_error(self):
        verdict = fixproof.judge(subjects.quotient, "div", rounding="toward-zero", cases=FEW)
        self.assertTrue(verdict, verdict.text)
        self.assertIn("says DE on all ", verdict.text)
        wrong = fixproof.judge(subjects.quotient, "div", rounding="toward-zero", no_result=0,
                               cases=FEW)
        self.assertEqual({one.said for one in wrong.examples}, {fixproof.DE})
        self.assertEqual({one.expected for one in wrong.examples}, {0})

    def test_an_overflow_error_is_a_divide_error(self):
        def checked(a, b):
            exact = (a * b) >> 16
            if not -(1 << 31) <= exact < 1 << 31:
                raise OverflowError
            return exact
        verdict = fixproof.judge(checked, "mul", overflow="de", rounding="floor", cases=FEW)
        self.assertTrue(verdict, verdict.text)
        self.assertIn("overflow         says DE on all ", verdict.text)

    def test_exact_results_have_no_rounding(self):
        verdict = fixproof.judge(lambda a, b: subjects.wrap(a + b), "add", cases=FEW)
        self.assertTrue(verdict)
        self.assertIsNone(verdict.rounding)

    def test_other_formats(self):
        def product(a, b):
            return min((a * b + 0x80) >> 8, 0xFFFF)
        self.assertTrue(fixproof.judge(product, "mul", format="u8_8", overflow="saturate",
                                       rounding="half-up", cases=FEW))

        def dot(*words):
            exact = sum(a * b for a, b in zip(words[:2], words[2:])) >> 15
            return max(-32768, min(exact, 32767))
        self.assertTrue(fixproof.judge(dot, "dot", terms=2, format="q1_15", rounding="floor",
                                       overflow="saturate", cases=FEW))
        # 18 bits in 32.
        self.assertTrue(fixproof.judge(lambda a, b: a * b, "mul", format="q2_16", to="q4_32",
                                       cases=FEW))

    def test_conversions_take_floats_and_text(self):
        verdict = fixproof.judge(lambda x: repr(x / 65536), "to_decimal", cases=1000)
        self.assertTrue(verdict, verdict.text)
        taken = []

        def note(x):
            taken.append(x)
            return 0
        fixproof.judge(note, "from_binary64", cases=100, overflow="any")
        self.assertEqual({type(x) for x in taken}, {float})
        fixproof.judge(note, "from_decimal", cases=100, overflow="any")
        self.assertEqual({type(x) for x in taken}, {float, str})

    def test_a_promised_error(self):
        verdict = fixproof.judge(subjects.floor, "mul", within="0.5", cases=FEW)
        self.assertFalse(verdict)
        self.assertTrue(fixproof.judge(subjects.floor, "mul", within=1, overflow="any",
                                       cases=FEW))

    def test_the_rule_of_a_program(self):
        verdict = fixproof.judge(subjects.floor, "mul", rule="doom", cases=FEW)
        self.assertTrue(verdict)
        self.assertIn("the rule doom", verdict.text)

    def test_assert_right_shows_the_verdict(self):
        fixproof.assert_right(subjects.half_up, "mul", rounding="half-up", cases=FEW)
        with self.assertRaises(AssertionError) as caught:
            fixproof.assert_right(subjects.lost_carry, "mul", rounding="half-up", cases=FEW)
        self.assertTrue(str(caught.exception).startswith("lost_carry is not right\nmul: half-up, "))
        self.assertIn("carry", str(caught.exception))


class Cases(unittest.TestCase):
    def test_are_those_of_gen(self):
        lines = subprocess.run([fixproof.command(), "gen", "div", "--cases", "500", "--seed", "3"],
                               capture_output=True, check=True, text=True).stdout.splitlines()
        cases = list(fixproof.cases("div", cases=500, seed=3))
        self.assertEqual(["{:08x} {:08x}".format(*(word & subjects.MASK for word in case))
                          for case in cases], lines)
        self.assertTrue(any(word < 0 for case in cases for word in case))

    def test_can_be_left_early(self):
        for case in fixproof.cases("mul"):
            self.assertEqual(case, (0, 0))
            break


class Formats(unittest.TestCase):
    def test_ranges(self):
        for name, low, high, one, dtype in [
                ("q16_16", -2**31, 2**31 - 1, 65536, "int32"), ("u8_8", 0, 65535, 256, "uint16"),
                ("q2_16", -2**17, 2**17 - 1, 65536, "int32"),
                ("q-4_20", -32768, 32767, 2**20, "int16"),
                ("ud32_2", 0, 2**32 - 1, 100, "uint32"),
                ("q20_-2", -2**17, 2**17 - 1, 0.25, "int32")]:
            format = fixproof.Format(name)
            self.assertEqual((format.lowest, format.highest, format.one, format.dtype),
                             (low, high, one, dtype), name)
            self.assertEqual(format.wrap(high + 1), low)
            self.assertEqual(format.wrap(low - 1), high)

    def test_other_names_are_refused(self):
        for name in ("q16", "q60_16", "q0_1", "f32", "", None, 3, "q16_16\n"):
            with self.assertRaisesRegex(fixproof.Error, "write qW_F or uW_F"):
                fixproof.Format(name)


class Refusals(unittest.TestCase):
    def refuses(self, message, function=subjects.half_up, operation="mul", **options):
        with self.assertRaises(fixproof.Error) as caught:
            fixproof.judge(function, operation, **options)
        self.assertIn(message, str(caught.exception))
        self.assertNotIn("\n", str(caught.exception))
        return caught.exception

    def test_results_that_are_no_words(self):
        for said, message in [
                (1.5, "which is of type float; return the integer in units of q16_16"),
                (None, "which is no result; return an int"),
                ("1", "which is of type str; return an int"),
                (1 << 40, "is no word of q16_16 (-2147483648 to 2147483647); wrap or saturate it"),
                (-1 - (1 << 31), "wrap or saturate it"),
                (0xFFFFFFFF, "return the two's complement value, -1")]:
            self.refuses(message, lambda a, b: said)
        self.refuses("case 1: <lambda>(0, 0) returned ", lambda a, b: 1.5)
        self.refuses("is no decimal number", lambda x: "1\n2", "to_decimal")

    def test_the_case_of_an_exception_is_named_and_the_exception_chained(self):
        def fails(a, b):
            if a == 1:
                raise KeyError("planted")
            return 0
        number = 1 + next(n for n, case in enumerate(fixproof.cases("mul")) if case[0] == 1)
        error = self.refuses(f"case {number:,}: fails(1, 0) raised KeyError: 'planted'", fails)
        self.assertIsInstance(error.__cause__, KeyError)

    def test_options_of_the_command(self):
        self.refuses("--rounding 'up': choose one of half-up", rounding="up")
        self.refuses("unknown operation 'mull' (did you mean mul?)", operation="mull")
        self.refuses("--overflow 'never': choose one of", overflow="never")
        self.refuses("--outside-domain applies only to functions", no_result="de")
        self.refuses("--cases", cases=0)
        self.refuses("choose mul, div", operation="--help")
        self.refuses("write qW_F or uW_F", format="q16")

    def test_a_wrong_option_ends_before_the_function_has_taken_all_cases(self):
        calls = []

        def counts(a, b):
            calls.append(a)
            return 0
        self.refuses("--rounding 'up'", counts, rounding="up")
        self.assertLess(len(calls), 500_000)

    def test_operands_and_results_of_other_numbers(self):
        for operands, results, message in [
                ([(1, 2), (3, 4)], [1], "2 cases, but 1 results"), ([], [], "there are no cases"),
                ([(1, 2, 3)], [1], "mul takes 2 words"), ([(1, 1 << 31)], [1], "no word of q16_16"),
                ([(1, 2)], [2.0], "case 1 (1, 2): the result is 2.0, which is of type float")]:
            with self.assertRaises(fixproof.Error) as caught:
                fixproof.check("mul", operands, results)
            self.assertIn(message, str(caught.exception))

    def test_the_command_is_missing(self):
        with mock.patch.dict(os.environ, FIXPROOF="/nowhere/fixproof"):
            self.refuses("FIXPROOF=/nowhere/fixproof: no such program; set FIXPROOF to")
        with mock.patch.dict(os.environ, PATH="/nowhere"):
            del os.environ["FIXPROOF"]
            self.refuses("the command fixproof is not on the PATH; set FIXPROOF to it")

    def test_the_command_is_another_program(self):
        for program in ("/bin/true", "/bin/false", "/bin/cat", "/bin/echo"):
            with mock.patch.dict(os.environ, FIXPROOF=program):
                self.refuses("")

    def test_a_module_that_is_not_installed(self):
        for module, name in (("numpy", "_arrays"), ("hypothesis", "strategies")):
            with mock.patch.dict(sys.modules, {module: None, f"fixproof.{name}": None}):
                del sys.modules[f"fixproof.{name}"]
                message = f"install it .Debian: python3-{module}"
                with self.assertRaisesRegex(fixproof.Error, message):
                    __import__(f"fixproof.{name}")


class Interrupts(unittest.TestCase):
    def test_ctrl_c_in_the_function_stops_and_leaves_no_process(self):
        script = textwrap.dedent("""
            import sys, time
            import fixproof
            def slow(a, b):
                print("called", flush=True)
                time.sleep(60)
            try:
                fixproof.judge(slow, "mul")
            except KeyboardInterrupt:
                print("interrupted", flush=True)
            """)
        # In a group of its own, as a terminal has it: Ctrl-C goes to every process of the group.
        with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True,
                              stderr=subprocess.PIPE, start_new_session=True) as process:
            try:
                self.assertEqual(process.stdout.readline(), "called\n")
                os.killpg(process.pid, signal.SIGINT)
                out, err = process.communicate(timeout=30)
            finally:
                process.kill()
        self.assertEqual((out, err, process.returncode), ("interrupted\n", "", 0))
        with self.assertRaises(ProcessLookupError):  # the group is empty
            os.killpg(process.pid, 0)

    def test_no_process_is_left_after_an_error(self):
        with self.assertRaises(fixproof.Error):
            fixproof.judge(lambda a, b: None, "mul")
        for _ in range(100):
            children = Path(f"/proc/self/task/{os.getpid()}/children").read_text()
            if not children:
                break
            time.sleep(0.01)
        self.assertEqual(children, "")


class Page(unittest.TestCase):
    def test_the_examples_say_what_they_show(self):
        tries, failures = page.failures(more=False)
        self.assertGreaterEqual(tries, 14)
        self.assertFalse(failures, failures)


if __name__ == "__main__":
    unittest.main()
