"""Files on several ranks: each reads its piece. Run it by as many ranks as are wanted."""

import os
import tempfile

import numpy as np
from checks import check, end, picture, simple, view_of
from paraview import servermanager
from paraview.vtk.util import numpy_support

ranks = servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()
random = np.random.default_rng(3)
count = 40_000
places = random.random((count, 3)) * [8, 4, 2]

with tempfile.TemporaryDirectory() as folder:
    names = {}
    for ending in ("pts", "xyz", "dump"):
        names[ending] = os.path.join(folder, "a." + ending)
        with open(names[ending], "w") as file:
            if ending == "xyz":
                file.write(f"{count}\nin no order\n")
            if ending == "dump":
                file.write(f"ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n{count}\nITEM: BOX BOUNDS ff ff ff\n"
                           "0 8\n0 4\n0 2\nITEM: ATOMS id x y z\n")
            before = {"pts": lambda i: "", "xyz": lambda i: "Ar ", "dump": lambda i: f"{i + 1} "}[ending]
            file.writelines(f"{before(i)}{x:.9g} {y:.9g} {z:.9g}\n" for i, (x, y, z) in enumerate(places))

    for ending, name in names.items():
        source = simple.OpenDataFile(name)
        source.UpdatePipeline()
        total = source.GetDataInformation().GetNumberOfPoints()
        check(total == count, f"{ending}: {total} points on {ranks} ranks together")
        marked = simple.ProcessIdScalars(Input=source)
        marked.UpdatePipeline()
        least, most = marked.PointData["ProcessId"].GetRange()
        check((least, most) == (0, ranks - 1), f"{ending}: all ranks have some, {least:g} to {most:g}")
        numbers = simple.Histogram(Input=marked, SelectInputArray=["POINTS", "ProcessId"], BinCount=max(2, ranks))
        numbers.UpdatePipeline()
        table = servermanager.Fetch(numbers)
        shares = numpy_support.vtk_to_numpy(table.GetRowData().GetArray("bin_values"))
        shares = shares[shares > 0]
        check(shares.max() <= count / ranks + 1, f"{ending}: none has more than its share, {shares}")
        view = simple.CreateView("RenderView")
        display = simple.Show(source, view)
        check(display.Representation == "Mote Particles", f"{ending}: shown as {display.Representation}")
        simple.Render(view)
        for proxy in (numbers, marked, display, view, source):
            simple.Delete(proxy)

    # A box for each rank, and copies of what is beside it.
    source = simple.OpenDataFile(names["dump"])
    distributed = simple.DistributeParticlesMote(Input=source, GhostDistance=0.5)
    facts = simple.ProgrammableFilter(Input=distributed, OutputDataSetType="vtkPolyData", Script="""
import numpy as np
from vtkmodules.util import numpy_support
from vtkmodules.vtkCommonCore import vtkPoints
data = self.GetInputDataObject(0, 0)
places = numpy_support.vtk_to_numpy(data.GetPoints().GetData())
ids = numpy_support.vtk_to_numpy(data.GetPointData().GetArray("id"))
marks = data.GetPointData().GetArray("vtkGhostType")
own = numpy_support.vtk_to_numpy(marks) == 0 if marks else np.ones(len(ids), bool)
facts = {"own": own.sum(), "ghosts": (~own).sum(), "ids": ids[own].sum(), "twice": len(ids) - len(np.unique(ids))}
low, high = places[own].min(axis=0), places[own].max(axis=0)
facts.update({f"low{c}": low[c] for c in range(3)}, **{f"high{c}": high[c] for c in range(3)})
away = np.linalg.norm(np.maximum(0, np.maximum(low - places, places - high)), axis=1)
facts["away"] = away.max()
points = vtkPoints()
points.InsertNextPoint(0, 0, 0)
self.GetPolyDataOutput().SetPoints(points)
for name, value in facts.items():
    array = numpy_support.numpy_to_vtk(np.array([float(value)]), deep=True)
    array.SetName(name)
    self.GetPolyDataOutput().GetPointData().AddArray(array)
""")
    facts.UpdatePipeline()
    rows = servermanager.Fetch(facts).GetPointData()
    column = {name: numpy_support.vtk_to_numpy(rows.GetArray(name)) for name in
              ("own", "ghosts", "ids", "twice", "away", "low0", "low1", "low2", "high0", "high1", "high2")}
    check(len(column["own"]) == ranks and column["own"].sum() == count, "distributed: none is lost or doubled")
    check(column["ids"].sum() == count * (count + 1) / 2 and column["twice"].max() == 0, "distributed: each has its own")
    check(column["own"].max() <= 1.02 * count / ranks, f"distributed: evenly, {column['own']}")
    # Two boxes are apart along an axis.
    boxes = np.array([[column[f"low{c}"], column[f"high{c}"]] for c in range(3)])
    apart = [np.any(boxes[:, 0, i] > boxes[:, 1, j]) or np.any(boxes[:, 0, j] > boxes[:, 1, i])
             for i in range(ranks) for j in range(i)]
    check(np.all(apart), "distributed: boxes do not overlap")
    if ranks == 1:
        check(column["ghosts"].sum() == 0, "distributed: one rank has no ghosts")
    else:
        def within(distance):
            return np.array([(np.linalg.norm(np.maximum(0, np.maximum(boxes[:, 0, r] - places, places - boxes[:, 1, r])),
                                             axis=1) <= distance).sum() for r in range(ranks)])
        have = column["own"] + column["ghosts"]
        check(np.all(within(0.5) <= have) and np.all(have <= within(0.51)), f"distributed: all within 0.5, {column['ghosts']}")
        check(0.4 < column["away"].min() and column["away"].max() <= 0.51, "distributed: and none farther")

# Volumes in pieces are blended in the order of the ranks, from wherever they are seen.
grid = simple.OpenDataFile(os.path.join(os.environ["MOTE_DATA"], "swirl.1.vtu"))
spread = simple.RedistributeDataSet(Input=grid)
for seen_from in ([1, 0.4, 0.3], [-1, 0.4, 0.3], [0.3, 1, 0.4], [0.3, -1, -0.4]):
    pictures = []
    for source in (grid, spread):
        view = view_of("MoteRenderView")
        display = simple.Show(source, view)
        display.SetRepresentationType("Mote Volume")
        simple.ColorBy(display, ("POINTS", "p"))
        display.RescaleTransferFunctionToDataRange(False, True)
        opacity = simple.GetOpacityTransferFunction("p")
        opacity.Points = [opacity.Points[0], 0.3, 0.5, 0.0, opacity.Points[-4], 1.0, 0.5, 0.0]
        display.ScalarOpacityUnitDistance = 0.01  # so that what is in front hides what is behind
        view.CameraPosition = seen_from
        view.CameraFocalPoint = [0, 0, 0]
        view.CameraViewUp = [0, 0, 1]
        view.ResetCamera(True)
        pictures.append(picture(view).astype(int))
        simple.Delete(display)
        simple.Delete(view)
    off = np.abs(pictures[0] - pictures[1]).max(axis=2)
    check((pictures[0].max(axis=2) > 0).mean() > 0.1, "pieces of a volume: there is one")
    check((off > 25).mean() < 0.001, f"pieces of a volume: {100 * (off > 25).mean():.3g} % of pixels are others, from {seen_from}")

end()
