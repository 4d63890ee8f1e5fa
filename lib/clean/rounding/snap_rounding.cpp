#include "clean/rounding/snap_rounding.h"

#include <algorithm>
#include <numbers>
#include <numeric>
#include <string>

#include "clean/rounding/broken_faces.h"
#include "clean/rounding/flat_vertices.h"
#include "clean/rounding/slivers.h"
#include "clean/rounding/thin_cells.h"
#include "clean/rounding/unsplittable_edges.h"
#include "clean/rounding/vertex_grids.h"
#include "mesh/location_text.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

/// Tolerance of repair, in grid steps. It applies to the heights of flat surfaces
/// (flat_vertices.h), the thickness of thin cells (thin_cells.h), and the heights of slivers
/// (slivers.h). With a height of 2 steps, one of two test meshes of coplanar boxes cannot be
/// rounded. With 8 steps, nearly coplanar faces cannot be rounded (docs/design/rounding.md).
constexpr double flat_steps = 4;
/// Largest number of rounds before repair fails or, once, starts again from the input. With 8,
/// repair fails in 3 of 220 difficult test meshes. With 32, it succeeds in hardly any more meshes
/// (docs/design/rounding.md).
constexpr int most_rounds = 16;
/// Number of doublings of the grid steps at a restart, and after a round that does not reduce the
/// number of broken faces. Three doublings make grids 8 times coarser. With one doubling after such
/// a round, repair fails in a difficult test mesh of nearly coplanar faces. Larger numbers increase
/// displacements (docs/design/rounding.md).
constexpr int doublings_in_vain = 3;
/// Repair fails if the number of intersecting pairs exceeds this multiple of a sum: the number of
/// intersecting pairs of the input, plus its number of faces. This bounds time and memory. With the
/// factor 1, repair fails for nearly coplanar faces; 2 and 8 make no difference
/// (docs/design/rounding.md).
constexpr std::size_t most_pairs_share = 4;

// Composes the results of two successive clean passes. Changes `vertex_is_new` and `source_face` of
// `after`, the result of the second pass, such that they refer to the input of the first pass.
void inherit(const Assembly& before, Assembly& after) {
  for (std::size_t v = 0; v < after.input_vertex.size(); ++v) {
    const Index source = after.input_vertex[v];
    if (source != no_index) after.vertex_is_new[v] = before.vertex_is_new[source];
  }
  for (Index& source : after.source_face) source = before.source_face[source];
}

Displacement round_new_vertices(Assembly& assembly, Scalar type) {
  Displacement moved;
  for (std::size_t v = 0; v < assembly.mesh.positions.size(); ++v) {
    if (!assembly.vertex_is_new[v]) continue;
    Vec3& position = assembly.mesh.positions[v];
    position = rounded_to(position, type);
    const double spacing = spacing_around(position, type);
    moved.note(std::numbers::sqrt3 / 2 * spacing, spacing);
  }
  return moved;
}

/// Returns the result of a clean pass that does not change the mesh.
Assembly unchanged_assembly(const Mesh& mesh) {
  Assembly assembly;
  assembly.mesh = mesh;
  assembly.vertex_is_new.assign(mesh.positions.size(), 0);
  assembly.face_is_new.assign(mesh.faces.size(), 0);
  assembly.input_vertex.resize(mesh.positions.size());
  std::iota(assembly.input_vertex.begin(), assembly.input_vertex.end(), Index{0});
  assembly.source_face.resize(mesh.faces.size());
  std::iota(assembly.source_face.begin(), assembly.source_face.end(), Index{0});
  return assembly;
}

class SnapRounder {
 public:
  SnapRounder(const Mesh& mesh, const CleanPass& pass, const SnapRoundingOptions& options,
              const Progress& progress)
      : mesh_(mesh),
        first_(pass),
        options_(options),
        progress_(progress),
        repair_progress_([&progress](std::string_view phase, double fraction) {
          progress("repair " + std::string(phase), fraction);
          return true;
        }),
        assembly_(pass.assembly),
        grids_(pass.assembly, options.coordinate),
        is_broken_(mesh.faces.size(), 0) {}

  SnapRoundingResult snap_round();

 private:
  void repair();
  void take_rounds(bool is_begun);
  bool repair_round(bool is_first);
  void find_broken();
  bool is_in_vain(std::size_t broken);
  void note_broken(const std::vector<Index>& broken);
  void begin_anew();
  void drop_collapsed();
  void mend();
  bool clean_again(bool gives_cells, ArrangedMesh* input = nullptr);
  bool has_changed() const;
  void count_faces(const std::vector<char>& was_whole);
  [[noreturn]] void give_up() const;
  [[noreturn]] static void throw_nothing_left();

  const Mesh& mesh_;
  const CleanPass& first_;
  const SnapRoundingOptions& options_;
  const Progress& progress_;
  /// Progress of further clean passes, whose phases are reported as "repair ...".
  Progress repair_progress_;
  Assembly assembly_;
  VertexGrids grids_;
  BrokenFaces broken_;           ///< result of the latest search
  DisjointFaces disjoint_;       ///< faces of which the latest search found no intersections
  std::vector<char> is_broken_;  ///< 1 for each input face of which rounding broke a part
  /// Number of broken faces in the previous round; 0 in the first round.
  std::size_t broken_before_ = 0;
  bool is_restarted_ = false;
  bool moves_to_grids_ = true;  ///< vertices move to grids: false after one restart, true after two
  std::optional<Vec3> place_;   ///< a corner of the first broken face
  ArrangedMesh input_;          ///< kept from the first restart for the second
  SnapRoundingResult result_;
};

void SnapRounder::give_up() const {
  const ErrorKind kind = options_.coordinate == Scalar::float32 ? ErrorKind::float_rounding_failed
                         : options_.is_open                     ? ErrorKind::not_closed
                                                                : ErrorKind::double_rounding_failed;
  const Vec3 place = place_.value_or(Vec3::Zero());
  throw GoalError(kind, "rounding leaves faces that intersect near " + point_text(place),
                  {.position = position_data(place)});
}

void SnapRounder::throw_nothing_left() {
  throw GoalError(ErrorKind::thinner_than_rounding,
                  "everything that the faces enclose is thinner than the rounding error");
}

// Removes faces without area until none is left. Such faces may come from splitting a singular edge
// (an edge of more than two faces) that is too short to be split; this edge is contracted.
void SnapRounder::drop_collapsed() {
  while (drop_collapsed_faces(assembly_) &&
         contract_unsplittable_edges(assembly_, result_.repairs > 1, options_.coordinate,
                                     result_.displacement)) {
  }
}

// Finds the broken faces. Keeps the others for the next search, unless there will be none.
void SnapRounder::find_broken() {
  broken_ = find_broken_faces(assembly_, disjoint_);
  const bool is_done = broken_.faces.empty() && result_.repairs == 0 && !options_.is_open;
  if (!is_done) disjoint_ = DisjointFaces(assembly_.mesh, broken_.disjoint);
}

// Tries in turn to move vertices to their grids, to remove vertices in flat surroundings, and to
// flip slivers, until no face is broken. After the first restart, vertices do not move to their
// grids. These are coarse then, and the movement can turn faces so far that they pass neighboring
// sheets.
void SnapRounder::mend() {
  const auto is_mended = [&](bool is_changed) {
    if (is_changed) {
      drop_collapsed();
      find_broken();
    }
    return broken_.faces.empty();
  };
  const auto around = [&] { return with_faces_around(assembly_.mesh, broken_.faces); };
  const bool moves_input = result_.repairs > 1;
  Displacement& moved = result_.displacement;
  if (is_mended(true)) return;
  if (moves_to_grids_ && is_mended(grids_.snap(assembly_, around(), moves_input, moved))) return;
  if (is_mended(
          remove_flat_vertices(mesh_, assembly_, around(), flat_steps, moves_input, grids_, moved)))
    return;
  is_mended(flip_slivers(assembly_, around(), flat_steps, grids_, moved));
}

// Runs a clean pass on the rounded mesh, or on the input if `input` is not null. Returns true if
// the result needs no further rounding.
bool SnapRounder::clean_again(bool gives_cells, ArrangedMesh* input) {
  const std::size_t most_pairs = most_pairs_share * (first_.pairs + mesh_.faces.size());
  CleanPassOptions options{1, options_.method, false, nullptr, {}, most_pairs};
  if (input) options.winding_level = options_.winding_level, options.chooser = options_.chooser;
  options.arranged = input;
  options.coordinate = options_.coordinate;
  if (!input) options.pairs = &broken_.pairs;
  const std::vector<std::uint8_t> levels = grids_.levels_of_faces(assembly_.mesh);
  bool is_given = false;
  if (gives_cells && !options_.is_open)
    options.change_kept = [&](Arrangement& arrangement, std::vector<char>& kept) {
      is_given = give_thin_cells_away(arrangement, kept, {flat_steps, levels, options_.coordinate},
                                      result_.displacement);
    };
  CleanPass pass;
  try {
    pass = run_clean_pass(assembly_.mesh, options, repair_progress_);
  } catch (const GoalError&) {
    throw_nothing_left();
  }
  if (pass.unchanged) return true;
  if (pass.pairs > most_pairs) give_up();
  if (pass.assembly.mesh.faces.empty()) throw_nothing_left();
  grids_.inherit(assembly_.mesh, pass.assembly);
  inherit(assembly_, pass.assembly);
  assembly_ = std::move(pass.assembly);
  return pass.pairs == 0 && !is_given && assembly_.split_edges == 0 && !options_.is_open;
}

// Restarts repair from the input. Called at most twice: if a round fails to reduce the number of
// broken faces, and if all rounds fail. If sheets intersect at tiny angles, every rounding creates
// new intersections. Therefore thin cells of space between such sheets are removed in the exact
// arrangement of the input, before rounding. Only cells at faces that rounding broke are removed,
// because only their grids become coarser. Open meshes are not restarted, because it is not known
// which of their cells are inside.
void SnapRounder::begin_anew() {
  moves_to_grids_ = is_restarted_;
  is_restarted_ = true;
  broken_before_ = 0;
  result_.displacement = {};
  assembly_ = unchanged_assembly(mesh_);
  grids_ = VertexGrids(assembly_, options_.coordinate);
  std::vector<Index> broken;
  for (Index f = 0; f < is_broken_.size(); ++f)
    if (is_broken_[f]) broken.push_back(f);
  for (int i = 0; i < doublings_in_vain; ++i) grids_.coarsen(mesh_, broken);
  clean_again(true, &input_);
}

// True if the number of broken faces did not decrease since the previous round.
bool SnapRounder::is_in_vain(std::size_t broken) {
  const bool is_vain = broken > 0 && broken_before_ > 0 && broken >= broken_before_;
  broken_before_ = broken;
  return is_vain;
}

void SnapRounder::note_broken(const std::vector<Index>& broken) {
  for (const Index face : broken) is_broken_[assembly_.source_face[face]] = 1;
  if (broken.empty()) return;
  ++result_.repairs;
  if (place_) return;
  place_ = assembly_.mesh.positions[assembly_.mesh.faces[broken.front()][0]];
  result_.places = count_places(assembly_.mesh, broken);
}

// Runs one round: rounding, repair, and a clean pass. Returns true if no further round is needed.
// If the first round breaks no face, a closed mesh needs no clean pass. An open mesh needs a clean
// pass, because its pieces may now enclose other pieces.
bool SnapRounder::repair_round(bool is_first) {
  progress_("round");
  result_.displacement += round_new_vertices(assembly_, options_.coordinate);
  find_broken();
  const std::size_t broken = broken_.faces.size();
  const bool is_whole = broken == 0;
  if (is_whole && is_first && !options_.is_open) return true;
  result_.faces += broken;
  result_.pairs += broken_.pairs.size();
  note_broken(broken_.faces);
  const bool is_vain = is_in_vain(broken);
  if (is_vain && !is_restarted_ && !options_.is_open) {
    begin_anew();
    return false;
  }
  for (int i = 0; i < (is_vain ? doublings_in_vain : 1); ++i)
    grids_.coarsen(assembly_.mesh, broken_.faces);
  if (!is_whole) mend();
  return clean_again(!is_whole);
}

void SnapRounder::take_rounds(bool is_begun) {
  for (int round = 0; round < most_rounds; ++round)
    if (repair_round(round == 0 && !is_begun)) return;
  give_up();
}

// Repairs the mesh in rounds. If this fails for a closed mesh, starts once more from the input, and
// in these rounds moves vertices to their grids, too. Meshes in which one plane has many layers of
// coplanar faces need this.
void SnapRounder::repair() {
  try {
    take_rounds(false);
  } catch (const GoalError& error) {
    if (options_.is_open || error.kind() == ErrorKind::thinner_than_rounding) throw;
    is_restarted_ = true;
    begin_anew();
    take_rounds(true);
  }
}

// True if rounding may have changed faces that were whole after the first clean pass. If no face
// was repaired or merged, whole faces stay whole, because their corners do not move.
bool SnapRounder::has_changed() const {
  return result_.repairs > 0 || first_.assembly.mesh.faces.size() != assembly_.mesh.faces.size();
}

// Removes vertices that no face uses after repair.
void drop_unused_vertices(Assembly& assembly) {
  std::vector<char> is_used(assembly.mesh.positions.size(), 0);
  for (const Face& face : assembly.mesh.faces)
    for (const Index v : face) is_used[v] = 1;
  if (std::find(is_used.begin(), is_used.end(), 0) == is_used.end()) return;
  std::vector<char> is_new;
  for (std::size_t v = 0; v < is_used.size(); ++v)
    if (is_used[v]) is_new.push_back(assembly.vertex_is_new[v]);
  assembly.vertex_is_new = std::move(is_new);
  assembly.mesh = select_faces(assembly.mesh, std::vector<bool>(assembly.mesh.faces.size(), true));
}

// Returns 1 for each face of the mesh that is also a face of the assembly, corner by corner.
std::vector<char> whole_faces(const Mesh& mesh, const Assembly& assembly) {
  std::vector<char> is_whole(mesh.faces.size(), 0);
  const auto at = [](const Mesh& of, Index face, std::size_t i) {
    return of.positions[of.faces[face][i]];
  };
  for (Index f = 0; f < assembly.source_face.size(); ++f) {
    const Index source = assembly.source_face[f];
    bool is_same = true;
    for (std::size_t i = 0; i < 3; ++i) is_same &= at(assembly.mesh, f, i) == at(mesh, source, i);
    is_whole[source] |= is_same ? 1 : 0;
  }
  return is_whole;
}

void SnapRounder::count_faces(const std::vector<char>& was_whole) {
  const std::vector<char> is_whole = whole_faces(mesh_, assembly_);
  std::vector<char> is_left(mesh_.faces.size(), 0);
  for (const Index source : assembly_.source_face) is_left[source] = 1;
  for (std::size_t f = 0; f < is_left.size(); ++f)
    if (was_whole[f] && !is_whole[f]) ++(is_left[f] ? result_.cut_faces : result_.removed_faces);
}

SnapRoundingResult SnapRounder::snap_round() {
  repair();
  if (has_changed()) count_faces(whole_faces(mesh_, first_.assembly));
  drop_unused_vertices(assembly_);
  // Flips of slivers changed the source faces of triangles (slivers.h). Each triangle gets the
  // columns of its source face.
  if (result_.repairs > 0)
    assembly_.mesh.face_columns = mesh_.face_columns.select(assembly_.source_face);
  const auto& is_new = assembly_.vertex_is_new;
  result_.new_vertices = static_cast<std::size_t>(std::count(is_new.begin(), is_new.end(), 1));
  result_.copied_vertices = assembly_.copies;
  result_.level = grids_.largest_level();
  result_.face_is_new = std::move(assembly_.face_is_new);
  result_.source_face = std::move(assembly_.source_face);
  result_.mesh = std::move(assembly_.mesh);
  return std::move(result_);
}

}  // namespace

FirstRound round_once(Assembly& assembly, Scalar type) {
  const Displacement displacement = round_new_vertices(assembly, type);
  return {count_places(assembly.mesh, find_broken_faces(assembly).faces), displacement};
}

SnapRoundingResult snap_round(const Mesh& mesh, const CleanPass& pass,
                              const SnapRoundingOptions& options, const Progress& progress) {
  return SnapRounder(mesh, pass, options, progress).snap_round();
}

}  // namespace transformesh
