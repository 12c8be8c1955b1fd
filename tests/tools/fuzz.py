#!/usr/bin/python3
"""Mutates decks and mesh files, and feeds them to `ashlar check`: every answer must be a result or an error message.

fuzz.py ASHLAR [--seconds S] [--seed N] [--keep FOLDER]
A finding is a death by a signal, a report of a sanitizer, exit code 1 ('error in the program'), more memory than
MEMORY_LIMIT, or no answer within TIME_LIMIT. Each is kept in FOLDER with the file that made it. The same seed tries the
same inputs in the same order; seed 0 is taken from the clock.
"""
import argparse
import pathlib
import random
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
MEMORY_LIMIT = 4 << 30   # bytes; no deck of the collection needs a quarter of it
TIME_LIMIT = 60          # seconds; decks stop their own loops long before
LARGEST_SEED = 200_000   # bytes: larger files spend the time in reading

WORDS = ["nil", "true", "0", "-1", "1e308", "-1e308", "0/0", "1/0", "2^53", "1e-320", "{}", "''", '"x"', "m", "Pa", "degC", "K",
         "kg/m^3", "function() end", "function(x, y, z) return nil end", "function(x, y, z) return 0/0 end",
         "function(x, y, z) error('no') end", "function(x, y, z) return {} end", "print", "math.huge", "-math.huge",
         "setmetatable({}, { __index = error })", "string.rep('x', 1e5)", "coroutine", "{ {}, {} }", "{ 0, 0, 0 }"]
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
                new = rng.choice(WORDS + NUMBERS + [f"-{one[0]}", f"{one[0]}*1e9", f"{one[0]}/1e9"])
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


def mesh_deck(mesh):
    return (f'model "fuzz" {{}}\nimport_mesh {{ file = "{mesh}" }}\n'
            'material "rock" { region = "column", density = 2600, young = 20*GPa, poisson = 0.2 }\n'
            'stage "rest" { solve = static {} }\n')


def seeds():
    """Names and contents of the files to start from, decks and meshes apart."""
    decks = sorted(p for place in ("decks/start", "decks/dam", "decks/verify", "tests/decks/wrong")
                   for p in (ROOT / place).glob("*.lua"))
    meshes = sorted(p for place in ("tests/data", "tests/decks/wrong", "decks/verify")
                    for p in (ROOT / place).iterdir() if p.suffix in (".msh", ".inp", ".vtu", ".stl", ".off"))
    return decks, [p for p in meshes if p.stat().st_size < LARGEST_SEED]


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY_LIMIT, MEMORY_LIMIT))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def sanitized(program):
    return b"__asan_init" in pathlib.Path(program).read_bytes()


def answer(program, folder, limits):
    """What is wrong with the answer; empty where nothing is."""
    try:
        run = subprocess.run([program, "check", "deck.lua"], cwd=folder, capture_output=True, timeout=TIME_LIMIT, check=False,
                             preexec_fn=limits)
    except subprocess.TimeoutExpired:
        return f"no answer within {TIME_LIMIT} s"
    said = (run.stdout + run.stderr).decode("utf-8", "replace")
    if run.returncode < 0:
        return f"signal {-run.returncode}\n{said[-3000:]}"
    if "Sanitizer" in said or "runtime error:" in said:
        return f"sanitizer\n{said[-5000:]}"
    if run.returncode == 1:
        return f"error in the program\n{said[-3000:]}"
    if run.returncode == 5 and "memory" in said:
        return f"more memory than {MEMORY_LIMIT >> 30} GB\n{said[-3000:]}"
    if run.returncode == 2 and not run.stderr.strip():
        return "refused without a word"
    return ""


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
    tried, findings, end = 0, {}, time.monotonic() + options.seconds
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        for path in {p for d in {q.parent for q in decks} for p in d.iterdir() if p.is_file() and p.suffix != ".lua"}:
            shutil.copy(path, folder / path.name)
        while time.monotonic() < end:
            if rng.random() < 0.5:
                deck = rng.choice(decks)
                (folder / "deck.lua").write_text(mutate_deck(deck.read_text(encoding="utf-8", errors="surrogateescape"), rng),
                                           encoding="utf-8", errors="surrogateescape")
                kept = [folder / "deck.lua"]
                origin = deck.name
            else:
                mesh = rng.choice([p for p in meshes if p.suffix not in (".stl", ".off")])
                changed = folder / ("fuzz" + mesh.suffix)
                changed.write_bytes(mutate_bytes(mesh.read_bytes(), rng))
                (folder / "deck.lua").write_text(mesh_deck(changed.name), encoding="utf-8")
                kept = [folder / "deck.lua", changed]
                origin = mesh.name
            tried += 1
            what = answer(program, folder, limits)
            if what.startswith("no answer"):  # a crowded machine is no finding
                what = answer(program, folder, limits)
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
    print(f"{tried} inputs tried with seed {options.seed}: {sum(findings.values())} findings, {len(findings)} of different kinds")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
