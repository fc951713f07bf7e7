"""Writes the cloud of io_reader_vtk_test.cpp with VTK's own writers, in every mode they have."""

import sys

try:
    import vtk
except ImportError:
    sys.exit(77)

FOLDER = sys.argv[1]
COUNT = 3000


def surface(scalar):
    points = vtk.vtkPoints()
    points.SetDataType(scalar)
    for i in range(COUNT):
        points.InsertNextPoint((i * 7919 % 1000) / 8, -(i * 104729 % 997) / 4, i)
    triangles = vtk.vtkCellArray()
    delta = vtk.vtkFloatArray()
    delta.SetName("Delta")
    source = vtk.vtkUnsignedCharArray()
    source.SetName("Source")
    for i in range(COUNT - 2):
        triangles.InsertNextCell(3)
        for corner in range(3):
            triangles.InsertCellPoint(i + corner)
        delta.InsertNextValue(i / 32)
        source.InsertNextValue(i % 2)
    ids = vtk.vtkIdTypeArray()
    ids.SetName("GlobalPointId")
    for i in range(COUNT):
        ids.InsertNextValue(3 * i)
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(triangles)
    data.GetCellData().AddArray(delta)
    data.GetCellData().AddArray(source)
    data.GetPointData().AddArray(ids)
    note = vtk.vtkStringArray()
    note.SetName("note")
    for text in ("two words", "", "x" * 100):
        note.InsertNextValue(text)
    data.GetFieldData().AddArray(note)
    time = vtk.vtkDoubleArray()
    time.SetName("TIME")
    time.SetNumberOfComponents(2)
    time.SetComponentName(0, "first part")
    time.InsertNextTuple2(0.5, 2)
    data.GetFieldData().AddArray(time)
    return data


def unstructured(data):
    grid = vtk.vtkUnstructuredGrid()
    grid.SetPoints(data.GetPoints())
    grid.SetCells(vtk.VTK_TRIANGLE, data.GetPolys())
    grid.SetFieldData(data.GetFieldData())
    return grid


def structured(data):
    grid = vtk.vtkStructuredGrid()
    grid.SetDimensions(COUNT // 100, 10, 10)
    grid.SetPoints(data.GetPoints())
    grid.SetFieldData(data.GetFieldData())
    return grid


def write_legacy(data, name):
    kinds = (
        ("poly", vtk.vtkPolyDataWriter, data),
        ("cells", vtk.vtkUnstructuredGridWriter, unstructured(data)),
        ("grid", vtk.vtkStructuredGridWriter, structured(data)),
    )
    for kind, writer_class, content in kinds:
        for binary in (False, True):
            for version in (42, 51):
                writer = writer_class()
                writer.SetInputData(content)
                mode = "binary" if binary else "ascii"
                writer.SetFileName(f"{FOLDER}/{name}_{kind}_{mode}_{version}.vtk")
                writer.SetFileVersion(version)
                if binary:
                    writer.SetFileTypeToBinary()
                writer.Write()


def write_xml(data, name):
    modes = (("ascii", 0, 0), ("base64", 1, 0), ("raw", 2, 0), ("appended64", 2, 1))
    compressors = (("none", None), ("zlib", vtk.vtkZLibDataCompressor), ("lz4", vtk.vtkLZ4DataCompressor))
    kinds = (
        ("poly.vtp", vtk.vtkXMLPolyDataWriter, data),
        ("cells.vtu", vtk.vtkXMLUnstructuredGridWriter, unstructured(data)),
    )
    for kind, writer_class, content in kinds:
        for mode, data_mode, encoded in modes:
            for compressor, compressor_class in compressors:
                for wide in (False, True):
                    writer = writer_class()
                    writer.SetInputData(content)
                    writer.SetDataMode(data_mode)
                    writer.SetEncodeAppendedData(encoded)
                    writer.SetCompressor(compressor_class() if compressor_class else None)
                    writer.SetBlockSize(1000)
                    if wide:
                        writer.SetHeaderTypeToUInt64()
                        writer.SetByteOrderToBigEndian()
                    ints = "wide_big" if wide else "narrow_little"
                    writer.SetFileName(f"{FOLDER}/{name}_{mode}_{compressor}_{ints}_{kind}")
                    writer.Write()


for scalar_name, scalar_type in (("float", vtk.VTK_FLOAT), ("double", vtk.VTK_DOUBLE)):
    cloud = surface(scalar_type)
    write_legacy(cloud, scalar_name)
    write_xml(cloud, scalar_name)
writer = vtk.vtkXMLPolyDataWriter()
writer.SetInputData(surface(vtk.VTK_FLOAT))
writer.SetCompressorTypeToLZMA()
writer.SetFileName(f"{FOLDER}/refused_lzma.vtp")
writer.Write()
