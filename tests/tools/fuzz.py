#!/usr/bin/python3
"""Mutates decks and mesh files, and feeds them to `ashlar check`, those of few elements also to `ashlar run`, which Ctrl-C
ends after a while: every answer must be a result or an error message.

fuzz.py ASHLAR [--seconds S] [--seed N] [--keep FOLDER]
A finding is a death by a signal, a report of a sanitizer (leaks included), exit code 1 ('error in the program'), more
memory than MEMORY_LIMIT, no answer within the limits of time, a run that refuses what check let pass, or a number in the
results of a finished run that is none. Each is kept in FOLDER with the file that made it. The same seed tries the same
inputs in the same order; seed 0 is taken from the clock. Times are those of the processor, so that a crowded machine is
no finding.
"""
import argparse
import os
import pathlib
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import h5py
import numpy

ROOT = pathlib.Path(__file__).resolve().parents[2]
MEMORY_LIMIT = 4 << 30   # bytes; no deck of the collection needs a quarter of it
TIME_LIMIT = 60          # seconds of the processor; decks stop their own loops long before
WAIT_LIMIT = 1200        # seconds of the clock: who waits so long waits for ever
RUN_TIME = 4             # seconds of the processor after which Ctrl-C ends a run
RUN_ELEMENTS = 3000      # decks of more elements are checked only
LARGEST_SEED = 200_000   # bytes: larger files spend the time in reading

SURFACES = (".stl", ".off")   # files of facets, for solids

WORDS = ["nil", "true", "0", "-1", "1e308", "-1e308", "0/0", "1/0", "2^53", "1e-320", "{}", "''", '"x"', "m", "Pa", "degC", "K",
         "kg/m^3", "function() end", "function(x, y, z) return nil end", "function(x, y, z) return 0/0 end",
         "function(x, y, z) error('no') end", "function(x, y, z) return {} end", "function(x, y, z, t) return z * t end",
         "function(x, y, z, t) return t > 0 and 0/0 or 1 end", "in_time(function(t) return t end)", "{ { 0, 1 }, { 1, 2 } }", "print", "math.huge", "-math.huge",
         "setmetatable({}, { __index = error })", "string.rep('x', 1e5)", "coroutine", "{ {}, {} }", "{ 0, 0, 0 }"]
MILD = ["*0.1", "*0.9", "*1.2", "*3"]   # changes that a deck may well survive, for runs
NUMBERS = ["0", "-1", "1", "2147483647", "2147483648", "-2147483648", "4294967295", "9223372036854775807",
           "18446744073709551615", "99999999999999999999", "1e308", "-1e308", "1e-320", "nan", "inf", "-inf", "1e999", "0x10", ""]
BYTES = [0, 1, 10, 13, 32, 34, 36, 44, 60, 62, 127, 128, 254, 255]


def mutate_deck(text, rng):
    for _ in range(rng.choice([1, 1, 1, 2, 4])):
        tokens = list(re.finditer(r'"[^"\n]*"|[A-Za-z_]\w*|\d[\w.]*|[^\s\w]', text))
        if not tokens:
            return text
        one, other = rng.choice(tokens), rng.choice(tokens)
        new = rng.choice([lambda: rng.choice(WORDS), lambda: other[0], lambda: "", lambda: one[0] * 2,
                          lambda: rng.choice(NUMBERS), lambda: one[0][::-1]])()
        if rng.random() < 0.4:
            numbers = [t for t in tokens if t[0][0].isdigit()]
            if numbers:
                one = rng.choice(numbers)
                new = rng.choice(WORDS + NUMBERS + [f"-{one[0]}", f"{one[0]}*1e9", f"{one[0]}/1e9"] + [one[0] + m for m in MILD] * rng.choice([0, 15]))
        if rng.random() < 0.15:
            lines = text.split("\n")
            at, to = rng.randrange(len(lines)), rng.randrange(len(lines))
            line = lines.pop(at)
            if rng.random() < 0.5:
                lines.insert(to, line)
            text = "\n".join(lines)
        else:
            text = text[:one.start()] + new + text[one.end():]
    return text


def mutate_bytes(data, rng):
    data = bytearray(data)
    for _ in range(rng.choice([1, 1, 2, 5, 20])):
        if not data:
            break
        at = rng.randrange(len(data))
        kind = rng.randrange(7)
        if kind == 0:
            data[at] = rng.choice(BYTES)
        elif kind == 1:
            data[at] ^= 1 << rng.randrange(8)
        elif kind == 2:
            del data[at:at + rng.choice([1, 4, 8, 64, len(data)])]
        elif kind == 3:
            piece = data[at:at + rng.choice([1, 8, 100])]
            to = rng.randrange(len(data))
            data[to:to] = piece
        elif kind == 4:  # a whole line goes, doubles or moves
            lines = data.split(b"\n")
            line = lines.pop(rng.randrange(len(lines)))
            for _ in range(rng.randrange(3)):
                lines.insert(rng.randrange(len(lines) + 1), line)
            data = bytearray(b"\n".join(lines))
        else:  # a number of the text becomes another; the head of a file is where counts are
            numbers = list(re.finditer(rb"-?\d[\d.e+-]*", data[:rng.choice([400, len(data)])]))
            if numbers:
                number = rng.choice(numbers)
                data[number.start():number.end()] = rng.choice(NUMBERS).encode()
    return bytes(data)


def mesh_deck(mesh, regions):
    names = ", ".join(f'"{name}"' for name in regions)
    body = f'solid "bar" {{ file = "{mesh}", size = 4*m }}' if mesh.endswith(SURFACES) else f'import_mesh {{ file = "{mesh}" }}'
    return (f'model "fuzz" {{}}\n{body}\n'
            f'material "rock" {{ region = {{ {names} }}, density = 2600, young = 20*GPa, poisson = 0.2 }}\n'
            f'surface "foot" {{ of = {{ {names} }}, facing = {{ 0, 0, -1 }} }}\n'
            'fix { surface = "foot", x = 0, y = 0, z = 0 }\n'
            'gravity { z = -9.81 }\n'
            'stage "rest" { solve = static {} }\n')


def regions_of(program, mesh):
    """Names of the regions in a mesh file, as the program says them when asked for another."""
    with tempfile.TemporaryDirectory() as place:
        shutil.copy(mesh, place)
        pathlib.Path(place, "deck.lua").write_text(mesh_deck(mesh.name, ["nowhere"]), encoding="utf-8")
        err = subprocess.run([program, "check", "deck.lua"], cwd=place, capture_output=True, text=True, check=False).stderr
    names = re.search(r"there is no region 'nowhere'; valid: (.*)", err)
    return names[1].split(", ") if names else ["bar"]


def seeds():
    """Names and contents of the files to start from, decks and meshes apart."""
    decks = sorted(p for place in ("decks/start", "decks/dam", "decks/verify", "tests/decks/wrong")
                   for p in (ROOT / place).glob("*.lua"))
    meshes = sorted(p for place in ("tests/data", "tests/decks/wrong", "decks/verify")
                    for p in (ROOT / place).iterdir() if p.suffix in (".msh", ".inp", ".vtu", *SURFACES))
    return decks, [p for p in meshes if p.stat().st_size < LARGEST_SEED]


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY_LIMIT, MEMORY_LIMIT))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def sanitized(program):
    return b"__asan_init" in pathlib.Path(program).read_bytes()


def processor_seconds(process):
    try:
        words = pathlib.Path(f"/proc/{process}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()
    except OSError:
        return 0
    return (int(words[11]) + int(words[12])) / os.sysconf("SC_CLK_TCK")


def obey(command, folder, limits, stop_after=None):
    """Exit code (None where the limits of time ended it), stdout and stderr; Ctrl-C after so many seconds of the processor."""
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        process = subprocess.Popen(command, cwd=folder, stdout=out, stderr=err, preexec_fn=limits)
        begin, pause, limit, late = time.monotonic(), 0.002, TIME_LIMIT, False
        while process.poll() is None:
            time.sleep(pause)
            pause = min(2 * pause, 0.2)
            used = processor_seconds(process.pid)
            if stop_after and used > stop_after:
                process.send_signal(signal.SIGINT)
                stop_after, limit = None, used + TIME_LIMIT
            if used > limit or time.monotonic() - begin > WAIT_LIMIT:
                process.kill()
                late = True
        out.seek(0)
        err.seek(0)
        return None if late else process.returncode, *(f.read().decode("utf-8", "replace") for f in (out, err))


def fault(code, out, err):
    """What is wrong with an answer; empty where nothing is."""
    said = out + err
    if code is None:
        return f"no answer within {TIME_LIMIT} s\n{said[-1000:]}"
    if code < 0:
        return f"signal {-code}\n{said[-3000:]}"
    if "Sanitizer" in said or "runtime error:" in said:
        return f"sanitizer\n{said[-5000:]}"
    if code == 1:
        return f"error in the program\n{said[-3000:]}"
    if code == 5 and "memory" in said:
        return f"more memory than {MEMORY_LIMIT >> 30} GB\n{said[-3000:]}"
    if code == 2 and not err.strip():
        return "refused without a word"
    return ""


def no_numbers(folder):
    """Where the results of a run hold numbers that are none."""
    for file in sorted(folder.glob("history_*.csv")):
        if re.search(r"(?i)(^|,)-?(nan|inf)\b", file.read_text(encoding="utf-8"), re.MULTILINE):
            return file.name
    found = []

    def visit(name, item):
        if isinstance(item, h5py.Dataset) and item.dtype.kind == "f" and not numpy.isfinite(item[()]).all():
            found.append(name)

    with h5py.File(folder / "results.vtkhdf") as file:
        file.visititems(visit)
    return ", ".join(found)


def check(program, folder, limits):
    """What is wrong with the answer of check, and whether the deck is worth a run."""
    code, out, err = obey([program, "check", "deck.lua"], folder, limits)
    elements = re.search(r"^mesh +([\d ]+) elements", out, re.MULTILINE)
    return fault(code, out, err), code == 0 and elements and int(elements[1].replace(" ", "")) <= RUN_ELEMENTS


def run(program, folder, limits):
    """What is wrong with the answer of run."""
    shutil.rmtree(folder / "deck.run", ignore_errors=True)
    code, out, err = obey([program, "run", "deck.lua", "--threads", "2"], folder, limits, RUN_TIME)
    what = fault(code, out, err)
    if not what and code == 2 and "stage 1 " not in out:
        what = f"refused by run, not by check\n{err[-3000:]}"
    if not what and code in (0, 3, 4) and (bad := no_numbers(folder / "deck.run")):
        what = f"no number in {bad} with exit code {code}\n{out[-3000:]}"
    return what


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("program")
    parser.add_argument("--seconds", type=float, default=10)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path, default=pathlib.Path("fuzz_findings"))
    options = parser.parse_args()
    program = str(pathlib.Path(options.program).resolve())
    # The address sanitizer reserves terabytes of addresses: it has a limit of its own.
    limits = None if sanitized(program) else limit_memory
    options.seed = options.seed or int(time.time())
    rng = random.Random(options.seed)
    decks, meshes = seeds()
    right = [deck for deck in decks if deck.parent.name != "wrong"]
    regions = {mesh: regions_of(program, mesh) for mesh in meshes}
    tried, ran, findings, end = 0, 0, {}, time.monotonic() + options.seconds
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        for path in {p for d in {q.parent for q in decks} for p in d.iterdir() if p.is_file() and p.suffix != ".lua"}:
            shutil.copy(path, folder / path.name)
        while time.monotonic() < end:
            if rng.random() < 0.5:
                deck = rng.choice(rng.choice([decks, right]))
                (folder / "deck.lua").write_text(mutate_deck(deck.read_text(encoding="utf-8", errors="surrogateescape"), rng),
                                           encoding="utf-8", errors="surrogateescape")
                kept = [folder / "deck.lua"]
                origin = deck.name
            else:
                mesh = rng.choice(meshes)
                changed = folder / ("fuzz" + mesh.suffix)
                changed.write_bytes(mutate_bytes(mesh.read_bytes(), rng))
                (folder / "deck.lua").write_text(mesh_deck(changed.name, regions[mesh]), encoding="utf-8")
                kept = [folder / "deck.lua", changed]
                origin = mesh.name
            tried += 1
            what, runs = check(program, folder, limits)
            if runs and not what:
                ran += 1
                what = run(program, folder, limits)
            if what:
                key = re.sub(r"\d+", "", what)[:200]
                findings.setdefault(key, 0)
                findings[key] += 1
                if findings[key] > 1:
                    continue
                keep = options.keep / f"seed{options.seed}_{tried}"
                keep.mkdir(parents=True, exist_ok=True)
                for file in kept:
                    shutil.copy(file, keep / file.name)
                (keep / "finding.txt").write_text(f"from {origin}\n{what}\n", encoding="utf-8")
                print(f"{keep} (from {origin}): {what}", flush=True)
    print(f"{tried} inputs tried with seed {options.seed}, {ran} of them run: {sum(findings.values())} findings, {len(findings)} of different kinds")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
