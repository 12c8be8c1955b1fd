#!/usr/bin/python3
"""Runs verification decks with every set of arguments that their heads name; every expect must hold.

run_verify.py ASHLAR DECK ...    decks by name, such as d0_elastic
"""
import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent.parent / "tools"))
from verification_table import runs, solve  # noqa: E402


def main(program, names):
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        for number, run in enumerate(runs(names)):
            outcome = solve(program, run, pathlib.Path(folder) / str(number))
            held = sum(expect["passed"] for expect in outcome.expects)
            print(f"{run.deck.stem} {' '.join(run.arguments)}: {held} of {len(outcome.expects)} expects hold, "
                  f"exit code {outcome.code}, {outcome.seconds:.1f} s", flush=True)
            if not outcome.passed:
                failed += 1
                print(outcome.output)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
