#!/usr/bin/python3
"""Runs the verification decks and prints a Markdown table: reference, ours, difference, tolerance, time.

verification_table.py ASHLAR [DECK ...]    decks by name, such as d0_elastic; all of decks/verify unless given
  --all    a row for every expect instead of the worst of each run
Exit code 1 if an expect fails or a run does not end well.

The head of each deck says what this program reads, a line each, wrapped with deeper indentation:
  -- Case NAME: what it is        -- Source: of the reference       -- Accept: tolerance
  -- Runs: arguments | arguments | ...
"""
import argparse
import dataclasses
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

DECKS = pathlib.Path(__file__).resolve().parent.parent / "decks" / "verify"
UNITS = {"displacement": "m", "stress": "Pa", "temperature": "degC", "reaction": "N", "load": "N", "load_moment": "N m"}


@dataclasses.dataclass
class Run:
    deck: pathlib.Path
    case: str
    source: str
    arguments: list


@dataclasses.dataclass
class Outcome:
    run: Run
    code: int
    seconds: float
    expects: list  # as in manifest.json
    output: str

    @property
    def passed(self):
        return self.code == 0 and bool(self.expects)


def head(deck):
    """Entries of the comment at the head of a deck: {"Case": ..., "Source": ..., ...}."""
    entries, last = {}, None
    for line in deck.read_text(encoding="utf-8").splitlines():
        if not line.startswith("--"):
            break
        start = re.match(r"-- (Source|Accept|Runs): ?(.*)|-- Cases? ([^:]*): (.*)", line)
        if start and start[3]:
            entries["Case"], last = start[3], None
        elif start:
            last = start[1]
            entries[last] = start[2]
        elif last and line.startswith("--   "):
            entries[last] += " " + line[2:].strip()
        else:
            last = None
    return entries


def runs(names=()):
    """Every run of the decks, in the order of the decks' names. Files without `Runs` are parts of decks."""
    found = []
    for deck in sorted(DECKS.glob("*.lua")):
        entries = head(deck)
        if "Runs" not in entries or (names and deck.stem not in names):
            continue
        source = re.split(r"[,;:]|\. |\.$", entries["Source"])[0]
        found += [Run(deck, entries["Case"], source, text.split()) for text in entries["Runs"].split("|")]
    missing = set(names) - {run.deck.stem for run in found}
    if missing:
        sys.exit("no verification deck is called " + ", ".join(sorted(missing)))
    return found


def solve(program, run, folder, threads=None, precision=None):
    """Runs a deck into `folder`, which must not exist."""
    command = [program, "run", str(run.deck), "--out", str(folder)]
    for argument in run.arguments:
        command += ["--set", argument]
    if threads:
        command += ["--threads", str(threads)]
    if precision:
        command += ["--precision", precision]
    # Threads that spin while they wait slow each other where there are more of them than cores.
    done = subprocess.run(command, capture_output=True, text=True, check=False,
                          env={**os.environ, "OMP_WAIT_POLICY": "passive"})
    manifest = pathlib.Path(folder) / "manifest.json"
    data = json.loads(manifest.read_text(encoding="utf-8")) if manifest.exists() else {}
    seconds = sum(stage["wall_seconds"] for stage in data.get("stages", []))
    return Outcome(run, done.returncode, seconds, data.get("expects", []), done.stdout + done.stderr)


def share_of_tolerance(expect):
    low, high = expect["between"]
    if "found" not in expect:
        return float("inf")
    off, width = abs(expect["found"] - (low + high) / 2), (high - low) / 2
    return off / width if width > 0 else (0.0 if off == 0 else float("inf"))


def unit_of(expect):
    field = re.search(r"\b(" + "|".join(sorted(UNITS, key=len, reverse=True)) + r")(\.\w+)?\b[^;]* is ", expect["message"])
    return " " + UNITS[field[1]] if field else ""


def rows(outcome, every):
    """Lists of the table's columns."""
    name = f"{outcome.run.case} `{' '.join([outcome.run.deck.stem, *outcome.run.arguments])}`"
    source, seconds = outcome.run.source, f"{outcome.seconds:.2f}"
    measured = [e for e in outcome.expects if "between" in e]
    shown = measured if every else sorted(measured, key=share_of_tolerance)[-1:]
    table = []
    for expect in shown:
        low, high = expect["between"]
        reference, found, unit = (low + high) / 2, expect.get("found", float("nan")), unit_of(expect)
        quantity = expect["name"] + (f" (worst of {len(measured)})" if len(shown) < len(measured) else "")
        table.append([name, quantity, f"{reference:.7g}{unit}", source, f"{found:.7g}", f"{found - reference:.1e}",
                      f"{(high - low) / 2:.1e}", seconds, "ok" if expect["passed"] else "**FAILED**"])
    for expect in outcome.expects:
        if "between" not in expect:
            table.append([name, expect["name"], "", source, expect["message"], "", "", seconds,
                          "ok" if expect["passed"] else "**FAILED**"])
    if not outcome.expects or outcome.code not in (0, 4):
        last = outcome.output.strip().splitlines()[-1:] or ["no output"]
        table.append([name, f"exit code {outcome.code}", "", source, last[0], "", "", seconds, "**FAILED**"])
    return table


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("decks", nargs="*")
    parser.add_argument("--all", action="store_true")
    options = parser.parse_intermixed_args()
    print("| case and run | quantity | reference | source | ours | difference | tolerance | seconds | |")
    print("|---|---|---|---|---|---|---|---|---|")
    passed = True
    with tempfile.TemporaryDirectory() as folder:
        for number, run in enumerate(runs(options.decks)):
            outcome = solve(options.program, run, pathlib.Path(folder) / str(number))
            passed = passed and outcome.passed
            for row in rows(outcome, options.all):
                print("| " + " | ".join(row) + " |", flush=True)
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
