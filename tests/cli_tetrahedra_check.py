"""Opens tetrahedra with VTK's own readers and prints what they hold as JSON.

Usage: cli_tetrahedra_check.py INDEX.pvtu POINTS.f64
Exits with 77 where VTK is missing, with a message where VTK complains or a point is not bit-equal to
the input's of that index.
"""
import array
import json
import pathlib
import sys

try:
    import vtk
except ImportError:
    print("the Python module vtk is missing")
    sys.exit(77)

MASK = (1 << 64) - 1


def splitmix64(x):
    x = (x + 0x9E3779B97F4A7C15) & MASK
    x = ((x ^ (x >> 30)) * 0xBF58476D1CE4E5B9) & MASK
    x = ((x ^ (x >> 27)) * 0x94D049BB133111EB) & MASK
    return x ^ (x >> 31)


def digest_of(corners):
    value = 0
    for corner in sorted(corners):
        value = splitmix64(value ^ corner)
    return value


def read(reader, path):
    messages = []

    def complain(_caller, _event, message=""):
        messages.append(message)

    complain.CallDataType = vtk.VTK_STRING
    reader.AddObserver("ErrorEvent", complain)
    reader.SetFileName(str(path))
    reader.Update()
    if messages:
        sys.exit("VTK: " + "; ".join(messages))
    return reader.GetOutput()


class Totals:
    def __init__(self, points):
        self.points = points
        self.cells = 0
        self.digest = 0
        self.not_positive = 0
        self.unused_points = 0

    def add(self, grid):
        ids = grid.GetPointData().GetGlobalIds()
        coordinates = [grid.GetPoint(i) for i in range(grid.GetNumberOfPoints())]
        for i, point in enumerate(coordinates):
            at = 3 * int(ids.GetValue(i))
            if tuple(self.points[at : at + 3]) != point:
                sys.exit(f"point {i} is not point {at // 3} of the input")
        used = set()
        corners = vtk.vtkIdList()
        for cell in range(grid.GetNumberOfCells()):
            if grid.GetCellType(cell) != vtk.VTK_TETRA:
                sys.exit(f"cell {cell} is no tetrahedron")
            grid.GetCellPoints(cell, corners)
            local = [corners.GetId(i) for i in range(4)]
            used.update(local)
            volume = vtk.vtkTetra.ComputeVolume(*(coordinates[i] for i in local))
            self.not_positive += volume <= 0
            self.digest += digest_of(int(ids.GetValue(i)) for i in local)
        self.cells += grid.GetNumberOfCells()
        self.unused_points += len(coordinates) - len(used)


def main():
    index, cloud = map(pathlib.Path, sys.argv[1:])
    points = array.array("d", cloud.read_bytes())
    whole = read(vtk.vtkXMLPUnstructuredGridReader(), index)
    totals = Totals(points)
    chunks = sorted(index.with_suffix("").iterdir())
    for chunk in chunks:
        totals.add(read(vtk.vtkXMLUnstructuredGridReader(), chunk))
    print(json.dumps({
        "chunks": len(chunks),
        "cells_by_index": whole.GetNumberOfCells(),
        "cells": totals.cells,
        "digest": f"{totals.digest & MASK:016x}",
        "not_positive": totals.not_positive,
        "unused_points": totals.unused_points,
    }))


main()
