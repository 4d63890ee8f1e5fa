/// One call of a function from Python. transformesh/_functions.py has the signatures, defaults and
/// documentation of all functions. Each of them passes its arguments by name to the C++ function of
/// the same name in this folder.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "python_mesh.h"
#include "support/parallel.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"
#include "transformesh/length.h"
#include "transformesh/measure.h"
#include "transformesh/remesh.h"

namespace transformesh::python {

/// The maximum number of threads, set by `transformesh.set_threads`; 0 means one thread per core.
extern int threads;

/// Returns a Progress that calls `callback(phase, fraction)`, unless the callback is None. The call
/// is canceled by Ctrl-C, or if the callback returns False.
Progress progress_to(const py::object& callback);

/// Calls `body(progress)` without the GIL, on at most `threads` threads.
template <typename Body>
auto without_lock(const py::object& callback, Body body) {
  const ThreadLimit limit(threads);
  const Progress progress = progress_to(callback);
  const py::gil_scoped_release unlocked;
  return body(progress);
}

/// Returns the value of an argument as a T. Throws TypeError, with the name of the argument, if the
/// value cannot be converted to T.
template <typename T>
T converted(const py::handle& value, const std::string& name) {
  try {
    return py::cast<T>(value);
  } catch (const py::cast_error&) {
    throw py::type_error(name + ": a value of this type is not accepted");
  }
}

/// The arguments of one call, the mesh that the called function changes, and its report. Functions
/// that return an argument check it, and throw UsageError or TypeError with its name.
class Call {
 public:
  explicit Call(py::kwargs arguments) : arguments_(std::move(arguments)) {}

  py::object operator[](const char* name) const { return arguments_[name]; }
  template <typename T>
  T get(const char* name) const {
    return converted<T>((*this)[name], name);
  }
  /// Sets `value` to the argument of this name. Returns the call, so that several arguments can be
  /// read in one expression.
  template <typename T>
  const Call& operator()(const char* name, T& value) const {
    value = get<T>(name);
    return *this;
  }

  /// Returns the argument. Throws UsageError if it is none of `words`.
  std::string word(const char* name, const std::vector<std::string>& words) const;
  /// Returns the value that `values` assigns to the word given as the argument. Throws UsageError
  /// for other words.
  template <typename T>
  T choice(const char* name, const std::vector<std::pair<std::string, T>>& values) const {
    std::vector<std::string> words;
    for (const auto& [known, value] : values) words.push_back(known);
    return std::ranges::find(values, word(name, words), &std::pair<std::string, T>::first)->second;
  }
  const PythonMesh& mesh(const char* name) const { return get<const PythonMesh&>(name); }
  /// Returns the meshes of argument `meshes`. Throws if there are none.
  std::vector<const PythonMesh*> meshes(const std::string& function) const;
  std::optional<Vec3> vector(const char* name) const;
  std::optional<Box> box() const;
  std::string path(const char* name) const;
  /// Returns a function that calls the Python function in the argument with a message. Returns an
  /// empty function if the argument is None.
  std::function<void(const std::string& message)> callback(const char* name) const;
  /// Sets the smoothing from argument `smooth`: a factor of Laplacian smoothing, two factors for
  /// two passes, or a word.
  void set_smoothing(RemeshOptions& options) const;

  /// Returns a length argument: a number in input units, or a text such as "0.7x". The text has the
  /// syntax of lengths on the command line; x stands for the reference edge, the mean edge length
  /// of the initial mesh. Parses `otherwise` if the argument is None.
  Length length_as_given(const char* name, const char* otherwise) const;
  /// Converts a length to input units, as the command-line programs do. If the length refers to the
  /// reference edge (the mean edge length of the initial mesh), `document` gets a comment that
  /// states the reference edge.
  double resolve(const Length& length);
  double length(const char* name, double otherwise = 0);
  double reference_edge();
  /// Returns the obstacle from argument `keep_out`, with the distance to it from argument `gap`.
  /// Throws UsageError if only one of them is given.
  KeepOutOptions keep_out();

  /// Calls `body(progress)` without the GIL.
  template <typename Body>
  auto run(Body body) const {
    return without_lock(arguments_.contains("progress") ? (*this)["progress"] : py::none(), body);
  }
  /// Merges vertices of the mesh that have equal positions, by join_places().
  void join();
  /// Returns the changed mesh with its report. Adds `entries` to the report.
  MeshPointer result(const Entries& entries = {});

  Document document;  ///< the mesh that is changed
  Entries report;

 private:
  py::kwargs arguments_;
};

/// Returns the numbers of a scalar, sequence or array of any shape. Their number must be `count`.
std::vector<double> numbers_of(const py::handle& value, std::size_t count, const std::string& name);
Vec3 vector_of(const std::vector<double>& numbers);

/// Issues Python warnings for notes that a program would print on stderr.
void warn(const std::vector<std::string>& notes);

/// Merges equal positions of a soup (join_soup.h) and issues a warning. Returns the entry of the
/// report with the number of vertices that were merged.
Entries join_places(Mesh& mesh);

/// Adds a function of keyword arguments to the module.
template <typename Result>
void define(py::module_& module, const char* name, Result (*function)(Call&)) {
  module.def(name, [function](const py::kwargs& arguments) {
    Call call(arguments);
    return function(call);
  });
}
/// Adds a function of keyword arguments to the module. The function changes a copy of argument
/// `mesh` and returns it.
void define_filter(py::module_& module, const char* name, MeshPointer (*function)(Call&));

/// Add functions to the module; each bind function is in the source file of its name.
void bind_filters(py::module_& module);
void bind_remeshing(py::module_& module);
void bind_editing(py::module_& module);
void bind_measures(py::module_& module);
void bind_pictures(py::module_& module);
void bind_evolutions(py::module_& module);
void bind_views(py::module_& module);

}  // namespace transformesh::python
