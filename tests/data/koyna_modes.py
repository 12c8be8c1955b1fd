#!/usr/bin/python3
"""Natural frequencies of a dam on a rigid base by an independent program: the reference of decks/dam/koyna.lua.

koyna_modes.py RUN      RUN is a finished run of the deck; only its mesh is read

Textbook hexahedra of 2x2x2 Gauss points, an assembled stiffness, lumped mass (integral of N), inverse iteration in a
subspace. Nothing here comes from the engine.
"""
import pathlib
import sys

import h5py
import numpy

YOUNG, POISSON, DENSITY = 31.027e9, 0.15, 2643.0
MODES = 4


def gauss_points():
    side = numpy.array([[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1],
                        [-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]], float)
    for at in side / numpy.sqrt(3):
        one = 1 + side * at
        local = numpy.stack([side[:, 0] * one[:, 1] * one[:, 2], side[:, 1] * one[:, 0] * one[:, 2],
                             side[:, 2] * one[:, 0] * one[:, 1]], 1) / 8
        yield one.prod(1) / 8, local


def element(x):
    """Stiffness [24, 24] and lumped mass [8] of one element."""
    lame, shear = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON)), YOUNG / (2 * (1 + POISSON))
    law = numpy.diag([2 * shear] * 3 + [shear] * 3)
    law[:3, :3] += lame
    stiffness, mass = numpy.zeros((24, 24)), numpy.zeros(8)
    for shape, local in gauss_points():
        jacobian = local.T @ x
        det = numpy.linalg.det(jacobian)
        g = local @ numpy.linalg.inv(jacobian).T
        strain = numpy.zeros((6, 8, 3))
        for row, (i, j) in enumerate([(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)]):
            strain[row, :, i] = g[:, j]
            strain[row, :, j] = g[:, i]
        strain = strain.reshape(6, 24)
        stiffness += strain.T @ law @ strain * det
        mass += DENSITY * shape * det
    return stiffness, mass


def main(run):
    with h5py.File(pathlib.Path(run) / "results.vtkhdf") as file:
        points = file["VTKHDF/Points"][()]
        corners = file["VTKHDF/Connectivity"][()].reshape(-1, 8)
    size = 3 * len(points)
    stiffness, mass = numpy.zeros((size, size)), numpy.zeros(size)
    for nodes in corners:
        k, m = element(points[nodes])
        rows = (3 * nodes[:, None] + numpy.arange(3)).ravel()
        stiffness[numpy.ix_(rows, rows)] += k
        mass[rows] += numpy.repeat(m, 3)
    free = numpy.ones(size, bool)
    free[1::3] = points[:, 1] > 1e-9  # the deck holds the middle of the slice
    free[numpy.repeat(points[:, 2] < 1e-9, 3)] = False
    stiffness, mass = stiffness[numpy.ix_(free, free)], mass[free]
    compliance = numpy.linalg.inv(stiffness)
    rng = numpy.random.default_rng(1)
    shapes = rng.normal(size=(len(mass), 2 * MODES))
    for _ in range(60):
        shapes, _ = numpy.linalg.qr(compliance @ (mass[:, None] * shapes))
    reduced_k, reduced_m = shapes.T @ stiffness @ shapes, shapes.T @ (mass[:, None] * shapes)
    omega = numpy.sqrt(numpy.sort(numpy.linalg.eigvals(numpy.linalg.solve(reduced_m, reduced_k)).real))[:MODES]
    print("rad/s:", " ".join(f"{w:.5f}" for w in omega))


if __name__ == "__main__":
    sys.exit(__doc__) if len(sys.argv) != 2 else main(sys.argv[1])
