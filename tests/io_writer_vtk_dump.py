"""Opens a surface with VTK's own reader and writes its arrays as raw bytes.

Usage: io_writer_vtk_dump.py SURFACE OUTPUT_FOLDER
One file per array: points, triangles, point_ids, delta, source, closure. Exits with 77 where VTK is missing.
"""
import array
import pathlib
import sys

try:
    import vtk
except ImportError:
    print("the Python module vtk is missing")
    sys.exit(77)

READERS = {
    ".pvtp": vtk.vtkXMLPPolyDataReader,
    ".vtp": vtk.vtkXMLPolyDataReader,
    ".vtk": vtk.vtkPolyDataReader,
    ".ply": vtk.vtkPLYReader,
}


class Failures:
    """Collects what a reader complains about: VTK prints errors and goes on."""

    def __init__(self):
        self.messages = []

    def __call__(self, _caller, _event, message=""):
        self.messages.append(message)

    __call__.CallDataType = vtk.VTK_STRING


def main():
    surface, folder = map(pathlib.Path, sys.argv[1:])
    reader = READERS[surface.suffix]()
    failures = Failures()
    reader.AddObserver("ErrorEvent", failures.__call__)
    reader.SetFileName(str(surface))
    reader.Update()
    mesh = reader.GetOutput()

    triangles = array.array("q")
    corners = vtk.vtkIdList()
    for cell in range(mesh.GetNumberOfCells()):
        mesh.GetCellPoints(cell, corners)
        triangles.extend(corners.GetId(i) for i in range(corners.GetNumberOfIds()))
    arrays = {
    "points" : mesh.GetPoints().GetData() if mesh.GetPoints() else None,
        "point_ids" : mesh.GetPointData().GetGlobalIds(),
        "delta" : mesh.GetCellData().GetArray("Delta"),
        "source" : mesh.GetCellData().GetArray("Source"),
        "closure" : mesh.GetCellData().GetArray("Closure"),
    }
    for name, values in arrays.items():
        some = values is not None and values.GetNumberOfValues() > 0
        (folder / name).write_bytes(memoryview(values).tobytes() if some else b"")
        print(name, values.GetClassName() if values else "missing")
    (folder / "triangles").write_bytes(triangles.tobytes())
    if failures.messages:
        sys.exit("VTK: " + "; ".join(failures.messages))


main()
