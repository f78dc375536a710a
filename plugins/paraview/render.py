"""Draws a file by ParaView with Mote's representations; scripts/paraview render runs it."""

import argparse
import math
import os
import sys
import tempfile

from opened import open_file, ranks, time_of
from paraview import servermanager, simple
from vtkmodules import vtkIOImage, vtkImagingCore

# From where, and what is up.
VIEWS = {"+x": ((1, 0, 0), (0, 0, 1)), "-x": ((-1, 0, 0), (0, 0, 1)),
         "+y": ((0, 1, 0), (0, 0, 1)), "-y": ((0, -1, 0), (0, 0, 1)),
         "+z": ((0, 0, 1), (0, 1, 0)), "-z": ((0, 0, -1), (0, 1, 0))}
OBLIQUE = {"iso": ((0.61, -0.61, 0.5), (0, 0, 1)), "iso-y": ((0.45, 0.35, 0.82), (0, 1, 0))}

parser = argparse.ArgumentParser(prog="scripts/paraview render", description=__doc__.split(";")[0] + ".")
parser.add_argument("file", metavar="FILE")
parser.add_argument("-o", "--output", metavar="PICTURE", required=True)
parser.add_argument("--size", default="1024x1024", help="width x height in pixels; default 1024x1024")
parser.add_argument("--as", dest="kind", choices=("particles", "volume", "mesh"),
                    help="default: by what the file holds")
parser.add_argument("--color-by", metavar="ARRAY", help="default: one colour; of a volume its first array")
parser.add_argument("--samples", type=int, default=1, 
                    help="rays a pixel; default 1. Of volumes on several ranks the next square: 4, 9, 16")
parser.add_argument("--view", choices=(*OBLIQUE, *VIEWS), default="+z",
                    help="side to look from, as in mote render: iso has z up, iso-y has y up; default +z")
parser.add_argument("--step", type=int, default=1, help="time step, from 1")
parser.add_argument("--shadows", action="store_true")
parser.add_argument("--ambient-occlusion", action="store_true")
parser.add_argument("--silhouettes", action="store_true")
parser.add_argument("--ghosts", type=float, default=0.0, metavar="DISTANCE",
                    help="how far around the particles or polygons of a rank it knows those of others, which shadows, ambient "
                         "occlusion and silhouettes need; default: 0.12 of the longest side or 8 distances of neighbours; inf: all")


def arrays_of(source):
    """Names of arrays by association."""
    return {"POINTS": list(source.PointData.keys()), "CELLS": list(source.CellData.keys())}


def goes_across(options):
    """Whether anything is drawn that depends on more than one particle."""
    return options.shadows or options.ambient_occlusion or options.silhouettes


def kind_of(source, display):
    """By the representation that ParaView took, and the cells."""
    information = source.GetDataInformation()
    if display.Representation == "Mote Particles" or information.GetNumberOfCells() == 0:
        return "particles"
    return "volume" if information.GetDataSetTypeAsString() == "vtkUnstructuredGrid" else "mesh"


def distributed(source, kind, options):
    """The source, each rank with what lies in a box and copies of what is around it; or None.

    Several rays a pixel, light and lines need that.
    """
    if ranks() == 1 or not (options.samples > 1 or goes_across(options)):
        return None
    if kind == "particles":
        distribute = simple.DistributeParticlesMote
    elif kind == "mesh" and source.GetDataInformation().GetDataSetTypeAsString() == "vtkPolyData":
        distribute = simple.DistributeMeshMote
    else:
        return None
    return distribute(Input=source, GhostDistance=min(options.ghosts, 1e300), ReleaseInput=1)


def show(source, view, options):
    """Shows it. Returns its kind, its display, and how many pixels are drawn along the side of one that is written."""
    display = simple.Show(source, view)
    kind = options.kind or kind_of(source, display)
    boxes = distributed(source, kind, options)
    if boxes:
        simple.Hide(source, view)
        source = boxes
        display = simple.Show(source, view)
    # Ranks whose data lie in boxes are blended in order. Of others the nearest is seen: each ray must
    # have a pixel of its own.
    side = 1 if ranks() == 1 or boxes or kind == "particles" else math.isqrt(max(options.samples, 1) - 1) + 1
    name = {"particles": "Mote Particles", "volume": "Mote Volume", "mesh": "Mote Mesh"}[kind]
    if name not in display.GetProperty("Representation").Available:
        sys.exit(f"{options.file}: its data cannot be shown as {kind}")
    arrays = arrays_of(source)
    wanted = options.color_by
    if not wanted and kind == "volume":
        wanted = next((names[0] for names in arrays.values() if names), None)
    association = next((a for a, names in arrays.items() if wanted in names), None)
    if wanted and not association:
        known = ", ".join(arrays["POINTS"] + arrays["CELLS"]) or "none"
        sys.exit(f"--color-by: {options.file} has no array '{wanted}'; it has {known}")
    simple.ColorBy(display, (association, wanted) if wanted else ("POINTS", None))
    display.SetRepresentationType(name)
    if wanted:
        display.RescaleTransferFunctionToDataRange(False, True)
        display.SetScalarBarVisibility(view, True)
    return kind, display, side


def write_mean(options, view, size, side):
    """A picture of `side` times the size, and each pixel the mean of those in its place."""
    writers = {".png": vtkIOImage.vtkPNGWriter, ".jpg": vtkIOImage.vtkJPEGWriter,
               ".jpeg": vtkIOImage.vtkJPEGWriter, ".tif": vtkIOImage.vtkTIFFWriter,
               ".tiff": vtkIOImage.vtkTIFFWriter, ".bmp": vtkIOImage.vtkBMPWriter}
    ending = os.path.splitext(options.output)[1].lower()
    if ending not in writers:
        sys.exit(f"{options.output}: of several ranks and rays pictures are {', '.join(writers)}")
    with tempfile.TemporaryDirectory() as folder:
        name = os.path.join(folder, "large.png")
        if not simple.SaveScreenshot(name, view, ImageResolution=[side * n for n in size]):
            return False
        if servermanager.vtkProcessModule.GetProcessModule().GetPartitionId() != 0:
            return True
        reader = vtkIOImage.vtkPNGReader()
        reader.SetFileName(name)
        shrink = vtkImagingCore.vtkImageShrink3D()
        shrink.SetInputConnection(reader.GetOutputPort())
        shrink.SetShrinkFactors(side, side, 1)
        shrink.MeanOn()
        writer = writers[ending]()
        writer.SetFileName(options.output)
        writer.SetInputConnection(shrink.GetOutputPort())
        writer.Write()
        return writer.GetErrorCode() == 0


def main():
    words = sys.argv[1:]
    while "--view" in words[:-1]:  # so that -x is no option of its own
        at = words.index("--view")
        words[at:at + 2] = ["--view=" + words[at + 1]]
    options = parser.parse_args(words)
    try:
        size = [int(n) for n in options.size.lower().split("x")]
        if len(size) != 2 or min(size) < 1:
            raise ValueError
    except ValueError:
        sys.exit(f"--size: '{options.size}' is no size; 1024x768 is one")
    source = open_file(options.file)
    source.UpdatePipeline()
    lit = goes_across(options)
    view = simple.CreateView("MoteRenderView" if lit else "RenderView")
    view.ViewSize = size
    if options.samples > 1:
        view.UseFXAA = 0  # rays smooth edges, and it would blur them
    time = time_of(source, options.file, options.step)
    if time is not None:
        view.ViewTime = time
    kind, display, side = show(source, view, options)
    samples = 1 if side > 1 else options.samples
    setattr(display, f"Mote{kind.removesuffix('s').title()}Samples", samples)
    if lit:
        view.MoteSamples = samples
        view.MoteShadows = options.shadows
        view.MoteOcclusion = "Live" if options.ambient_occlusion else "None"
        view.MoteSilhouettes = options.silhouettes
        view.MoteSilhouetteThickness *= side
    view.CameraPosition, view.CameraViewUp = {**OBLIQUE, **VIEWS}[options.view]
    view.CameraFocalPoint = [0, 0, 0]
    view.ResetCamera(True)
    simple.Render(view)
    if not (write_mean(options, view, size, side) if side > 1 else
            simple.SaveScreenshot(options.output, view, ImageResolution=size)):
        sys.exit(f"{options.output}: cannot be written")


main()
