#!/usr/bin/python3
"""Reads the folder of a run back as other programs would: h5py against the VTKHDF layout, ParaView through the XDMF.

usage: read_back.py [--no-paraview] RUN...

Every fact of one reader is compared with the other: number of steps, times, points, cell types, ranges of every array.
Exits 1 with a line for each thing that is wrong.
"""
import argparse
import csv
import json
import pathlib
import sys

import h5py
import numpy as np

CORNERS = {5: 3, 9: 4, 10: 4, 12: 8, 13: 6}  # by VTK cell type: triangle, quad, tet, hex, wedge


class Wrong(Exception):
    """What is wrong with a file."""


def need(condition, *words):
    if not condition:
        raise Wrong(" ".join(str(word) for word in words))


def read_grid(path):
    """Checks a VTKHDF file against its layout; returns what ParaView has to find in it."""
    with h5py.File(path, "r") as file:
        group = file["VTKHDF"]
        need(list(group.attrs["Version"]) == [2, 0], "Version is", group.attrs["Version"])
        kind = group.attrs.get_id("Type").get_type()
        need(not kind.is_variable_str() and kind.get_cset() == h5py.h5t.CSET_ASCII, "Type is no fixed-length ASCII text")
        need(group.attrs["Type"] == b"UnstructuredGrid", "Type is", group.attrs["Type"])

        points, types = group["Points"][()], group["Types"][()]
        connectivity, offsets = group["Connectivity"][()], group["Offsets"][()]
        for name, count in (("NumberOfPoints", len(points)), ("NumberOfCells", len(types)),
                            ("NumberOfConnectivityIds", len(connectivity))):
            need(list(group[name][()]) == [count], name, "is", group[name][()], "but there are", count)
        need(points.dtype == np.float64 and points.shape == (len(points), 3), "Points are", points.dtype, points.shape)
        need(np.isfinite(points).all(), "a point is not finite")
        need(types.dtype == np.uint8 and set(types) <= set(CORNERS), "cell types are", sorted(set(types)))
        need(connectivity.dtype == np.int64 and offsets.dtype == np.int64, "corners are", connectivity.dtype)
        need(offsets[0] == 0 and list(np.diff(offsets)) == [CORNERS[t] for t in types], "Offsets do not fit the types")
        need(offsets[-1] == len(connectivity), "Offsets end at", offsets[-1])
        need(set(connectivity) == set(range(len(points))), "not every point is the corner of a cell, or one is unknown")

        times, arrays = read_steps(file, len(points), len(types))
        return {"times": times, "points": points, "types": types, "arrays": arrays}


def read_steps(file, point_count, cell_count):
    """(times, [steps] of {array name: (place, values)})."""
    group, steps = file["VTKHDF"], file["VTKHDF/Steps"]
    count, times = int(steps.attrs["NSteps"]), list(steps["Values"][()])
    need(count > 0, "there are no steps")
    need(len(times) == count, "NSteps is", count, "but there are", len(times), "times")
    need(all(a < b for a, b in zip(times, times[1:])), "times do not grow:", times)
    need(sorted(file["Steps"]) == [f"{s + 1:05d}" for s in range(count)], "groups in /Steps:", sorted(file["Steps"]))
    for name, shape, value in (("PartOffsets", (count,), 0), ("NumberOfParts", (count,), 1), ("PointOffsets", (count,), 0),
                               ("CellOffsets", (count, 1), 0), ("ConnectivityIdOffsets", (count, 1), 0)):
        need(steps[name].shape == shape and (steps[name][()] == value).all(), "Steps /", name, "is", steps[name][()])
    found = [{} for _ in range(count)]
    for place, rows in (("Point", point_count), ("Cell", cell_count)):
        need(sorted(group[f"{place}Data"]) == sorted(steps[f"{place}DataOffsets"]), place, "arrays and offsets differ")
        for name, dataset in group[f"{place}Data"].items():
            first = steps[f"{place}DataOffsets/{name}"][()]
            varies = f"Steps/00001/{name}" in file
            need(list(first) == [rows * s * varies for s in range(count)], "offsets of", name, "are", first)
            need(len(dataset) == (rows * count if varies else rows), name, "has", len(dataset), "rows")
            for s in range(count):
                values = dataset[first[s]:first[s] + rows]
                need(np.isfinite(values).all(), name, "is not finite at step", s + 1)
                if varies:
                    shown = file[f"Steps/{s + 1:05d}/{name}"]
                    need(shown.is_virtual, name, "is stored twice")
                    need(np.array_equal(shown[()], values), name, "of step", s + 1, "differs through its virtual dataset")
                found[s][name] = (place, values)
    return times, found


def compare_with_paraview(path, grid):
    """Opens the XDMF with both of ParaView's readers."""
    from paraview import servermanager, simple
    from vtk.util.numpy_support import vtk_to_numpy

    for reader in (simple.XDMFReader(FileNames=[str(path)]), simple.Xdmf3ReaderS(FileName=[str(path)])):
        name = type(reader).__name__
        times = list(np.atleast_1d(reader.TimestepValues))  # one step: a number instead of a list
        need(times == grid["times"], name, "finds times", times)
        for step, time in enumerate(grid["times"]):
            reader.UpdatePipeline(time)
            seen = servermanager.Fetch(reader)
            need(seen.IsA("vtkUnstructuredGrid"), name, "finds a", seen.GetClassName())
            points = vtk_to_numpy(seen.GetPoints().GetData())
            need(np.array_equal(points, grid["points"]), name, "finds other points at step", step + 1)
            types = [seen.GetCellType(c) for c in range(seen.GetNumberOfCells())]
            need(types == list(grid["types"]), name, "finds other cell types at step", step + 1)
            arrays = {"Point": seen.GetPointData(), "Cell": seen.GetCellData()}
            for array, (place, values) in grid["arrays"][step].items():
                data = arrays[place].GetArray(array)
                need(data is not None, name, "finds no", place.lower(), "array", array, "at step", step + 1)
                need(np.array_equal(vtk_to_numpy(data), values), name, "finds other values of", array, "at step", step + 1)
            total = sum(a.GetNumberOfArrays() for a in arrays.values())
            need(total == len(grid["arrays"][step]), name, "finds", total, "arrays at step", step + 1)
        simple.Delete(reader)


def read_texts(folder, manifest):
    """Manifest, log and histories."""
    for name in manifest["files"]:
        need((folder / name).is_file(), "manifest.json names", name, "which is not there")
    for number, line in enumerate((folder / "log.jsonl").read_text(encoding="utf-8").splitlines(), 1):
        try:
            need("event" in json.loads(line), f"log.jsonl:{number}: no event")
        except ValueError as error:
            raise Wrong(f"log.jsonl:{number}: {error}") from error
    for history in manifest["histories"]:
        with open(folder / history["file"], newline="", encoding="utf-8") as file:
            header, *rows = csv.reader(file)
        need(header[:4] == ["stage", "time", "load_factor", "balanced"] and len(header) > 4, history["file"], "begins with", header)
        need(all(" [" in column and column.endswith("]") for column in header[4:]), history["file"], "lacks units:", header)
        need(rows, history["file"], "has no rows")
        for row in rows:
            need(len(row) == len(header) and np.isfinite([float(v) for v in row[1:]]).all(), history["file"], "holds", row)
        done = [stage["name"] for stage in manifest["stages"]]
        need(rows[-1][0] == done[-1], history["file"], "ends in stage", rows[-1][0], "but the run in", done[-1])


def read_run(folder, paraview):
    manifest = json.loads((folder / "manifest.json").read_text(encoding="utf-8"))
    names = ["results"] + [n for n in ("interfaces",) if (folder / f"{n}.vtkhdf").exists()]
    times = {}
    for name in names:
        path = folder / f"{name}.vtkhdf"
        try:
            grid = read_grid(path)
            if paraview:
                compare_with_paraview(path.with_suffix(".xdmf"), grid)
        except (Wrong, KeyError, OSError) as error:
            raise Wrong(f"{path.name}: {error}") from error
        times[name] = grid["times"]
        kinds = ", ".join(f"{np.count_nonzero(grid['types'] == t)} of type {t}" for t in sorted(set(grid["types"])))
        print(f"{path}: {len(grid['times'])} steps at {', '.join(f'{t:g}' for t in grid['times'])}; "
              f"{len(grid['points'])} points; cells {kinds}")
        for array, (place, values) in grid["arrays"][-1].items():
            low, high = (np.atleast_1d(f(values, axis=0)) for f in (np.min, np.max))
            ranges = "  ".join(f"{a:.6g} .. {b:.6g}" for a, b in zip(low, high))
            print(f"  {place.lower():5} {array:16} {ranges}")
    need(len({tuple(t) for t in times.values()}) == 1, "results and interfaces have different times:", times)
    with h5py.File(folder / "results.vtkhdf", "r") as file:
        ended = [step.attrs["stage"] for step in file["Steps"].values() if step.attrs["stage_end"]]
    ended = [stage.decode() if isinstance(stage, bytes) else stage for stage in ended]
    done = [stage["name"] for stage in manifest["stages"]]
    need(ended == done, "fields at the ends of stages", ended, "but the run did", done)
    read_texts(folder, manifest)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", metavar="RUN", nargs="+", type=pathlib.Path)
    parser.add_argument("--no-paraview", action="store_true", help="h5py only")
    arguments = parser.parse_args()
    wrong = False
    for folder in arguments.runs:
        try:
            read_run(folder, not arguments.no_paraview)
        except ImportError as error:
            print(f"{error}: install python3-paraview or give --no-paraview", file=sys.stderr)
            return 1
        except (Wrong, OSError, ValueError, KeyError) as error:
            print(f"{folder}: {error}", file=sys.stderr)
            wrong = True
    return int(wrong)


if __name__ == "__main__":
    sys.exit(main())
