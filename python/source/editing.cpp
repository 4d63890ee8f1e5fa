/// Binds fill, handles, transform, align, select, split, cut, section, sample and carry.
#include "call.h"
#include "io/comments.h"
#include "transformesh/align.h"
#include "transformesh/carry.h"
#include "transformesh/components.h"
#include "transformesh/fill.h"
#include "transformesh/handles.h"
#include "transformesh/sample.h"
#include "transformesh/select.h"
#include "transformesh/transform.h"

namespace transformesh::python {
namespace {

// --- fill, handles -------------------------------------------------------------------------------

MeshPointer fill_mesh(Call& call) {
  call.join();
  FillOptions options;
  const auto max_edges = call.get<std::optional<std::size_t>>("max_edges");
  if (max_edges && *max_edges < 3) throw UsageError("max_edges: a hole has at least 3");
  options.max_edges = max_edges.value_or(options.max_edges);
  options.max_diameter = call.length("max_diameter", options.max_diameter);
  call("refine", options.refine)("fair", options.fair);
  call("allow_crossings", options.allow_self_intersections);
  options.coordinate = call.document.style.coordinate;
  return call.result(entries_of(
      call.run([&](const Progress& to) { return fill_holes(call.document.mesh, options, to); })));
}

MeshPointer remove_handles_of(Call& call) {
  call.join();
  const HandleOptions options{call.length("max_length"), call.document.style.coordinate};
  const HandleResult result =
      call.run([&](const Progress& to) { return remove_handles(call.document.mesh, options, to); });
  call.report.emplace_back("max_length", options.max_length);
  append(call.report, entries_of(result));
  return call.result({{"genus", connected_components(call.document.mesh).genus()}});
}

// --- transform -----------------------------------------------------------------------------------

/// Adds the matrix to the report of the mesh, as a NumPy array.
MeshPointer with_matrix(MeshPointer mesh, const Matrix4& matrix) {
  py::array_t<double> array({4, 4});
  for (Eigen::Index i = 0; i < 4; ++i)
    for (Eigen::Index j = 0; j < 4; ++j) array.mutable_at(i, j) = matrix(i, j);
  mesh->report["matrix"] = array;
  return mesh;
}

Matrix4 mirroring(const py::handle& value) {
  if (py::isinstance<py::str>(value)) {
    const std::string axis = py::cast<std::string>(value);
    if (axis.size() != 1 || axis < "x" || axis > "z")
      throw UsageError("mirror: '" + axis + "' is neither x, y, z nor four numbers");
    return mirroring_in(Vec3::Unit(axis[0] - 'x'), 0);
  }
  const std::vector<double> plane = numbers_of(value, 4, "mirror");
  return mirroring_in(vector_of(plane), plane[3]);
}

/// Returns the matrix of the transformation that the argument `name` of transform() requests.
/// `before` is the product of the matrices of earlier arguments. `center` and `unit_box` depend on
/// `before`, because they use the bounding box of the mesh that is already transformed.
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

MeshPointer transform_mesh(Call& call) {
  Matrix4 product = Matrix4::Identity();
  for (const auto& [name, value] : call.get<py::dict>("steps"))
    if (!value.is_none())
      product = step_of(py::cast<std::string>(name), value, call.document.mesh, product) * product;
  const TransformResult result =
      call.run([&](const Progress&) { return transform(call.document.mesh, product); });
  scale_lengths(call.document.style.comments, result.scale);
  return with_matrix(call.result(entries_of(result)), product);
}

// --- align ---------------------------------------------------------------------------------------

MeshPointer align_mesh(Call& call) {
  RegistrationOptions options;
  call("samples", options.samples)("iterations", options.iterations);
  const Mesh& reference = call.mesh("reference").document.mesh;
  const RegistrationResult result = call.run(
      [&](const Progress& to) { return align(call.document.mesh, reference, options, to); });
  return with_matrix(call.result(entries_of(result)), result.motion);
}

// --- select, split -------------------------------------------------------------------------------

/// Sets the condition of the selection from a text, or from an array with a boolean for each face.
void set_where(const py::object& where, SelectionOptions& options) {
  if (py::isinstance<py::str>(where)) {
    options.where = py::cast<std::string>(where);
  } else if (!where.is_none()) {
    const auto mask = py::array_t<bool, py::array::c_style>::ensure(where);
    if (!mask) throw UsageError("where: a condition or an array of booleans is needed");
    options.mask.emplace(mask.data(), mask.data() + mask.size());
  }
}

MeshPointer select_faces_of(Call& call) {
  SelectionOptions options;
  call("largest", options.largest)("at_least", options.at_least)("invert", options.invert);
  options.by = component_size_of(call.get<std::string>("by"));
  set_where(call["where"], options);
  options.box = call.box();
  options.around = call.vector("around");
  return call.result(
      entries_of(call.run([&](const Progress&) { return select(call.document.mesh, options); })));
}

std::vector<MeshPointer> split_mesh(Call& call) {
  const Document& document = call.mesh("mesh").document;
  const ComponentSize by = component_size_of(call.get<std::string>("by"));
  std::vector<MeshPointer> meshes;
  for (Mesh& part : call.run([&](const Progress&) { return split_components(document.mesh, by); }))
    meshes.push_back(mesh_of({std::move(part), document.style, document.other_elements}));
  return meshes;
}

// --- cut, section --------------------------------------------------------------------------------

CutPlane plane_of(const Call& call) {
  const std::vector<double> numbers = numbers_of(call["plane"], 4, "plane");
  return {vector_of(numbers), numbers[3]};
}

MeshPointer cut_mesh(Call& call) {
  const CutPlane at = plane_of(call);
  const auto cap = call.get<bool>("cap");
  Mesh& mesh = call.document.mesh;
  call.run([&](const Progress& to) {
    cap ? cut_closed(mesh, at, call.document.style.coordinate, to)
        : static_cast<void>(cut_open(mesh, at));
    return true;
  });
  return call.result();
}

py::array_t<double> section_of(Call& call) {
  const CutPlane at = plane_of(call);
  const Mesh& mesh = call.mesh("mesh").document.mesh;
  const auto segments = call.run([&](const Progress&) { return plane_section(mesh, at); });
  py::array_t<double> array({segments.size(), std::size_t{2}, std::size_t{3}});
  double* to = array.mutable_data();
  for (const auto& [from, end] : segments)
    for (const Vec3* point : {&from, &end}) to = std::copy_n(point->data(), 3, to);
  return array;
}

// --- sample --------------------------------------------------------------------------------------

MeshPointer sample_mesh(Call& call) {
  SampleOptions options;
  call("count", options.count)("seed", options.seed);
  const bool has_distance = !call["distance"].is_none();
  if ((options.count > 0) == has_distance)
    throw UsageError(
        "give either count, the number of points, or distance, the smallest distance between two "
        "of them");
  options.distance = call.length("distance");
  if (has_distance && !(options.distance > 0)) throw UsageError("distance must be above 0");
  Document& document = call.document;
  document.mesh =
      call.run([&](const Progress& to) { return sample_surface(document.mesh, options, to); });

  // The result has only points, as the output of tm-sample.
  document.other_elements.clear();
  document.style.element_order = {"vertex"};
  if (document.style.format == Format::off) document.style.format = Format::ply_little;
  return call.result({{"points", document.mesh.positions.size()}});
}

// --- carry ---------------------------------------------------------------------------------------

MeshPointer carry(Call& call) {
  std::vector<const Mesh*> before;
  for (const PythonMesh* mesh : call.meshes("carry")) before.push_back(&mesh->document.mesh);
  if (before.size() < 2)
    throw UsageError("carry: the first mesh of a chain and the last are needed");
  before.pop_back();
  call.document = call.meshes("carry").back()->document;
  CarryOptions options;
  call("columns", options.columns)("closest", options.closest);
  return call.result(entries_of(
      call.run([&](const Progress&) { return carry_along(before, call.document.mesh, options); })));
}

}  // namespace

void bind_editing(py::module_& module) {
  define_filter(module, "fill", &fill_mesh);
  define_filter(module, "handles", &remove_handles_of);
  define_filter(module, "transform", &transform_mesh);
  define_filter(module, "align", &align_mesh);
  define_filter(module, "select", &select_faces_of);
  define(module, "split", &split_mesh);
  define_filter(module, "cut", &cut_mesh);
  define(module, "section", &section_of);
  define_filter(module, "sample", &sample_mesh);
  define(module, "carry", &carry);
}

}  // namespace transformesh::python
