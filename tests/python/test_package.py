"""The package `mote` beside vtkmodules: what it holds and what it says of itself."""

import inspect
import itertools
import subprocess
import sys
import unittest

import mote
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_QUAD, VTK_VOXEL, vtkUnstructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkRenderingCore import vtkAbstractPicker, vtkMapper

CLASSES = [name for name in dir(mote) if name.startswith("vtkMote")]
# What VTK's macros give every class.
OF_EVERY_CLASS = (".IsA", ".NewInstance", ".SafeDownCast")


def said_of(method):
    """The paragraphs of a method's docstring that are not its signatures."""
    paragraphs = (method.__doc__ or "").strip().split("\n\n")
    return [text for text in paragraphs if text.strip() and "C++: " not in text]


class Package(unittest.TestCase):
    def test_names_its_version(self):
        self.assertRegex(mote.__version__, r"^\d+\.\d+\.\d+$")

    def test_holds_the_classes(self):
        for name in [
            "vtkMoteParticleMapper",
            "vtkMoteParticlePicker",
            "vtkMoteRayCastPass",
            "vtkMoteRendererSource",
            "vtkMoteSilhouettePass",
            "vtkMoteSilhouettes",
            "vtkMoteVolumeMapper",
            "vtkMoteReaderTable",
            "vtkMoteLAMMPSDumpReader",
            "vtkMoteCylindricalLocator",
        ]:
            self.assertIn(name, CLASSES)

    def test_knows_its_place_among_vtks_classes(self):
        self.assertIsInstance(mote.vtkMoteParticleMapper(), vtkMapper)
        self.assertIsInstance(mote.vtkMoteParticlePicker(), vtkAbstractPicker)
        self.assertIsInstance(mote.vtkMoteRendererSource(), vtkAlgorithm)

    def test_passes_and_filters_share_silhouettes(self):
        silhouettes = mote.vtkMoteSilhouettes()
        for sharer in [
            mote.vtkMoteRayCastPass(),
            mote.vtkMoteRendererSource(),
            mote.vtkMoteSilhouettePass(),
            mote.vtkMoteSilhouetteFilter(),
        ]:
            sharer.SetSilhouettes(silhouettes)
            self.assertIs(sharer.GetSilhouettes(), silhouettes)

    def test_volumes_say_how_many_cells_they_leave_out_and_why(self):
        points = vtkPoints()
        for place in itertools.product((0, 1), (0, 1), (0, 1)):
            points.InsertNextPoint(place)
        grid = vtkUnstructuredGrid()
        grid.SetPoints(points)
        grid.InsertNextCell(VTK_VOXEL, 8, range(8))
        grid.InsertNextCell(VTK_QUAD, 4, (0, 1, 3, 2))
        heights = vtkFloatArray()
        for i in range(8):
            heights.InsertNextValue(i)
        grid.GetPointData().SetScalars(heights)
        mapper = mote.vtkMoteVolumeMapper()
        mapper.SetInputData(grid)
        mapper.Update()
        self.assertEqual(mapper.GetNumberOfCells(), 1)
        self.assertEqual(mapper.GetNumberOfCellsLeftOut(), 1)
        self.assertEqual(mapper.GetNumberOfCellsLeftOut(mapper.OTHER_TYPE), 1)
        self.assertEqual(mapper.GetNumberOfCellsLeftOut(mapper.UNFIT_POLYHEDRON), 0)

    def test_every_class_has_a_docstring(self):
        for name in CLASSES:
            with self.subTest(name):
                self.assertGreater(len((getattr(mote, name).__doc__ or "").split()), 8)

    def test_methods_have_docstrings_of_their_own(self):
        self.assertIn("Multiplies the radius", mote.vtkMoteParticleMapper.SetRadiusScale.__doc__)
        self.assertIn("Multiplies the radius", mote.vtkMoteParticleMapper.GetRadiusScale.__doc__)
        silent = [
            f"{name}.{method}"
            for name in CLASSES
            for method, held in vars(getattr(mote, name)).items()
            if callable(held) and not isinstance(held, type)
            if not method.startswith("_") and not said_of(held)
        ]
        self.assertEqual([name for name in silent if not name.endswith(OF_EVERY_CLASS)], [])

    def test_every_class_prints_itself(self):
        for name in CLASSES:
            with self.subTest(name):
                try:
                    made = getattr(mote, name)()
                except TypeError as error:
                    self.assertIn("abstract", str(error))
                    continue
                self.assertIn(name, str(made))

    def test_imports_first_of_all(self):
        # Not after a vtkmodules that a program has imported by chance.
        code = "import mote; m = mote.vtkMoteParticleMapper(); print(m.GetClassName())"
        done = subprocess.run(
            [sys.executable, "-c", code], capture_output=True, text=True, check=False
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout.strip(), "vtkMoteParticleMapper")

    def test_star_imports_classes_alone(self):
        self.assertEqual(mote.__all__, CLASSES)

    def test_holds_nothing_else_but_functions(self):
        functions = {"Error", "Image", "Scene", "film", "mesh", "particles", "read", "render"}
        functions |= {"settings", "show", "volume", "write"}
        strangers = {
            name
            for name in dir(mote)
            if not name.startswith("_")
            and not name.startswith("vtkMote")
            and not inspect.ismodule(getattr(mote, name))
        }
        self.assertEqual(strangers - functions, set())


if __name__ == "__main__":
    unittest.main()
