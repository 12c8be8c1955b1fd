"""A run folder made without the engine: dam on rock with fields that are known functions, for the tests of the plotting program."""
import json
import pathlib

import h5py
import numpy as np

STAGES = ["gravity", "summer", "winter", "fracture"]
STRESS_NAMES = ["xx", "yy", "zz", "xy", "yz", "zx"]


def dam_on_rock(cells_across=8, cells_up=10, layers=2, thickness=12.0):
    """(points, hexahedra, regions): a triangular dam of 60 m on a block of rock, sharing the nodes of the base."""
    base, crest, height = 48.0, 8.0, 60.0
    xs = np.concatenate([np.linspace(-60, 0, 7)[:-1], np.linspace(0, base, cells_across + 1), np.linspace(base, 108, 7)[1:]])
    zs = np.linspace(-60, 0, 7)
    ys = np.linspace(0, thickness, layers + 1)
    points, number = [], {}

    def node(x, y, z):
        key = (round(x, 6), round(y, 6), round(z, 6))
        if key not in number:
            number[key] = len(points)
            points.append(key)
        return number[key]

    def fill(corner, across, up, region, elements, regions):
        for k in range(up):
            for j in range(layers):
                for i in range(across):
                    at = [(i, j, k), (i + 1, j, k), (i + 1, j + 1, k), (i, j + 1, k)]
                    elements.append([node(*corner(*c)) for c in at] + [node(*corner(a, b, c + 1)) for a, b, c in at])
                    regions.append(region)

    def dam_corner(i, j, k):
        z = height * k / cells_up
        width = max(crest, base + (crest - base) * z / (height - 10))
        return width * i / cells_across, ys[j], z

    elements, regions = [], []
    fill(dam_corner, cells_across, cells_up, 0, elements, regions)
    fill(lambda i, j, k: (xs[i], ys[j], zs[k]), len(xs) - 1, len(zs) - 1, 1, elements, regions)
    return np.array(points), np.array(elements), np.array(regions)


def write_grid(path, points, cells, vtk_type, fixed, steps, units):
    """One file in the layout of src/io/grid_file.hpp. `steps` is a list of (stage, load factor, {name: values})."""
    with h5py.File(path, "w") as file:
        file["VTKHDF/Points"] = points
        file["VTKHDF/Connectivity"] = cells.ravel().astype(np.int64)
        file["VTKHDF/Offsets"] = np.arange(len(cells) + 1, dtype=np.int64) * cells.shape[1]
        file["VTKHDF/Types"] = np.full(len(cells), vtk_type, np.uint8)
        point_data, cell_data = file.create_group("VTKHDF/PointData"), file.create_group("VTKHDF/CellData")
        for name, (values, names) in fixed.items():
            cell_data[name] = values.astype(np.int32)
            cell_data[name].attrs["names"] = names
        for number, (stage, load_factor, fields) in enumerate(steps, 1):
            group = file.create_group(f"Steps/{number:05d}")
            group.attrs.update({"stage": stage, "stage_number": number, "time": float(number),
                                "load_factor": load_factor, "stage_end": 1, "balanced": 1})
            for name, values in fields.items():
                group[name] = values
                place = point_data if len(values) == len(points) else cell_data
                if name not in place:
                    place[name] = values
                    place[name].attrs["unit"] = units[name]


def write_run(folder):
    """Writes the folder and returns what the fields are made of."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True)
    points, cells, regions = dam_on_rock()
    split = regions == 0  # every element of the dam has its own nodes, as a crackable body has
    block_cells = cells.copy()
    block_points = [points]
    count = len(points)
    for e in np.flatnonzero(split):
        block_points.append(points[cells[e]])
        block_cells[e] = np.arange(count, count + 8)
        count += 8
    block_points = np.concatenate(block_points)
    used = np.unique(block_cells)
    renumber = np.zeros(count, int)
    renumber[used] = np.arange(len(used))
    block_points, block_cells = block_points[used], renumber[block_cells]

    x, y, z = block_points.T
    settlement = np.stack([2e-3 * (z + 60) ** 2 / 120**2, 0 * x, -5e-3 * (z + 60) / 120], axis=1)
    summer, winter = 28 - 8 * np.exp(-((x / 12) ** 2)), 2 - 3 * np.exp(-(((x - 40) / 20) ** 2)) + 5 * (z < -30)
    opened = settlement.copy()
    crack = 12.0
    upper = np.zeros(len(block_points), bool)
    for e in np.flatnonzero(split):
        upper[block_cells[e]] = points[cells[e], 2].mean() > crack
    opened[upper, 2] += 2e-3 * (1 - x[upper] / 48)  # the part above z = 12 m tips: a crack open at the upstream face
    stress = np.zeros((len(cells), 6))
    stress[:, 2] = -2500 * 9.81 * (60 - points[cells].mean(axis=1)[:, 2])

    fields = {"displacement": settlement, "temperature": summer, "stress": stress}
    steps = [("gravity", 1.0, fields | {"temperature": 0 * x + 10}), ("summer", 1.0, fields),
             ("winter", 1.0, fields | {"temperature": winter}),
             ("fracture", 1.0, fields | {"temperature": winter, "displacement": opened})]
    units = {"displacement": "m", "temperature": "degC", "stress": "Pa", "opening": "m", "state": ""}
    write_grid(folder / "results.vtkhdf", block_points, block_cells, 12,
               {"region": (regions, ["dam", "rock"])}, steps, units)

    levels = np.unique(np.round(points[np.unique(cells[split])][:, 2], 6))[:-1]
    quads, places = [], []
    for e in np.flatnonzero(split):
        bottom = cells[e][[0, 1, 2, 3]]
        if points[bottom, 2].mean() in levels:
            quads.append(np.arange(4) + 4 * len(quads))
            places.append(points[bottom])
    quads, places = np.array(quads), np.concatenate(places)
    broken = ((abs(places[:, 2] - crack) < 1e-6) & (places[:, 0] < 30)).astype(np.uint8)
    opening = np.where(broken > 0, 2e-3 * (1 - places[:, 0] / 48), 0)
    write_grid(folder / "interfaces.vtkhdf", places, quads, 9, {},
               [(stage, 1.0, {"state": broken * (stage == "fracture"), "opening": opening * (stage == "fracture")})
                for stage in STAGES], units)

    (folder / "history_crest.csv").write_text(
        "stage,time,load_factor,balanced,displacement.x [m],displacement.z [m],temperature [degC]\n"
        "gravity,0,0,1,0,0,10\ngravity,1,1,1,0.002,-0.005,10\nsummer,2,1,1,0.002,-0.005,28\n"
        "fracture,4,1,1,0.004,-0.004,2\n",
        encoding="utf-8")
    (folder / "manifest.json").write_text(json.dumps({
        "model": {"name": "synthetic"}, "pictures": [], "histories": [{"name": "crest", "file": "history_crest.csv"}],
        "stages": [{"name": s, "kind": "thermal steady" if s in ("summer", "winter") else "static"} for s in STAGES],
    }), encoding="utf-8")
    return {"cracked_points": int(broken.sum()), "widest": float(opening.max()), "settlement": 5e-3}
