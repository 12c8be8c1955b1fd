#!/usr/bin/python3
"""Writes the meshes of the patch test, verify_patch_{hex8,wedge6,tet4}.msh (Gmsh 2.2 ASCII).

3 x 3 x 3 cells of the unit cube with moved inner nodes; each cell a hexahedron, two wedges or six tetrahedra.
Region "body", surface "outside". Inner nodes are printed as the decks list them.
"""
import math
import pathlib

HEX_FACES = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]


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
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "2", '2 2 "outside"', '3 1 "body"',
             "$EndPhysicalNames", "$Nodes", str(len(points))]
    lines += ["%d %.12g %.12g %.12g" % (i + 1, *p) for i, p in enumerate(points)]
    lines += ["$EndNodes", "$Elements", str(len(outside) + len(cells))]
    number = 0
    for kind, tag, items in (({3: 2, 4: 3}, 2, outside), ({4: 4, 6: 6, 8: 5}, 1, cells)):
        for item in items:
            number += 1
            lines.append(" ".join(map(str, [number, kind[len(item)], 2, tag, tag, *[n + 1 for n in item]])))
    path.write_text("\n".join([*lines, "$EndElements", ""]), encoding="ascii")
    on_outside = {n for face in outside for n in face}
    return [p for n, p in enumerate(points) if n not in on_outside]


def main():
    folder = pathlib.Path(__file__).parent
    points, hexes = grid()
    for shape, split in (("hex8", lambda h: [h]), ("wedge6", wedges), ("tet4", tetrahedra)):
        inner = write(folder / f"verify_patch_{shape}.msh", points, [c for h in hexes for c in split(h)])
    for p in inner:
        print("{ %.12f, %.12f, %.12f }," % p)


if __name__ == "__main__":
    main()
