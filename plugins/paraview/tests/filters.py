"""Sources and filters of the plugin, on what is known of them."""

import numpy as np
from checks import check, end, points, simple, producer_of
from paraview import servermanager, vtk
from paraview.vtk.util import numpy_support

pump = simple.MotePumpSource() if hasattr(simple, "MotePumpSource") else simple.PumpMote()
pump.Scale = 0.005
pump.UpdatePipeline()
cells = pump.GetDataInformation().GetNumberOfCells()
check(20000 < cells < 45000, f"a pump of a two hundredth of 6.45 million cells: {cells}")
check(len(pump.TimestepValues) > 1, "the pump has time steps")
arrays = [a.Name for a in pump.PointData]
check("pressure" in arrays, f"and a pressure: {arrays}")

average = simple.MeridionalAverageMote(Input=pump)
average.Array = "pressure"
average.Resolution = 64
average.UpdatePipeline()
table, image = (average.GetClientSideObject().GetOutputDataObject(port) for port in (0, 1))
values = numpy_support.vtk_to_numpy(image.GetPointData().GetArray("pressure"))
volumes = numpy_support.vtk_to_numpy(image.GetPointData().GetArray("volume"))
held = volumes > 0
check(max(image.GetDimensions()) == 64, f"the plane has the bins: {image.GetDimensions()}")
check(table.GetNumberOfRows() == held.sum(), "the table has a row for each bin that holds something")
low, high = pump.PointData["pressure"].GetRange()
check(np.all((values[held] >= low) & (values[held] <= high)), "averages lie between least and greatest value")

statistics = simple.MeshStatisticsMote(Input=pump)
statistics.UpdatePipeline()
table = servermanager.Fetch(statistics)
check(table.GetNumberOfRows() > 0 and table.GetNumberOfColumns() > 3,
      f"statistics are a table: {table.GetNumberOfRows()} x {table.GetNumberOfColumns()}")

centers = simple.MergeBlocks(Input=simple.CellCenters(Input=pump))
probed = {}
for name in ("ResampleWithDatasetMote", "ResampleWithDataset"):
    filter = getattr(simple, name)(SourceDataArrays=pump, DestinationMesh=centers)
    filter.UpdatePipeline()
    table = servermanager.Fetch(filter).GetPointData()
    probed[name] = [numpy_support.vtk_to_numpy(table.GetArray(array))
                    for array in ("vtkValidPointMask", "pressure")]
found, mine = probed["ResampleWithDatasetMote"]
others_found, others = probed["ResampleWithDataset"]
check(found.mean() > 0.999, f"the middles of cells are found in the pump: {found.mean():.4f}")
both = (found > 0) & (others_found > 0)
off = np.abs(mine[both] - others[both]) / (high - low)
check(np.quantile(off, 0.99) < 1e-3, f"with the values of ParaView's own filter: {off.max():.2g}")

quantiles = simple.VolumeQuantilesMote(Input=pump)
quantiles.Array = "pressure"
quantiles.UpdatePipeline()
values = numpy_support.vtk_to_numpy(servermanager.Fetch(quantiles).GetColumnByName("value"))
check(len(values) == 101 and np.all(np.diff(values) >= 0) and low <= values[0] <= values[-1] <= high,
      "quantiles ascend from the least to the greatest value")

# Streamlines of a known flow, which turns about the axis of z and rises: helices.
box = simple.Wavelet(WholeExtent=[-10, 10, -10, 10, -10, 10])
flow = simple.Calculator(Input=box, ResultArrayName="flow", Function="-coordsY*iHat+coordsX*jHat+2*kHat")
hexahedra = simple.AppendDatasets(Input=flow)
for on_cells in (False, True):
    given = simple.PointDatatoCellData(Input=hexahedra) if on_cells else hexahedra
    lines = simple.StreamlinesMote(Input=given, NumberOfSeeds=200, Vectors=["CELLS" if on_cells else "POINTS", "flow"])
    lines.UpdatePipeline()
    drawn, seeds = (lines.GetClientSideObject().GetOutputDataObject(port) for port in (0, 1))
    check(drawn.GetNumberOfCells() >= 200 and seeds.GetNumberOfPoints() == 200, f"200 seeds: {drawn.GetNumberOfCells()} lines")
    at = numpy_support.vtk_to_numpy(drawn.GetPoints().GetData()).astype(float)
    radii = np.hypot(at[:, 0], at[:, 1])
    spread = []
    for k in range(drawn.GetNumberOfCells()):
        ids = drawn.GetCell(k).GetPointIds()
        own = radii[[ids.GetId(i) for i in range(ids.GetNumberOfIds())]]
        spread.append(own.max() - own.min())
    # Vectors of cells become those of points first, which flattens them at the sides.
    check(np.quantile(spread, 0.5) < (0.05 if on_cells else 0.01), f"they stay as far from the axis: {np.quantile(spread, 0.5):.2g}")
mine = simple.StreamlinesMote(Input=pump, NumberOfSeeds=50, Vectors=["POINTS", "velocity"])
mine.UpdatePipeline()
check(mine.GetDataInformation().GetNumberOfCells() >= 50, "lines through the blocks of the pump")
check("pressure" in [a.Name for a in mine.PointData], "which have its arrays")

# A step of five on a plane: a line along it, and none elsewhere.
image = vtk.vtkImageData()
image.SetDimensions(40, 30, 1)
heights = np.zeros((30, 40))
heights[:, 20:] = 5.0
array = numpy_support.numpy_to_vtk(heights.ravel(), deep=True)
array.SetName("height")
image.GetPointData().AddArray(array)
steps = simple.SilhouettesofanImageMote(Input=producer_of(image), DepthArray=["POINTS", "height"])
steps.ThresholdMode = "World Units"
for threshold, seen in ((4.9, True), (5.1, False)):
    steps.Threshold = threshold
    steps.UpdatePipeline()
    found = numpy_support.vtk_to_numpy(steps.GetClientSideObject().GetOutputDataObject(0).GetPointData().GetScalars()).reshape(30, 40)
    check((found[:, 19:21].max() > 0.5) == seen, f"a step of 5, and a threshold of {threshold}: {found[:, 19:21].max():.2g}")
    check(found[:, :18].max() == 0 and found[:, 22:].max() == 0, "and no line where it is level")

lattice = np.stack(np.meshgrid(*[np.arange(6.0)] * 3), axis=-1).reshape(-1, 3)
baker = simple.BakeAmbientOcclusionMote(Input=producer_of(points(lattice, radius=[0.5] * len(lattice))))
baker.UpdatePipeline()
baked = servermanager.Fetch(baker)
names = [baked.GetPointData().GetArrayName(i) for i in range(baked.GetPointData().GetNumberOfArrays())]
names += [baked.GetFieldData().GetArrayName(i) for i in range(baked.GetFieldData().GetNumberOfArrays())]
check(baked.GetNumberOfPoints() == 216 and len(names) > 1, f"baked maps come with the points: {names}")
end()
