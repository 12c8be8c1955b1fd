#!/usr/bin/python3
"""Runs decks that must come out right: exit code 0, so every stage converges and every expect holds.

run_right.py ASHLAR DECK.lua|FOLDER ...
"""
import pathlib
import subprocess
import sys
import tempfile


def main(program, *places):
    decks = [deck for place in map(pathlib.Path, places) for deck in (sorted(place.glob("*.lua")) if place.is_dir() else [place])]
    failed = 0
    for deck in decks:
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run([program, "run", str(deck), "--out", folder + "/run"], capture_output=True, text=True,
                                 timeout=600, check=False)
        holds = sum(" ok " in line for line in run.stdout.splitlines())
        print(f"{deck}: exit code {run.returncode}, {holds} expects hold")
        if run.returncode:
            failed += 1
            print(run.stdout + run.stderr)
    print(f"{len(decks) - failed} of {len(decks)} decks come out right")
    return 1 if failed or not decks else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
