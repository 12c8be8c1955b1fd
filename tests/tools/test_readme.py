#!/usr/bin/python3
"""The README's first deck prints what the README says it prints, times and memory apart.

Called by CTest with the path of the program as the only argument.
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = pathlib.Path(sys.argv.pop() if len(sys.argv) > 1 else ROOT / "build" / "ashlar").resolve()


def steady(words):
    """The lines that do not depend on the machine, without their times."""
    lines = [line for line in words.strip().splitlines() if not re.search(r"\d %\)$|^memory|threads?$", line)]
    return [re.sub(r"[\d.]+ (ms|s)\b", "TIME", line) for line in lines]


class Readme(unittest.TestCase):
    def test_the_first_deck_prints_what_is_shown(self):
        blocks = re.findall(r"```(\w*)\n(.*?)```", (ROOT / "README.md").read_text(encoding="utf-8"), re.DOTALL)
        deck = next(text for kind, text in blocks if kind == "lua")
        shown = next(text for kind, text in blocks if kind == "" and text.startswith("stage"))
        self.assertEqual(len(deck.splitlines()), 10)
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "wall.lua").write_text(deck, encoding="utf-8")
            answer = subprocess.run([PROGRAM, "run", "wall.lua"], cwd=folder, capture_output=True, text=True)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertEqual(steady(answer.stdout), steady(shown))


if __name__ == "__main__":
    unittest.main()
