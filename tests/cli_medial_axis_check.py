"""Opens a medial axis with VTK's own readers and prints what it holds as JSON.

Usage: cli_medial_axis_check.py INDEX.pvtp POINTS.f64
Exits with 77 where VTK is missing, with a message where VTK complains or an array is missing.
"""
import array
import json
import math
import pathlib
import sys

try:
    import vtk
except ImportError:
    print("the Python module vtk is missing")
    sys.exit(77)

TYPES = {
    "Radius": "vtkDoubleArray",
    "Angle": "vtkFloatArray",
    "Label": "vtkUnsignedCharArray",
    "GlobalPointId": "vtkTypeInt64Array",
}


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


def main():
    index, cloud = map(pathlib.Path, sys.argv[1:])
    points = array.array("d", cloud.read_bytes())
    whole = read(vtk.vtkXMLPPolyDataReader(), index)
    data = whole.GetPointData()
    arrays = {name: data.GetArray(name) for name in TYPES}
    for name, values in arrays.items():
        if values is None:
            sys.exit(f"no array {name}")
        if name == "GlobalPointId":
            if values.GetDataTypeSize() != 8:
                sys.exit("GlobalPointId has no 64 bits")
        elif values.GetClassName() != TYPES[name]:
            sys.exit(f"{name} is a {values.GetClassName()}")
    balls = []
    off = 0.0
    for i in range(whole.GetNumberOfPoints()):
        centre = whole.GetPoint(i)
        radius = arrays["Radius"].GetValue(i)
        at = 3 * int(arrays["GlobalPointId"].GetTuple1(i))
        off = max(off, abs(math.dist(centre, points[at : at + 3]) - radius) / radius)
        balls.append([*centre, radius, arrays["Angle"].GetValue(i), arrays["Label"].GetValue(i)])
    chunks = sorted(index.with_suffix("").iterdir())
    vertices = 0
    for chunk in chunks:
        piece = read(vtk.vtkXMLPolyDataReader(), chunk)
        vertices += piece.GetNumberOfVerts()
        cell = vtk.vtkIdList()
        for i in range(piece.GetNumberOfVerts()):
            piece.GetCellPoints(i, cell)
            if cell.GetNumberOfIds() != 1 or cell.GetId(0) != i:
                sys.exit(f"vertex {i} is not point {i}")
    print(json.dumps({
        "chunks": len(chunks),
        "vertices": vertices,
        "cells_by_index": whole.GetNumberOfCells(),
        "off_sample": off,
        "balls": balls,
    }))


main()
