#!/usr/bin/python3
"""Runs the verification decks and prints what they found as Markdown, a table for each deck.

verification_table.py ASHLAR [DECK ...]    decks by name, such as d0_elastic; all of decks/verify unless given
  --all    a row for every expect instead of the worst of each quantity
  --book   writes the tables into decks/verify/README.md, where those of decks that are not run stay
verification_table.py --check    runs nothing: is every deck in that page, with all its runs, and nothing else?
Exit code 1 if an expect fails, a run does not end well, or the page is not complete.

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
BOOK = DECKS / "README.md"
UNITS = {"displacement": "m", "stress": "Pa", "nodal_stress": "Pa", "temperature": "degC", "reaction": "N", "load": "N", "load_moment": "N m"}


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
            last = "What"
            entries["Case"], entries[last] = start[3], start[4]
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


def solve(program, run, folder, threads=None, precision=None, devices=None):
    """Runs a deck into `folder`, which must not exist."""
    command = [program, "run", str(run.deck), "--out", str(folder)]
    for argument in run.arguments:
        command += ["--set", argument]
    if threads:
        command += ["--threads", str(threads)]
    if precision:
        command += ["--precision", precision]
    if devices:
        command += ["--devices", devices]
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


def quantity(expect):
    """The name of an expect without the numbers and components that tell it from its like."""
    name = re.sub(r"[-+]?\b\d+(\.\d+)?(e[-+]?\d+)?\b", "", expect["name"])
    name = re.sub(r"( (x|y|z|xx|yy|zz|xy|yz|zx))+$", "", name)
    return " ".join(re.sub(r"\(\s*,?\s*\)|=\s*(?=,|$)", "", name).split())


def rows(outcome, every):
    """Lists of the table's columns: the worst expect of each quantity, or every one."""
    run, seconds = f"`{' '.join(outcome.run.arguments) or 'as it is'}`", f"{outcome.seconds:.2g}"
    alike = {}
    for number, expect in enumerate(outcome.expects):
        alike.setdefault(number if every or "between" not in expect else quantity(expect), []).append(expect)
    table = []
    for group in alike.values():
        expect = max(group, key=lambda e: share_of_tolerance(e) if "between" in e else 0)
        name = expect["name"] + (f" (worst of {len(group)})" if len(group) > 1 else "")
        verdict = "" if expect["passed"] else " **FAILED**"
        if "between" in expect:
            low, high = expect["between"]
            reference, found, unit = (low + high) / 2, expect.get("found", float("nan")), unit_of(expect)
            table.append([run, name, f"{reference:.6g}{unit}", f"{found:.6g}{verdict}", f"{found - reference:.1e}",
                          f"{(high - low) / 2:.1e}", seconds])
        else:
            table.append([run, name, "", expect["message"].replace("|", "/") + verdict, "", "", seconds])
    if not outcome.expects or outcome.code not in (0, 4):
        last = outcome.output.strip().splitlines()[-1:] or ["no output"]
        table.append([run, f"exit code {outcome.code}", "", f"{last[0]} **FAILED**", "", "", seconds])
    return table


KINDS = {"A": r"closed form|by hand|^exact|elasticity|theory", "X": "CalculiX", "N": "numpy|independent program",
         "L": r"\b(?:1[89]|20)\d\d\b|NAFEMS|EM 1110"}
CHAPTERS = [("Elements", range(1, 13)), ("Explicit integration", range(13, 19)), ("Heat", range(19, 28)),
            ("Plasticity", range(28, 33)), ("Contacts and cracks", range(33, 41)), ("Dams", ["D0", "Koyna"]),
            ("Balances and other checks by hand", [])]
PREFACE = """# Verification book

Every deck of this folder runs in the tests and compares itself with an answer that does not come from Ashlar.
This page is written by `tools/verification_table.py ASHLAR --book`; times are those of one machine, in double precision.
Repeat a row with `ashlar run decks/verify/DECK.lua --set A=B --set C=D` for the run `A=B C=D`.

**Sources.** **A**: closed form or balance by hand. **X**: CalculiX 2.20 on a stated mesh. **N**: an independent
numpy program. **L**: literature. Each deck names its own.

**Tolerances** are of three kinds. *Same mesh*: the reference comes from the same elements on the same mesh, and only
rounding and the stop criterion differ (about 1e-4). *Mesh*: the exact value against a stated mesh, whose error is
in the tolerance (up to some per cent). *Analytic*: the elements represent the exact answer (1e-5 and below).

Each row is one quantity of one run, the worst one where a run compares several of its kind; the reference is the middle of
the accepted range, the tolerance half of its width. Rows without a reference are statements; the deck says what it expects.

Cases below the reach of a deck are unit tests in `tests/solve/patch.cpp`: P3 (rigid motion without force), and P1 with the seven
hexahedra of MacNeal and Harder, one of which is turned over at a corner, so that a deck refuses it; `patch_seven` cuts them.
P17 (answers do not depend on damping, time step or threads) is `tests/decks/run_same.py`.
"""


def chapter(case):
    """Index into CHAPTERS of a case such as `P4, P5` or `D0 heat`."""
    first = re.match(r"P(\d+)|(\w+)", case)
    key = int(first[1]) if first[1] else first[2]
    return next((i for i, (_, keys) in enumerate(CHAPTERS) if key in keys), len(CHAPTERS) - 1)


def section(deck, outcomes, every):
    """The part of the page about one deck: what it is, source, tolerance, table."""
    entries = head(deck)
    kinds = ", ".join(kind for kind, words in KINDS.items() if re.search(words, entries["Source"], re.I))
    lines = [f"### {entries['Case']} `{deck.stem}`", entries["What"][:1].upper() + entries["What"][1:], "", f"Source ({kinds}): {entries['Source']}  ",
             f"Accepted: {entries['Accept']}", "",
             "| run | quantity | reference | ours | difference | tolerance | seconds |", "|---|---|---|---|---|---|---|"]
    lines += ["| " + " | ".join(row) + " |" for outcome in outcomes for row in rows(outcome, every)]
    return "\n".join(lines) + "\n"


def read_book():
    """{deck's name: section} of the page."""
    text = BOOK.read_text(encoding="utf-8") if BOOK.exists() else ""
    parts = re.split(r"^(?=### )", re.sub(r"^## .*\n\n?", "", text, flags=re.M), flags=re.M)[1:]
    return {re.match(r"### .* `(\w+)`\n", part)[1]: part.rstrip() + "\n" for part in parts}


def write_book(sections):
    cases = {run.deck.stem: run.case for run in runs()}
    text, last = PREFACE, None
    def order(name):
        number = re.match(r"P(\d+)", cases[name])
        return chapter(cases[name]), int(number[1]) if number else 0, name
    for name in sorted(set(sections) & set(cases), key=order):
        if chapter(cases[name]) != last:
            last = chapter(cases[name])
            text += f"\n## {CHAPTERS[last][0]}\n"
        text += "\n" + sections[name]
    BOOK.write_text(text, encoding="utf-8")


def check_book():
    """What the page lacks or has too much, a line each."""
    sections, faults = read_book(), []
    expected = {}
    for run in runs():
        expected.setdefault(run.deck.stem, []).append(f"`{' '.join(run.arguments) or 'as it is'}`")
    faults += [f"{name}: in the page, but no deck that runs" for name in sorted(set(sections) - set(expected))]
    for name, wanted in expected.items():
        listed = list(dict.fromkeys(re.findall(r"^\| (`[^`]*`) \|", sections.get(name, ""), flags=re.M)))
        if listed != wanted:
            faults.append(f"{name}: the page has runs {listed}, the deck {wanted}")
    if any("**FAILED**" in text for text in sections.values()):
        faults.append("the page lists a failure")
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", nargs="?")
    parser.add_argument("decks", nargs="*")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--book", action="store_true")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_intermixed_args()
    if options.check:
        faults = check_book()
        print("\n".join(faults + ["update: tools/verification_table.py ASHLAR DECK ... --book"] if faults else ["complete"]))
        return 1 if faults else 0
    if not options.program:
        parser.error("which program?")
    passed, by_deck, sections = True, {}, read_book() if options.book else {}
    for run in runs(options.decks):
        by_deck.setdefault(run.deck, []).append(run)
    with tempfile.TemporaryDirectory() as folder:
        for deck, its_runs in by_deck.items():
            outcomes = [solve(options.program, run, pathlib.Path(folder) / f"{deck.stem}_{number}")
                        for number, run in enumerate(its_runs)]
            passed = passed and all(outcome.passed for outcome in outcomes)
            sections[deck.stem] = section(deck, outcomes, options.all)
            print(sections[deck.stem], flush=True)
    if options.book:
        write_book(sections)
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
