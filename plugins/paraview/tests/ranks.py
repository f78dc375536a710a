"""Files on several ranks: each reads its piece. Run it by as many ranks as are wanted."""

import os
import tempfile

import numpy as np
from checks import check, end, simple
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

end()
