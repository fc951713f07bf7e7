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


def face_cells(piece):
    """The cells of two and three points, behind those of one, as lists of positions."""
    cells = []
    ids = vtk.vtkIdList()
    for i in range(piece.GetNumberOfVerts(), piece.GetNumberOfCells()):
        piece.GetCellPoints(i, ids)
        cells.append([ids.GetId(k) for k in range(ids.GetNumberOfIds())])
    return cells


def shape_of(pieces):
    """What the chunks have in common: balls by PoleId, faces between them."""
    balls = {}
    owned = set()
    repeated = 0
    faces = set()
    edges = set()
    root = {}

    def find(ball):
        while root.setdefault(ball, ball) != ball:
            root[ball] = ball = root[root[ball]]
        return ball

    for piece in pieces:
        data = piece.GetPointData()
        ids = data.GetArray("PoleId")
        names = [int(ids.GetTuple1(i)) for i in range(piece.GetNumberOfPoints())]
        if names != sorted(set(names)):
            sys.exit("PoleId does not ascend in a chunk")
        for i, name in enumerate(names):
            values = [data.GetArray(a).GetTuple1(i) for a in TYPES]
            ball = (piece.GetPoint(i), values)
            if balls.setdefault(name, ball) != ball:
                sys.exit(f"two balls of PoleId {name}")
            find(name)
            if i < piece.GetNumberOfVerts():
                if name in owned:
                    sys.exit(f"PoleId {name} is a vertex twice")
                owned.add(name)
            else:
                repeated += 1
        for cell in face_cells(piece):
            face = tuple(names[at] for at in cell)
            if face in faces or face != tuple(sorted(set(face))) or len(face) not in (2, 3):
                sys.exit(f"face {face}")
            if cell[0] >= piece.GetNumberOfVerts():
                sys.exit(f"face {face} does not begin in its chunk")
            faces.add(face)
            for a in range(len(face)):
                for b in range(a + 1, len(face)):
                    edges.add((face[a], face[b]))
                    root[find(face[a])] = find(face[b])
    if owned != set(balls):
        sys.exit("a ball is in no chunk of its own")
    lines = {face for face in faces if len(face) == 2}
    of_triangles = {(f[a], f[b]) for f in faces - lines for a, b in ((0, 1), (0, 2), (1, 2))}
    if lines & of_triangles:
        sys.exit("an edge of a triangle is a line as well")
    return {"balls": len(balls), "repeated": repeated, "lines": len(lines), "edges": len(edges),
            "triangles": len(faces) - len(lines), "pieces": len({find(b) for b in balls})}


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
    pieces = [read(vtk.vtkXMLPolyDataReader(), chunk) for chunk in chunks]
    for piece in pieces:
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
        "shape": shape_of(pieces) if data.GetArray("PoleId") else None,
        "balls": balls,
    }))


main()
