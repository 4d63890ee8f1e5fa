/// What every call from Python into the library has: threads, progress, Ctrl-C, and lengths.
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

/// `transformesh.set_threads`: 0 is one per core.
extern int threads;

/// A callable of phase and fraction, or none. Ctrl-C ends the call; so does an answer of False.
Progress progress_to(const py::object& callback);

/// A callable of a line of text, or none.
std::function<void(const std::string& message)> message_callback(const py::object& callback);

/// Calls `body(progress)` without the interpreter's lock, on as many threads as are set.
template <typename Body>
auto without_lock(const py::object& callback, Body body) {
  const ThreadLimit limit(threads);
  const Progress progress = progress_to(callback);
  const py::gil_scoped_release unlocked;
  return body(progress);
}

/// Input units, or text as on a command line: 0.7x, 1%.
using PythonLength = std::variant<double, std::string>;

/// Resolves lengths as the programs do: where one refers to the reference edge, the document gets
/// the comment that says how long it is.
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

/// The parts of the module.
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
