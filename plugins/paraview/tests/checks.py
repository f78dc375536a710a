"""What the tests of the plugin share; run by pvbatch with MOTE_PLUGIN naming Mote.so."""

import os
import tempfile

import numpy as np
from paraview import simple, vtk
from paraview.vtk.util import numpy_support
from vtkmodules.vtkIOImage import vtkPNGReader

simple._DisableFirstRenderCameraReset()
simple.LoadPlugin(os.environ["MOTE_PLUGIN"], remote=False, ns=vars(simple))
failures = []


def check(holds, words):
    """Notes a failure, and goes on."""
    print(("ok      " if holds else "FAILED  ") + words, flush=True)
    if not holds:
        failures.append(words)


def end():
    if failures:
        print(f"{len(failures)} checks failed", flush=True)
        os._exit(1)  # pvbatch would lose the code
    print("all checks held", flush=True)


def producer_of(data):
    """A pipeline source of a data object. (Scripts of programmable filters import numpy's names over those of a test.)"""
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    producer.UpdatePipeline()
    return producer


def points(places, **arrays):
    """A data set of points without cells."""
    data = vtk.vtkPolyData()
    at = vtk.vtkPoints()
    at.SetData(numpy_support.numpy_to_vtk(np.asarray(places, dtype=float), deep=True))
    data.SetPoints(at)
    for name, values in arrays.items():
        array = numpy_support.numpy_to_vtk(np.asarray(values), deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    return data


def view_of(kind="RenderView", size=(300, 300), height=2.0):
    """A black view along -z onto the origin, in parallel projection, as high as `height` there."""
    view = simple.CreateView(kind)
    view.ViewSize = list(size)
    view.UseColorPaletteForBackground = 0
    view.Background = [0.0, 0.0, 0.0]
    view.OrientationAxesVisibility = 0
    view.CameraParallelProjection = 1
    view.CameraPosition = [0.0, 0.0, 10.0]
    view.CameraFocalPoint = [0.0, 0.0, 0.0]
    view.CameraViewUp = [0.0, 1.0, 0.0]
    view.CameraParallelScale = height / 2
    return view


def picture(view, keep=None):
    """What a view shows: bytes, rows from the top, columns, red green blue."""
    simple.Render(view)
    name = keep or os.path.join(tempfile.mkdtemp(), "view.png")
    simple.SaveScreenshot(name, view, ImageResolution=view.ViewSize)
    reader = vtkPNGReader()
    reader.SetFileName(name)
    reader.Update()
    image = reader.GetOutput()
    columns, rows, _ = image.GetDimensions()
    values = numpy_support.vtk_to_numpy(image.GetPointData().GetScalars())
    return values.reshape(rows, columns, -1)[::-1, :, :3].astype(int)


def covered(image):
    """The share of pixels that are not black."""
    return float((image.sum(axis=2) > 0).mean())
