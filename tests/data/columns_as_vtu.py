#!/usr/bin/python3
"""Writes the columns as .vtu by VTK's own writer, from the ASCII Gmsh 4.1 files: one file per way to store arrays.

Regions and surfaces are numbered by the group of the geometric entity; points that no cell uses are left out.
"""
from pathlib import Path

import vtk

DATA = Path(__file__).resolve().parent
VTK_TYPE = {2: vtk.VTK_TRIANGLE, 3: vtk.VTK_QUAD, 4: vtk.VTK_TETRA, 5: vtk.VTK_HEXAHEDRON, 6: vtk.VTK_WEDGE}


def lines_of(text, section):
    return text.split(f"${section}\n")[1].split(f"$End{section}")[0].splitlines()


def read(path):
    text = path.read_text()
    lines = iter(lines_of(text, "Entities"))
    counts = [int(word) for word in next(lines).split()]
    group = {}
    for dimension, count in enumerate(counts):
        for _ in range(count):
            words = next(lines).split()
            first = 4 if dimension == 0 else 7
            if int(words[first]):
                group[dimension, int(words[0])] = abs(int(words[first + 1]))
    points = {}
    lines = iter(lines_of(text, "Nodes"))
    for _ in range(int(next(lines).split()[0])):
        count = int(next(lines).split()[3])
        ids = [int(next(lines)) for _ in range(count)]
        for number in ids:
            points[number] = [float(word) for word in next(lines).split()]
    cells = []
    lines = iter(lines_of(text, "Elements"))
    for _ in range(int(next(lines).split()[0])):
        dimension, entity, kind, count = (int(word) for word in next(lines).split())
        for _ in range(count):
            nodes = [int(word) for word in next(lines).split()[1:]]
            if kind in VTK_TYPE:
                cells.append((VTK_TYPE[kind], nodes, group[dimension, entity]))
    return points, cells


def main(shape, name, mode, encode):
    points, cells = read(DATA / f"column_{shape}_41.msh")
    used = {node for _, nodes, _ in cells for node in nodes}
    grid, vtk_points, place = vtk.vtkUnstructuredGrid(), vtk.vtkPoints(), {}
    vtk_points.SetDataTypeToDouble()
    for number, point in points.items():
        if number in used:
            place[number] = vtk_points.InsertNextPoint(point)
    grid.SetPoints(vtk_points)
    region = vtk.vtkIntArray()
    region.SetName("region")
    for kind, nodes, number in cells:
        grid.InsertNextCell(kind, len(nodes), [place[node] for node in nodes])
        region.InsertNextValue(number)
    grid.GetCellData().AddArray(region)
    writer = vtk.vtkXMLUnstructuredGridWriter()
    writer.SetInputData(grid)
    writer.SetFileName(str(DATA / name))
    writer.SetCompressorTypeToNone()
    writer.SetDataMode(mode)
    writer.SetEncodeAppendedData(encode)
    writer.Write()


if __name__ == "__main__":
    main("hex", "column_hex_ascii.vtu", vtk.vtkXMLWriter.Ascii, 0)
    main("hex", "column_hex_raw.vtu", vtk.vtkXMLWriter.Appended, 0)
    main("wedge", "column_wedge_base64.vtu", vtk.vtkXMLWriter.Appended, 1)
    main("tet", "column_tet_inline.vtu", vtk.vtkXMLWriter.Binary, 0)
