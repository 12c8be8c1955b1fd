#!/usr/bin/python3
"""Law: bodies do not lie in each other. The start deck of falling blocks is run to its end, where everything is at rest and
no point of a block's edges is deeper in another block than four times what its weight presses a whole face in by; and what
is at rest neither gains nor loses energy."""
import csv
import pathlib
import subprocess
import sys
import tempfile

import h5py
import numpy as np

PROGRAM, DECK = sys.argv[1:]
FACES = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
EDGES = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
ALLOWED = 4 * 2500 * 9.81 * 0.2 / 2e9  # m, times density, gravity, side over stiffness
AT_REST = 1e-12  # J, of some 400 that the fall has set free
ACCOUNT = 1e-6  # J

# What the start deck falls by, and other ways for the cube to land.
TURNS = ("30*deg", "45*deg", "10*deg")


def depth_of(points, corners):
    """[points] how deep they are inside a convex hexahedron, m; negative outside."""
    least = np.full(len(points), np.inf)
    for face in FACES:
        a = corners[list(face)]
        normal = np.cross(a[2] - a[0], a[3] - a[1])
        least = np.minimum(least, (a.mean(0) - points) @ (normal / np.linalg.norm(normal)))
    return least


def deepest(result):
    with h5py.File(result) as file:
        grid = file["VTKHDF"]
        bodies = grid["Connectivity"][()].reshape(-1, 8)
        block = grid["CellData/block"][()]
        count = len(grid["Points"])
        places = grid["Points"][()] + grid["PointData/displacement"][()].reshape(-1, count, 3)[-1]
    along = np.linspace(0, 1, 21)[:, None]
    found = -np.inf
    for i, inner in enumerate(bodies):
        points = np.concatenate([(1 - along) * places[inner[a]] + along * places[inner[b]] for a, b in EDGES])
        for j, outer in enumerate(bodies):
            if block[i] != block[j]:
                found = max(found, depth_of(points, places[outer]).max())
    return found


failed = False
text = pathlib.Path(DECK).read_text(encoding="utf-8")
with tempfile.TemporaryDirectory() as folder:
    # Undamped they clatter on; the deck says how well the energy of that has to be kept.
    clatter = text.replace("contact_damping = 1e-4*s, ", "").replace("duration = 5*s", "duration = 1*s")
    assert clatter.count("contact_damping") == 1 and "1*s" in clatter
    pathlib.Path(folder, "clatter.lua").write_text(clatter, encoding="utf-8")
    subprocess.run([PROGRAM, "run", "clatter.lua"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    for turn in TURNS:
        assert text.count("30*deg") == 2
        deck = pathlib.Path(folder, "fall.lua")
        deck.write_text(text.replace("30*deg", turn), encoding="utf-8")
        subprocess.run([PROGRAM, "run", deck.name, "--force"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        depth = deepest(pathlib.Path(folder, "fall.run", "results.vtkhdf"))
        with open(pathlib.Path(folder, "fall.run", "history_all.csv"), encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        kinetic = float(rows[-1]["energy.kinetic [J]"])
        drifts = abs(float(rows[-1]["energy.error [J]"]) - float(rows[-len(rows) // 10]["energy.error [J]"]))
        print(f"turned by {turn}: {depth:.3g} m deep, allowed {ALLOWED:.3g} m; {kinetic:.2g} J kinetic, "
              f"account moves by {drifts:.2g} J in the last tenth")
        failed |= not 0 < depth < ALLOWED  # at rest they press on the ground
        failed |= not kinetic < AT_REST or not drifts < ACCOUNT
sys.exit(failed)
