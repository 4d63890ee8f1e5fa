/// Binds cut (at planes), section (cross sections) and thicken (a solid from a sheet).
#include "arguments.h"
#include "call.h"
#include "python_mesh.h"
#include "transformesh/offset.h"
#include "transformesh/select.h"

namespace transformesh::python {
namespace {

CutPlane plane_of(const py::handle& value) {
  const std::vector<double> numbers = numbers_of(value, 4, "plane");
  return {vector_of(numbers), numbers[3]};
}

MeshPointer cut_mesh(const PythonMesh& mesh, const py::object& plane, bool cap,
                     const py::object& progress) {
  Document document = mesh.document;
  const CutPlane at = plane_of(plane);
  without_lock(progress, [&](const Progress& to) {
    cap ? cut_closed(document.mesh, at, document.style.coordinate, to)
        : static_cast<void>(cut_open(document.mesh, at));
    return true;
  });
  return mesh_of(std::move(document));
}

py::array_t<double> section_of(const PythonMesh& mesh, const py::object& plane) {
  const CutPlane at = plane_of(plane);
  const auto segments = without_lock(
      py::none(), [&](const Progress&) { return plane_section(mesh.document.mesh, at); });
  py::array_t<double> array({segments.size(), std::size_t{2}, std::size_t{3}});
  double* to = array.mutable_data();
  for (const auto& [from, end] : segments)
    for (const Vec3* point : {&from, &end})
      for (Eigen::Index i = 0; i < 3; ++i) *to++ = (*point)[i];
  return array;
}

MeshPointer thicken_mesh(const PythonMesh& mesh, const PythonLength& thickness,
                         const py::object& progress) {
  Document document = mesh.document;
  join_places(document.mesh);
  const double length = Lengths(document)(thickness);
  without_lock(progress, [&](const Progress& to) {
    thicken(document.mesh, length, document.style.coordinate, to);
    return true;
  });
  return mesh_of(std::move(document));
}

}  // namespace

void bind_cuts(py::module_& module) {
  using py::arg;
  const py::object none = py::none();
  module.def("cut", &cut_mesh, arg("mesh"), arg("plane"), py::kw_only(), arg("cap") = false,
             arg("progress") = none,
             "The part where a x + b y + c z >= d, of the plane (a, b, c, d); `cap` closes the cut "
             "of a closed mesh. See --plane of tm-select(1).");
  module.def("section", &section_of, arg("mesh"), arg("plane"),
             "The segments in which faces meet the plane (a, b, c, d): an array (n, 2, 3) of their "
             "ends. See --section of tm-select(1).");
  module.def("thicken", &thicken_mesh, arg("mesh"), arg("thickness"), py::kw_only(),
             arg("progress") = none,
             "A solid of that thickness around an open sheet. See --thicken of tm-offset(1).");
}

}  // namespace transformesh::python
