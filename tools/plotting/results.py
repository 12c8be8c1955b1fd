"""Reads the folder of a run: manifest.json, fields (VTKHDF), interfaces, histories."""
import csv
import dataclasses
import json
import pathlib

import h5py
import numpy as np

from plotting.geometry import Polygons


class ResultsError(Exception):
    """The folder is no run, or lacks what was asked for; the message says what there is."""


@dataclasses.dataclass
class Mesh:
    points: np.ndarray        # [nodes, 3] m
    connectivity: np.ndarray
    offsets: np.ndarray       # [elements + 1]
    types: np.ndarray         # [elements] VTK cell types
    regions: np.ndarray       # [elements] index into region_names
    region_names: list


@dataclasses.dataclass
class Output:
    """One moment that fields were written at."""
    step: str                 # name of its group, "00001"
    stage: str
    time: float
    load_factor: float
    balanced: bool            # False: the last state of a stage that failed

    @property
    def words(self):
        return (f"stage {self.stage}" + (f" (load factor {self.load_factor:.3g})" if self.load_factor < 1 else "")
                + ("" if self.balanced else ", NOT in balance"))


class Faces(Polygons):
    """Interface faces at one moment; points are contact points."""

    def __init__(self, points, connectivity, offsets, state, opening):
        super().__init__(connectivity, connectivity, np.zeros(len(connectivity)), offsets, np.arange(len(offsets) - 1))
        self.points = points
        self.state = state        # [points] 0: intact
        self.opening = opening    # [points] m
        corners, edges = points[connectivity], self.edges()
        vectors = np.add.reduceat(np.cross(corners[edges[:, 0]], corners[edges[:, 1]]), offsets[:-1], axis=0)
        self.area = np.linalg.norm(vectors, axis=1) / 2
        self.cracked_share = self.mean((state[connectivity] > 0).astype(float))


@dataclasses.dataclass
class History:
    name: str
    columns: list             # "displacement.x", ...
    units: dict               # column -> unit
    stages: list              # [rows]
    time: np.ndarray          # [rows]
    load_factor: np.ndarray   # [rows]
    balanced: np.ndarray      # [rows] False: the last state of a stage that failed
    values: dict              # column -> [rows]

    @property
    def stage_ends(self):
        """(time, stage) of the last row of each stage."""
        return list({stage: (time, stage) for time, stage in zip(self.time, self.stages)}.values())

    @property
    def seconds(self):
        """Since the stage began, [rows]; zeros where no stage takes time."""
        return self.values.get("seconds", np.zeros(len(self.time)))

    def rows_of(self, stage):
        return np.array([s == stage for s in self.stages])

    @property
    def stages_with_a_way(self):
        """Stages that were recorded on their way, not only at their end (the first row of all is the start)."""
        names = self.stages[1:]
        return [stage for stage in dict.fromkeys(names) if names.count(stage) > 1]


class Run:
    """The folder that `ashlar run` wrote."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        try:
            self.manifest = json.loads((self.folder / "manifest.json").read_text(encoding="utf-8"))
            self.file = h5py.File(self.folder / "results.vtkhdf", "r")
        except (OSError, ValueError) as error:
            raise ResultsError(f"{folder} is no folder of results: {error}") from error
        self.name = self.manifest["model"]["name"]
        self.mesh = self.read_mesh()
        self.outputs = [Output(name, text(group.attrs["stage"]), group.attrs["time"], group.attrs["load_factor"],
                               bool(group.attrs["balanced"]))
                        for name, group in sorted(self.file["Steps"].items())]

    def read_mesh(self):
        group = self.file["VTKHDF"]
        regions = group["CellData/region"]
        return Mesh(group["Points"][()], group["Connectivity"][()], group["Offsets"][()], group["Types"][()],
                    regions[()], [text(name) for name in regions.attrs["names"]])

    def output(self, stage):
        """The last output of a stage; of the run if `stage` is empty."""
        found = [o for o in self.outputs if not stage or o.stage == stage]
        if not found:
            stages = list(dict.fromkeys(o.stage for o in self.outputs))
            raise ResultsError(f"no output of a stage '{stage}'; stages: " + ", ".join(stages))
        return found[-1]

    def field(self, name, output):
        """("point" or "cell", values) at one output."""
        step = self.file["Steps"][output.step]
        if name not in step:
            raise ResultsError(f"the results hold no field '{name}'; fields: " + ", ".join(sorted(step)))
        return ("point" if name in self.file["VTKHDF/PointData"] else "cell"), step[name][()]

    def has_interfaces(self):
        return (self.folder / "interfaces.vtkhdf").exists()

    def interfaces(self, output):
        """The interface faces at one output."""
        if not self.has_interfaces():
            raise ResultsError("the results hold no interfaces: the deck has no joint and no crackable region")
        with h5py.File(self.folder / "interfaces.vtkhdf", "r") as file:
            group = file["VTKHDF"]
            step = file["Steps"][output.step]
            return Faces(group["Points"][()], group["Connectivity"][()], group["Offsets"][()], step["state"][()],
                         step["opening"][()])

    def history(self, name):
        """One history as its file holds it."""
        files = {h["name"]: h["file"] for h in self.manifest["histories"]}
        if name not in files:
            raise ResultsError(f"no history '{name}'; histories: " + ", ".join(files))
        with open(self.folder / files[name], encoding="utf-8", newline="") as file:
            head, *rows = csv.reader(file)
        if not rows:
            raise ResultsError(f"history '{name}' has no rows yet")
        numbers = np.array([[float(cell) for cell in row[1:]] for row in rows])
        titles = [title.rstrip("]").partition(" [") for title in head[4:]]
        columns = [title[0] for title in titles]
        return History(name, columns, {title[0]: title[2] for title in titles}, [row[0] for row in rows],
                       numbers[:, 0], numbers[:, 1], numbers[:, 2] != 0,
                       {column: numbers[:, 3 + i] for i, column in enumerate(columns)})

    def thermal_stages(self):
        return [s["name"] for s in self.manifest["stages"] if s["kind"].startswith("thermal")]


def text(value):
    return value.decode("utf-8") if isinstance(value, bytes) else str(value)
