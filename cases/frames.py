"""Reads what fix output/vtk wrote, with VTK's own readers: from one rank or from several, it makes no difference.

    series = frames.Series(folder / "post", "outline")
    time, file = series.nearest(50.0)
    polygons, values = frames.outlines(file)
"""

import xml.etree.ElementTree
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import (vtkXMLImageDataReader, vtkXMLPImageDataReader, vtkXMLPolyDataReader, vtkXMLPPolyDataReader)

READERS = {".vti": vtkXMLImageDataReader, ".pvti": vtkXMLPImageDataReader,
           ".vtp": vtkXMLPolyDataReader, ".pvtp": vtkXMLPPolyDataReader}


class Series:
    """The frames of one data set, as its .pvd lists them: pairs of time and file, in order of time."""

    def __init__(self, folder, name):
        root = xml.etree.ElementTree.parse(Path(folder) / f"{name}.pvd").getroot()
        self.frames = sorted((float(entry.get("timestep")), Path(folder) / entry.get("file")) for entry in root.iter("DataSet"))

    def __iter__(self):
        return iter(self.frames)

    def nearest(self, time):
        return min(self.frames, key=lambda frame: abs(frame[0] - time))


def read(file):
    reader = READERS[Path(file).suffix]()
    reader.SetFileName(str(file))
    reader.Update()
    return reader.GetOutput()


def arrays(attributes):
    """{name: values} of point or cell data."""
    return {attributes.GetArrayName(i): vtk_to_numpy(attributes.GetArray(i)) for i in range(attributes.GetNumberOfArrays())}


def points(data):
    return vtk_to_numpy(data.GetPoints().GetData())[:, :2] if data.GetNumberOfPoints() else np.empty((0, 2))


def outlines(file):
    """The objects' polygons, each an array of x, y in order, and their values as {name: one entry an object}."""
    data = read(file)
    corners, polygons = points(data), data.GetPolys()
    ends = vtk_to_numpy(polygons.GetOffsetsArray())
    order = vtk_to_numpy(polygons.GetConnectivityArray())
    return [corners[order[a:b]] for a, b in zip(ends[:-1], ends[1:])], arrays(data.GetCellData())


def vertices(file):
    """Positions x, y of mass points or contact-detection spheres, and their values."""
    data = read(file)
    return points(data), arrays(data.GetPointData())


def fields(file):
    """Cell centres x and y of a two-dimensional grid, and its values with y as the first index."""
    data = read(file)
    nx, ny = (n - 1 for n in data.GetDimensions()[:2])
    x, y = (data.GetOrigin()[d] + (np.arange(n) + 0.5) * data.GetSpacing()[d] for d, n in ((0, nx), (1, ny)))
    return x, y, {name: values.reshape(ny, nx, -1).squeeze() for name, values in arrays(data.GetCellData()).items()}
