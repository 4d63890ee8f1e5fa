#include "tm/clean/rounding/snap_rounding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "tm/clean/rounding/rounding.h"
#include "tm/clean/rounding/trouble_spots.h"
#include "tm/clean/rounding/unite_close.h"
#include "tm/mesh/digits.h"
#include "tm/mesh/location_text.h"
#include "tm/support/error.h"

namespace transformesh {
namespace {

constexpr int most_rounds = 20;
constexpr int most_rounds_of_repair = 12;
constexpr int most_equal_rounds = 3;
constexpr std::size_t few = 30;  // by so many the broken faces may grow in number
constexpr std::size_t few_pairs = 1000;
// How close new vertices become one from the start, in doublings of the spacing of floats or
// doubles. More would close films that can be kept.
constexpr int doublings_of_new = -1;
constexpr int most_doublings_of_merging = 8;
constexpr int most_grid_steps = 5;
constexpr int most_starts = 20;

// One way to unite parts close to what is broken. Distances are in doublings of the spacing of
// floats or doubles.
struct Attempt {
  int doublings;  ///< the distance in the first rounds
  bool is_wide;   ///< takes all faces near the broken ones, not only these
  bool is_local;  ///< as in Closeness, for floats; doubles cannot be measured in finer units
  int doublings_of_merging = 1;  ///< the least distance within which vertices become one
};
// No attempt mends every place, and what one leaves broken another mends. This order left the
// fewest places broken in trials with the corpus and with shapes rotated at random.
constexpr std::array attempts = {Attempt{-2, true, true},   Attempt{0, true, false},
                                 Attempt{-2, false, false}, Attempt{2, true, false},
                                 Attempt{-1, false, false}, Attempt{-3, false, false},
                                 Attempt{1, false, true},   Attempt{-2, false, false, -1}};
constexpr Attempt on_grid = {-2, false, false};

const Attempt& attempt_after(int failures) {
  return failures < std::ssize(attempts) ? attempts[static_cast<std::size_t>(failures)] : on_grid;
}

int grid_step_after(int failures) {
  return std::max(0, failures - static_cast<int>(attempts.size()) + 1);
}

// The distance of an attempt in a round. Rotating in doubles moves what was coplanar by a few
// spacings of doubles; what was rotated in doubles and stored in floats is off by one spacing of
// floats.
int doublings_in(int round, const Attempt& attempt, Scalar coordinate) {
  return attempt.doublings + round / 3 + (coordinate == Scalar::float32 ? 0 : 2);
}

// The spacing of the grid at each step, in doublings of the spacing of floats or doubles.
int grid_doublings(Scalar coordinate, int step) {
  return (coordinate == Scalar::float32 ? 2 : 5) * step;
}

std::string place_of(const Mesh& mesh, Index face) {
  return point_text(mesh.positions[mesh.faces[face][0]]);
}

class SnapRounder {
 public:
  SnapRounder(const Mesh& mesh, const SnapRoundingOptions& options, const Progress& progress)
      : mesh_(mesh), options_(options), progress_(progress), spots_(mesh) {}

  SnapRoundingResult snap_round(CleanPass pass);

 private:
  bool repair(Assembly& assembly);
  double distance(int doublings) const {
    return std::ldexp(coordinate_spacing(mesh_, options_.coordinate), doublings);
  }
  void round_new_positions(Assembly& assembly) const;
  void round_and_merge(Assembly& assembly) const;
  void unite_broken(Assembly& assembly, const std::vector<Index>& broken, int round) const;
  void unite(Assembly& assembly, std::vector<Index> broken, int failures, int round) const;
  Mesh snapped_input() const;
  void count_faces(const std::vector<char>& was_whole, const Assembly& assembly);
  CleanPass run_pass(const Mesh& mesh, const PassOptions& options) const;
  [[noreturn]] void give_up() const;

  const Mesh& mesh_;
  const SnapRoundingOptions& options_;
  const Progress& progress_;
  TroubleSpots spots_;
  std::size_t most_pairs_ = 0;  ///< with more than these, repair is hopeless
  std::string place_;           ///< the first place that was broken
  SnapRoundingResult result_;
};

void SnapRounder::round_new_positions(Assembly& assembly) const {
  if (options_.coordinate != Scalar::float32) return;
  for (std::size_t v = 0; v < assembly.mesh.positions.size(); ++v) {
    if (!assembly.vertex_is_new[v]) continue;
    for (double& x : assembly.mesh.positions[v]) x = round_to_single(x);
  }
}

void SnapRounder::give_up() const {
  const std::string place = place_.empty() ? place_of(mesh_, 0) : place_;
  throw GoalError("rounding leaves faces that cross near " + place +
                  "; write doubles (--double), or move and scale the mesh to the origin");
}

// Cleans what was rounded. Where nothing is left of it, the shape is too small for its coordinates.
CleanPass SnapRounder::run_pass(const Mesh& mesh, const PassOptions& options) const {
  try {
    return run_clean_pass(mesh, options, progress_);
  } catch (const GoalError&) {
    give_up();
  }
}

// Expresses what a further pass tells about its input by that of the first pass: which vertices are
// new, and the sources of faces.
void inherit(const Assembly& before, Assembly& after) {
  for (std::size_t v = 0; v < after.input_vertex.size(); ++v) {
    const Index source = after.input_vertex[v];
    if (source != no_index) after.vertex_is_new[v] = before.vertex_is_new[source];
  }
  for (Index& source : after.source_face) source = before.source_face[source];
}

void SnapRounder::unite(Assembly& assembly, std::vector<Index> broken, int failures,
                        int round) const {
  const Attempt& attempt = attempt_after(failures);
  const double reach = distance(doublings_in(round, attempt, options_.coordinate));
  const bool is_local = attempt.is_local && options_.coordinate == Scalar::float32;
  merge_close_vertices(assembly, with_faces_around(assembly.mesh, broken),
                       std::max(reach, distance(attempt.doublings_of_merging)));
  if (attempt.is_wide) broken = with_near_faces(assembly.mesh, broken, reach);
  if (unite_close_parts(assembly, broken, {reach, is_local}, options_.coordinate)) return;
  // Too many faces pass one place, through one point or in a mess of slivers.
  merge_clusters(assembly, broken, options_.coordinate);
  merge_close_vertices(assembly, broken, distance(std::min(failures, most_doublings_of_merging)));
}

// Unites parts near the broken faces, in each place by the attempt that follows those that failed.
void SnapRounder::unite_broken(Assembly& assembly, const std::vector<Index>& broken,
                               int round) const {
  std::set<int> all_failures;
  for (const Index face : broken) all_failures.insert(spots_.failures_at(assembly.mesh, face));
  for (const int failures : all_failures) {
    const bool is_first = failures == *all_failures.begin();
    std::vector<Index> there = is_first ? broken : find_broken_faces(assembly);
    std::erase_if(there,
                  [&](Index face) { return spots_.failures_at(assembly.mesh, face) != failures; });
    unite(assembly, std::move(there), failures, round);
  }
}

// The number of broken faces from round to round. Repair is hopeless when it grows by more than a
// few, stays the same, or takes too long.
class Trend {
 public:
  bool is_fewest(std::size_t broken) const { return broken <= fewest_; }
  bool is_hopeless(std::size_t broken) {
    equal_rounds_ = broken == last_ ? equal_rounds_ + 1 : 1;
    last_ = broken;
    fewest_ = std::min(fewest_, broken);
    return ++rounds_ > most_rounds_of_repair || equal_rounds_ > most_equal_rounds ||
           2 * broken > 3 * fewest_ + few;
  }

 private:
  std::size_t last_ = 0;
  std::size_t fewest_ = std::numeric_limits<std::size_t>::max();
  int rounds_ = 0;
  int equal_rounds_ = 0;
};

void SnapRounder::round_and_merge(Assembly& assembly) const {
  round_new_positions(assembly);
  // Vertices that rounding all but unites would only make slivers.
  merge_close_vertices(assembly, find_new_faces(assembly), distance(doublings_of_new));
}

// Rounds, and then repairs and cleans what rounding broke, until cleaning changes nothing. What is
// whole at once need not be cleaned again, unless the mesh is open: then other fans close its
// borders now. Returns whether it succeeded; if not, notes the faces that were broken when they
// were fewest.
bool SnapRounder::repair(Assembly& assembly) {
  Trend trend;
  TroubleSpots spots = spots_;
  for (int round = 0; round < most_rounds; ++round) {
    progress_("round");
    round_and_merge(assembly);
    const std::vector<Index> broken = find_broken_faces(assembly);
    if (broken.empty() && round == 0 && !options_.is_open) return true;
    if (!broken.empty()) {
      if (place_.empty()) place_ = place_of(assembly.mesh, broken.front());
      if (trend.is_fewest(broken.size())) (spots = spots_).add(assembly, broken);
      if (trend.is_hopeless(broken.size())) break;
      ++result_.repairs;
      unite_broken(assembly, broken, round);
    }
    CleanPass pass = run_pass(assembly.mesh, {1, options_.method, false, most_pairs_});
    if (pass.unchanged) return true;
    if (pass.pairs > most_pairs_) break;
    inherit(assembly, pass.assembly);
    assembly = std::move(pass.assembly);
  }
  spots_ = std::move(spots);
  return false;
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

// The input with vertices on a grid where all attempts failed, coarser the more often they did.
Mesh SnapRounder::snapped_input() const {
  Mesh mesh = mesh_;
  for (int step = 1; step <= grid_step_after(spots_.most_failures()); ++step) {
    std::vector<char> is_marked;
    for (const int failures : spots_.failures_of_input())
      is_marked.push_back(grid_step_after(failures) >= step ? 1 : 0);
    const double spacing = distance(grid_doublings(options_.coordinate, step));
    mesh = snap_to_grid(mesh, is_marked, spacing, options_.coordinate);
  }
  return mesh;
}

SnapRoundingResult SnapRounder::snap_round(CleanPass pass) {
  const std::vector<char> was_whole = whole_faces(mesh_, pass.assembly);
  most_pairs_ = 2 * pass.pairs + few_pairs;
  for (int start = 1; !repair(pass.assembly); ++start) {
    result_.grid_steps = static_cast<std::size_t>(grid_step_after(spots_.most_failures()));
    if (start == most_starts || result_.grid_steps > most_grid_steps) give_up();
    const Mesh snapped = snapped_input();
    pass = run_pass(snapped, {options_.level, options_.method, false});
    if (pass.unchanged) {
      result_.mesh = snapped;
      return std::move(result_);
    }
  }
  count_faces(was_whole, pass.assembly);
  const auto& is_new = pass.assembly.vertex_is_new;
  result_.new_vertices = static_cast<std::size_t>(std::count(is_new.begin(), is_new.end(), 1));
  result_.copied_vertices = pass.assembly.copies;
  result_.mesh = std::move(pass.assembly.mesh);
  return std::move(result_);
}

}  // namespace

SnapRoundingResult snap_round(const Mesh& mesh, CleanPass pass, const SnapRoundingOptions& options,
                              const Progress& progress) {
  return SnapRounder(mesh, options, progress).snap_round(std::move(pass));
}

}  // namespace transformesh
