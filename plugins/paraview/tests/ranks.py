"""Files on several ranks: each reads its piece. Run it by as many ranks as are wanted."""

import os
import tempfile

import numpy as np
from checks import check, covered, end, picture, points, simple, view_of
from paraview import servermanager
from paraview.vtk.util import numpy_support
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

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
        reader = simple.OpenDataFile(name)
        reader.UpdatePipeline()
        total = reader.GetDataInformation().GetNumberOfPoints()
        check(total == count, f"{ending}: {total} points on {ranks} ranks together")
        marked = simple.ProcessIdScalars(Input=reader)
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
        display = simple.Show(reader, view)
        check(display.Representation == "Mote Particles", f"{ending}: shown as {display.Representation}")
        simple.Render(view)
        for proxy in (numbers, marked, display, view, reader):
            simple.Delete(proxy)

    # A box for each rank, and copies of what is beside it.
    distributed = simple.DistributeParticlesMote(Input=simple.OpenDataFile(names["dump"]), GhostDistance=0.5)
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
one = vtkPoints()
one.InsertNextPoint(0, 0, 0)
self.GetPolyDataOutput().SetPoints(one)
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

    # What was sent need not stay where it was read, and is read again where it is wanted.
    reader = simple.OpenDataFile(names["dump"])
    between = simple.ProcessIdScalars(Input=reader)
    lean = simple.DistributeParticlesMote(Input=between, Ghosts=0, ReleaseInput=1)
    lean.UpdatePipeline()
    held = [proxy.GetClientSideObject().GetOutputDataObject(0).GetNumberOfPoints() for proxy in (reader, between)]
    check((held == [0, 0]) == (ranks > 1), f"released: the first rank's reader and filter hold {held} points")
    check(lean.GetDataInformation().GetNumberOfPoints() == count, "released: all are distributed")
    again = simple.PointDatatoCellData(Input=reader)
    again.UpdatePipeline()
    check(reader.GetClientSideObject().GetOutputDataObject(0).GetNumberOfPoints() >= count // ranks, "released: and read again")


def compare(what, first, second, array, setup, tolerance=0.001, **of_view):
    """Pictures of two sources from four sides, which the ranks have in other ways."""
    shares = []
    for seen_from in ([1, 0.4, 0.3], [-1, 0.4, 0.3], [0.3, 1, 0.4], [0.3, -1, -0.4]):
        pictures, scale = [], None
        for shown in (first, second):
            view = view_of("MoteRenderView")
            for name, value in of_view.items():
                setattr(view, name, value)
            display = simple.Show(shown, view)
            setup(display)
            simple.ColorBy(display, ("POINTS", array))
            display.RescaleTransferFunctionToDataRange(False, True)
            opacity = simple.GetOpacityTransferFunction(array)
            opacity.Points = [opacity.Points[0], 0.3, 0.5, 0.0, opacity.Points[-4], 1.0, 0.5, 0.0]
            view.CameraPosition = seen_from
            view.CameraFocalPoint = [0, 0, 0]
            view.CameraViewUp = [0, 0, 1]
            view.ResetCamera(True)
            simple.Render(view)  # tells what the camera is
            scale = scale or view.CameraParallelScale
            view.CameraParallelScale = scale  # on several ranks the first was a hundredth larger
            pictures.append(picture(view))
            simple.Delete(display)
            simple.Delete(view)
        off = (np.abs(pictures[0] - pictures[1]).max(axis=2) > 25).mean()
        shares.append(off)
        check(covered(pictures[0]) > 0.1, f"{what}: there is something to see")
        check(off < tolerance, f"{what}: {100 * off:.3g} % of pixels are others, from {seen_from}")
    return np.mean(shares)


# Volumes in pieces, and particles that light goes through, are blended in the order of the ranks.
def as_volume(display):
    display.SetRepresentationType("Mote Volume")
    display.ScalarOpacityUnitDistance = 0.01  # so that what is in front hides what is behind


def as_translucent(display):
    display.SetRepresentationType("Mote Particles")
    display.Opacity = 0.5


def as_mesh(display):
    display.SetRepresentationType("Mote Mesh")


grid = simple.OpenDataFile(os.path.join(os.environ["MOTE_DATA"], "swirl.1.vtu"))
compare("pieces of a volume", grid, simple.RedistributeDataSet(Input=grid), "p", as_volume)
with tempfile.TemporaryDirectory() as folder:
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(os.path.join(folder, "few.vtp"))
    writer.SetInputData(points(places[:3000], x=places[:3000, 0]))
    writer.Write()
    whole = simple.OpenDataFile(writer.GetFileName())  # the first rank has all
    compare("translucent particles", whole, simple.DistributeParticlesMote(Input=whole), "x", as_translucent)

    # Spheres of triangles, which the borders of the boxes go through.
    append = vtkAppendPolyData()
    for x, y, z in places[:60]:
        ball = vtkSphereSource()
        ball.SetCenter(x, y, z)
        ball.SetThetaResolution(24)
        ball.SetPhiResolution(16)
        ball.Update()
        append.AddInputData(ball.GetOutput())
    append.Update()
    mesh = append.GetOutput()
    mesh.GetPointData().AddArray(numpy_support.numpy_to_vtk(
        numpy_support.vtk_to_numpy(mesh.GetPoints().GetData())[:, 0].copy(), deep=True))
    mesh.GetPointData().GetArray(mesh.GetPointData().GetNumberOfArrays() - 1).SetName("height")
    writer.SetFileName(os.path.join(folder, "mesh.vtp"))
    writer.SetInputData(mesh)
    writer.Write()
    whole = simple.OpenDataFile(writer.GetFileName())
    shared = simple.DistributeMeshMote(Input=whole)
    shared.UpdatePipeline()
    cells = shared.GetDataInformation().GetNumberOfCells()
    check((cells == mesh.GetNumberOfCells()) if ranks == 1 else (cells > mesh.GetNumberOfCells()),
          f"mesh: {cells} cells with ghosts, of {mesh.GetNumberOfCells()}")
    lean = simple.DistributeMeshMote(Input=whole, Ghosts=0)
    lean.UpdatePipeline()
    check(lean.GetDataInformation().GetNumberOfCells() == mesh.GetNumberOfCells(), "mesh: none is lost or doubled")
    numbers = simple.ProcessIdScalars(Input=lean)
    numbers.UpdatePipeline()
    check(numbers.PointData["ProcessId"].GetRange() == (0, ranks - 1), "mesh: all ranks have some")
    lit = {"MoteOcclusion": "Live", "MoteSilhouettes": 1}
    # What light and lines need from farther than the ghosts is missing.
    near = compare("a mesh with light and lines", whole, shared, "height", as_mesh, 0.01, **lit)
    none = compare("a mesh without ghosts", whole, lean, "height", as_mesh, 0.05, **lit)
    check(ranks == 1 or none > 1.5 * near, "a mesh: ghosts bring light and lines of other ranks")
    shared.GhostDistance = 100
    compare("a mesh with far ghosts", whole, shared, "height", as_mesh, 0.0001, **lit)

end()
