/// The Python class Mesh: a document (lib/io/document/document.h) whose data NumPy arrays show
/// without a copy, and the report of the operation that made it.
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
  /// Values of removed or replaced columns, which an array may still show.
  std::list<std::vector<double>> retired = {};
};
using MeshPointer = std::shared_ptr<PythonMesh>;

/// Makes a mesh from positions (n, 3) and faces (m, 3), with the checks of a file. Copies the data
/// once if types are doubles or floats, and 32- or 64-bit integers.
MeshPointer make_mesh(const py::object& positions, const py::object& faces);
/// Returns report entries by name. A list of numbers becomes a tuple, a length becomes text.
py::dict dict_of(const Entries& entries);
MeshPointer mesh_of(Document document, py::dict report = {});
MeshPointer mesh_of(Document document, const Entries& report);
MeshPointer mesh_of(Mesh mesh, const Entries& report = {});

/// Returns the text of a str or a path-like object.
std::string path_text(const py::handle& path);
/// Returns the rows of an array (n, 3). Throws InputError for other shapes.
std::vector<Vec3> vectors_of(const py::array& array, const std::string& name);
py::array array_of(const std::vector<Vec3>& vectors);

/// Binds the class Mesh, and reading and writing.
void bind_mesh(py::module_& module);

}  // namespace transformesh::python
