"""The functions that a person types: scenes of NumPy arrays and files, and pictures of them."""

import ast
import gc
import inspect
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading
import unittest
import warnings

import mote

try:
    import numpy as np
    from vtkmodules.util.numpy_support import vtk_to_numpy
except ImportError:
    sys.exit(77)  # skipped: the functions need NumPy

DATA = pathlib.Path(os.environ["MOTE_SOURCE_DIR"]) / "data"
DUMP = DATA / "hopper.dump.gz"
SMALL = {"size": (160, 120), "samples": 1}


def lattice(n=5, dtype=np.float64):
    return np.stack(np.meshgrid(*[np.arange(n)] * 3, indexing="ij"), -1).reshape(-1, 3).astype(dtype)


def same(one, other):
    return np.array_equal(one.array, other.array)


class Folder(unittest.TestCase):
    def setUp(self):
        self.assertNotIn("DISPLAY", os.environ)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)


class Scenes(Folder):
    def test_points_are_not_copied(self):
        for dtype in (np.float32, np.float64):
            points = lattice(dtype=dtype)
            scene = mote.particles(points, radius=0.4)
            self.assertTrue(np.shares_memory(points, scene.points))
            before = scene.render(**SMALL)
            del points
            gc.collect()
            np.ones(3 * 5**3, dtype)  # which would take the place of what was freed
            self.assertTrue(same(before, scene.render(**SMALL)))

    def test_points_of_other_forms(self):
        flat = mote.particles(lattice()[:, :2], radius=0.4)
        self.assertEqual(flat.points.shape, (125, 3))
        whole = mote.particles(lattice(dtype=np.int16), radius=0.4)
        self.assertTrue(same(whole.render(**SMALL), mote.particles(lattice(), radius=0.4).render(**SMALL)))
        strided = mote.particles(np.asfortranarray(lattice()), radius=0.4)
        self.assertTrue(same(whole.render(**SMALL), strided.render(**SMALL)))
        for wrong in (np.zeros(3), np.zeros((4, 4)), "none"):
            with self.assertRaises(ValueError):
                mote.particles(wrong)

    def test_radii_and_colors(self):
        points = lattice()
        number = mote.particles(points, radius=0.3, color="tomato").render(**SMALL)
        self.assertFalse(same(number, mote.particles(points, radius=0.4, color="tomato").render(**SMALL)))
        array = mote.particles(points, radius=np.full(125, 0.3), color="tomato").render(**SMALL)
        self.assertTrue(same(number, array))
        colored = mote.particles(points, radius=0.3, color=points[:, 0])
        named = mote.particles(points, radius=0.3, color="x position", arrays={"x position": points[:, 0]})
        plain = {**SMALL, "legend": False}
        self.assertTrue(same(colored.render(**plain), named.render(**plain)))
        self.assertFalse(same(colored.render(**plain), number))
        with self.assertRaises(ValueError):
            mote.particles(points, color=np.zeros(7))
        with self.assertRaises(TypeError):
            mote.particles(points, color=np.array(["a"] * 125))

    def test_masked_values_are_none(self):
        points = lattice()
        inside = points[:, 0] < 3
        hidden = np.ma.masked_array(points, mask=np.repeat(~inside, 3).reshape(-1, 3))
        with self.assertWarnsRegex(UserWarning, "50 with a position that is not finite"):
            shown = mote.particles(hidden, radius=0.4).render(**SMALL)
        self.assertTrue(same(shown, mote.particles(np.where(inside[:, None], points, np.nan), 0.4).render(**SMALL)))
        for values in (points[:, 2], points[:, 2].astype(np.int32)):
            masked = mote.particles(points, 0.4, np.ma.masked_greater(values, 3))
            self.assertEqual(np.isnan(masked["color"]).sum(), 25)
        whole = np.ma.masked_greater(np.arange(125, dtype=np.int32), 999)
        self.assertEqual(mote.particles(points, 0.4, whole)["color"].dtype, np.int32)

    def test_words_are_types(self):
        plain = {**SMALL, "caption": False}
        atoms = self.folder / "atoms.xyz"
        for names, numbers in ((("O", "Fe", "H"), (8, 26, 1)), (("B1", "A2", "Na"), (2, 1, 3))):
            words = np.array([names[i * i % 3] for i in range(125)])
            rows = [f"{word} {x} {y} {z}" for word, (x, y, z) in zip(words, lattice())]
            atoms.write_text("\n".join(["125", "atoms", *rows, ""]))
            read = mote.read(atoms, radius=0.4)
            for types in (words, list(words), words.astype(object), words.astype("S")):
                scene = mote.particles(lattice(), radius=0.4, types=types)
                for word, number in zip(names, numbers):
                    self.assertTrue((scene["type"][words == word] == number).all())
                self.assertTrue(np.array_equal(scene["type"], read["type"]))
                self.assertTrue(same(scene.render(**plain), read.render(**plain)))

    def test_arrays_by_name(self):
        scene = mote.particles(lattice(), radius=0.4, types=np.arange(125) % 3)
        self.assertEqual(scene.keys(), ["type"])
        scene["height"] = scene.points[:, 2]
        self.assertIn("height", scene)
        self.assertTrue(np.array_equal(scene["height"], scene.points[:, 2]))
        with self.assertRaisesRegex(KeyError, "height"):
            scene["depth"]
        with self.assertRaisesRegex(ValueError, "125 points"):
            scene["depth"] = [1, 2]

    def test_values_that_change_are_seen(self):
        scene = mote.particles(lattice(), radius=0.4, color=lattice()[:, 0])
        before = scene.render(**SMALL)
        scene["color"] = lattice()[:, 2]
        after = scene.render(**SMALL)
        self.assertFalse(same(before, after))
        fresh = mote.particles(lattice(), radius=0.4, color=lattice()[:, 2])
        self.assertTrue(same(after, fresh.render(**SMALL)))

    def test_a_view_that_is_kept_draws_what_a_fresh_one_does(self):
        scene = mote.particles(lattice(), radius=0.4, color=lattice()[:, 0])
        for settings in ({}, {"azimuth": 30}, {"show": {"x": (1, None)}}, {"shadows": "hard"}, {}):
            fresh = mote.particles(lattice(), radius=0.4, color=lattice()[:, 0])
            self.assertTrue(same(scene.render(**SMALL, **settings), fresh.render(**SMALL, **settings)))

    def test_meshes_and_volumes(self):
        corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0.0]])
        mesh = mote.mesh(corners, [[0, 1, 2], [1, 3, 2]], color=[0.0, 1.0])
        self.assertEqual(mesh.render(**SMALL).contents, "2 triangles")
        with self.assertRaisesRegex(ValueError, "from 0 to 3"):
            mote.mesh(corners, [[0, 1, 4]])
        values = np.arange(4 * 5 * 6.0).reshape(4, 5, 6)
        volume = mote.volume(values, spacing=(1, 2, 3))
        self.assertIn("60 cells", volume.render(**SMALL).contents)
        image = volume.data[0]
        self.assertEqual(image.GetScalarComponentAsDouble(3, 4, 5, 0) if image.GetPointData().GetScalars()
                         else image.GetPointData().GetArray("value").GetValue(3 + 4 * (4 + 5 * 5)), values[3, 4, 5])
        with self.assertRaises(ValueError):
            mote.volume(np.zeros((3, 3)))

    def test_data_of_vtk_stay_as_they_are(self):
        mesh = mote.mesh(lattice(2)[:3], [[0, 1, 2]]).data[0]
        colored = mote.mesh(mesh, color=[1.0, 2.0, 3.0])
        self.assertEqual(colored.keys(), ["color"])
        self.assertEqual(mesh.GetPointData().GetNumberOfArrays(), 0)
        self.assertIs(colored.data[0].GetPoints(), mesh.GetPoints())
        self.assertIs(mote.mesh(mesh).data[0], mesh)

    def test_scenes_are_added(self):
        left = mote.particles(lattice(), radius=0.3, color="tomato")
        right = mote.particles(lattice() + [7, 0, 0], radius=0.3)
        self.assertIn("250 particles", (left + right).render(**SMALL).contents)
        self.assertIn("250 particles", mote.render([left, right], **SMALL).contents)


class Locales(Folder):
    def test_decimal_commas_of_the_program_change_nothing(self):
        made = shutil.which("localedef") and subprocess.run(
            ["localedef", "-i", "de_DE", "-f", "UTF-8", self.folder / "de_DE.UTF-8"],
            capture_output=True).returncode
        if made != 0:
            self.skipTest("no German locale can be made")
        draw = f"""if True:
            import hashlib, locale, sys, mote, numpy
            if sys.argv[1:]:
                locale.setlocale(locale.LC_ALL, "de_DE.UTF-8")
                assert locale.str(0.5) == "0,5"
            points = numpy.random.default_rng(1).random((500, 3))
            scene = mote.particles(points, radius=0.015, color=points[:, 2], range=[0.25, 0.75],
                                   show={{"x": (0.1, 0.9)}}, where="y > 0.25", radius_scale="0.5")
            cut = mote.read({str(DATA / "swirl.0.vtu")!r}, cut="x=0.001:", slice="z=0.05")
            for one in scene, cut:
                print(hashlib.md5(one.render(size=(320, 240), samples=1).array.tobytes()).hexdigest())
            """
        told = [subprocess.run([sys.executable, "-c", draw, *words], capture_output=True, text=True,
                               check=True, env=dict(os.environ, LOCPATH=str(self.folder))).stdout
                for words in ([], ["in German"])]
        self.assertEqual(*told)


class Again(Folder):
    def test_the_first_picture_is_as_the_later_ones(self):
        for settings in ({"arrows": 30}, {"streamlines": 8, "color_by": "z"}, {"arrows": 30, "color_by": "none"}):
            scene = mote.read(DATA / "swirl.0.vtu", **settings)
            first = scene.render(**SMALL)
            self.assertTrue(same(first, scene.render(**SMALL)), settings)
            self.assertFalse(same(first, mote.read(DATA / "swirl.0.vtu").render(**SMALL)))


class Files(Folder):
    def test_the_picture_is_that_of_the_program(self):
        whole = {"size": (320, 240), "samples": 4, "caption": "hopper"}
        picture = mote.read(DUMP, color_by="v:magnitude").render(**whole)
        done = subprocess.run(
            [sys.executable, "-m", "mote", "render", DUMP, "-o", "a.png", "--size", "320x240", "--samples", "4",
             "--color-by", "v:magnitude", "--caption", "hopper"],
            cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        from vtkmodules.vtkIOImage import vtkPNGReader

        reader = vtkPNGReader()
        reader.SetFileName(str(self.folder / "a.png"))
        reader.Update()
        pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(240, 320, -1)[::-1]
        self.assertLessEqual(np.abs(pixels.astype(int) - picture.array).max(), 1)

    def test_time_steps(self):
        scene = mote.read(DUMP)
        self.assertEqual(len(scene.times), 7)
        self.assertEqual([len(frame) for frame in scene.steps()], [len(scene.at(i)) for i in range(7)])
        self.assertTrue(np.array_equal(scene.at(-1).points, scene.points))
        self.assertFalse(np.array_equal(scene.at(0).points, scene.points))
        with self.assertRaises(IndexError):
            scene.at(7)
        with self.assertRaises(IndexError):
            mote.particles(lattice()).at(0)

    def test_pictures_are_written(self):
        picture = mote.render(DUMP, output=self.folder / "a.png", **SMALL)
        picture.save(self.folder / "b.png")
        self.assertEqual((self.folder / "a.png").stat().st_size > 1000, True)
        self.assertEqual(picture._repr_png_()[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(mote.read(DUMP)._repr_png_()[:4], b"\x89PNG")
        with self.assertRaisesRegex(mote.Error, "nowhere"):
            picture.save("/nowhere/a.png")
        with self.assertRaisesRegex(mote.Error, "animate"):
            mote.render(DUMP, output=self.folder / "a.mp4", **SMALL)

    def test_films(self):
        scene = mote.particles(lattice(), radius=0.4)
        frames = (scene.render(**SMALL, azimuth=10 * i) for i in range(3))
        mote.film(frames, self.folder / "turn.ogv", rate=10)
        self.assertEqual((self.folder / "turn.ogv").read_bytes()[:4], b"OggS")
        with self.assertRaisesRegex(mote.Error, "one size"):
            mote.film([scene.render(**SMALL), scene.render(size=(64, 64))], self.folder / "two.ogv")
        self.assertEqual(os.listdir(self.folder), ["turn.ogv"])
        for path, images in (("film.txt", []), ("none.ogv", [])):
            with self.assertRaises(mote.Error):
                mote.film(images, self.folder / path)


    def test_data_are_written(self):
        points = np.random.default_rng(5).random((500, 3))
        scene = mote.particles(points, radius=0.1, color=points[:, 0] ** 3)
        for name in ("a.vtp", "a.vtu", "a.xyz", "a.xyz.gz"):
            path = self.folder / name
            mote.write(scene, path)
            again = mote.read(path)
            np.testing.assert_array_equal(again.points, scene.points, name)
            for key in scene.keys():
                np.testing.assert_array_equal(again[key], scene[key], name)
        with self.assertRaisesRegex(mote.Error, "must end in"):
            mote.write(scene, self.folder / "a.txt")
        with self.assertRaisesRegex(mote.Error, "folder does not exist"):
            mote.write(scene, "/nowhere/a.vtp")
        with self.assertRaisesRegex(ValueError, "the scene has 2"):
            mote.write(scene + scene, self.folder / "b.vtp")
        self.assertEqual(len(os.listdir(self.folder)), 4)
        mote.write(scene + scene, self.folder / "b.vtm")
        both = mote.read(self.folder / "b.vtm")
        self.assertEqual(len(both.data), 2)
        for data in both.data:
            self.assertEqual(data.GetNumberOfPoints(), 500)


class Errors(Folder):
    def test_settings(self):
        scene = mote.particles(lattice(), radius=0.4)
        with self.assertRaisesRegex(TypeError, "did you mean color_by"):
            scene.render(colour_by="x")
        with self.assertRaisesRegex(ValueError, "shadows: 'dark'"):
            scene.render(shadows="dark")
        with self.assertRaisesRegex(ValueError, "exclude"):
            scene.render(range=(0, 1), percentiles=(1, 99))
        with self.assertRaisesRegex(TypeError, "Scene.at"):
            scene.render(step=1)
        with self.assertRaises(TypeError):
            scene.render(shadows=object())
        with self.assertRaises(ValueError):
            scene.render(show={"x": (1, 2, 3)})

    def test_numbers(self):
        for radius in (0, -1.0, np.nan, np.inf):
            with self.assertRaisesRegex(ValueError, "radius must be a number above zero"):
                mote.particles(lattice(), radius)
        with self.assertRaisesRegex(TypeError, "complex"):
            mote.particles(lattice().astype(complex))
        scene = mote.particles(lattice(), radius=0.4)
        for wrong in (np.nan, float("inf"), np.float32("-inf")):
            with self.assertRaisesRegex(ValueError, "light"):
                scene.render(light_size=wrong)
        open_range = scene.render(show={"x": (-np.inf, 2)}, **SMALL)
        self.assertTrue(same(open_range, scene.render(show={"x": (None, 2)}, **SMALL)))

    def test_data(self):
        with self.assertRaisesRegex(mote.Error, "there is no such file"):
            mote.read(self.folder / "nothing.dump")
        with self.assertRaisesRegex(mote.Error, "'mass'"):
            mote.render(DUMP, color_by="mass", **SMALL)
        with self.assertRaises(TypeError):
            mote.render(7)
        with self.assertRaises(mote.Error):
            mote.show(mote.particles(lattice()))  # where there is no display

    def test_a_scene_is_drawn_after_an_error(self):
        scene = mote.particles(lattice(), radius=0.4)
        before = scene.render(**SMALL)
        with self.assertRaises(mote.Error):
            scene.render(color_by="mass", **SMALL)
        self.assertTrue(same(before, scene.render(**SMALL)))

    def test_threads_draw_at_the_same_time(self):
        pictures = [None] * 4

        def draw(i):
            scene = mote.particles(lattice() * (i + 1), radius=0.4)
            for _ in range(5):
                pictures[i] = scene.render(**SMALL)

        threads = [threading.Thread(target=draw, args=(i,)) for i in range(len(pictures))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for i, picture in enumerate(pictures):
            self.assertTrue(same(picture, mote.particles(lattice() * (i + 1), radius=0.4).render(**SMALL)))

    def test_warnings_are_pythons(self):
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            mote.volume(np.zeros((3, 3, 3)) + lattice(3)[:, 0].reshape(3, 3, 3), iso=[99.0]).render(**SMALL)
        self.assertRegex(" ".join(str(one.message) for one in told), "99")


WINDOW = """
"$0" -c 'import mote, numpy as np
scene = mote.particles(np.random.rand(100, 3), radius=0.05, name="grains")
mote.show(scene, size=(600, 400), panel=False)
print("closed")' &
process=$!
for _ in $(seq 300); do
  window=$(xdotool search --onlyvisible --name grains 2>/dev/null | head -1)
  [ -n "$window" ] && break
  sleep 0.1
done
xdotool windowfocus --sync "$window"
for _ in $(seq 300); do
  xdotool key s
  ls *.png >/dev/null 2>&1 && break
  sleep 0.5
done
xdotool key q
wait $process
"""


class Window(Folder):
    def test_shows_until_it_is_closed(self):
        screen = "-screen 0 800x600x24 -noreset"
        done = subprocess.run(
            ["xvfb-run", "-a", "-s", screen, "bash", "-c", WINDOW, sys.executable],
            cwd=self.folder, capture_output=True, text=True, timeout=200, check=False,
            env={**os.environ, "XDG_STATE_HOME": str(self.folder / "state")})
        self.assertEqual((done.returncode, done.stdout), (0, "closed\n"), done.stderr)
        self.assertTrue(list(self.folder.glob("*.png")))


class Help(Folder):
    def test_settings_are_told(self):
        self.assertIn("Array that colours", mote.settings()["color_by"])
        self.assertIn("shadows: ", mote.render.__doc__)
        for name in ("particles", "mesh", "volume", "read", "render", "show", "film", "settings", "write"):
            self.assertGreater(len(inspect.getdoc(getattr(mote, name)).split()), 8, name)

    def test_stubs(self):
        package = pathlib.Path(mote.__file__).parent
        stub = ast.parse((package / "functions.pyi").read_text())
        functions = {one.name: one for one in stub.body if isinstance(one, ast.FunctionDef)}
        known = [one.arg for one in functions["render"].args.args + functions["render"].args.kwonlyargs]
        for name in ("shadows", "color_by", "silhouettes", "output"):
            self.assertIn(name, known)
        classes = {one.name for one in ast.parse((package / "__init__.pyi").read_text()).body
                   if isinstance(one, ast.ClassDef)}
        self.assertEqual(classes, {name for name in dir(mote) if name.startswith("vtkMote")})
        self.assertTrue((package / "py.typed").exists())

    def test_the_program(self):
        done = subprocess.run([sys.executable, "-m", "mote", "--version"], capture_output=True, text=True, check=False)
        self.assertEqual(done.stdout.strip(), "mote " + mote.__version__)
        done = subprocess.run([sys.executable, "-m", "mote", "render"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2)


if __name__ == "__main__":
    unittest.main()
