#!/usr/bin/python3
"""Writes the curved meshes of verification decks (Gmsh 2.2 ASCII) beside them, into decks/verify.

sphere_N_SHAPE.msh   octant of a thick sphere, radii 1 and 2: three patches of N x N x N cells; surfaces "inner", "outer"
le10_SHAPE.msh       NAFEMS LE10, quarter of an elliptic plate, finer towards point D; surfaces "top", "rim" and "knife"
le11_SHAPE.msh       NAFEMS LE11, quarter of a cylinder, taper and sphere
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


def le10(nr=12, nt=16, nz=4, thick=0.6):
    """Inner ellipse 2 x 1, outer one 3.25 x 2.75; cells grow away from D = (2, 0, thick)."""
    mesh = Mesh()

    def place(i, j, k):
        s, angle = (i / nr) ** 1.4, math.pi / 2 * (j / nt) ** 1.4
        return [(2 + 1.25 * s) * math.cos(angle), (1 + 1.75 * s) * math.sin(angle), thick * k / nz]
    mesh.patch(nr, nt, nz, place)
    # The plate rests on the middle line of its rim. Wedges that touch it along this line alone give it a surface to fix.
    holder = []
    for j in range(nt):
        ends = []
        for end in (j, j + 1):
            x, y, z = place(nr, end, nz / 2)
            ends.append([mesh.point((f * x, f * y, z - drop)) for f, drop in ((1, 0), (1.05, 0.1), (1.05, 0))])
        holder.append(ends[1] + ends[0])
    rim = lambda p: abs((p[0] / 3.25) ** 2 + (p[1] / 2.75) ** 2 - 1) < 1e-6
    outside = lambda p: (p[0] / 3.25) ** 2 + (p[1] / 2.75) ** 2 > 1 - 1e-6
    return mesh, {
        "top": lambda points: all(abs(p[2] - thick) < 1e-9 for p in points),
        "rim": lambda points: all(map(rim, points)),
        "knife": lambda points: all(map(outside, points)) and not all(map(rim, points)),
    }, {"holder": holder}


def le11(n=4):
    """Profile in (r, z), 0 to 4 along it: spherical, to the taper, to the cylinder, cylinder."""
    def profile(t):
        ray = lambda radius, degrees: (radius * math.cos(math.radians(degrees)), radius * math.sin(math.radians(degrees)))
        mix = lambda a, b, s: (a[0] + (b[0] - a[0]) * s, a[1] + (b[1] - a[1]) * s)
        d, f, g, top = ray(1.4, 30), (1.1062, 1.045), (1, 1.39), (1, 1.79)
        inner, end = ray(1, 45), (ray(1, 45)[0], 1.79)
        if t <= 1:
            return ray(1, 22.5 * t), ray(1.4, 30 * t)
        if t <= 2:
            return ray(1, 22.5 * t), mix(d, f, t - 1)
        if t <= 3:
            return mix(inner, end, (t - 2) / 2), mix(f, g, t - 2)
        return mix(inner, end, (t - 2) / 2), mix(g, top, t - 3)
    mesh = Mesh()

    def place(i, j, k):
        a, b = profile(j / n)
        r, z = (p + (q - p) * i / n for p, q in zip(a, b))
        angle = math.pi / 2 * k / (2 * n)
        return [r * math.cos(angle), r * math.sin(angle), z]
    mesh.patch(n, 4 * n, 2 * n, place)
    return mesh, {}


def main():
    for shape in ("hex8", "wedge6"):
        mesh, surfaces, regions = le10()
        mesh.write("le10", shape, surfaces, regions)
        mesh, surfaces = le11()
        mesh.write("le11", shape, surfaces)
        for n in (4, 8):
            mesh, surfaces = sphere(n)
            mesh.write(f"sphere_{n}", shape, surfaces)


if __name__ == "__main__":
    main()
