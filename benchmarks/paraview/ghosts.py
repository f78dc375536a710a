"""A picture of random particles on several ranks, which each know those beside their own: from the side, where boxes hide one
another.

    export VTK_SMP_BACKEND_IN_USE=STDThread MOTE_PLUGIN=...  # Mote.so, as scripts/paraview builds it
    xvfb-run -a mpiexec -n N pvbatch benchmarks/paraview/ghosts.py LOOK DISTANCE PICTURE
    oiiotool --fail 0.02 --diff PICTURE PICTURE_OF_ONE_RANK

LOOK is rays, occlusion, shadows or silhouettes. DISTANCE is 0, for the usual one, or inf. pvbatch is in build/paraview/packages/usr/bin.
"""

import os
import sys
import tempfile

import numpy as np
from paraview import simple

simple._DisableFirstRenderCameraReset()
simple.LoadPlugin(os.environ["MOTE_PLUGIN"], remote=False, ns=vars(simple))
look, distance, picture = sys.argv[1:4]
places = np.random.default_rng(3).random((30_000, 3)) * [10, 6, 4]
with tempfile.TemporaryDirectory() as folder:
    name = os.path.join(folder, "random.xyz")
    with open(name, "w") as file:
        file.write("30000\n\n" + "".join(f"A {x:.6f} {y:.6f} {z:.6f}\n" for x, y, z in places))
    particles = simple.DistributeParticlesMote(Input=simple.OpenDataFile(name), GhostDistance=min(float(distance), 1e300))
    view = simple.CreateView("MoteRenderView")
    view.ViewSize = [500, 400]
    view.MoteSamples = 4
    view.MoteShadows = look == "shadows"
    view.MoteOcclusion = "Live" if look == "occlusion" else "None"
    view.MoteSilhouettes = look == "silhouettes"
    display = simple.Show(particles, view)
    display.SetRepresentationType("Mote Particles")
    simple.ColorBy(display, ("POINTS", None))
    view.CameraPosition = [60, 20, 9]
    view.CameraFocalPoint = [5, 3, 2]
    view.CameraViewUp = [0, 0, 1]
    view.ResetCamera(True)
    simple.Render(view)
    simple.SaveScreenshot(picture, view, ImageResolution=[500, 400])
