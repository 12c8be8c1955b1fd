#!/usr/bin/python3
"""Checks wrong decks: `ashlar check` must exit with 2 and say exactly what NN_name.txt holds.

run_wrong.py ASHLAR [--write]     with --write the texts are written instead, to be read by a person
A first line `-- ashlar check --set name=value` in a deck gives arguments.
"""
import pathlib
import subprocess
import sys


def check(program, deck):
    first = deck.read_text(encoding="utf-8", errors="replace").split("\n", 1)[0]
    arguments = first.removeprefix("-- ashlar check").split() if first.startswith("-- ashlar check") else []
    return subprocess.run([program, "check", deck.name, *arguments], cwd=deck.parent, capture_output=True, text=True,
                          timeout=120, check=False)


def main(program, write=False):
    program = str(pathlib.Path(program).resolve())
    decks = sorted((pathlib.Path(__file__).parent / "wrong").glob("*.lua"))
    failed = 0
    for deck in decks:
        run = check(program, deck)
        golden = deck.with_suffix(".txt")
        if write:
            golden.write_text(run.stderr, encoding="utf-8")
        wanted = golden.read_text(encoding="utf-8") if golden.exists() else "(no golden text)\n"
        if run.returncode == 2 and run.stderr == wanted and run.stdout == "":
            continue
        failed += 1
        print(f"{deck.name}: exit code {run.returncode}, wanted 2\n--- wanted\n{wanted}--- found\n{run.stdout}{run.stderr}")
    print(f"{len(decks) - failed} of {len(decks)} wrong decks refused as they should be")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], "--write" in sys.argv[2:]))
