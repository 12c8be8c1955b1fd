#!/usr/bin/python3
"""Writes the distorted cubes of the patch tests, verify_patch_{seven,grid}_{hex8,wedge6,tet4}.msh (Gmsh 2.2 ASCII).

seven: a cube in a cube and the six pieces around it (MacNeal and Harder 1985)
grid:  3 x 3 x 3 cells of the unit cube with moved inner nodes
Region "body", surface "outside". Inner nodes are printed as the decks list them.
"""
import math
import pathlib

INNER = [(.249, .342, .192), (.826, .288, .288), (.850, .649, .263), (.273, .750, .230),
         (.320, .186, .643), (.677, .305, .683), (.788, .693, .644), (.165, .745, .702)]
UNIT = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
HEX_FACES = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]


def seven():
    """Corners 0-7 outside, 8-15 inside. The first five hexahedra of the list stand so that a cut of their bottom and top
    along 0-2 gives wedges that fit: inner and upper and lower pieces along z, the ring around them along the ring."""
    inside = list(range(8, 16))
    hexes = [inside, [0, 1, 2, 3, *inside[:4]], [*inside[4:], 4, 5, 6, 7]]
    for i in range(4):  # the ring: from one inner upright edge to the next, bottom = the side towards corner i
        j = (i + 1) % 4
        hexes.append([8 + i, i, 4 + i, 12 + i, 8 + j, j, 4 + j, 12 + j])
    return [tuple(map(float, p)) for p in UNIT] + INNER, hexes


def grid():
    points, hexes = [], []
    for n in range(64):
        at = (n % 4, n // 4 % 4, n // 16)
        move = (0.08 * math.sin(1.7 * n), 0.08 * math.sin(2.9 * n + 1), 0.08 * math.sin(4.1 * n + 2))
        inner = all(0 < c < 3 for c in at)
        points.append(tuple(c / 3 + inner * m for c, m in zip(at, move)))
    for n in range(64):
        if n % 4 < 3 and n // 4 % 4 < 3 and n // 16 < 3:
            hexes.append([n, n + 1, n + 5, n + 4, n + 16, n + 17, n + 21, n + 20])
    return points, hexes


def wedges(h):
    return [[h[0], h[1], h[2], h[4], h[5], h[6]], [h[0], h[2], h[3], h[4], h[6], h[7]]]


def tetrahedra(h):
    """The smallest node joined to the halves of the three faces without it, each cut from its smallest node."""
    apex, cells = min(h), []
    for face in HEX_FACES:
        quad = [h[i] for i in face]
        if apex not in quad:
            k = quad.index(min(quad))
            a, b, c, d = quad[k:] + quad[:k]
            cells += [[a, c, b, apex], [a, d, c, apex]]
    return cells


def faces(cell):
    local = {8: HEX_FACES, 6: [(0, 2, 1), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)],
             4: [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]}[len(cell)]
    return [[cell[i] for i in face] for face in local]


def write(path, points, cells):
    owners = {}
    for cell in cells:
        for face in faces(cell):
            owners.setdefault(tuple(sorted(face)), []).append(face)
    assert all(len(o) <= 2 for o in owners.values())
    outside = [o[0] for o in owners.values() if len(o) == 1]
    gmsh = {3: 2, 4: 3}, {4: 4, 6: 6, 8: 5}
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "2", '2 2 "outside"', '3 1 "body"',
             "$EndPhysicalNames", "$Nodes", str(len(points))]
    lines += ["%d %.12g %.12g %.12g" % (i + 1, *p) for i, p in enumerate(points)]
    lines += ["$EndNodes", "$Elements", str(len(outside) + len(cells))]
    number = 0
    for kind, tag, items in ((gmsh[0], 2, outside), (gmsh[1], 1, cells)):
        for item in items:
            number += 1
            lines.append(" ".join(map(str, [number, kind[len(item)], 2, tag, tag, *[n + 1 for n in item]])))
    path.write_text("\n".join([*lines, "$EndElements", ""]), encoding="ascii")
    on_outside = {n for face in outside for n in face}
    return [p for n, p in enumerate(points) if n not in on_outside]


def main():
    folder = pathlib.Path(__file__).parent
    for name, (points, hexes) in (("seven", seven()), ("grid", grid())):
        for shape, split in (("hex8", lambda h: [h]), ("wedge6", wedges), ("tet4", tetrahedra)):
            inner = write(folder / f"verify_patch_{name}_{shape}.msh", points, [c for h in hexes for c in split(h)])
        print(name, ", ".join("{ %.12g, %.12g, %.12g }" % p for p in inner))


if __name__ == "__main__":
    main()
