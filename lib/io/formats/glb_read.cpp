#include <Eigen/LU>
#include <algorithm>

#include "io/document/unit.h"
#include "io/formats/column_groups.h"
#include "io/formats/finite_values.h"
#include "io/formats/glb.h"
#include "io/formats/gltf_mesh.h"
#include "io/formats/gltf_scene.h"
#include "mesh/coordinate_spacing.h"
#include "mesh/index_limits.h"
#include "mesh/surface_columns.h"
#include "support/counted.h"

namespace transformesh {
namespace {

class GlbReader {
 public:
  GlbReader(const Source& source, const std::string& folder)
      : source_(source), budget_(source), file_(source, folder) {}

  ReadResult read() {
    Style& style = result_.document.style;
    style.format = Format::glb;
    style.coordinate = Scalar::float32;
    read_comments();
    set_missing_unit();
    const std::vector<GltfInstance> instances = gltf_instances(file_);
    for (const GltfInstance& instance : instances) add_instance(instance);
    Mesh& mesh = result_.document.mesh;
    round_floats(mesh.vertex_columns);
    zero_values_not_finite(mesh.vertex_columns, source_, "vertex", "glb", result_.notes);
    drop_points_not_finite(mesh, 0, "glb", result_.notes);
    if (instances.size() > 1) note(counted(instances.size(), "mesh node") + " read as one mesh");
    note_losses();
    return std::move(result_);
  }

 private:
  void note(const std::string& text) { result_.notes.push_back("glb: " + text); }

  void read_comments() {
    const GltfJson& json = file_.json();
    const auto list = json["asset"].find("extras");
    if (list == json["asset"].end() || !list->is_object() || !list->contains("comments")) return;
    for (const GltfJson& comment : list->at("comments"))
      if (comment.is_string())
        result_.document.style.comments.push_back(comment.get<std::string>());
  }

  /// Sets the unit to meters, the unit of glTF, unless a comment of this suite states another unit.
  void set_missing_unit() {
    if (unit_of(result_.document) == nullptr) set_unit(result_.document, *find_unit("meter"));
  }

  void add_instance(const GltfInstance& instance) {
    // Number of bytes by which a visit of a node reduces the budget, because a visit takes time
    // even if the mesh is empty.
    constexpr std::size_t cost_of_visit = 64;
    budget_.spend(cost_of_visit);
    Document part;
    part.mesh = gltf_mesh(file_, instance.mesh, budget_, losses_);
    part.style.coordinate = Scalar::float32;
    if (!instance.to_scene.matrix().isIdentity(0)) {
      place(instance.to_scene, part.mesh);
      part.style.coordinate = Scalar::float64;
    }
    Mesh& all = result_.document.mesh;
    if (all.positions.size() + part.mesh.positions.size() >= no_index)
      file_.fail(too_many_vertices);
    if (all.faces.size() + part.mesh.faces.size() >= no_index / 3) file_.fail(too_many_triangles);
    add_missing_colors(all.vertex_columns, all.positions.size(), part.mesh.vertex_columns,
                       part.mesh.positions.size());
    add_missing_colors(all.face_columns, all.faces.size(), part.mesh.face_columns,
                       part.mesh.faces.size());
    for (const std::string& line : append(result_.document, part)) note(line);
  }

  /// Transforms a mesh to scene coordinates. If the transformation is a mirror image, faces are
  /// reversed, so that the outside stays outside.
  static void place(const Eigen::Affine3d& to_scene, Mesh& mesh) {
    for (Vec3& position : mesh.positions) position = to_scene * position;
    const Eigen::Matrix3d linear = to_scene.linear();
    const double sign = linear.determinant() < 0 ? -1 : 1;
    // Matrix for normals: the inverse transpose up to a factor. It is the matrix of cofactors,
    // which needs no division.
    Eigen::Matrix3d normal_matrix;
    normal_matrix << linear.col(1).cross(linear.col(2)), linear.col(2).cross(linear.col(0)),
        linear.col(0).cross(linear.col(1));
    turn_normals(sign * normal_matrix, mesh.vertex_columns);
    if (sign > 0) return;
    for (Index f = 0; f < mesh.faces.size(); ++f) {
      std::swap(mesh.faces[f][1], mesh.faces[f][2]);
      reverse_corner_lists(mesh, f);
    }
  }

  static void turn_normals(const Eigen::Matrix3d& matrix, Columns& columns) {
    Column* const x = columns.find("nx");
    Column* const y = columns.find("ny");
    Column* const z = columns.find("nz");
    if (x == nullptr || y == nullptr || z == nullptr) return;
    for (std::size_t v = 0; v < x->values.size(); ++v) {
      const Vec3 normal = matrix * Vec3(x->values[v], y->values[v], z->values[v]);
      const Vec3 unit = normal.stableNormalized();
      x->values[v] = unit.x(), y->values[v] = unit.y(), z->values[v] = unit.z();
    }
  }

  /// Rounds float columns again. Values computed from normalized integers, rotated normals and
  /// reversed texture coordinates are not floats yet.
  static void round_floats(Columns& columns) {
    for (Column& column : columns.columns)
      if (column.type == Scalar::float32)
        for (double& value : column.values) value = round_to_single(value);
  }

  void note_losses() {
    const auto left_out = [&](std::size_t count, const std::string& what) {
      if (count > 0) note(counted(count, what) + " left out");
    };
    left_out(losses_.line_primitives, "line primitive");
    left_out(losses_.unread_attributes, "unsupported vertex attribute");
    left_out(losses_.unused_merges, "mismatched EXT_mesh_manifold extension");
    left_out(file_.count("images"), "picture");
    left_out(file_.count("animations"), "animation");
    left_out(file_.count("skins"), "skin");
    left_out(file_.count("cameras"), "camera");
    if (file_.rest() > 0) note(counted(file_.rest(), "byte") + " after the last chunk ignored");
  }

  const Source& source_;
  ExpansionBudget budget_;
  GltfFile file_;
  GltfLosses losses_;
  ReadResult result_;
};

}  // namespace

ReadResult read_glb(const Source& source, const std::string& folder) {
  return GlbReader(source, folder).read();
}

}  // namespace transformesh
