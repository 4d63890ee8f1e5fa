/// One call of a function from Python. transformesh/_functions.py has the signatures, defaults and
/// documentation of all functions. Each passes its arguments by name to its namesake here.
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

/// The number set by `transformesh.set_threads`; 0 means one thread per core.
extern int threads;

/// Returns a Progress that calls `callback(phase, fraction)`, unless it is None. Ctrl-C, or a
/// result of False, cancels the call.
Progress progress_to(const py::object& callback);

/// Calls `body(progress)` without the GIL, on at most `threads` threads.
template <typename Body>
auto without_lock(const py::object& callback, Body body) {
  const ThreadLimit limit(threads);
  const Progress progress = progress_to(callback);
  const py::gil_scoped_release unlocked;
  return body(progress);
}

/// Returns the value of an argument. Throws TypeError if its type is another one.
template <typename T>
T converted(const py::handle& value, const std::string& name) {
  try {
    return py::cast<T>(value);
  } catch (const py::cast_error&) {
    throw py::type_error(name + ": a value of this type is not accepted");
  }
}

/// The arguments, with checks that throw UsageError or TypeError and name the argument; the mesh
/// that is changed, and its report.
class Call {
 public:
  explicit Call(py::kwargs arguments) : arguments_(std::move(arguments)) {}

  py::object operator[](const char* name) const { return arguments_[name]; }
  template <typename T>
  T get(const char* name) const {
    return converted<T>((*this)[name], name);
  }
  /// Sets `value` to an argument. Returns the call, so that settings can be chained.
  template <typename T>
  const Call& operator()(const char* name, T& value) const {
    value = get<T>(name);
    return *this;
  }

  /// Returns the argument, which must be one of these words.
  std::string word(const char* name, const std::vector<std::string>& words) const;
  /// Returns the value that belongs to a word.
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
  /// Returns a function that calls the argument with a message; nothing if it is None.
  std::function<void(const std::string& message)> callback(const char* name) const;
  /// Sets the smoothing from argument `smooth`: a factor of Laplacian smoothing, two factors for
  /// two passes, or a word.
  void set_smoothing(RemeshOptions& options) const;

  /// Returns a length in the syntax of the programs; a number is in input units.
  Length length_as_given(const char* name, const char* otherwise) const;
  /// Resolves a length as the programs do. If it refers to the reference edge, the document gets
  /// the comment that states the length of the reference edge.
  double resolve(const Length& length);
  double length(const char* name, double otherwise = 0);
  double reference_edge();
  /// Returns the obstacle `keep_out` with its `gap`. Both arguments must be given, or none.
  KeepOutOptions keep_out();

  /// Calls `body(progress)` without the GIL.
  template <typename Body>
  auto run(Body body) const {
    return without_lock(arguments_.contains("progress") ? (*this)["progress"] : py::none(), body);
  }
  /// Merges equal positions of the mesh (join_places()).
  void join();
  /// Returns the changed mesh, whose report gets these entries in addition.
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

/// Adds a function that is called with its arguments by name.
template <typename Result>
void define(py::module_& module, const char* name, Result (*function)(Call&)) {
  module.def(name, [function](const py::kwargs& arguments) {
    Call call(arguments);
    return function(call);
  });
}
/// Adds a function that changes a copy of argument `mesh`.
void define_filter(py::module_& module, const char* name, MeshPointer (*function)(Call&));

/// Add the parts of the module.
void bind_filters(py::module_& module);
void bind_remeshing(py::module_& module);
void bind_editing(py::module_& module);
void bind_measures(py::module_& module);
void bind_pictures(py::module_& module);
void bind_evolutions(py::module_& module);
void bind_views(py::module_& module);

}  // namespace transformesh::python
