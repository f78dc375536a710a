"""A file of particles or polygons on several ranks, each with a piece: what reading and frames take, and memory.

    export LP_NUM_THREADS=1 VTK_SMP_BACKEND_IN_USE=STDThread MOTE_PLUGIN=...  # Mote.so, as scripts/paraview builds it
    xvfb-run -a mpiexec --bind-to core -n N pvbatch --sym benchmarks/paraview/ranks.py FILE [LOOK]

LOOK is `plain`, the default, or `boxes`: as plain, but each rank gets the particles of a box and no ghosts; `lit`: ambient
occlusion, shadows and four rays a pixel, with ghosts. What was read is freed when it has been sent, unless `keep` comes behind.
`mesh` behind it says that these are polygons.

pvbatch is in build/paraview/packages/usr/bin. 1024x1024, the camera moves between frames, medians. Memory is what each rank has taken more than
before it read: at the end, and at the most.
"""

import os
import statistics
import sys
import time

from paraview import servermanager, simple

simple._DisableFirstRenderCameraReset()
simple.LoadPlugin(os.environ["MOTE_PLUGIN"], remote=False, ns=vars(simple))
controller = servermanager.vtkProcessModule.GetProcessModule().GetGlobalController()
rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()


def memory():
    """Of this process, in MB: what it takes by itself, and files that it has mapped."""
    with open("/proc/self/status") as file:
        lines = dict(line.split(":", 1) for line in file)
    return [int(lines[key].split()[0]) / 1e3 for key in ("RssAnon", "RssFile", "VmHWM")]


before = memory()
start = time.time()
source = simple.OpenDataFile(sys.argv[1])
source.UpdatePipeline()
read = time.time() - start
count = source.GetDataInformation().GetNumberOfPoints()
look = sys.argv[2] if len(sys.argv) > 2 else "plain"
start = time.time()
polygons = "mesh" in sys.argv
if polygons:
    count = source.GetDataInformation().GetNumberOfCells()
if look != "plain" and ranks > 1:
    distribute = simple.DistributeMeshMote if polygons else simple.DistributeParticlesMote
    source = distribute(Input=source, Ghosts=look == "lit", ReleaseInput="keep" not in sys.argv)
    source.UpdatePipeline()
sent = time.time() - start
view = simple.CreateView("MoteRenderView" if look == "lit" else "RenderView")
view.ViewSize = [1024, 1024]
if look == "lit":
    view.MoteSamples = 4
    view.MoteShadows = 1
    view.MoteOcclusion = "Live"
display = simple.Show(source, view)
display.SetRepresentationType("Mote Mesh" if polygons else "Mote Particles")
simple.ResetCamera(view)
start = time.time()
simple.Render(view)
first = time.time() - start
camera = simple.GetActiveCamera()
frames = []
for _ in range(9):
    camera.Azimuth(3)
    start = time.time()
    simple.Render(view)
    frames.append(time.time() - start)
own, mapped, _ = (now - then for now, then in zip(memory(), before))
most = memory()[2] - before[0] - before[1]
controller.Barrier()
if rank == 0:
    print(f"{ranks} ranks, the first with {count} {'polygons' if polygons else 'particles'} of the file: {look}: read in {read:.2f} s, sent in {sent:.2f} s, first picture {first:.2f} s, "
          f"frame {statistics.median(frames):.3f} s", flush=True)
for k in range(ranks):
    controller.Barrier()
    if k == rank:
        print(f"  rank {rank}: {own:.0f} MB, and {mapped:.0f} MB of files; at the most {most:.0f} MB of both", flush=True)
