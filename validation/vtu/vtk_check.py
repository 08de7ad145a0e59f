"""Loads VTU files with VTK (the library ParaView is made of) and with meshio, and compares: python vtk_check.py FILE.vtu...

Set up once: python3 -m venv .venv && .venv/bin/pip install vtk==9.7.2 meshio==5.3.5 numpy==2.4.6
"""
import sys

import meshio
import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy


def arrays(data) -> dict:
    return {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)) for i in range(data.GetNumberOfArrays())}


def check(path: str) -> bool:
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    sizes = vtk.vtkCellSizeFilter()
    sizes.SetInputData(grid)
    sizes.Update()
    area = vtk_to_numpy(sizes.GetOutput().GetCellData().GetArray("Area")).sum()
    on_points, on_cells = arrays(grid.GetPointData()), arrays(grid.GetCellData())
    field = grid.GetFieldData()
    notes = {field.GetAbstractArray(i).GetName(): field.GetAbstractArray(i).GetValue(0)
             for i in range(field.GetNumberOfArrays())}
    print(f"{path}: VTK {vtk.vtkVersion.GetVTKVersion()}: {grid.GetNumberOfPoints()} points, "
          f"{grid.GetNumberOfCells()} cells of type {grid.GetCellType(0)}, area {area:.9g}, notes {notes}")
    for name, values in {**on_points, **on_cells}.items():
        print(f"  {name}: {values.shape}, {values.min():.6g} to {values.max():.6g}")
    # With the notes left out: meshio 5.3.5 reads no text arrays.
    other = meshio.read(path) if not notes else None
    fine = grid.GetNumberOfCells() > 0 and area > 0
    if other is not None:
        same = all(numpy.array_equal(other.point_data[name].squeeze(), values) for name, values in on_points.items())
        fine &= bool(same and len(other.points) == grid.GetNumberOfPoints())
        print(f"  meshio {meshio.__version__} agrees: {same}")
    return fine


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    sys.exit(0 if all([check(path) for path in sys.argv[1:]]) else 1)
