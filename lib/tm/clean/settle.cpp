#include "tm/clean/settle.h"

#include <algorithm>
#include <string>

#include "tm/clean/rounding.h"
#include "tm/mesh/place.h"
#include "tm/support/error.h"
#include "tm/support/single.h"

namespace transformesh {
namespace {

constexpr int most_rounds = 8;
// Vertices this close become one, in doublings of the spacing of floats or doubles. More merges
// what lies apart and breaks as much as it mends.
constexpr int doublings_of_new = 3;
constexpr int doublings_of_broken = 5;
constexpr int most_grid_steps = 5;

// Films of a few spacings survive where new vertices first merge over half a spacing only, and over
// twice as much in every round. Where that does not settle, they merge over all of it at once.
enum class Merging { growing, full };

int doublings_in(int round, Merging merging) {
  return merging == Merging::full ? doublings_of_new : std::min(round - 1, doublings_of_new);
}

// The spacing of the grid at each step, in doublings of the spacing of floats and of doubles.
int grid_doublings(Scalar coordinate, int step) {
  return (coordinate == Scalar::float32 ? 2 : 5) * step;
}

std::string place_of(const Mesh& mesh, Index face) {
  return point_text(mesh.positions[mesh.faces[face][0]]);
}

class Settler {
 public:
  Settler(const Mesh& mesh, const SettleOptions& options, const Progress& progress)
      : mesh_(mesh), options_(options), progress_(progress), troubled_(mesh.faces.size(), 0) {}

  Settled settle(CleanPass pass);

 private:
  bool repair(Assembly& assembly, Merging merging);
  double distance(int doublings) const {
    return merge_distance(mesh_, options_.coordinate, doublings);
  }
  void round_new_positions(Assembly& assembly) const;
  void note_trouble(const Assembly& assembly, const std::vector<Index>& broken);
  CleanPass run_pass(const Mesh& mesh, int level) const;
  [[noreturn]] void give_up() const;

  const Mesh& mesh_;
  const SettleOptions& options_;
  const Progress& progress_;
  std::vector<char> troubled_;  ///< per input face: whether it or a piece of it was ever broken
  std::string place_;
  Settled result_;
};

void Settler::round_new_positions(Assembly& assembly) const {
  if (options_.coordinate != Scalar::float32) return;
  for (std::size_t v = 0; v < assembly.mesh.positions.size(); ++v) {
    if (!assembly.vertex_is_new[v]) continue;
    for (double& x : assembly.mesh.positions[v]) x = round_to_single(x);
  }
}

void Settler::note_trouble(const Assembly& assembly, const std::vector<Index>& broken) {
  for (const Index face : broken) troubled_[assembly.source_face[face]] = 1;
  if (place_.empty() && !broken.empty()) place_ = place_of(assembly.mesh, broken.front());
}

void Settler::give_up() const {
  throw GoalError("rounding leaves faces that cross near " + place_ +
                  "; write doubles (--double), or move and scale the mesh to the origin");
}

// Where nothing is left of what rounding broke, the shape is too small for its coordinates.
CleanPass Settler::run_pass(const Mesh& mesh, int level) const {
  try {
    return run_clean_pass(mesh, {level, options_.method, false}, progress_);
  } catch (const GoalError&) {
    give_up();
  }
}

// What was new before a further pass is not a vertex of the input, and sources are input faces.
void inherit(const Assembly& before, Assembly& after) {
  for (std::size_t v = 0; v < after.input_vertex.size(); ++v) {
    const Index source = after.input_vertex[v];
    if (source != no_index) after.vertex_is_new[v] = before.vertex_is_new[source];
  }
  for (Index& source : after.source_face) source = before.source_face[source];
}

// Rounds, checks what was rounded and cleans that again, until nothing is broken or ever more is.
// What remains of an open mesh is cleaned again in any case, because other borders need other fans.
bool Settler::repair(Assembly& assembly, Merging merging) {
  std::size_t fewest = assembly.mesh.faces.size();
  for (int round = 0;; ++round) {
    progress_("round");
    round_new_positions(assembly);
    // Points that rounding all but unites would only make slivers.
    merge_close_vertices(assembly, find_new_faces(assembly),
                         distance(doublings_in(round, merging)));
    const std::vector<Index> broken = find_broken_faces(assembly);
    if (broken.empty() && !options_.is_open) return true;
    if (!broken.empty()) {
      note_trouble(assembly, broken);
      if (round >= most_rounds || broken.size() > 3 * fewest) return false;
      fewest = std::min(fewest, broken.size());
      ++result_.repairs;
      merge_close_vertices(assembly, broken, distance(doublings_of_broken));
    }
    CleanPass pass = run_pass(assembly.mesh, 1);
    if (pass.unchanged) return true;
    inherit(assembly, pass.assembly);
    assembly = std::move(pass.assembly);
  }
}

Settled Settler::settle(CleanPass pass) {
  bool is_settled = repair(pass.assembly, Merging::growing);
  if (!is_settled) {
    pass = run_pass(mesh_, options_.level);
    is_settled = repair(pass.assembly, Merging::full);
  }
  while (!is_settled) {
    if (result_.grid_steps == most_grid_steps) give_up();
    const int step = static_cast<int>(++result_.grid_steps);
    const double spacing = distance(grid_doublings(options_.coordinate, step));
    const Mesh snapped = snap_to_grid(mesh_, troubled_, spacing, options_.coordinate);
    pass = run_pass(snapped, options_.level);
    if (pass.unchanged) {
      result_.mesh = snapped;
      return std::move(result_);
    }
    is_settled = repair(pass.assembly, Merging::full);
  }
  const auto& is_new = pass.assembly.vertex_is_new;
  result_.new_vertices = static_cast<std::size_t>(std::count(is_new.begin(), is_new.end(), 1));
  result_.copied_vertices = pass.assembly.copies;
  result_.mesh = std::move(pass.assembly.mesh);
  return std::move(result_);
}

}  // namespace

Settled settle(const Mesh& mesh, CleanPass pass, const SettleOptions& options,
               const Progress& progress) {
  return Settler(mesh, options, progress).settle(std::move(pass));
}

}  // namespace transformesh
