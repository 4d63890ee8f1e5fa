/// Parts common to all calls from Python into the library: threads, progress, Ctrl-C, lengths.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <functional>
#include <optional>
#include <string>
#include <variant>

#include "support/parallel.h"
#include "transformesh/control.h"
#include "transformesh/document.h"
#include "transformesh/length.h"

namespace transformesh::python {

namespace py = pybind11;

/// The number set by `transformesh.set_threads`; 0 means one thread per core.
extern int threads;

/// Returns a Progress that calls `callback(phase, fraction)`, unless it is None. Ctrl-C, or a
/// result of False, cancels the call.
Progress progress_to(const py::object& callback);

/// Returns a function that calls `callback(message)`; does nothing if it is None.
std::function<void(const std::string& message)> message_callback(const py::object& callback);

/// Calls `body(progress)` without the GIL, on at most `threads` threads.
template <typename Body>
auto without_lock(const py::object& callback, Body body) {
  const ThreadLimit limit(threads);
  const Progress progress = progress_to(callback);
  const py::gil_scoped_release unlocked;
  return body(progress);
}

/// A length as a number in input units, or as text in the syntax of the programs: 0.7x, 1%.
using PythonLength = std::variant<double, std::string>;

/// Resolves lengths as the programs do. If a length refers to the reference edge, the document gets
/// the comment that states the length of the reference edge.
class Lengths {
 public:
  explicit Lengths(Document& document);
  double operator()(const PythonLength& length);
  double operator()(const std::optional<PythonLength>& length, double otherwise) {
    return length ? (*this)(*length) : otherwise;
  }
  double reference_edge();

 private:
  Document& document_;
};
Length parsed(const PythonLength& length);

/// Add the parts of the module.
void bind_errors(py::module_& module);
void bind_filters(py::module_& module);
void bind_remeshing(py::module_& module);
void bind_editing(py::module_& module);
void bind_cuts(py::module_& module);
void bind_measures(py::module_& module);
void bind_pictures(py::module_& module);
void bind_evolutions(py::module_& module);
void bind_flows(py::module_& module);
void bind_views(py::module_& module);

}  // namespace transformesh::python
