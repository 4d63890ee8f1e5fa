/// What Python sees as a Mesh: a document (lib/io/document/document.h) whose numbers NumPy
/// arrays show without a copy, and what the operation that made it has to say.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <list>
#include <memory>

#include "entries/entries.h"
#include "transformesh/document.h"

namespace transformesh::python {

namespace py = pybind11;

struct PythonMesh {
  Document document;
  py::dict report;
  /// Values of columns that are gone or replaced: an array may still show them.
  std::list<std::vector<double>> retired = {};
};
using MeshPointer = std::shared_ptr<PythonMesh>;

/// Positions (n, 3) and faces (m, 3), checked as a file is. One copy where their types are doubles
/// or floats and 32- or 64-bit integers.
MeshPointer make_mesh(const py::object& positions, const py::object& faces);
/// Values by name. A list of numbers becomes a tuple, a length becomes text.
py::dict dict_of(const Entries& entries);
MeshPointer mesh_of(Document document, py::dict report = {});
MeshPointer mesh_of(Document document, const Entries& report);

/// (n, 3) numbers as vectors. Throws InputError where the shape is another one.
std::vector<Vec3> vectors_of(const py::array& array, const std::string& name);
py::array array_of(const std::vector<Vec3>& vectors);

/// The class Mesh, reading and writing.
void bind_mesh(py::module_& module);

}  // namespace transformesh::python
