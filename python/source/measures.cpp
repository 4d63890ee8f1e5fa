/// Binds functions that measure and check meshes.
#include "call.h"
#include "clean/certify/certify.h"
#include "python_mesh.h"
#include "transformesh/compare.h"
#include "transformesh/manifold.h"

namespace transformesh::python {
namespace {

py::dict info(const PythonMesh& self) {
  Entries all = describe(self.document.mesh);
  const ManifoldReport found = check_manifold(self.document.mesh);
  append(all, {{"manifold", found.is_manifold()},
               {"oriented", found.is_oriented()},
               {"closed", found.is_closed()}});
  return dict_of(all);
}

py::dict compare_meshes(const PythonMesh& mesh, const PythonMesh& reference,
                        const std::optional<double>& distance, std::size_t samples,
                        std::uint64_t seed, const py::object& progress) {
  CompareOptions options{samples, seed, distance.value_or(-1)};
  const Comparison found = without_lock(progress, [&](const Progress& to) {
    return compare(mesh.document.mesh, reference.document.mesh, options, to);
  });
  return dict_of(entries_of(found));
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
