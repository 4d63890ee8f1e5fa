/// The Python module: functions of the library for meshes whose data are NumPy arrays.
#include <new>

#include "advice.h"
#include "call.h"

namespace transformesh::python {

namespace {

/// Adds an exception class with two bases: one of this module (`own`) and one of Python
/// (`builtin`).
PyObject* add_error(py::module_& module, const char* name, PyObject* own, PyObject* builtin,
                    const char* about) {
  const std::string full = std::string("transformesh.") + name;
  const py::tuple bases = own == nullptr ? py::make_tuple(py::handle(builtin))
                                         : py::make_tuple(py::handle(own), py::handle(builtin));
  PyObject* error = PyErr_NewExceptionWithDoc(full.c_str(), about, bases.ptr(), nullptr);
  module.add_object(name, error);
  return error;
}

PyObject *usage_error, *input_error, *goal_error, *output_error, *cancelled;

/// Returns the data of an error as a dict.
py::dict dict_of(const ErrorData& data) {
  py::dict result;
  if (!data.faces.empty()) result["faces"] = data.faces;
  if (data.edge) result["edge"] = py::make_tuple((*data.edge)[0], (*data.edge)[1]);
  if (const auto& place = data.position)
    result["position"] = py::make_tuple((*place)[0], (*place)[1], (*place)[2]);
  if (!data.counts.empty()) result["counts"] = data.counts;
  if (!data.lengths.empty()) result["lengths"] = data.lengths;
  if (!data.name.empty()) result["name"] = data.name;
  return result;
}

void raise(PyObject* type, const Error& error) {
  const py::object exception = py::handle(type)(with_advice(error.problem()));
  exception.attr("kind") = name_of(error.kind());
  exception.attr("data") = dict_of(error.data());
  PyErr_SetObject(type, exception.ptr());
}

void translate(std::exception_ptr pointer) {
  try {
    if (pointer) std::rethrow_exception(pointer);
  } catch (const UsageError& error) {
    raise(usage_error, error);
  } catch (const InputError& error) {
    raise(input_error, error);
  } catch (const GoalError& error) {
    raise(goal_error, error);
  } catch (const OutputError& error) {
    raise(output_error, error);
  } catch (const CancelledError& error) {
    PyErr_SetString(cancelled, error.what());
  }
}

py::none set_threads(Call& call) {
  const auto count = call.get<int>("count");
  if (count < 0 || count > 1024) throw UsageError("threads: from 0, one per core, to 1024");
  threads = count;
  return {};
}

}  // namespace

void bind_errors(py::module_& module) {
  PyObject* base = add_error(module, "Error", nullptr, PyExc_Exception, "Any refusal.");
  py::setattr(base, "kind", py::str(name_of(ErrorKind::other)));
  py::setattr(base, "data", py::dict());
  usage_error = add_error(module, "UsageError", base, PyExc_ValueError,
                          "An argument that makes no sense; programs exit with 2.");
  input_error = add_error(module, "InputError", base, PyExc_ValueError,
                          "A mesh or a file that is not what the operation needs; exit code 3.");
  goal_error =
      add_error(module, "GoalError", base, PyExc_RuntimeError, "There is no result; exit code 4.");
  output_error = add_error(module, "OutputError", base, PyExc_OSError,
                           "A file could not be written; exit code 5.");
  cancelled = add_error(module, "Cancelled", base, PyExc_RuntimeError,
                        "The progress callback returned False.");
  py::register_exception_translator(translate);
}

}  // namespace transformesh::python

PYBIND11_MODULE(_transformesh, module) {
  using namespace transformesh::python;
  module.attr("__version__") = TM_VERSION;
  bind_errors(module);
  bind_mesh(module);
  bind_filters(module);
  bind_remeshing(module);
  bind_editing(module);
  bind_measures(module);
  bind_pictures(module);
  bind_evolutions(module);
  bind_views(module);
  define(module, "set_threads", &set_threads);
}
