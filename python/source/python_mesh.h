/// The Python class Mesh: a document (lib/io/document/document.h), and the report of the operation
/// that made it. NumPy arrays give access to the document's data without a copy.
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
  /// Values of removed or replaced columns, because NumPy arrays may still refer to them.
  std::list<std::vector<double>> retired = {};
};
using MeshPointer = std::shared_ptr<PythonMesh>;

/// Returns report entries by name. A list of numbers becomes a tuple, a length becomes text.
py::dict dict_of(const Entries& entries);
MeshPointer mesh_of(Document document, py::dict report = {});
MeshPointer mesh_of(Document document, const Entries& report);
MeshPointer mesh_of(Mesh mesh, const Entries& report = {});

/// Returns the text of a str or a path-like object.
std::string path_text(const py::handle& path);
/// Returns the rows of an array (n, 3). Throws InputError for other shapes.
std::vector<Vec3> vectors_of(const py::array& array, const std::string& name);

/// Adds the class Mesh, and the functions that read and write meshes, to the Python module.
void bind_mesh(py::module_& module);

}  // namespace transformesh::python
