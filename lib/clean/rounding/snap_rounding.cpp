#include "clean/rounding/snap_rounding.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>

#include "clean/rounding/broken_faces.h"
#include "clean/rounding/close_vertices.h"
#include "clean/rounding/contact_splits.h"
#include "clean/rounding/push_outwards.h"
#include "clean/rounding/slivers.h"
#include "clean/rounding/thin_cells.h"
#include "clean/rounding/vertex_grids.h"
#include "mesh/location_text.h"
#include "support/elementary/exponential.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

constexpr int most_rounds = 14;
constexpr int most_attempts = 7;
constexpr int last_given = 3;  // the last attempt before which thin cells are given away
constexpr std::size_t most_intersected = 30;  // pairs per face: with more there are too many cells
constexpr int digits_fewer = 5;               // binary, of what is extreme in every direction
constexpr int rounds_ahead = 3;  // every attempt begins as coarse as that round of the one before
constexpr int most_vain = 2;     // rounds in a row that leave no fewer faces broken than before,
constexpr int patience = 2;      // further attempts if all attempts failed
constexpr std::size_t few_pairs = 1000;
constexpr std::size_t pairs_to_repair = 4;  // times those of the input
constexpr std::size_t most_broken_share = 3;
/// How close new vertices become one where nothing is broken, in spacings.
constexpr double close_to_new = 0.75;

/// How close and how thin parts are that may be united, and how far they come apart, in spacings.
struct Tolerances {
  double vertices, slivers, push, cells;
  bool moves_input;  ///< vertices of the input may move as well
};

/// Which cells are given away where the surface is cleaned.
struct GivenCells {
  double spacings;                      ///< the most in thickness
  std::vector<char> marked_faces = {};  ///< beside these faces only, where there are any
};

/// How thin the cells of the input are that are given away before a further attempt, in spacings.
double given_spacings(int attempt) { return std::ldexp(32, 3 * attempt); }

Tolerances tolerances(int attempt, int round) {
  const int step = round + rounds_ahead * attempt;
  const double coarser = elementary::exp2(step / 4.0);
  return {3 * coarser, 4 * coarser, coarser, 4 * coarser * coarser, step > 0};
}

// Expresses what a further clean pass tells about its input by that of the first clean pass: which
// vertices are new, and the sources of faces.
void inherit(const Assembly& before, Assembly& after) {
  for (std::size_t v = 0; v < after.input_vertex.size(); ++v) {
    const Index source = after.input_vertex[v];
    if (source != no_index) after.vertex_is_new[v] = before.vertex_is_new[source];
  }
  for (Index& source : after.source_face) source = before.source_face[source];
}

// Rounds new vertices. Those that rounding all but unites would only make slivers.
Displacement round_and_merge(Assembly& assembly, const Spacings& spacings) {
  Displacement moved;
  for (std::size_t v = 0; v < assembly.mesh.positions.size(); ++v) {
    if (!assembly.vertex_is_new[v]) continue;
    Vec3& position = assembly.mesh.positions[v];
    position = rounded_to(position, spacings.type);
    const double spacing = spacing_around(position, spacings.type);
    moved.note(std::numbers::sqrt3 / 2 * spacing, spacing);
  }
  moved +=
      merge_close_vertices(assembly, find_new_faces(assembly), {close_to_new, false}, spacings);
  return moved;
}

class SnapRounder {
 public:
  SnapRounder(const Mesh& mesh, const SnapRoundingOptions& options, const Progress& progress)
      : mesh_(mesh), options_(options), progress_(progress) {}

  SnapRoundingResult snap_round(const CleanPass& pass);

 private:
  /// State of one attempt.
  struct Attempts {
    std::size_t fewest = std::numeric_limits<std::size_t>::max();  ///< broken faces until now
    int vain = 0;                                                  ///< rounds without fewer
  };

  bool repair(Assembly& assembly, int attempt);
  bool is_in_vain(std::size_t broken, Attempts& attempts);
  void note_broken(const Assembly& assembly, const std::vector<Index>& broken, bool is_first);
  Assembly begin_anew(const CleanPass& pass, int attempt);
  Assembly begin_simpler(const CleanPass& pass, int attempt);
  void choose_spacings(int attempt);
  int next_attempt(int attempt) const;
  void mend(Assembly& assembly, BrokenFaces broken, const Tolerances& most);
  bool clean_again(Assembly& assembly, const GivenCells& cells, int winding_level = 1);
  bool has_changed(const Assembly& before, const Assembly& now) const;
  void count_faces(const std::vector<char>& was_whole, const Assembly& assembly);
  [[noreturn]] void give_up() const;
  [[noreturn]] static void throw_nothing_left();

  const Mesh& mesh_;
  const SnapRoundingOptions& options_;
  const Progress& progress_;
  Spacings spacing_;            ///< those that count
  std::size_t most_pairs_ = 0;  ///< with more than these, repair is hopeless
  bool is_hopeless_ = false;
  bool is_shattered_ = false;  ///< rounding breaks a good part of the faces
  bool is_extreme_ = false;    ///< so it does where coordinates are extreme in every direction
  int patience_ = 0;           ///< how many vain rounds more are waited for
  bool is_vain_ = false;       ///< whether a attempt ended for want of it
  std::optional<Vec3> place_;  ///< the first place that was broken
  IntersectionCache known_;
  std::vector<char> is_broken_;  ///< per face of the mesh: whether rounding broke a part of it
  SnapRoundingResult result_;
};

void SnapRounder::give_up() const {
  const bool is_float = options_.coordinate == Scalar::float32;
  const Vec3 place = place_.value_or(Vec3::Zero());
  throw GoalError(is_float ? ErrorKind::float_rounding_failed : ErrorKind::double_rounding_failed,
                  "rounding leaves faces that intersect near " + point_text(place),
                  {.position = position_data(place)});
}

void SnapRounder::throw_nothing_left() {
  throw GoalError(ErrorKind::thinner_than_rounding,
                  "the faces enclose nothing that is thicker than rounding moves it");
}

// Unites what is close around the broken faces, until none is left.
void SnapRounder::mend(Assembly& assembly, BrokenFaces broken, const Tolerances& most) {
  const auto around = [&] { return with_faces_around(assembly.mesh, broken.faces); };
  result_.displacement +=
      merge_close_vertices(assembly, around(), {most.vertices, most.moves_input}, spacing_);
  drop_collapsed_faces(assembly);
  broken = find_broken_faces(assembly, known_);
  const auto note = [&](const Displacement& moved) {
    if (!(moved.spacings > 0)) return false;
    result_.displacement += moved;
    drop_collapsed_faces(assembly);
    return true;
  };
  if (!broken.faces.empty() && note(flip_slivers(assembly, around(), most.slivers, spacing_)))
    broken = find_broken_faces(assembly, known_);
  if (!broken.faces.empty() &&
      note(push_outwards(assembly, broken.faces, {most.push, most.moves_input}, spacing_)))
    broken = find_broken_faces(assembly, known_);
  if (!broken.faces.empty())
    note(split_at_contacts(assembly, broken.intersections, most.slivers, spacing_));
}

// Cleans what was rounded, and gives thin cells away. Returns whether nothing is left to be rounded
// again.
bool SnapRounder::clean_again(Assembly& assembly, const GivenCells& cells, int winding_level) {
  CleanPassOptions options{winding_level, options_.method, false, {}, most_pairs_};
  bool is_given = false;
  if (cells.spacings > 0 && !options_.is_open)
    options.change_kept = [&](Arrangement& arrangement, std::vector<char>& kept) {
      const auto given =
          give_thin_cells_away(arrangement, kept, cells.spacings, spacing_, cells.marked_faces);
      is_given = given.has_value();
      if (given) result_.displacement += *given;
    };
  CleanPass pass;
  try {
    pass = run_clean_pass(assembly.mesh, options, progress_);
  } catch (const GoalError&) {
    throw_nothing_left();
  }
  if (pass.unchanged) return true;
  is_hopeless_ = pass.pairs > most_pairs_;
  if (is_hopeless_) return false;
  if (pass.assembly.mesh.faces.empty()) throw_nothing_left();
  inherit(assembly, pass.assembly);
  assembly = std::move(pass.assembly);
  return pass.pairs == 0 && !is_given && assembly.split_edges == 0 && !options_.is_open;
}

// The last attempts make simpler what coordinates that are extreme along an axis leave.
void SnapRounder::choose_spacings(int attempt) {
  if (attempt > last_given) spacing_.are_per_axis = false;
}

// Coordinates that are extreme in every direction are better made simpler at once: before thin
// cells are sought, which takes the complete arrangement.
int SnapRounder::next_attempt(int attempt) const {
  constexpr int simpler = last_given + 1;
  if (!is_extreme_) return attempt + 1;
  if (attempt == 0) return simpler;
  if (attempt == simpler) return 1;
  return attempt + 1 == simpler ? simpler + 1 : attempt + 1;
}

// Rounds, and then mends and cleans what rounding broke, until cleaning changes nothing. What is
// whole at once need not be cleaned again, unless the mesh is open: its pieces may have closed
// around others. Returns whether it succeeded.
bool SnapRounder::repair(Assembly& assembly, int attempt) {
  Attempts attempts;
  for (int round = 0; round < most_rounds; ++round) {
    progress_("round");
    result_.displacement += round_and_merge(assembly, spacing_);
    BrokenFaces found = find_broken_faces(assembly, known_);
    const bool is_whole = found.faces.empty();
    if (is_whole && round == 0 && !options_.is_open) return true;
    if (is_in_vain(found.faces.size(), attempts)) return false;
    if (round == 0) choose_spacings(attempt);
    const Tolerances most = tolerances(attempt, round);
    note_broken(assembly, found.faces, attempt == 0 && round == 0);
    if (!is_whole && is_extreme_ && attempt == 0) return false;
    if (!is_whole) mend(assembly, std::move(found), most);
    if (clean_again(assembly, {is_whole ? 0 : most.cells})) return true;
    if (is_hopeless_) return false;
  }
  return false;
}

// Whether for too long there have not been fewer.
bool SnapRounder::is_in_vain(std::size_t broken, Attempts& attempts) {
  attempts.vain = broken == 0 || broken < attempts.fewest ? 0 : attempts.vain + 1;
  attempts.fewest = std::min(attempts.fewest, broken);
  const bool is_now = attempts.vain == most_vain + patience_;
  is_vain_ |= is_now;
  return is_now;
}

void SnapRounder::note_broken(const Assembly& assembly, const std::vector<Index>& broken,
                              bool is_first) {
  for (const Index face : broken) is_broken_[assembly.source_face[face]] = 1;
  is_shattered_ |= is_first && broken.size() > assembly.mesh.faces.size() / most_broken_share;
  is_extreme_ |= spacing_.are_per_axis && is_shattered_;
  if (broken.empty()) return;
  ++result_.repairs;
  if (place_) return;
  place_ = assembly.mesh.positions[assembly.mesh.faces[broken.front()][0]];
  result_.places = count_places(assembly.mesh, broken);
}

// Where nothing was mended or merged, whole faces are those that were, as their corners stay.
bool SnapRounder::has_changed(const Assembly& before, const Assembly& now) const {
  return result_.repairs > 0 || before.mesh.faces.size() != now.mesh.faces.size();
}

// What was mended may leave vertices that no face uses.
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

// Marks the faces of the mesh that are whole faces of the assembly.
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

void SnapRounder::count_faces(const std::vector<char>& was_whole, const Assembly& assembly) {
  const std::vector<char> is_whole = whole_faces(mesh_, assembly);
  std::vector<char> is_left(mesh_.faces.size(), 0);
  for (const Index source : assembly.source_face) is_left[source] = 1;
  for (std::size_t f = 0; f < is_left.size(); ++f)
    if (was_whole[f] && !is_whole[f]) ++(is_left[f] ? result_.cut_faces : result_.removed_faces);
}

/// The mesh as if it were the result of a clean pass that changed nothing.
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

// Where parts are so thin and so nearly parallel that rounding their intersections makes new ones
// again and again, they are given away in the exact arrangement of the input, before anything is
// rounded. What that cannot help begins from the result once more, and coarser, as open meshes do,
// of which it is not known what is inside, and what is so crowded that its complete arrangement is
// large.
Assembly SnapRounder::begin_anew(const CleanPass& pass, int attempt) {
  result_.displacement = {};
  is_hopeless_ = false;
  if (is_shattered_ && attempt > last_given) return begin_simpler(pass, attempt);
  const bool is_crowded = pass.pairs > most_intersected * mesh_.faces.size();
  if (options_.is_open || is_crowded || attempt > last_given) return pass.assembly;
  Assembly assembly = unchanged_assembly(mesh_);
  clean_again(assembly, {given_spacings(attempt), is_broken_}, options_.winding_level);
  return assembly;
}

// Of coordinates that are extreme in every direction only the digits are kept that count where the
// vertex is, and further attempts keep fewer.
Assembly SnapRounder::begin_simpler(const CleanPass& pass, int attempt) {
  most_pairs_ = pairs_to_repair * pass.pairs + few_pairs;
  Assembly assembly = unchanged_assembly(mesh_);
  result_.displacement = snap_to_vertex_grids(
      assembly.mesh, options_.coordinate, std::ldexp(1, digits_fewer * (attempt - last_given - 1)));
  clean_again(assembly, {0}, options_.winding_level);
  if (!is_hopeless_) return assembly;
  result_.displacement = {};
  return pass.assembly;
}

SnapRoundingResult SnapRounder::snap_round(const CleanPass& pass) {
  spacing_ = spacings_for(mesh_, options_.coordinate);
  // What is extreme is better given up early, and begun anew.
  most_pairs_ = (spacing_.are_per_axis ? 1 : pairs_to_repair) * pass.pairs + few_pairs;
  is_broken_.assign(mesh_.faces.size(), 0);
  Assembly assembly = pass.assembly;
  for (int attempt = 0; !repair(assembly, attempt);) {
    attempt = next_attempt(attempt);
    if (attempt == most_attempts) {
      if (patience_ > 0 || !is_vain_) give_up();
      patience_ = patience;
      attempt = 1;
    }
    assembly = begin_anew(pass, attempt);
  }
  if (has_changed(pass.assembly, assembly))
    count_faces(whole_faces(mesh_, pass.assembly), assembly);
  drop_unused_vertices(assembly);
  // A sliver that was flipped is part of the face beside it now.
  if (result_.repairs > 0)
    assembly.mesh.face_columns = mesh_.face_columns.select(assembly.source_face);
  const auto& is_new = assembly.vertex_is_new;
  result_.new_vertices = static_cast<std::size_t>(std::count(is_new.begin(), is_new.end(), 1));
  result_.copied_vertices = assembly.copies;
  result_.mesh = std::move(assembly.mesh);
  return std::move(result_);
}

}  // namespace

FirstRound round_once(Assembly& assembly, const Spacings& spacings) {
  const Displacement displacement = round_and_merge(assembly, spacings);
  return {count_places(assembly.mesh, find_broken_faces(assembly).faces), displacement};
}

SnapRoundingResult snap_round(const Mesh& mesh, const CleanPass& pass,
                              const SnapRoundingOptions& options, const Progress& progress) {
  return SnapRounder(mesh, options, progress).snap_round(pass);
}

}  // namespace transformesh
