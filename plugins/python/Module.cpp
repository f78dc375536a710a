// The extension module behind the functions of the package `mote`: the program's settings, stage
// and window, for data of a Python program. What people call is in functions.py.

#include "DataFilm.h"
#include "DataView.h"

#include <Program.h>
#include <base/Failure.h>

#include <vtkDataObject.h>
#include <vtkImageData.h>
#include <vtkPythonUtil.h>

#include <locale.h>
#include <new>

namespace
{

using namespace mote::app;

PyObject* errorClass = nullptr; ///< mote.Error

/// Lets other Python threads run while this one works, which reads and writes numbers with points,
/// whatever the program's locale: settings and pictures are the same everywhere.
class Unlocked
{
public:
  Unlocked()
    : state_(PyEval_SaveThread())
    , points_(::newlocale(LC_NUMERIC_MASK, "C", ::duplocale(LC_GLOBAL_LOCALE)))
    , before_(points_ ? ::uselocale(points_) : nullptr)
  {
  }
  ~Unlocked()
  {
    if (points_)
    {
      ::uselocale(before_);
      ::freelocale(points_);
    }
    PyEval_RestoreThread(state_);
  }
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;

private:
  PyThreadState* state_;
  locale_t points_, before_;
};

/// Does the work, and makes a Python exception of what it throws. Returns null then.
template <typename Work>
PyObject* guarded(const Work& work)
{
  try
  {
    return work();
  }
  catch (const WrongSetting& wrong)
  {
    PyErr_SetString(wrong.isUnknown ? PyExc_TypeError : PyExc_ValueError, wrong.sentence.c_str());
  }
  catch (const Interrupted&)
  {
    PyErr_SetNone(PyExc_KeyboardInterrupt);
  }
  catch (const std::bad_alloc&)
  {
    PyErr_SetString(PyExc_MemoryError, "there is not enough memory for this");
  }
  catch (const std::exception& error)
  {
    PyErr_SetString(errorClass, error.what());
  }
  return nullptr;
}

/// Has Python tell the warnings. Returns false where it makes an exception of one.
bool tell(const std::vector<std::string>& warnings)
{
  for (const std::string& warning : warnings)
    if (PyErr_WarnEx(PyExc_UserWarning, warning.c_str(), 3) != 0)
      return false;
  return true;
}

PyObject* textOf(const std::string& text)
{
  return PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace");
}

/// The texts of a list; false with a Python exception for another thing.
bool takeTexts(PyObject* list, std::vector<std::string>& texts)
{
  PyObject* fast = PySequence_Fast(list, "a list of texts is needed");
  if (!fast)
    return false;
  for (Py_ssize_t i = 0; i < PySequence_Fast_GET_SIZE(fast); ++i)
  {
    PyObject* bytes = nullptr; // file names in the file system's encoding
    if (!PyUnicode_FSConverter(PySequence_Fast_GET_ITEM(fast, i), &bytes))
    {
      Py_DECREF(fast);
      return false;
    }
    texts.emplace_back(PyBytes_AS_STRING(bytes));
    Py_DECREF(bytes);
  }
  Py_DECREF(fast);
  return true;
}

/// The pairs of a name and a data object of a list; false with a Python exception for another
/// thing.
bool takeData(PyObject* list, std::vector<GivenData>& data)
{
  PyObject* fast = PySequence_Fast(list, "a list of data is needed");
  if (!fast)
    return false;
  bool isGood = true;
  for (Py_ssize_t i = 0; isGood && i < PySequence_Fast_GET_SIZE(fast); ++i)
  {
    const char* name = nullptr;
    PyObject* object = nullptr;
    isGood = PyArg_ParseTuple(PySequence_Fast_GET_ITEM(fast, i), "sO", &name, &object) != 0;
    if (!isGood)
      break;
    auto* pointer =
      static_cast<vtkDataObject*>(vtkPythonUtil::GetPointerFromObject(object, "vtkDataObject"));
    isGood = pointer != nullptr;
    if (!isGood && !PyErr_Occurred())
      PyErr_SetString(PyExc_TypeError, "data of VTK are needed, not None");
    data.push_back({name, pointer});
  }
  Py_DECREF(fast);
  return isGood;
}

// What is drawn of a scene: an object that keeps what was built of its data.

struct ViewObject
{
  PyObject_HEAD DataView* view;
};

PyObject* newView(PyTypeObject* type, PyObject*, PyObject*)
{
  auto* self = reinterpret_cast<ViewObject*>(type->tp_alloc(type, 0));
  if (self)
    self->view = new DataView;
  return reinterpret_cast<PyObject*>(self);
}

void freeView(PyObject* self)
{
  delete reinterpret_cast<ViewObject*>(self)->view;
  Py_TYPE(self)->tp_free(self);
}

PyObject* draw(PyObject* self, PyObject* arguments)
{
  PyObject* list = nullptr;
  const char* settings = nullptr;
  const char* output = nullptr;
  std::vector<GivenData> data;
  if (!PyArg_ParseTuple(arguments, "Oss", &list, &settings, &output) || !takeData(list, data))
    return nullptr;
  return guarded(
    [&]() -> PyObject*
    {
      DrawnImage drawn;
      {
        const Unlocked unlocked;
        drawn = reinterpret_cast<ViewObject*>(self)->view->draw(data, settings, output);
      }
      if (!tell(drawn.warnings))
        return nullptr;
      return Py_BuildValue("(NNd)", vtkPythonUtil::GetObjectFromPointer(drawn.image),
        textOf(drawn.contents), drawn.traceTime);
    });
}

PyMethodDef viewMethods[] = {{"draw", draw, METH_VARARGS,
                               "draw(data, settings, output): the image of the data, [(name, "
                               "vtkDataObject), ...], by settings "
                               "as JSON; what it shows in words; the seconds that tracing took."},
  {nullptr, nullptr, 0, nullptr}};

PyTypeObject viewType = {PyVarObject_HEAD_INIT(nullptr, 0)};

// Files that are read.

struct FilesObject
{
  PyObject_HEAD DataFiles* files;
};

PyObject* newFiles(PyTypeObject* type, PyObject* arguments, PyObject*)
{
  PyObject* list = nullptr;
  std::vector<std::string> names;
  if (!PyArg_ParseTuple(arguments, "O", &list) || !takeTexts(list, names))
    return nullptr;
  return guarded(
    [&]() -> PyObject*
    {
      std::unique_ptr<DataFiles> files;
      std::vector<std::string> warnings;
      {
        const Unlocked unlocked;
        files = std::make_unique<DataFiles>(names, warnings);
      }
      if (!tell(warnings))
        return nullptr;
      auto* self = reinterpret_cast<FilesObject*>(type->tp_alloc(type, 0));
      if (self)
        self->files = files.release();
      return reinterpret_cast<PyObject*>(self);
    });
}

void freeFiles(PyObject* self)
{
  delete reinterpret_cast<FilesObject*>(self)->files;
  Py_TYPE(self)->tp_free(self);
}

PyObject* timesOf(PyObject* self, void*)
{
  const std::vector<double>& times = reinterpret_cast<FilesObject*>(self)->files->times();
  PyObject* list = PyList_New(static_cast<Py_ssize_t>(times.size()));
  for (std::size_t i = 0; list && i < times.size(); ++i)
    PyList_SET_ITEM(list, static_cast<Py_ssize_t>(i), PyFloat_FromDouble(times[i]));
  return list;
}

PyObject* readStep(PyObject* self, PyObject* arguments)
{
  int step = 0;
  if (!PyArg_ParseTuple(arguments, "i", &step))
    return nullptr;
  return guarded(
    [&]() -> PyObject*
    {
      std::vector<GivenData> data;
      std::vector<std::string> warnings;
      {
        const Unlocked unlocked;
        data = reinterpret_cast<FilesObject*>(self)->files->read(step, warnings);
      }
      if (!tell(warnings))
        return nullptr;
      PyObject* list = PyList_New(0);
      for (const GivenData& one : data)
      {
        PyObject* pair =
          Py_BuildValue("(NN)", textOf(one.name), vtkPythonUtil::GetObjectFromPointer(one.data));
        if (!pair || PyList_Append(list, pair) != 0)
        {
          Py_XDECREF(pair);
          Py_DECREF(list);
          return nullptr;
        }
        Py_DECREF(pair);
      }
      return list;
    });
}

PyMethodDef filesMethods[] = {
  {"read", readStep, METH_VARARGS, "read(step): [(name, vtkDataSet), ...] of a step, from 0."},
  {nullptr, nullptr, 0, nullptr}};

PyGetSetDef filesFacts[] = {
  {"times", timesOf, nullptr, "The times of the steps; none where files have no time.", nullptr},
  {nullptr, nullptr, nullptr, nullptr, nullptr}};

PyTypeObject filesType = {PyVarObject_HEAD_INIT(nullptr, 0)};

// Films.

struct FilmObject
{
  PyObject_HEAD DataFilm* film;
};

PyObject* newFilm(PyTypeObject* type, PyObject* arguments, PyObject*)
{
  PyObject* file = nullptr;
  double rate = 25.0;
  const char* quality = nullptr;
  if (!PyArg_ParseTuple(arguments, "O&ds", PyUnicode_FSConverter, &file, &rate, &quality))
    return nullptr;
  const std::string name = PyBytes_AS_STRING(file);
  Py_DECREF(file);
  return guarded(
    [&]() -> PyObject*
    {
      auto film = std::make_unique<DataFilm>(name, rate, quality);
      auto* self = reinterpret_cast<FilmObject*>(type->tp_alloc(type, 0));
      if (self)
        self->film = film.release();
      return reinterpret_cast<PyObject*>(self);
    });
}

void freeFilm(PyObject* self)
{
  delete reinterpret_cast<FilmObject*>(self)->film;
  Py_TYPE(self)->tp_free(self);
}

PyObject* addFrame(PyObject* self, PyObject* arguments)
{
  PyObject* object = nullptr;
  if (!PyArg_ParseTuple(arguments, "O", &object))
    return nullptr;
  auto* image =
    static_cast<vtkImageData*>(vtkPythonUtil::GetPointerFromObject(object, "vtkImageData"));
  if (!image)
    return nullptr;
  return guarded(
    [&]() -> PyObject*
    {
      const Unlocked unlocked;
      reinterpret_cast<FilmObject*>(self)->film->add(image);
      Py_RETURN_NONE;
    });
}

PyObject* finishFilm(PyObject* self, PyObject*)
{
  return guarded(
    [&]() -> PyObject*
    {
      const Unlocked unlocked;
      reinterpret_cast<FilmObject*>(self)->film->finish();
      Py_RETURN_NONE;
    });
}

PyMethodDef filmMethods[] = {
  {"add", addFrame, METH_VARARGS, "add(image): one more frame, of the size of the first."},
  {"finish", finishFilm, METH_NOARGS, "finish(): closes the file and gives it its name."},
  {nullptr, nullptr, 0, nullptr}};

PyTypeObject filmType = {PyVarObject_HEAD_INIT(nullptr, 0)};

// Functions.

PyObject* run(PyObject*, PyObject* arguments)
{
  PyObject* list = nullptr;
  std::vector<std::string> words;
  if (!PyArg_ParseTuple(arguments, "O", &list) || !takeTexts(list, words))
    return nullptr;
  std::vector<char*> pointers;
  for (std::string& word : words)
    pointers.push_back(word.data());
  pointers.push_back(nullptr);
  int code = 0;
  {
    const Unlocked unlocked;
    code = runProgram(static_cast<int>(words.size()), pointers.data());
  }
  return PyLong_FromLong(code);
}

PyObject* show(PyObject*, PyObject* arguments)
{
  PyObject* list = nullptr;
  PyObject* names = nullptr;
  const char* settings = nullptr;
  std::vector<GivenData> data;
  std::vector<std::string> files;
  if (!PyArg_ParseTuple(arguments, "OOs", &list, &names, &settings) || !takeData(list, data) ||
      !takeTexts(names, files))
    return nullptr;
  return guarded(
    [&]() -> PyObject*
    {
      const Unlocked unlocked;
      showData(data, files, settings);
      Py_RETURN_NONE;
    });
}

PyObject* settings(PyObject*, PyObject*)
{
  return textOf(settingsAsJson());
}

PyMethodDef functions[] = {
  {"run", run, METH_VARARGS, "run(words): the program, as by its command line; its exit code."},
  {"show", show, METH_VARARGS, "show(data, files, settings): the window, until it is closed."},
  {"settings", settings, METH_NOARGS, "settings(): what settings there are, as JSON."},
  {nullptr, nullptr, 0, nullptr}};

PyModuleDef about = {PyModuleDef_HEAD_INIT, "mote._program",
  "What the functions of mote call; see mote.render.", -1, functions};

bool addType(PyObject* module, PyTypeObject& type, const char* name, std::size_t size, newfunc make,
  destructor free, PyMethodDef* methods, PyGetSetDef* facts)
{
  type.tp_name = name;
  type.tp_basicsize = static_cast<Py_ssize_t>(size);
  type.tp_flags = Py_TPFLAGS_DEFAULT;
  type.tp_new = make;
  type.tp_dealloc = free;
  type.tp_methods = methods;
  type.tp_getset = facts;
  return PyType_Ready(&type) == 0 && PyModule_AddType(module, &type) == 0;
}

} // namespace

PyMODINIT_FUNC PyInit__program()
{
  PyObject* module = PyModule_Create(&about);
  if (!module)
    return nullptr;
  errorClass = PyErr_NewExceptionWithDoc("mote.Error",
    "What went wrong, as one sentence: a file that cannot be read, data that cannot be drawn.",
    PyExc_RuntimeError, nullptr);
  if (!errorClass || PyModule_AddObjectRef(module, "Error", errorClass) != 0 ||
      !addType(module, viewType, "mote._program.View", sizeof(ViewObject), newView, freeView,
        viewMethods, nullptr) ||
      !addType(module, filesType, "mote._program.Files", sizeof(FilesObject), newFiles, freeFiles,
        filesMethods, filesFacts) ||
      !addType(module, filmType, "mote._program.Film", sizeof(FilmObject), newFilm, freeFilm,
        filmMethods, nullptr))
  {
    Py_DECREF(module);
    return nullptr;
  }
  return module;
}
