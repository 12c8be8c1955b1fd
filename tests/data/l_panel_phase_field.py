#!/usr/bin/python3
"""Crack path of Winkler's L-shaped panel by the phase-field regularized cohesive zone model, independent of the engine.

Wu 2017 (J. Mech. Phys. Solids 103), linear softening, Rankine's effective stress, plane stress, displacement and damage
in turns, bilinear quadrilaterals. Length 10 mm on elements of 2.5 mm. Prints how far the middle of the crack lies above
the inner corner, mm, and the force, N. About ten minutes on a core: l_panel_phase_field.py [LENGTH] [SIZE] [MOVEMENT]
"""
import sys

import numpy as np
import scipy.sparse as sparse
from scipy.sparse.linalg import spsolve

YOUNG, POISSON, TENSILE, ENERGY, THICK = 25850.0, 0.18, 2.7, 0.065, 100.0  # N, mm
PLACES = (25, 50, 75, 100, 150)


def lines(start, parts):
    """Coordinates from `start` to the end of each part in steps of about its size."""
    at = [float(start)]
    for end, size in parts:
        at.extend(np.linspace(at[-1], end, max(1, round((end - at[-1]) / size)) + 1)[1:])
    return np.array(at)


def panel(size):
    """Points [n, 2] and quadrilaterals [m, 4]."""
    x = lines(0, [(250, size), (260, size), (290, 2 * size), (470, 10), (500, 10)])
    z = lines(0, [(200, 10), (235, 2 * size), (250, size), (370, size), (400, 2 * size), (500, 10)])
    number, points, quads = {}, [], []

    def node(i, j):
        if (i, j) not in number:
            number[i, j] = len(points)
            points.append((x[i], z[j]))
        return number[i, j]

    for i in range(len(x) - 1):
        for j in range(len(z) - 1):
            if x[i] < 250 - 1e-9 or z[j] > 250 - 1e-9:
                quads.append([node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)])
    return np.array(points), np.array(quads)


class Gauss:
    """One Gauss point of every quadrilateral."""

    def __init__(self, points, quads, r, s, elasticity):
        self.shape = np.array([(1 - r) * (1 - s), (1 + r) * (1 - s), (1 + r) * (1 + s), (1 - r) * (1 + s)]) / 4
        by_parameter = np.array([[s - 1, 1 - s, 1 + s, -1 - s], [r - 1, -1 - r, 1 + r, 1 - r]]) / 4
        jacobian = by_parameter @ points[quads]
        self.area = np.linalg.det(jacobian)
        gradient = np.linalg.inv(jacobian) @ by_parameter
        strain = np.zeros((len(quads), 3, 8))
        strain[:, 0, 0::2] = strain[:, 2, 1::2] = gradient[:, 0]
        strain[:, 1, 1::2] = strain[:, 2, 0::2] = gradient[:, 1]
        self.stress = elasticity @ strain
        self.stiffness = np.swapaxes(strain, 1, 2) @ self.stress * self.area[:, None, None]
        self.laplace = np.swapaxes(gradient, 1, 2) @ gradient * self.area[:, None, None]
        self.drive = np.full(len(quads), TENSILE**2 / (2 * YOUNG))  # largest so far

    def driven(self, u):
        s = np.einsum("eab,eb->ea", self.stress, u)
        largest = (s[:, 0] + s[:, 1]) / 2 + np.hypot((s[:, 0] - s[:, 1]) / 2, s[:, 2])
        return np.maximum(self.drive, np.maximum(largest, 0) ** 2 / (2 * YOUNG))


def softening(d, a):
    """Share of stiffness left and its two derivatives."""
    q, dq = a * d * (1 - d / 2), a * (1 - d)
    p, dp = (1 - d) ** 2, -2 * (1 - d)
    both, change = p + q, dp * q - p * dq
    return p / both, change / both**2, (2 * q + p * a) / both**2 - 2 * change * (dp + dq) / both**3


def main():
    length, size, end = (float(v) for v in (sys.argv[1:] + ["10", "2.5", "0.3"][len(sys.argv) - 1:]))
    points, quads = panel(size)
    elasticity = YOUNG / (1 - POISSON**2) * np.array([[1, POISSON, 0], [POISSON, 1, 0], [0, 0, (1 - POISSON) / 2]])
    g = 1 / np.sqrt(3)
    gauss = [Gauss(points, quads, r, s, elasticity) for r, s in ((-g, -g), (g, -g), (g, g), (-g, g))]
    count = len(points)
    dofs = np.stack([2 * quads, 2 * quads + 1], -1).reshape(len(quads), 8)
    rows, columns = np.repeat(dofs, 8, 1).ravel(), np.tile(dofs, (1, 8)).ravel()
    damage_rows, damage_columns = np.repeat(quads, 4, 1).ravel(), np.tile(quads, (1, 4)).ravel()
    foot = np.flatnonzero(points[:, 1] < 1e-9)
    pushed = 2 * np.flatnonzero((abs(points - (470, 250)) < 1e-6).all(1))[0] + 1
    free = np.setdiff1d(np.arange(2 * count), np.concatenate([2 * foot, 2 * foot + 1, [pushed]]))
    a = 4 * YOUNG * ENERGY / TENSILE**2 / (np.pi * length)
    stiff, local = 2 * length * ENERGY / np.pi, ENERGY / (np.pi * length)
    u, d = np.zeros(2 * count), np.zeros(count)
    for move in np.arange(0.00375, end + 1e-9, 0.00375):
        for _ in range(150):
            parts = sum(p.stiffness * np.maximum(softening(d[quads] @ p.shape, a)[0], 1e-6)[:, None, None] for p in gauss)
            matrix = sparse.csr_matrix((parts.ravel(), (rows, columns)), (2 * count, 2 * count)).tocsc()
            u[:], u[pushed] = 0, move
            u[free] = spsolve(matrix[free][:, free], -(matrix @ u)[free])
            drive = [p.driven(u[dofs]) for p in gauss]
            before = d.copy()
            for _ in range(30):
                residual, tangent = np.zeros(quads.shape), np.zeros((len(quads), 4, 4))
                for p, driven in zip(gauss, drive):
                    there = d[quads] @ p.shape
                    _, slope, bend = softening(there, a)
                    residual += ((slope * driven + local * (2 - 2 * there)) * p.area)[:, None] * p.shape
                    residual += stiff * np.einsum("eij,ej->ei", p.laplace, d[quads])
                    own = np.maximum(bend * driven - 2 * local, 0) + 1e-9
                    tangent += stiff * p.laplace + (own * p.area)[:, None, None] * np.outer(p.shape, p.shape)
                total = np.bincount(quads.ravel(), residual.ravel(), count)
                moves = np.flatnonzero((d > 1e-12) | (total < 0))
                matrix_d = sparse.csr_matrix((tangent.ravel(), (damage_rows, damage_columns)), (count, count)).tocsc()
                new = d.copy()
                new[moves] = np.clip(d[moves] - spsolve(matrix_d[moves][:, moves], total[moves]), 0, 1)
                change, d = abs(new - d).max(), new
                if change < 1e-4:
                    break
            if abs(d - before).max() < 2e-3:
                break
        for p, driven in zip(gauss, drive):
            p.drive = driven
        print(f"{move:.4f} mm {(matrix @ u)[pushed] * THICK:7.0f} N", path(points, d), flush=True)


def path(points, d):
    told = []
    for place in PLACES:
        x = points[np.argmin(abs(points[:, 0] - 250 + place)), 0]
        column = abs(points[:, 0] - x) < 1e-6
        weight = np.where(d[column] > 0.8 * d[column].max(), d[column], 0)
        if weight.max() > 0.3:
            told.append(f"{(weight * points[column, 1]).sum() / weight.sum() - 250:.1f} at {250 - x:.0f}")
    return ", ".join(told)


if __name__ == "__main__":
    main()
