"""The functions that a person types: scenes of particles, meshes and volumes, and pictures of them."""

import json
import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkCompositeDataSet,
    vtkDataObject,
    vtkDataSet,
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkPolyData,
)
from vtkmodules.vtkIOImage import vtkPNGWriter

from . import _program
from ._settings import _ROWS, _checked, _plain, _sentence, _size

Error = _program.Error


def settings():
    """The names of all settings that render(), show() and the makers of scenes take, with what each
    does: {"color_by": "Array that colours: ...", ...}. Those of the window alone are show()'s."""
    return {name.replace("-", "_"): _sentence(row) for name, row in _ROWS.items()}


class Image:
    """A picture that render() made.

    ``array`` is its pixels, uint8 of shape (height, width, 3), the upper row first.
    ``contents`` tells what it shows, ``trace_time`` the seconds that tracing took. A notebook shows it,
    and numpy.asarray() is ``array``.
    """

    def __init__(self, image, contents="", trace_time=0.0):
        self._image = image
        self.contents = contents
        self.trace_time = trace_time

    @property
    def array(self):
        width, height, _ = self._image.GetDimensions()
        scalars = self._image.GetPointData().GetScalars()
        return vtk_to_numpy(scalars).reshape(height, width, -1)[::-1]

    @property
    def size(self):
        """(width, height) in pixels."""
        return tuple(self._image.GetDimensions()[:2])

    def __array__(self, dtype=None):
        return self.array if dtype is None else self.array.astype(dtype)

    def vtk(self):
        """The picture as a vtkImageData, its lower row first."""
        return self._image

    def save(self, path):
        """Writes .png, .jpg or .tif. Raises mote.Error where that cannot be written."""
        from . import vtkMoteImageWriter

        writer = vtkMoteImageWriter()
        writer.AddObserver("ErrorEvent", lambda *_: None)  # the exception tells it
        writer.SetInputData(self._image)
        writer.SetFileName(os.fspath(path))
        if not writer.CheckFileName() or not writer.Write():
            raise Error(writer.GetErrorMessage())

    def _repr_png_(self):
        writer = vtkPNGWriter()
        writer.SetInputData(self._image)
        writer.WriteToMemoryOn()
        writer.Write()
        return bytes(memoryview(writer.GetResult()))

    def __repr__(self):
        return "<mote.Image of {}x{} pixels, {}>".format(*self.size, self.contents)


class Scene:
    """Data and the settings that they are drawn with. particles(), mesh(), volume() and read() make
    them; ``scene + scene`` shows both, by the settings of both, of which the first one's go before. A
    notebook shows a small picture.

    ``scene[name]`` is an array of the first data set as NumPy has it, of its points, or cells where
    points have none of that name; ``scene[name] = values`` adds one, without a copy where it can.
    ``points`` are its coordinates.
    """

    def __init__(self, data, settings=None, files=None, names=(), step=0):
        self._data = list(data)  # (name, vtkDataObject)
        self.settings = dict(settings or {})
        self._files = files  # what read() opened, and by which names
        self._names = names
        self._step = step
        self._is_as_read = files is not None  # without arrays that were added
        self._view = _program.View()

    # The data.

    @property
    def data(self):
        """The data sets, as VTK has them."""
        return [data for _, data in self._data]

    @property
    def _first(self):
        for _, data in self._data:
            if isinstance(data, vtkDataSet):
                return data
        raise Error("this scene has no data set of points")

    @property
    def points(self):
        """Coordinates of the points, of shape (n, 3), without a copy."""
        points = self._first.GetPoints() if hasattr(self._first, "GetPoints") else None
        if points is None:
            raise Error("the points of this data set have no coordinates of their own")
        return vtk_to_numpy(points.GetData())

    def keys(self):
        """Names of the arrays, of points and then of cells."""
        fields = (self._first.GetPointData(), self._first.GetCellData())
        return [f.GetArrayName(i) for f in fields for i in range(f.GetNumberOfArrays())]

    def __contains__(self, name):
        return name in self.keys()

    def __iter__(self):
        return iter(self.keys())

    def __getitem__(self, name):
        for field in (self._first.GetPointData(), self._first.GetCellData()):
            if field.GetArray(name):
                return vtk_to_numpy(field.GetArray(name))
        raise KeyError(f"there is no array {name}; there are {', '.join(self.keys()) or 'none'}")

    def __setitem__(self, name, values):
        data = self._first
        values = _unmasked(values)
        counts = (data.GetNumberOfPoints(), data.GetNumberOfCells())
        if values.ndim == 0 or values.shape[0] not in counts:
            raise ValueError(
                f"array {name} has {values.shape[0] if values.ndim else 1} values, and there are "
                f"{counts[0]} points and {counts[1]} cells"
            )
        field = data.GetPointData() if values.shape[0] == counts[0] else data.GetCellData()
        field.AddArray(_array(name, values))
        data.Modified()
        self._is_as_read = False

    def __len__(self):
        return self._first.GetNumberOfPoints()

    # Time.

    @property
    def times(self):
        """The times of the steps in the files; none where they have no time."""
        return list(self._files.times) if self._files else []

    def at(self, step):
        """The scene at another time step, from 0; -1 is the last."""
        count = max(1, len(self.times))
        if not self._files or not -count <= step < count:
            raise IndexError(f"there is no step {step}; there are {count}")
        step %= count
        return Scene(self._files.read(step), self.settings, self._files, self._names, step)

    def steps(self):
        """The scene at each of its time steps, one after the other."""
        for step in range(max(1, len(self.times))):
            yield self.at(step)

    # Pictures.

    def __add__(self, other):
        return Scene(self._data + other._data, {**other.settings, **self.settings})

    def with_settings(self, **settings):
        """The same data with other settings, beside those that the scene has."""
        other = Scene(self._data, {**self.settings, **_checked(settings, "with_settings")})
        other._files, other._names, other._step = self._files, self._names, self._step
        other._is_as_read, other._view = self._is_as_read, self._view
        return other

    def render(self, size=None, output=None, **settings):
        """As mote.render() of this scene."""
        return render(self, size, output, **settings)

    def _repr_png_(self):
        return render(self, (640, 480))._repr_png_()

    def __repr__(self):
        return "<mote.Scene of {}>".format(
            ", ".join(f"{name}, {data.GetClassName()}" for name, data in self._data) or "nothing"
        )


def _array(name, values):
    """An array of VTK over the values of one of NumPy, which it keeps alive; a copy where the values do
    not lie one after the other or have a type that VTK has not."""
    values = _unmasked(values)
    if values.dtype == bool or values.dtype == np.float16:
        values = values.astype(np.uint8 if values.dtype == bool else np.float32)
    if values.dtype.kind not in "iuf" or values.dtype.itemsize > 8:
        raise TypeError(f"array {name} has values of type {values.dtype}; numbers are needed")
    if values.ndim > 2:
        values = values.reshape(len(values), -1)
    array = numpy_to_vtk(np.ascontiguousarray(values.astype(values.dtype.newbyteorder("="), copy=False)))
    array.SetName(name)
    return array


def _unmasked(values):
    """An array of NumPy; NaN stands for what a mask hides."""
    if np.ma.is_masked(values):
        wide = values.dtype if values.dtype.kind == "f" else np.float64
        return values.astype(wide).filled(np.nan)
    return np.asarray(values)


def _points(points, what):
    points = _unmasked(points)
    if points.ndim != 2 or points.shape[1] not in (2, 3):
        raise ValueError(f"{what} are an array of shape (n, 3), or (n, 2), not {points.shape}")
    if points.dtype.kind not in "biuf":
        raise TypeError(f"{what} have coordinates of type {points.dtype}; numbers are needed")
    if points.dtype not in (np.float32, np.float64):
        points = points.astype(np.float64)
    if points.shape[1] == 2:
        points = np.column_stack([points, np.zeros(len(points), points.dtype)])
    made = vtkPoints()
    made.SetData(_array("points", points))
    return made


def _with_arrays(data, arrays, kind):
    scene = Scene([(kind, data)])
    for name, values in (arrays or {}).items():
        scene[name] = values
    return scene


def _given(data, arrays, color):
    """Data of VTK as they are, or, where arrays come to them, an object of the scene's own that shares theirs."""
    if not arrays and (color is None or isinstance(color, str)):
        return data
    own = data.NewInstance()
    own.ShallowCopy(data)
    return own


def _color(scene, color):
    """Has the scene the colour: the values of an array, the name of one, or a colour for all."""
    if color is None:
        return {}
    if isinstance(color, str):
        known = color.split(":")[0] in scene.keys()
        return {"color-by": color} if known else {"color-by": "none", "plain-color": color}
    scene["color"] = color
    return {"color-by": "color"}


def _types(data, types):
    """Numbers of types, of which the data are told where they are words. As of files, elements have
    those of the periodic table, 0 where there is none ("X"); else words have their places in
    alphabetical order, from 1."""
    types = np.asarray(types)
    if types.dtype.kind not in "OUS":
        return types
    from vtkmodules.vtkDomainsChemistry import vtkPeriodicTable

    words, places = np.unique(types.astype(str), return_inverse=True)
    table = vtkPeriodicTable()
    numbers = np.array([table.GetAtomicNumber(word) for word in words], np.int32)
    if not np.all((numbers > 0) | np.isin(words, ("X", "Xx"))):
        numbers = np.arange(1, len(words) + 1, dtype=np.int32)
    names = vtkStringArray()
    names.SetName("type_names")
    for number, word in zip(numbers, words):
        names.InsertNextValue(f"{number}={word}")
    data.GetFieldData().AddArray(names)
    return numbers[places]


def particles(points, radius=None, color=None, *, types=None, arrays=None, name="particles", **settings):
    """A scene of particles, drawn as spheres.

    points: their centres, of shape (n, 3) or (n, 2). Those of float32 or float64 are not copied, so
        leave them as they are while the scene lives.
    radius: a number for all, an array of n, or the name of one of ``arrays``; None: half the typical
        distance between neighbours.
    color: values, an array of n, the name of one of ``arrays``, or a colour such as "tomato" for all.
    types: one a particle, whole numbers or words such as "Fe", which have a colour each where nothing
        else colours: words that are chemical elements have the elements'.
    arrays: more arrays by their names: {"speed": ..., "force": ...}.
    settings: as render() has them.

    >>> mote.particles(np.random.rand(1000, 3), radius=0.02, color="tomato")
    """
    data = vtkPolyData()
    data.SetPoints(_points(points, "centres of particles"))
    scene = _with_arrays(data, arrays, name)
    given = {}
    if types is not None:
        scene["type"] = _types(data, types)
    if isinstance(radius, str):
        given["radius"] = radius
    elif np.isscalar(radius):
        if not 0 < radius < np.inf:
            raise ValueError(f"radius must be a number above zero, not {radius}")
        given["radius"] = _plain(radius)
    elif radius is not None:
        scene["radius"] = radius
        given["radius"] = "radius"
    scene.settings = {**given, **_color(scene, color), **_checked(settings, "particles")}
    return scene


def mesh(points, triangles=None, color=None, *, arrays=None, name="mesh", **settings):
    """A scene of a mesh of triangles.

    points: corners, of shape (n, 3), not copied; or a vtkPolyData that has all.
    triangles: indices of three corners each, of shape (m, 3).
    color, arrays: as particles() has them, of n corners or m triangles.
    """
    if isinstance(points, vtkDataObject):
        data = _given(points, arrays, color)
    else:
        corners = np.asarray(triangles if triangles is not None else ())
        if corners.ndim != 2 or corners.shape[1] != 3 or corners.dtype.kind not in "iu":
            raise ValueError("triangles are an array of whole numbers of shape (m, 3)")
        if corners.size and not 0 <= corners.min() <= corners.max() < len(points):
            raise ValueError(f"triangles name corners from 0 to {len(points) - 1}")
        data = vtkPolyData()
        data.SetPoints(_points(points, "corners of a mesh"))
        cells = vtkCellArray()
        offsets = np.arange(0, corners.size + 1, 3, dtype=np.int64)
        cells.SetData(
            numpy_to_vtkIdTypeArray(offsets, deep=True),
            numpy_to_vtkIdTypeArray(np.ascontiguousarray(corners, np.int64).ravel(), deep=True),
        )
        data.SetPolys(cells)
    scene = _with_arrays(data, arrays, name)
    scene.settings = {**_color(scene, color), **_checked(settings, "mesh")}
    return scene


def volume(grid, color=None, *, spacing=(1, 1, 1), origin=(0, 0, 0), arrays=None, name="volume", **settings):
    """A scene of a volume: cells that are looked into.

    grid: data of VTK, such as a vtkUnstructuredGrid or a vtkMultiBlockDataSet, which is not copied; or
        values on the points of a regular grid, an array of shape (nx, ny, nz), ``spacing`` apart from
        ``origin`` on, called "value".
    color, arrays: as particles() has them, of points or cells.
    """
    if isinstance(grid, vtkDataObject):
        data = _given(grid, arrays, color)
    else:
        values = _unmasked(grid)
        if values.ndim != 3 or min(values.shape) < 2:
            raise ValueError("values on a grid are an array of shape (nx, ny, nz), two at least along each")
        data = vtkImageData()
        data.SetDimensions(values.shape)
        data.SetSpacing(spacing)
        data.SetOrigin(origin)
        data.GetPointData().AddArray(_array("value", values.ravel(order="F")))
        color = "value" if color is None else color
    scene = _with_arrays(data, arrays, name)
    scene.settings = {**_color(scene, color), **_checked(settings, "volume")}
    return scene


def read(*paths, step=-1, **settings):
    """A scene of files, of every kind that `mote` reads: `mote --help` lists them. Files that differ in a
    number alone are time steps of one series. ``step`` counts from 0; -1 is the last.

    >>> mote.read("run.dump", color_by="c_pe", radius=1.4)
    """
    if not paths:
        raise TypeError("read() needs a file")
    names = []
    for path in paths:
        names += [path] if isinstance(path, (str, os.PathLike)) else list(path)
    names = [os.fspath(name) for name in names]
    return Scene([], _checked(settings, "read"), _program.Files(names), names).at(step)


def _as_scene(scene):
    if isinstance(scene, Scene):
        return scene
    if isinstance(scene, vtkDataObject):
        return Scene([("data", scene)])
    if isinstance(scene, (str, os.PathLike)):
        return read(scene)
    if isinstance(scene, (list, tuple)) and scene:
        whole = _as_scene(scene[0])
        for other in scene[1:]:
            whole = whole + _as_scene(other)
        return whole
    raise TypeError(f"a scene, data of VTK or the name of a file is needed, not {type(scene).__name__}")


def render(scene, size=None, output=None, **settings):
    """Draws a scene, and returns a mote.Image. Needs no display.

    scene: what particles(), mesh(), volume() or read() made, data of VTK, the name of a file, or a list
        of these.
    size: (width, height) in pixels; 1280x960 by default.
    output: a file to write, too: .png, .jpg, .tif, or .exr with depths, normals and ids.
    settings: every option of `mote render`, with _ for -: shadows="soft", show={"c_pe": (-3, None)},
        range=(0, 5), silhouettes=True. They go before those of the scene. mote.settings() lists them.

    Raises TypeError for a setting that there is not, ValueError for a value that it cannot take, and
    mote.Error for what cannot be drawn or written. What a picture of the same scene has built before is
    not built again.
    """
    scene = _as_scene(scene)
    chosen = {**scene.settings, **_checked(settings, "render")}
    if size is not None:
        chosen["size"] = _size(size)
    image, contents, seconds = scene._view.draw(
        scene._data, json.dumps(chosen), os.fspath(output) if output else ""
    )
    return Image(image, contents, seconds)


def show(scene, **settings):
    """Opens the window on a scene, and returns when it is closed. Takes the settings of render(), and those
    of `mote`. A scene of files, to which no array was added, shows all their time steps. Raises mote.Error
    where there is no display."""
    scene = _as_scene(scene)
    chosen = {**scene.settings, **_checked(settings, "show")}
    if scene._is_as_read:
        _program.show([], scene._names, json.dumps({**chosen, "step": str(scene._step + 1)}))
    else:
        _program.show(scene._data, [], json.dumps(chosen))


def _blocks(scene):
    blocks = vtkMultiBlockDataSet()
    for index, (name, data) in enumerate(scene._data):
        blocks.SetBlock(index, data)
        blocks.GetMetaData(index).Set(vtkCompositeDataSet.NAME(), name)
    return blocks


def write(scene, path):
    """Writes the data of a scene as a file that other programs read: .vtp for particles and surfaces, .vtu for
    any cells, .xyz or .xyz.gz (extended XYZ) for particles, .vtm for any number of data sets, as blocks. All of
    them, whatever the settings hide.

    scene: what render() takes; it must hold one data set, but for .vtm.
    path: the file, which is replaced where it is there. It appears whole or not at all.

    Raises ValueError for a scene of several data sets, and mote.Error for what cannot be written.

    >>> mote.write(mote.read("run.dump"), "run.xyz")
    """
    from . import vtkMoteBlocksWriter, vtkMoteDataWriter

    scene = _as_scene(scene)
    if vtkMoteBlocksWriter.EndingOf(os.fspath(path)):
        writer = vtkMoteBlocksWriter()
        writer.SetInputData(_blocks(scene))
    else:
        data = [one for one in scene.data if isinstance(one, vtkDataSet)]
        if len(data) != 1:
            raise ValueError(f"a file holds one data set, and the scene has {len(data)}; a .vtm file holds any number")
        writer = vtkMoteDataWriter()
        writer.SetInputData(data[0])
    writer.SetFileName(os.fspath(path))
    writer.AddObserver("ErrorEvent", lambda *_: None)  # the exception tells it
    if not writer.Write():
        raise Error(writer.GetErrorMessage())


def film(images, path, rate=25, quality="high"):
    """Writes pictures of one size as a film: .ogv, which needs nothing else; .mp4, .mkv, .webm, .mov, .avi or
    .gif by the program ffmpeg. ``images`` may be a generator; they are not kept."""
    video = _program.Film(os.fspath(path), rate, quality)
    for image in images:
        video.add(image.vtk())
    video.finish()


render.__doc__ += "\n    Settings:\n\n" + "\n".join(
    f"    {name.replace('-', '_')}: {_sentence(row)}." for name, row in _ROWS.items() if not row["command"]
)
