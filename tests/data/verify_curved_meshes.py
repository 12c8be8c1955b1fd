#!/usr/bin/python3
"""Writes the curved meshes of verification decks (Gmsh 2.2 ASCII) beside them, into decks/verify.

sphere_N_SHAPE.msh   octant of a thick sphere, radii 1 and 2: three patches of N x N x N cells; surfaces "inner", "outer"
Every mesh has a region "body". SHAPE is hex8, or wedge6 with each cell as two wedges.
"""
import math
import pathlib

from verify_patch_meshes import faces, wedges

FOLDER = pathlib.Path(__file__).resolve().parent.parent.parent / "decks" / "verify"


class Mesh:
    """Points, merged by place, and cells of the region "body"; surfaces are sets of outer faces."""

    def __init__(self):
        self.points, self.numbers, self.cells = [], {}, []

    def point(self, place):
        key = tuple(round(c * 1e7) for c in place)
        if key not in self.numbers:
            self.numbers[key] = len(self.points)
            self.points.append([0.0 if abs(c) < 1e-12 else c for c in place])
        return self.numbers[key]

    def patch(self, nx, ny, nz, place):
        """nx x ny x nz cells whose corners lie at place(i, j, k), a right-handed map or a left-handed one."""
        for k in range(nz):
            for j in range(ny):
                for i in range(nx):
                    low = [self.point(place(i + a, j + b, k)) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
                    high = [self.point(place(i + a, j + b, k + 1)) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
                    self.cells.append(low + high if self.upright(low, high) else high + low)

    def upright(self, low, high):
        a, b, c = ([q - p for p, q in zip(self.points[low[0]], self.points[n])] for n in (low[1], low[3], high[0]))
        return sum(c[i] * (a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2]) for i in range(3)) > 0

    def write(self, name, shape, surfaces=(), regions=()):
        """surfaces: {name: function(list of points) -> whether a face belongs}; regions: {name: cells} besides "body"."""
        body = [w for c in self.cells for w in wedges(c)] if shape == "wedge6" else self.cells
        volumes = {"body": body, **dict(regions)}
        count = {}
        for cells in volumes.values():
            for cell in cells:
                for face in faces(cell):
                    count.setdefault(tuple(sorted(face)), []).append(face)
        outer = [owners[0] for owners in count.values() if len(owners) == 1]
        names, elements = [], []
        for tag, (surface, belongs) in enumerate(dict(surfaces).items(), 1):
            names.append(f'2 {tag} "{surface}"')
            chosen = [f for f in outer if belongs([self.points[n] for n in f])]
            elements += [({3: 2, 4: 3}[len(f)], tag, f) for f in chosen]
        for tag, (region, cells) in enumerate(volumes.items(), len(names) + 1):
            names.append(f'3 {tag} "{region}"')
            elements += [({4: 4, 6: 6, 8: 5}[len(c)], tag, c) for c in cells]
        lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(names)), *names,
                 "$EndPhysicalNames", "$Nodes", str(len(self.points))]
        lines += ["%d %.10g %.10g %.10g" % (n, *p) for n, p in enumerate(self.points, 1)]
        lines += ["$EndNodes", "$Elements", str(len(elements))]
        lines += [" ".join(map(str, [n, kind, 2, tag, tag, *[m + 1 for m in nodes]]))
                  for n, (kind, tag, nodes) in enumerate(elements, 1)]
        (FOLDER / f"{name}_{shape}.msh").write_text("\n".join([*lines, "$EndElements", ""]), encoding="ascii")


def sphere(n):
    mesh = Mesh()
    for side in range(3):
        def place(i, j, k, side=side):
            u, v = math.tan(i / n * math.pi / 4), math.tan(j / n * math.pi / 4)
            ray = ((1, u, v), (v, 1, u), (u, v, 1))[side]
            return [(1 + k / n) * c / math.hypot(*ray) for c in ray]
        mesh.patch(n, n, n, place)
    on = lambda radius: lambda points: all(abs(math.hypot(*p) - radius) < 1e-6 for p in points)
    return mesh, {"inner": on(1), "outer": on(2)}


def main():
    for shape in ("hex8", "wedge6"):
        for n in (4, 8):
            mesh, surfaces = sphere(n)
            mesh.write(f"sphere_{n}", shape, surfaces)


if __name__ == "__main__":
    main()
