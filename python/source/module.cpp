/// The Python module: functions of the library for meshes whose data are NumPy arrays.
#include <new>

#include "advice.h"
#include "call.h"

namespace transformesh::python {
namespace {

/// Returns the exception class of that name in transformesh/_errors.py.
py::object error_class(const char* name) {
  return py::module_::import("transformesh._errors").attr(name);
}

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

void raise(const char* name, const Error& error) {
  const py::object type = error_class(name);
  const py::object exception = type(with_advice(error.problem()));
  exception.attr("kind") = name_of(error.kind());
  exception.attr("data") = dict_of(error.data());
  PyErr_SetObject(type.ptr(), exception.ptr());
}

void translate(std::exception_ptr pointer) {
  try {
    if (pointer) std::rethrow_exception(pointer);
  } catch (const UsageError& error) {
    raise("UsageError", error);
  } catch (const InputError& error) {
    raise("InputError", error);
  } catch (const GoalError& error) {
    raise("GoalError", error);
  } catch (const OutputError& error) {
    raise("OutputError", error);
  } catch (const CancelledError& error) {
    PyErr_SetString(error_class("Cancelled").ptr(), error.what());
  }
}

py::none set_threads(Call& call) {
  const auto count = call.get<int>("count");
  if (count < 0 || count > 1024) throw UsageError("threads: from 0, one per core, to 1024");
  threads = count;
  return {};
}

}  // namespace
}  // namespace transformesh::python

PYBIND11_MODULE(_transformesh, module) {
  using namespace transformesh::python;
  module.attr("__version__") = TM_VERSION;
  py::register_exception_translator(translate);
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
