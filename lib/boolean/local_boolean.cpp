#include "boolean/local_boolean.h"

#include <algorithm>
#include <array>
#include <utility>

#include "boolean/operand_kinds.h"
#include "boolean/selected_cells.h"
#include "clean/flat/changed_faces.h"
#include "clean/flat/merge_flat.h"
#include "clean/intersect/contacts.h"
#include "clean/rounding/snap_rounding.h"
#include "mesh/mesh_of_faces.h"
#include "transformesh/intersect.h"

namespace transformesh {
namespace {

/// Least ratio of two numbers: the faces of the solid, and the faces of the part (the faces of the
/// solid near the operand) and the operand together. If the ratio is smaller, boolean() runs
/// instead. Then boolean() takes less time, because it cuts only faces that have an exterior part.
constexpr std::size_t least_ratio = 4;

/// Name of a temporary vertex attribute (column) with the index of the vertex in the solid, or -1
/// for vertices that are not in the solid.
constexpr const char* vertex_number = "tm:vertex";

bool have_same_columns(const Columns& a, const Columns& b) {
  const auto is_alike = [](const Column& x, const Column& y) {
    return x.name == y.name && x.type == y.type && x.list_count_type == y.list_count_type;
  };
  return std::equal(a.columns.begin(), a.columns.end(), b.columns.begin(), b.columns.end(),
                    is_alike);
}

/// Returns the face rotated so that its smallest vertex index comes first.
Face normalized(Face face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

class LocalBoolean {
 public:
  LocalBoolean(BooleanOperation operation, EditedSolid& solid, const Mesh& operand,
               const BooleanOptions& options)
      : operation_(operation), solid_(solid), operand_(operand), options_(options) {}
  std::optional<LocalBooleanResult> run();

 private:
  struct Change {
    std::vector<Index> removed;  ///< faces of the solid that are removed
    std::vector<Index> added;    ///< faces of `assembly_` that are added
    /// For each vertex of `assembly_` its vertex in the solid, or no_index.
    std::vector<Index> vertex_of;
  };

  bool find_part();
  void collect_part();
  std::optional<Arrangement> arranged();
  bool assemble_chosen(Arrangement& arrangement);
  void number_vertices();
  void merge();
  Change find_change() const;
  bool is_clear_of_rest(const Change& change) const;
  void apply(const Change& change);

  BooleanOperation operation_;
  EditedSolid& solid_;
  const Mesh& operand_;
  const BooleanOptions& options_;
  Box reach_;  ///< faces of the solid that touch this box are near the operand, and form the part
  std::vector<Index> faces_;     ///< faces of the solid near the operand (the part); ascending
  std::vector<Index> vertices_;  ///< vertices of `faces_`, as indices in the solid; ascending
  /// 1 for each inner vertex of the part, the faces near the operand: all faces of the solid at the
  /// vertex are in the part.
  std::vector<char> is_inner_;
  JoinedOperands joined_;   ///< the faces of the solid near the operand (the part), and the operand
  std::vector<char> kept_;  ///< 1 for each piece of a cut face that is kept
  Assembly assembly_;
  LocalBooleanResult result_;
};

// Finds the part of the solid near the operand. First, the faces that touch the bounding box of the
// operand are found. The part consists of all faces that touch the bounding box of these faces.
// Hence it contains all faces that pieces of a cut face can meet after rounding. Returns false if
// the part is too large.
bool LocalBoolean::find_part() {
  const Mesh& mesh = solid_.mesh();
  reach_ = bounding_box(operand_);
  const std::vector<Index> core = solid_.faces_touching(reach_);
  std::vector<Index> corners;
  for (const Index face : core)
    for (const Index v : mesh.faces[face]) corners.push_back(v);
  for (const Index v : corners) reach_.extend(mesh.positions[v]);
  faces_ = solid_.faces_touching(reach_);
  if (least_ratio * (faces_.size() + operand_.faces.size()) > solid_.faces()) return false;
  for (const Index face : faces_)
    for (const Index v : mesh.faces[face]) vertices_.push_back(v);
  std::sort(vertices_.begin(), vertices_.end());
  vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
  is_inner_.assign(vertices_.size(), 0);
  const auto local = [&](Index v) {
    return std::lower_bound(vertices_.begin(), vertices_.end(), v) - vertices_.begin();
  };
  for (const Index v : corners) is_inner_[static_cast<std::size_t>(local(v))] = 1;
  return true;
}

void LocalBoolean::collect_part() {
  const Mesh& mesh = solid_.mesh();
  Mesh part;
  for (const Index v : vertices_) part.positions.push_back(mesh.positions[v]);
  part.vertex_columns = mesh.vertex_columns.select(vertices_);
  part.face_columns = mesh.face_columns.select(faces_);
  Column& numbers = part.vertex_columns.get(vertex_number, Scalar::int32, vertices_.size());
  std::copy(vertices_.begin(), vertices_.end(), numbers.values.begin());
  for (const Index f : faces_) {
    Face face = mesh.faces[f];
    for (Index& v : face)
      v = static_cast<Index>(std::lower_bound(vertices_.begin(), vertices_.end(), v) -
                             vertices_.begin());
    part.faces.push_back(face);
  }
  joined_ = join_operands(operation_, {{&part}, {&operand_}});
  std::vector<double>& values = joined_.mesh.vertex_columns.find(vertex_number)->values;
  std::fill(values.begin() + static_cast<std::ptrdiff_t>(vertices_.size()), values.end(), -1);
}

// Returns the arrangement of the part (the faces of the solid near the operand) and the operand.
// Returns nothing if the winding numbers of the operand are not all 0 or 1, or if two faces of the
// solid intersect.
std::optional<Arrangement> LocalBoolean::arranged() {
  const auto welded = std::make_shared<WeldedMesh>(weld(joined_.mesh));
  const std::vector<Meeting> meetings = find_meetings(*welded, Progress());
  result_.pairs = count_pairs(*welded, meetings);
  if (find_operand_kinds(*welded, meetings, joined_)[1] != OperandKind::simple) return std::nullopt;
  const auto is_of_solid = [&](Index face) {
    return joined_.operand_of[welded->face_of[face]] == 0;
  };
  for (const Meeting& meeting : meetings)
    if (is_of_solid(meeting.first) && is_of_solid(meeting.second)) return std::nullopt;
  return arrange(welded, meetings, Progress());
}

bool LocalBoolean::assemble_chosen(Arrangement& arrangement) {
  kept_.assign(arrangement.pieces.size(), 0);
  const WindingAt first_at = [this](const Vec3& point) { return solid_.winding_at(point); };
  if (!choose_selected(operation_, joined_, first_at, arrangement, kept_).is_known) return false;
  assembly_ = assemble(joined_.mesh, arrangement, kept_);
  return round_once(assembly_, options_.coordinate).places == 0;
}

// Assigns vertices of the solid to the vertices of `assembly_`. There, a vertex is duplicated for
// each umbrella (faces around the vertex that are connected across edges). If all faces of a vertex
// are in the part (an inner vertex), only its first duplicate is the vertex of the solid, and the
// others are new vertices. If the part lacks faces of a vertex, one umbrella of the solid may
// appear as several in the part, and all duplicates are the vertex of the solid.
void LocalBoolean::number_vertices() {
  std::vector<double>& numbers = assembly_.mesh.vertex_columns.find(vertex_number)->values;
  std::vector<char> is_taken(vertices_.size(), 0);
  for (std::size_t v = 0; v < numbers.size(); ++v) {
    if (assembly_.vertex_is_new[v]) numbers[v] = -1;
    if (numbers[v] < 0) continue;
    const auto local = static_cast<std::size_t>(
        std::lower_bound(vertices_.begin(), vertices_.end(), static_cast<Index>(numbers[v])) -
        vertices_.begin());
    if (is_taken[local] && is_inner_[local]) numbers[v] = -1;
    is_taken[local] = 1;
  }
}

void LocalBoolean::merge() {
  if (!options_.merge_flat || assembly_.mesh.faces.empty()) return;
  std::vector<char> changed = find_changed_faces(joined_.mesh, assembly_.mesh,
                                                 assembly_.source_face, assembly_.face_is_new);
  std::vector<char> fixed;
  for (const double number : assembly_.mesh.vertex_columns.find(vertex_number)->values) {
    const auto at = std::lower_bound(vertices_.begin(), vertices_.end(), number);
    fixed.push_back(number >= 0 && !is_inner_[static_cast<std::size_t>(at - vertices_.begin())]);
  }
  const MergeFlatResult merged = merge_flat(assembly_.mesh, std::move(changed), flat_spacings,
                                            options_.coordinate, Progress(), fixed);
  result_.merge_displacement = merged.displacement;
}

// Compares the faces of `assembly_` with those of the part, the faces of the solid near the
// operand. Faces that occur in both do not change, and keep their place in the solid.
LocalBoolean::Change LocalBoolean::find_change() const {
  const Mesh& mesh = assembly_.mesh;
  Change change;
  for (const double number : mesh.vertex_columns.find(vertex_number)->values)
    change.vertex_of.push_back(number < 0 ? no_index : static_cast<Index>(number));
  std::vector<std::pair<Face, Index>> before;
  for (const Index face : faces_) before.emplace_back(normalized(solid_.mesh().faces[face]), face);
  std::sort(before.begin(), before.end());
  std::vector<char> stays(before.size(), 0);
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    Face face = mesh.faces[f];
    for (Index& v : face) v = change.vertex_of[v];
    const std::pair<Face, Index> wanted(normalized(face), 0);
    const auto at = std::lower_bound(before.begin(), before.end(), wanted);
    if (at != before.end() && at->first == wanted.first)
      stays[static_cast<std::size_t>(at - before.begin())] = 1;
    else
      change.added.push_back(f);
  }
  for (std::size_t i = 0; i < before.size(); ++i)
    if (!stays[i]) change.removed.push_back(before[i].second);
  return change;
}

// Returns true if no added face intersects a face of the solid outside the part, the faces near the
// operand. Such intersections are possible because merged flat faces can reach beyond the part, and
// rounding moves faces.
bool LocalBoolean::is_clear_of_rest(const Change& change) const {
  Mesh both = mesh_of_faces(assembly_.mesh, change.added);
  const Box box = bounding_box(both);
  if (reach_.contains(box)) return true;
  std::vector<Index> rest;
  for (const Index face : solid_.faces_touching(box))
    if (!std::binary_search(faces_.begin(), faces_.end(), face)) rest.push_back(face);
  const Mesh others = mesh_of_faces(solid_.mesh(), rest);
  const auto first = static_cast<Index>(both.positions.size());
  both.positions.insert(both.positions.end(), others.positions.begin(), others.positions.end());
  for (const auto& [a, b, c] : others.faces)
    both.faces.push_back({first + a, first + b, first + c});
  const std::vector<FacePair> pairs = find_intersections(both);
  return std::none_of(pairs.begin(), pairs.end(), [&](const FacePair& pair) {
    return std::min(pair.first, pair.second) < change.added.size();
  });
}

void LocalBoolean::apply(const Change& change) {
  Mesh& mesh = assembly_.mesh;
  mesh.vertex_columns.erase(vertex_number);
  mesh.face_columns = mesh.face_columns.select(change.added);
  std::vector<Face> faces;
  for (const Index f : change.added) faces.push_back(mesh.faces[f]);
  mesh.faces = std::move(faces);
  solid_.replace(change.removed, mesh, change.vertex_of);
}

std::optional<LocalBooleanResult> LocalBoolean::run() {
  if (!have_same_columns(solid_.mesh().vertex_columns, operand_.vertex_columns) ||
      !have_same_columns(solid_.mesh().face_columns, operand_.face_columns) || !find_part())
    return std::nullopt;
  collect_part();
  std::optional<Arrangement> arrangement = arranged();
  if (!arrangement || !assemble_chosen(*arrangement)) return std::nullopt;
  number_vertices();
  merge();
  const Change change = find_change();
  if (!is_clear_of_rest(change)) return std::nullopt;
  apply(change);
  return result_;
}

}  // namespace

std::optional<LocalBooleanResult> combine_in_place(BooleanOperation operation, EditedSolid& solid,
                                                   const Mesh& operand,
                                                   const BooleanOptions& options) {
  if (operand.faces.empty()) return LocalBooleanResult();
  return LocalBoolean(operation, solid, operand, options).run();
}

}  // namespace transformesh
