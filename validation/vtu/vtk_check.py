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
    notes, legend = facts(arrays(grid.GetFieldData()))
    print(f"{path}: VTK {vtk.vtkVersion.GetVTKVersion()}: {grid.GetNumberOfPoints()} points, "
          f"{grid.GetNumberOfCells()} cells of type {grid.GetCellType(0)}, area {area:.9g}, notes {notes}, legend {legend}")
    for name, values in {**on_points, **on_cells}.items():
        print(f"  {name}: {values.shape}, {numpy.nanmin(values):.6g} to {numpy.nanmax(values):.6g}")
    other = meshio.read(path)
    same = all(equal(other.point_data[name], values) for name, values in on_points.items())
    same &= all(equal(other.cell_data[name][0], values) for name, values in on_cells.items())
    same &= facts(other.field_data) == (notes, legend) and len(other.points) == grid.GetNumberOfPoints()
    named = set(on_cells.get("region", [])) <= {number for name, number in legend.items() if name.startswith("region: ")}
    print(f"  meshio {meshio.__version__} agrees: {same}; every region has a name: {named}")
    return bool(grid.GetNumberOfCells() > 0 and area > 0 and same and named)


def facts(fields: dict) -> tuple[dict, dict]:
    """Texts, kept as the codes of their UTF-8, and the names of the numbers of label fields."""
    notes = {name: bytes(values).decode() for name, values in fields.items() if values.dtype == numpy.uint8}
    legend = {name: int(numpy.squeeze(values)) for name, values in fields.items() if values.dtype == numpy.int32}
    return notes, legend


def equal(left, right) -> bool:
    return numpy.array_equal(numpy.squeeze(left), numpy.squeeze(right), equal_nan=True)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    sys.exit(0 if all([check(path) for path in sys.argv[1:]]) else 1)
