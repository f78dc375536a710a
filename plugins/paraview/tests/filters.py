"""Sources and filters of the plugin, on what is known of them."""

import numpy as np
from checks import check, end, points, simple, producer_of
from paraview import servermanager
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

lattice = np.stack(np.meshgrid(*[np.arange(6.0)] * 3), axis=-1).reshape(-1, 3)
baker = simple.BakeAmbientOcclusionMote(Input=producer_of(points(lattice, radius=[0.5] * len(lattice))))
baker.UpdatePipeline()
baked = servermanager.Fetch(baker)
names = [baked.GetPointData().GetArrayName(i) for i in range(baked.GetPointData().GetNumberOfArrays())]
names += [baked.GetFieldData().GetArrayName(i) for i in range(baked.GetFieldData().GetNumberOfArrays())]
check(baked.GetNumberOfPoints() == 216 and len(names) > 1, f"baked maps come with the points: {names}")
end()
