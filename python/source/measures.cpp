/// Binds info, compare and certify.
#include "call.h"
#include "clean/certify/certify.h"
#include "transformesh/compare.h"
#include "transformesh/manifold.h"

namespace transformesh::python {
namespace {

py::dict info(Call& call) {
  const Mesh& mesh = call.mesh("mesh").document.mesh;
  Entries all = describe(mesh);
  const ManifoldReport found = check_manifold(mesh);
  append(all, {{"manifold", found.is_manifold()},
               {"oriented", found.is_oriented()},
               {"closed", found.is_closed()}});
  return dict_of(all);
}

py::dict compare_meshes(Call& call) {
  CompareOptions options;
  call("samples", options.samples)("seed", options.seed);
  options.distance = call.get<std::optional<double>>("distance").value_or(-1);
  const Mesh& mesh = call.mesh("mesh").document.mesh;
  const Mesh& reference = call.mesh("reference").document.mesh;
  return dict_of(entries_of(
      call.run([&](const Progress& to) { return compare(mesh, reference, options, to); })));
}

py::dict certify_mesh(Call& call) {
  const Document& document = call.mesh("mesh").document;
  const Mesh& input = call.mesh("input").document.mesh;
  CertifyOptions options;
  call("level", options.winding_level);
  options.coordinate = document.style.coordinate;
  const Certificate found =
      call.run([&](const Progress& to) { return certify(input, document.mesh, options, to); });
  return dict_of({{"holds", found.holds()},
                  {"problem", found.problem},
                  {"winding_tested", found.input_is_closed},
                  {"samples", found.samples},
                  {"undecided", found.undecided},
                  {"wrong", found.wrong},
                  {"margin", found.margin}});
}

}  // namespace

void bind_measures(py::module_& module) {
  define(module, "info", &info);
  define(module, "compare", &compare_meshes);
  define(module, "certify", &certify_mesh);
}

}  // namespace transformesh::python
