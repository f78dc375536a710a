"""Rendering from Python without a display."""

import gc
import math
import os
import unittest

import mote
from vtkmodules.vtkCommonCore import VTK_FLOAT, reference, vtkFloatArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer

try:
    import numpy
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
except ImportError:
    numpy = None


def particles(positions, radii=None):
    points = vtkPoints()
    for position in positions:
        points.InsertNextPoint(position)
    data = vtkPolyData()
    data.SetPoints(points)
    if radii is not None:
        array = vtkFloatArray()
        array.SetName("radius")
        for radius in radii:
            array.InsertNextValue(radius)
        data.GetPointData().AddArray(array)
    return data


def scene(data):
    mapper = mote.vtkMoteParticleMapper()
    mapper.SetInputData(data)
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0, 0, 10)
    camera.SetParallelProjection(True)
    camera.SetParallelScale(1)
    source = mote.vtkMoteRendererSource()
    source.SetRenderer(renderer)
    source.SetSize(64, 48)
    source.SetSamplesPerPixel(1)
    source.DepthOn()
    source.IdsOn()
    return mapper, source


class Errors:
    """Keeps what an object complains of."""

    def __init__(self, source):
        self.texts = []
        self.catch.__func__.CallDataType = "string0"
        source.AddObserver("ErrorEvent", self.catch)

    def catch(self, _caller, _event, text):
        self.texts.append(text)


class Pipeline(unittest.TestCase):
    def setUp(self):
        self.assertNotIn("DISPLAY", os.environ)

    def test_traces_a_sphere(self):
        _, source = scene(particles([(0, 0, 0)], [0.5]))
        source.Update()
        image = source.GetOutput()
        self.assertEqual(image.GetDimensions(), (64, 48, 1))
        depth = image.GetPointData().GetArray("depth")
        self.assertAlmostEqual(depth.GetValue(24 * 64 + 32), 9.5, 2)
        self.assertEqual(depth.GetValue(0), math.inf)
        self.assertEqual(image.GetPointData().GetArray("particle").GetValue(0), -1)

    def test_traces_triangles(self):
        data = particles([(-0.5, -0.5, 0), (0.5, -0.5, 0), (0.5, 0.5, 0), (-0.5, 0.5, 0)])
        polygon = vtkCellArray()
        polygon.InsertNextCell(4, (0, 1, 2, 3))
        data.SetPolys(polygon)
        mapper = mote.vtkMoteMeshMapper()
        mapper.SetInputData(data)
        mapper.Update()
        self.assertEqual(mapper.GetNumberOfTriangles(), 2)
        self.assertEqual(mapper.GetReport(), "")
        _, source = scene(data)
        actor = source.GetRenderer().GetActors().GetLastActor()
        actor.SetMapper(mapper)
        source.Update()
        depth = source.GetOutput().GetPointData().GetArray("depth")
        self.assertAlmostEqual(depth.GetValue(24 * 64 + 32), 10.0, 5)
        self.assertEqual(depth.GetValue(0), math.inf)
        self.assertIn("NumberOfTriangles: 2", str(mapper))

    def test_keeps_its_input_alive(self):
        _, source = scene(particles([(0, 0, 0)], [0.5]))
        gc.collect()
        source.Update()
        self.assertEqual(source.GetOutput().GetPointData().GetScalars().GetDataType(), VTK_FLOAT)

    def test_radius_modes_by_name(self):
        mapper, source = scene(particles([(0, 0, 0), (0.5, 0, 0)]))
        mapper.SetRadiusModeToConstant()
        mapper.SetRadius(0.125)
        source.Update()
        self.assertEqual(mapper.GetRadiusMode(), mote.vtkMoteParticleMapper.RADIUS_CONSTANT)
        self.assertAlmostEqual(mapper.GetBounds()[1], 0.625, 6)
        self.assertEqual(mapper.GetNumberOfParticles(), 2)

    def test_ranges(self):
        data = particles([(i * 0.1, 0, 0) for i in range(10)], [0.05] * 10)
        mapper, source = scene(data)
        source.Update()
        self.assertTrue(mapper.SetCenterRange(0, 0.2, math.inf))
        self.assertTrue(mapper.AddRange("radius", 0, 1))
        self.assertTrue(mapper.AddRange("radius", 0, 0.01, 1))
        self.assertTrue(mapper.SetRadiusRange(0.01, 1))
        self.assertEqual(mapper.GetNumberOfRanges(), 1)
        mapper.Update()
        self.assertEqual(mapper.GetNumberOfVisibleParticles(), 8)
        limits = [0.0, 0.0]
        mapper.GetCenterRange(0, limits)
        self.assertEqual(limits, [0.2, math.inf])
        bounds = [0.0] * 6
        mapper.GetVisibleBounds(bounds)
        self.assertAlmostEqual(bounds[0], 0.15, 6)
        mapper.RemoveAllRanges()
        mapper.Update()
        self.assertEqual(mapper.GetNumberOfVisibleParticles(), 10)
        self.assertEqual(mapper.GetNumberOfBuilds(), 1)

    def test_area_light(self):
        _, source = scene(particles([(0, 0, 0), (0.4, 0, 0.8)], [0.5, 0.2]))
        light = mote.vtkMoteAreaLight()
        light.SetPosition(1, 0, 2)
        light.SetSize(10)
        light.SetSamples(3)
        source.GetRenderer().AddLight(light)

        def brightness():
            source.Update()
            colors = source.GetOutput().GetPointData().GetScalars()
            return sum(colors.GetComponent(i, 0) for i in range(colors.GetNumberOfTuples()))

        shadowed = brightness()
        light.ShadowsOff()
        self.assertGreater(brightness(), shadowed)

    def test_errors_reach_python(self):
        mapper, source = scene(particles([(0, 0, 0)], [0.5]))
        errors = Errors(mapper)
        mapper.SetRadiusModeToArray()
        mapper.SetRadiusArrayName("size")
        source.Update()
        self.assertEqual(len(errors.texts), 1)
        self.assertIn('no point array "size"', errors.texts[0])
        errors = Errors(source)
        source.SetSize(0, 0)
        source.Update()
        self.assertEqual(len(errors.texts), 1)

    def test_exceptions_for_wrong_types(self):
        mapper, source = scene(particles([(0, 0, 0)], [0.5]))
        with self.assertRaises(TypeError):
            mapper.SetRadius("large")
        with self.assertRaises(TypeError):
            source.SetRenderer(mapper)
        with self.assertRaises(TypeError):
            mapper.SetInputData(vtkActor())

    def test_counts_props_left_out(self):
        _, source = scene(particles([(0, 0, 0)], [0.5]))
        other = vtkActor()
        other.SetMapper(vtkPolyDataMapper())
        source.GetRenderer().AddActor(other)
        source.Update()
        self.assertEqual(source.GetNumberOfIgnoredProps(), 1)

    def test_progress_observers_may_be_python(self):
        _, source = scene(particles([(i * 0.01, 0, 0) for i in range(100)], [0.5] * 100))
        source.SetSize(512, 512)
        seen = []
        source.AddObserver("ProgressEvent", lambda caller, event: seen.append(caller.GetProgress()))
        source.Update()
        self.assertGreater(len(seen), 1)
        self.assertTrue(all(0 <= share <= 1 for share in seen))

    @unittest.skipIf(numpy is None, "numpy is not installed")
    def test_images_become_numpy_arrays(self):
        _, source = scene(particles([(0, 0, 0)], [0.5]))
        source.Update()
        image = source.GetOutput()
        width, height, _ = image.GetDimensions()
        arrays = image.GetPointData()
        color = vtk_to_numpy(arrays.GetScalars()).reshape(height, width, 4)
        self.assertEqual(color.dtype, numpy.float32)
        self.assertTrue(((color >= 0) & (color <= 1)).all())
        ids = vtk_to_numpy(arrays.GetArray("particle")).reshape(height, width)
        self.assertEqual(ids.dtype, numpy.int64)
        self.assertEqual(ids[24, 32], 0)
        covered = (ids == 0).sum() / (24 * 24)  # a pixel is 1/24 wide
        self.assertAlmostEqual(covered, math.pi / 4, 1)

    @unittest.skipIf(numpy is None, "numpy is not installed")
    def test_numpy_arrays_become_particles(self):
        rng = numpy.random.default_rng(1)
        positions = rng.uniform(-0.8, 0.8, (1000, 3))
        values = positions[:, 0].copy()
        points = vtkPoints()
        points.SetData(numpy_to_vtk(positions))
        data = vtkPolyData()
        data.SetPoints(points)
        array = numpy_to_vtk(values)
        array.SetName("x")
        data.GetPointData().SetScalars(array)
        mapper, source = scene(data)
        mapper.SetRadiusModeToConstant()
        mapper.SetRadius(0.02)
        source.Update()
        ids = vtk_to_numpy(source.GetOutput().GetPointData().GetArray("particle"))
        self.assertGreater((ids >= 0).sum(), 100)
        self.assertAlmostEqual(mapper.GetParticleValue(7), values[7])
        positions += 5  # in place: out of view
        points.Modified()
        source.Update()
        ids = vtk_to_numpy(source.GetOutput().GetPointData().GetArray("particle"))
        self.assertEqual((ids >= 0).sum(), 0)

    def test_none_is_a_sentence(self):
        problem = reference("")
        self.assertEqual(len(mote.vtkMoteReaderTable.GetTimeSteps(None, problem)), 0)
        self.assertIn("no reader", str(problem))
        read = mote.vtkMoteAmbientOcclusionBaker.ReadMaps
        self.assertIn("no data", read("maps.moteao", None))


if __name__ == "__main__":
    unittest.main()
