/// Binds fill, handles, transform, align, select, split, sample and carry.
#include <algorithm>

#include "arguments.h"
#include "call.h"
#include "io/comments.h"
#include "python_mesh.h"
#include "transformesh/align.h"
#include "transformesh/carry.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/fill.h"
#include "transformesh/handles.h"
#include "transformesh/sample.h"
#include "transformesh/select.h"
#include "transformesh/transform.h"

namespace transformesh::python {
namespace {

// --- fill ----------------------------------------------------------------------------------------

MeshPointer fill_mesh(const PythonMesh& mesh, const std::optional<std::size_t>& max_edges,
                      const std::optional<PythonLength>& max_diameter, bool refine, bool fair,
                      bool allow_self_intersections, const py::object& progress) {
  Document document = mesh.document;
  Entries report = join_places(document.mesh);
  FillOptions options;
  if (max_edges && *max_edges < 3) throw UsageError("max_edges: a hole has at least 3");
  options.max_edges = max_edges.value_or(options.max_edges);
  options.max_diameter = Lengths(document)(max_diameter, options.max_diameter);
  options.refine = refine;
  options.fair = fair;
  options.allow_self_intersections = allow_self_intersections;
  options.coordinate = document.style.coordinate;
  const FillResult result = without_lock(
      progress, [&](const Progress& to) { return fill_holes(document.mesh, options, to); });
  append(report, entries_of(result));
  return mesh_of(std::move(document), report);
}

// --- handles -------------------------------------------------------------------------------------

MeshPointer remove_handles_of(const PythonMesh& mesh, const PythonLength& max_length,
                              const py::object& progress) {
  Document document = mesh.document;
  Entries report = join_places(document.mesh);
  HandleOptions options;
  options.max_length = Lengths(document)(max_length);
  options.coordinate = document.style.coordinate;
  const HandleResult result = without_lock(
      progress, [&](const Progress& to) { return remove_handles(document.mesh, options, to); });
  report.emplace_back("max_length", options.max_length);
  append(report, entries_of(result));
  report.emplace_back("genus", connected_components(document.mesh).genus());
  return mesh_of(std::move(document), report);
}

// --- transform -----------------------------------------------------------------------------------

py::array_t<double> array_of(const Matrix4& matrix) {
  py::array_t<double> array({4, 4});
  for (Eigen::Index i = 0; i < 4; ++i)
    for (Eigen::Index j = 0; j < 4; ++j) array.mutable_at(i, j) = matrix(i, j);
  return array;
}

Matrix4 mirroring(const py::handle& value) {
  if (py::isinstance<py::str>(value)) {
    const std::string axis = py::cast<std::string>(value);
    if (axis.size() != 1 || axis < "x" || axis > "z")
      throw UsageError("mirror: '" + axis + "' is neither x, y or z nor four numbers");
    return mirroring_in(Vec3::Unit(axis[0] - 'x'), 0);
  }
  const std::vector<double> plane = numbers_of(value, 4, "mirror");
  return mirroring_in(vector_of(plane), plane[3]);
}

/// Returns the matrix of a keyword argument. `before` is the product of the earlier ones, on which
/// some keywords depend.
Matrix4 step_of(const std::string& name, const py::handle& value, const Mesh& mesh,
                const Matrix4& before) {
  const auto numbers = [&](std::size_t count) { return numbers_of(value, count, name); };
  if (name == "translate") return translation_by(vector_of(numbers(3)));
  if (name == "rotate") return rotation_about(vector_of(numbers(4)), numbers(4)[3]);
  if (name == "scale") return scaling_by(Vec3::Constant(numbers(1)[0]));
  if (name == "scale_axes") return scaling_by(vector_of(numbers(3)));
  if (name == "mirror") return mirroring(value);
  if (name == "matrix")
    return Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(numbers(16).data());
  const bool is_wanted = name == "center" || name == "unit_box";
  if (!is_wanted) throw UsageError("transform: there is no '" + name + "'");
  if (!py::cast<bool>(value)) return Matrix4::Identity();
  const Box box = mapped_box(mesh, before);
  return name == "center" ? centering(box) : fitting_unit_box(box);
}

MeshPointer transform_mesh(const PythonMesh& mesh, const py::kwargs& steps) {
  Document document = mesh.document;
  Matrix4 product = Matrix4::Identity();
  for (const auto& [name, value] : steps)
    if (!value.is_none())
      product = step_of(py::cast<std::string>(name), value, document.mesh, product) * product;
  const TransformResult result =
      without_lock(py::none(), [&](const Progress&) { return transform(document.mesh, product); });
  scale_lengths(document.style.comments, result.scale);
  py::dict report = dict_of(entries_of(result));
  report["matrix"] = array_of(product);
  return mesh_of(std::move(document), report);
}

// --- align ---------------------------------------------------------------------------------------

MeshPointer align_mesh(const PythonMesh& mesh, const PythonMesh& reference, std::size_t samples,
                       int iterations, const py::object& progress) {
  Document document = mesh.document;
  const RegistrationResult result = without_lock(progress, [&](const Progress& to) {
    return align(document.mesh, reference.document.mesh, {samples, iterations}, to);
  });
  py::dict report = dict_of(entries_of(result));
  report["matrix"] = array_of(result.motion);
  return mesh_of(std::move(document), report);
}

// --- select, split -------------------------------------------------------------------------------

/// Sets the selection from a condition as text, or from a boolean per face.
void set_where(const py::object& where, SelectionOptions& options) {
  if (py::isinstance<py::str>(where)) {
    options.where = py::cast<std::string>(where);
  } else if (!where.is_none()) {
    const auto mask = py::array_t<bool, py::array::c_style>::ensure(where);
    if (!mask) throw UsageError("where: a condition or an array of booleans is needed");
    options.mask.emplace(mask.data(), mask.data() + mask.size());
  }
}

MeshPointer select_faces_of(const PythonMesh& mesh, const std::optional<std::size_t>& largest,
                            double at_least, const std::string& by, const py::object& where,
                            const py::object& box, const py::object& around, bool invert) {
  Document document = mesh.document;
  SelectionOptions options;
  options.largest = largest;
  options.at_least = at_least;
  options.by = component_size_of(by);
  set_where(where, options);
  options.box = optional_box(box);
  options.around = optional_vector(around, "around");
  options.invert = invert;
  const SelectionResult result =
      without_lock(py::none(), [&](const Progress&) { return select(document.mesh, options); });
  return mesh_of(std::move(document), entries_of(result));
}

std::vector<MeshPointer> split_mesh(const PythonMesh& mesh, const std::string& by) {
  std::vector<Mesh> parts = without_lock(py::none(), [&](const Progress&) {
    return split_components(mesh.document.mesh, component_size_of(by));
  });
  std::vector<MeshPointer> meshes;
  for (Mesh& part : parts)
    meshes.push_back(mesh_of({std::move(part), mesh.document.style, mesh.document.other_elements}));
  return meshes;
}

// --- sample --------------------------------------------------------------------------------------

MeshPointer sample_mesh(const PythonMesh& mesh, std::size_t count,
                        const std::optional<PythonLength>& distance, std::uint64_t seed,
                        const py::object& progress) {
  Document document = mesh.document;
  if ((count > 0) == distance.has_value())
    throw UsageError("give either count, the number of points, or distance, their least distance");
  const SampleOptions options{count, Lengths(document)(distance, 0), seed};
  if (distance && !(options.distance > 0)) throw UsageError("distance must be more than 0");
  document.mesh = without_lock(
      progress, [&](const Progress& to) { return sample_surface(document.mesh, options, to); });

  // The result has only points, as the output of tm-sample.
  document.other_elements.clear();
  document.style.element_order = {"vertex"};
  if (document.style.format == Format::off) document.style.format = Format::ply_little;
  return mesh_of(std::move(document), Entries{{"points", document.mesh.positions.size()}});
}

// --- carry ---------------------------------------------------------------------------------------

MeshPointer carry(const py::args& meshes, const std::vector<std::string>& columns, bool closest) {
  if (meshes.size() < 2)
    throw UsageError("carry: the first mesh of a chain and the last are needed");
  std::vector<const Mesh*> before;
  for (const py::handle& mesh : meshes)
    before.push_back(&py::cast<const PythonMesh&>(mesh).document.mesh);
  before.pop_back();
  Document document = py::cast<const PythonMesh&>(meshes[meshes.size() - 1]).document;
  const CarryResult result = without_lock(py::none(), [&](const Progress&) {
    return carry_along(before, document.mesh, {columns, closest, {}});
  });
  return mesh_of(std::move(document), entries_of(result));
}

}  // namespace

void bind_editing(py::module_& module) {
  using py::arg;
  const py::object none = py::none();
  module.def("fill", &fill_mesh, arg("mesh"), py::kw_only(), arg("max_edges") = none,
             arg("max_diameter") = none, arg("refine") = true, arg("fair") = true,
             arg("allow_crossings") = false, arg("progress") = none,
             "Closes holes by smooth patches, never into a self-intersection unless "
             "`allow_crossings` says "
             "so; the report has what stays open. See tm-fill(1).");
  module.def(
      "handles", &remove_handles_of, arg("mesh"), py::kw_only(), arg("max_length") = "5x",
      arg("progress") = none,
      "Removes handles that a loop of at most this length goes around; the surface may intersect "
      "itself there, for clean(). See tm-handles(1).");
  module.def("transform", &transform_mesh, arg("mesh"),
             "Moves, turns, scales and mirrors, in the order of the keywords: translate=(x, y, z), "
             "rotate=(x, y, z, degrees), scale=factor, scale_axes=(x, y, z), mirror='x' or "
             "(a, b, c, d), matrix=(4, 4) numbers, center=True, unit_box=True. The report has the "
             "matrix of all. See tm-transform(1).");
  module.def("align", &align_mesh, arg("mesh"), arg("reference"), py::kw_only(),
             arg("samples") = RegistrationOptions().samples,
             arg("iterations") = RegistrationOptions().iterations, arg("progress") = none,
             "Turns and moves the mesh onto a reference that shows part of the same surface. The "
             "report has the matrix, the share of the mesh that overlaps, and its root mean square "
             "distance. See tm-align(1).");
  module.def("select", &select_faces_of, arg("mesh"), py::kw_only(), arg("largest") = none,
             arg("at_least") = 0.0, arg("by") = "faces", arg("where") = none, arg("box") = none,
             arg("around") = none, arg("invert") = false,
             "The faces that meet all conditions: of the `largest` components or those `at_least` "
             "so large, `where` a property is such as 'label=2' or an array is true, in a `box` "
             "((x, y, z), (x, y, z)), of the component `around` a point. See tm-select(1).");
  module.def("split", &split_mesh, arg("mesh"), py::kw_only(), arg("by") = "faces",
             "The components as a list of meshes, the largest by 'faces', 'area' or 'volume' "
             "first. See tm-select(1).");
  module.def("sample", &sample_mesh, arg("mesh"), arg("count") = 0, py::kw_only(),
             arg("distance") = none, arg("seed") = 1, arg("progress") = none,
             "Points with normals on the surface, `count` of them by area, or a Poisson disk "
             "of that `distance`. See tm-sample(1).");
  module.def("carry", &carry, py::kw_only(), arg("columns") = std::vector<std::string>(),
             arg("closest") = false,
             "Carries columns from the first mesh of a chain to the last: carry(first, between, "
             "..., last), each made of the one before with source=True, or with `closest` near it. "
             "`columns` names those to carry; without, all but normals. See tm-carry(1).");
}

}  // namespace transformesh::python
