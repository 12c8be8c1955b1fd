#!/usr/bin/python3
"""Runs decks several times and compares the results.

run_same.py bits ASHLAR      1, 2 and 3 threads, a second run, lanes beside each other: every dataset and every history has the same bytes
run_same.py answer ASHLAR    a static answer does not depend on start, damping and pseudo time step, to 1e-6
"""
import itertools
import pathlib
import sys
import tempfile

import h5py
import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent.parent / "tools"))
from verification_table import DECKS, Run, solve  # noqa: E402


def contents(folder):
    """{name: bytes} of every dataset and attribute of every HDF5 file, and of every history."""
    found = {}

    def keep(file, name, thing):
        for key, value in thing.attrs.items():
            found[f"{file}:{name}@{key}"] = numpy.asarray(value).tobytes()
        if isinstance(thing, h5py.Dataset):
            found[f"{file}:{name}"] = thing.dtype.str.encode() + str(thing.shape).encode() + thing[()].tobytes()

    for path in sorted(folder.glob("*.vtkhdf")):
        with h5py.File(path) as file:
            keep(path.name, "/", file)
            file.visititems(lambda name, thing, at=path.name: keep(at, name, thing))
    for path in sorted(folder.glob("*.csv")):
        found[path.name] = path.read_bytes()
    return found


def run(program, folder, deck, arguments, threads=None, devices=None):
    """Results of a run; an expect that fails (exit code 4) still leaves them."""
    outcome = solve(program, Run(DECKS / f"{deck}.lua", "", "", arguments), folder, threads, devices=devices)
    if outcome.code != 0:
        sys.exit(f"{deck} {arguments}: exit code {outcome.code}\n{outcome.output}")
    return folder


def same_bits(program, folder):
    failed = 0
    for deck, arguments in (("d0_elastic", []), ("d0_elastic", ["start=rest"]), ("d0_heat", ["transient=true", "fine=true"]), ("d0_staged", []),
                            ("cooled_column", []), ("yearly_ground", ["film=15"])):
        first = None
        lanes = "stress=cpu,thermal=cpu" if deck == "yearly_ground" else None
        for number, threads in enumerate((1, 2, 3, 2)):
            now = contents(run(program, folder / " ".join([deck, *arguments, str(number)]), deck, arguments, threads,
                               lanes if number > 1 else None))
            first = first or now
            different = sorted(name for name in first.keys() | now.keys() if first.get(name) != now.get(name))
            failed += bool(different)
            print(f"{deck} {' '.join(arguments)}: {len(now)} pieces with {threads} threads, {len(different)} differ "
                  f"{' '.join(different[:5])}", flush=True)
    return failed


def same_answer(program, folder):
    ways = [["start=rest", f"damping={damping}", f"step_factor={step_factor}"]
            for damping, step_factor in itertools.product(("adaptive", "local", "viscous"), ("1", "0.7"))]
    answers = {}
    for number, way in enumerate([["start=search"], *ways]):
        place = run(program, folder / str(number), "d0_elastic", way)
        with h5py.File(place / "results.vtkhdf") as file:
            answers[" ".join(way)] = file["VTKHDF/PointData/displacement"][()]
    first = next(iter(answers.values()))
    failed = 0
    for name, answer in answers.items():
        apart = abs(answer - first).max() / abs(first).max()
        failed += not apart <= 1e-6
        print(f"{name}: {apart:.1e} apart from the first", flush=True)
    return failed


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as temporary:
        what = {"bits": same_bits, "answer": same_answer}[sys.argv[1]]
        sys.exit(1 if what(sys.argv[2], pathlib.Path(temporary)) else 0)
