#!/usr/bin/python3
"""Checks who includes whom (src/ARCHITECTURE.md, floors): a file includes only its own floor and lower ones.

usage: check_floors.py [ROOT]        ROOT holds src/ and, where it exists, cuda/
Prints one line per violation, `file:line: what is wrong`; exit code 1 if there is any.
"""
import pathlib
import re
import sys

FLOORS = ["base", "physics", "model", "kernels", "backend", "solve", "io", "script", "cli", "main"]
RANK = {name: rank for rank, name in enumerate(FLOORS)}
RANK["cuda"] = RANK["backend"]

SOURCES = {".hpp", ".cpp", ".cu", ".cuh", ".h"}
INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]')
LUA = re.compile(r"^(lua|lauxlib|lualib|luaconf)\.(h|hpp)$")
HDF5 = re.compile(r"^(hdf5(_hl)?|H5\w+)\.h$")
CGAL = re.compile(r"^CGAL/")
CUDA_HEADER = re.compile(r"^(cuda|cuda_\w+|cub/.*|thrust/.*|cooperative_groups.*|nvtx3/.*)(\.h|\.hpp|\.cuh)?$")
CUDA_WORD = re.compile(r"__(CUDACC|CUDA_ARCH)__|__(host|device|global|shared)__|<<<")


def floor_of(path, root):
    """Floor that a source file belongs to; None for a file that no floor owns."""
    parts = path.relative_to(root).parts
    if parts[0] == "cuda":
        return "cuda"
    if parts == ("src", "main.cpp"):
        return "main"
    return parts[1] if len(parts) > 2 and parts[1] in RANK else None


def complaints_about(path, root):
    """Yields (line number, what is wrong)."""
    floor = floor_of(path, root)
    if floor is None:
        yield 1, "belongs to no floor (" + " < ".join(FLOORS) + ")"
        return
    knows_cuda = floor == "cuda" or path in (root / "src" / "base" / name for name in ("hd.hpp", "number.hpp"))
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if not knows_cuda and CUDA_WORD.search(line.split("//")[0]):
            yield number, "only cuda/ and base/hd.hpp and number.hpp know CUDA"
        match = INCLUDE.match(line)
        if not match:
            continue
        quote, name = match.groups()
        if name.endswith((".cpp", ".cu")):
            yield number, f"includes the source file {name}"
        if LUA.match(name) and floor != "script":
            yield number, f"only script includes Lua's {name}"
        if HDF5.match(name) and floor != "io":
            yield number, f"only io includes HDF5's {name}"
        if CGAL.match(name) and not (floor == "model" and path.suffix == ".cpp"):
            yield number, f"only the model's .cpp files include {name}"
        if CUDA_HEADER.match(name) and not knows_cuda:
            yield number, f"only cuda/ and base/hd.hpp include {name}"
        if quote == '"':
            yield from ((number, text) for text in complaints_about_floor(name, floor, path, root))


def complaints_about_floor(name, floor, path, root):
    """What is wrong with `#include "name"` in a file of `floor`."""
    owner = name.split("/")[0]
    if owner not in RANK:
        beside = floor == "cuda" and (path.parent / name).exists()
        if not beside:
            yield f'"{name}" is not of the form "floor/file.hpp"'
    elif RANK[owner] > RANK[floor] or (owner == "cuda" and floor != "cuda"):
        yield f"{floor} (floor {RANK[floor]}) includes {name} of the higher floor {owner} ({RANK[owner]})"
    elif not (root / "src" / name).exists() and not (root / name).exists():
        yield f'"{name}" does not exist under src'


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent).resolve()
    files = sorted(p for top in ("src", "cuda") for p in (root / top).rglob("*") if p.suffix in SOURCES)
    if not files:
        sys.exit(f"check_floors: no sources under {root}")
    wrong = [f"{p.relative_to(root)}:{n}: {text}" for p in files for n, text in complaints_about(p, root)]
    print("\n".join(wrong) if wrong else f"{len(files)} files, every include points to its own floor or a lower one")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
