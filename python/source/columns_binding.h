/// Binds the columns of a mesh as a dict of arrays.
#pragma once

#include "python_mesh.h"

namespace transformesh::python {

py::object vertex_columns(const MeshPointer& mesh);
py::object face_columns(const MeshPointer& mesh);
void bind_columns(py::module_& module);

}  // namespace transformesh::python
