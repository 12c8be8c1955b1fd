#!/usr/bin/python3
"""tools/check_flags.py passes a build that compiles with the flags of equal bits and finds each of them missing.

Called by CTest with the build's folder as the only argument.
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
CHECK = ROOT / "tools" / "check_flags.py"
BUILD = sys.argv.pop() if len(sys.argv) > 1 else ROOT / "build"

GOOD = "c++ -O3 -march=x86-64-v3 -ffp-contract=off -fno-math-errno"


def check_commands(*commands):
    """Runs the check on a build that compiles one source file per command."""
    with tempfile.TemporaryDirectory() as folder:
        rules = []
        for number, command in enumerate(commands):
            source = f"source_{number}.cpp"
            rules.append(f"rule compile_{number}\n  command = {command} -o $out -c $in\n"
                         f"build {source}.o: compile_{number} {source}\n")
        (pathlib.Path(folder) / "build.ninja").write_text("\n".join(rules), encoding="utf-8")
        return subprocess.run([CHECK, folder], capture_output=True, text=True)


class CheckFlags(unittest.TestCase):
    def test_this_build_has_the_flags(self):
        answer = subprocess.run([CHECK, BUILD], capture_output=True, text=True)
        self.assertEqual(answer.returncode, 0, answer.stdout + answer.stderr)

    def test_the_flags_suffice(self):
        self.assertEqual(check_commands(GOOD, GOOD).returncode, 0)

    def test_each_missing_flag_is_named(self):
        for flag in ("-ffp-contract=off", "-fno-math-errno", "-march"):
            with self.subTest(flag):
                answer = check_commands(GOOD, " ".join(w for w in GOOD.split() if not w.startswith(flag)))
                self.assertEqual(answer.returncode, 1)
                self.assertIn(f"source_1.cpp: compiled without {flag}", answer.stdout)

    def test_flags_that_change_bits_or_drop_assertions_are_named(self):
        for flag in ("-ffast-math", "-Ofast", "-DNDEBUG"):
            with self.subTest(flag):
                answer = check_commands(f"{GOOD} {flag}")
                self.assertEqual(answer.returncode, 1)
                self.assertIn(f"source_0.cpp: compiled with {flag}", answer.stdout)

    def test_two_instruction_sets_in_one_build_are_named(self):
        answer = check_commands(GOOD, GOOD.replace("x86-64-v3", "native"))
        self.assertEqual(answer.returncode, 1)
        self.assertIn("native, x86-64-v3", answer.stdout)


if __name__ == "__main__":
    unittest.main()
