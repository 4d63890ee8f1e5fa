/// What looks at meshes and judges them.
#include "call.h"
#include "clean/certify/certify.h"
#include "geometry/compare.h"
#include "mesh/components.h"
#include "mesh/manifold.h"
#include "mesh/measure.h"
#include "python_mesh.h"

namespace transformesh::python {
namespace {

py::tuple tuple_of(const Vec3& point) { return py::make_tuple(point.x(), point.y(), point.z()); }

py::dict info(const PythonMesh& self) {
  const Mesh& mesh = self.document.mesh;
  const EdgeLengths lengths = edge_lengths(mesh);
  const Components parts = connected_components(mesh);
  const ManifoldReport manifold = check_manifold(mesh);
  const Box box = bounding_box(mesh);
  const Angles smallest = angles(mesh);
  py::dict all;
  all["vertices"] = mesh.positions.size();
  all["faces"] = mesh.faces.size();
  all["edges"] = lengths.count;
  all["components"] = parts.components.size();
  all["genus"] = parts.genus();
  all["boundary_loops"] = manifold.boundary_loops;
  all["manifold"] = manifold.is_manifold();
  all["oriented"] = manifold.is_oriented();
  all["closed"] = manifold.is_closed();
  all["area"] = surface_area(mesh);
  all["volume"] = volume(mesh);
  all["bbox_min"] = tuple_of(box.minimum);
  all["bbox_max"] = tuple_of(box.maximum);
  all["edge_mean"] = lengths.mean;
  all["edge_min"] = lengths.minimum;
  all["edge_max"] = lengths.maximum;
  all["angle_min"] = smallest.minimum_deg;
  all["angle_min_mean"] = smallest.minimum_mean_deg;
  all["valence6"] = valence_six_share(mesh);
  return all;
}

py::dict compare_meshes(const PythonMesh& mesh, const PythonMesh& reference,
                        const std::optional<double>& distance, std::size_t samples,
                        std::uint64_t seed, const py::object& progress) {
  CompareOptions options{samples, seed, distance.value_or(-1)};
  const Comparison found = without_lock(progress, [&](const Progress& to) {
    return compare(mesh.document.mesh, reference.document.mesh, options, to);
  });
  py::dict all;
  all["accuracy"] = found.accuracy;
  all["completeness"] = found.completeness;
  all["mean"] = found.mean;
  all["rms"] = found.rms;
  all["hausdorff"] = found.hausdorff;
  all["hausdorff_to_reference"] = found.hausdorff_to_reference;
  all["hausdorff_from_reference"] = found.hausdorff_from_reference;
  all["volume_difference"] = found.volume_difference;
  return all;
}

py::dict certify_mesh(const PythonMesh& mesh, const PythonMesh& input, int winding_level,
                      const py::object& progress) {
  CertifyOptions options;
  options.winding_level = winding_level;
  options.coordinate = mesh.document.style.coordinate;
  const Certificate found = without_lock(progress, [&](const Progress& to) {
    return certify(input.document.mesh, mesh.document.mesh, options, to);
  });
  py::dict all;
  all["holds"] = found.holds();
  all["problem"] = found.problem;
  all["winding_tested"] = found.input_is_closed;
  all["samples"] = found.samples;
  all["undecided"] = found.undecided;
  all["wrong"] = found.wrong;
  all["margin"] = found.margin;
  return all;
}

}  // namespace

void bind_measures(py::module_& module) {
  using py::arg;
  const py::object none = py::none();
  module.def("info", &info, arg("mesh"),
             "Counts, topology, sizes and quality, as tm-info and tm-checkmanifold report them.");
  module.def("compare", &compare_meshes, arg("mesh"), arg("reference"), py::kw_only(),
             arg("distance") = none, arg("samples") = CompareOptions().samples,
             arg("seed") = CompareOptions().seed, arg("progress") = none,
             "Distances between a mesh and a reference. See tm-compare(1).");
  module.def("certify", &certify_mesh, arg("mesh"), arg("input"), py::kw_only(), arg("level") = 1,
             arg("progress") = none,
             "Whether a mesh is the boundary of winding number at least `level` of the input, by "
             "samples and by no code that computes such boundaries. See tm-checkmanifold(1).");
}

}  // namespace transformesh::python
