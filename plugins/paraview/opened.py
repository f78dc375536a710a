"""A file as a source of ParaView, with Mote's plugin: what the scripts of this folder share."""

import os
import sys

from paraview import servermanager, simple


def open_file(name):
    """The source of a file, or an end with a sentence."""
    if not os.path.isfile(name):
        sys.exit(f"{name}: there is no such file")
    simple._DisableFirstRenderCameraReset()
    simple.LoadPlugin(os.environ["MOTE_PLUGIN"], remote=False, ns=vars(simple))
    source = simple.OpenDataFile(name)
    if source is None:
        sys.exit(f"{name}: ParaView has no reader for it")
    return source


def time_of(source, name, step):
    """The time of a step, counted from 1; None where the file knows no time."""
    times = list(getattr(source, "TimestepValues", []) or [])
    if not times:
        return None
    if not 1 <= step <= len(times):
        sys.exit(f"--step: {name} has steps 1 to {len(times)}")
    return times[step - 1]


def ranks():
    return servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()
