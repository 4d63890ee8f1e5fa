#include "tm/clean/clean.h"

#include <algorithm>
#include <memory>

#include "tm/clean/assemble.h"
#include "tm/clean/orientation_check.h"
#include "tm/clean/outermost.h"
#include "tm/clean/rounding.h"
#include "tm/support/error.h"
#include "tm/support/length.h"
#include "tm/support/single.h"

namespace transformesh {
namespace {

constexpr int most_rounds = 8;

void round_new_positions(Assembly& assembly, Scalar coordinate) {
  if (coordinate != Scalar::float32) return;
  for (std::size_t v = 0; v < assembly.mesh.positions.size(); ++v) {
    if (!assembly.vertex_is_new[v]) continue;
    for (double& x : assembly.mesh.positions[v]) x = round_to_single(x);
  }
}

// One pass of the paper's algorithm, exact but for the positions of new vertices.
struct Pass {
  std::size_t pairs = 0;
  std::size_t cut_faces = 0;
  std::size_t removed_faces = 0;
  Exterior exterior;
  bool unchanged = false;
  Assembly assembly;  ///< empty where unchanged
};

Pass run_pass(const Mesh& mesh, const CleanOptions& options, bool is_input,
              const Progress& progress) {
  Pass pass;
  progress("intersect");
  const auto soup = std::make_shared<const Soup>(make_soup(mesh));
  const auto [loops, is_oriented] = find_borders(*soup, mesh);
  if (is_input && !is_oriented) refuse_orientation(*soup, mesh);
  if (!loops.empty() && options.method == ExteriorMethod::static_test) {
    throw UsageError("--method static needs a closed mesh; this one has " +
                     std::to_string(loops.size()) + (loops.size() == 1 ? " border" : " borders") +
                     ": use --method grow");
  }
  const std::vector<FacePair> pairs = find_soup_intersections(*soup, progress);
  const Arrangement arrangement = arrange(soup, pairs, progress);
  const int level = is_input ? options.level : 1;
  pass.exterior =
      find_exterior(arrangement, level, options.method, close_borders(*soup, loops), progress);

  const auto& kept = pass.exterior.kept;
  const auto whole_end = kept.begin() + static_cast<std::ptrdiff_t>(arrangement.whole_pieces);
  pass.pairs = pairs.size();
  pass.cut_faces = soup->faces.size() - arrangement.whole_pieces;
  pass.removed_faces = static_cast<std::size_t>(std::count(kept.begin(), whole_end, 0));
  pass.unchanged =
      pass.cut_faces == 0 && pass.removed_faces == 0 && soup->faces.size() == mesh.faces.size();
  progress("stitch");
  if (!pass.unchanged) pass.assembly = assemble(mesh, arrangement, kept);
  return pass;
}

std::string place_of(const Mesh& mesh, Index face) {
  const Vec3& p = mesh.positions[mesh.faces[face][0]];
  return "(" + shortest_text(p[0]) + " " + shortest_text(p[1]) + " " + shortest_text(p[2]) + ")";
}

// What was new before a further pass is still not a vertex of the input.
void inherit_newness(const Assembly& before, Assembly& after) {
  for (std::size_t v = 0; v < after.input_vertex.size(); ++v) {
    const Index source = after.input_vertex[v];
    if (source != no_index) after.vertex_is_new[v] = before.vertex_is_new[source];
  }
}

// Rounds, checks what was rounded, and cleans again what rounding broke, until nothing is.
void settle(Assembly& assembly, const CleanOptions& options, CleanResult& result,
            const Progress& progress) {
  for (int round = 0;; ++round) {
    progress("round");
    round_new_positions(assembly, options.coordinate);
    // Points that rounding all but unites would only make slivers.
    merge_close_vertices(assembly, find_new_faces(assembly),
                         merge_distance(assembly.mesh, options.coordinate, 3), false);
    const std::vector<Index> broken = find_broken_faces(assembly);
    if (broken.empty()) return;
    if (round == most_rounds) {
      throw GoalError("rounding leaves faces that cross near " +
                      place_of(assembly.mesh, broken.front()) +
                      "; write doubles (--double), or move and scale the mesh to the origin");
    }
    ++result.rounding_repairs;
    merge_close_vertices(assembly, broken,
                         merge_distance(assembly.mesh, options.coordinate, 6 + 4 * round),
                         round > 1);
    Pass pass;
    pass = run_pass(assembly.mesh, options, false, progress);
    if (pass.unchanged) return;
    inherit_newness(assembly, pass.assembly);
    assembly = std::move(pass.assembly);
  }
}

}  // namespace

CleanResult clean(const Mesh& mesh, const CleanOptions& options, const Progress& progress) {
  if (mesh.faces.empty()) throw InputError("the mesh has no faces: there is nothing to clean");
  Pass pass = run_pass(mesh, options, true, progress);
  CleanResult result;
  result.pairs = pass.pairs;
  result.cut_faces = pass.cut_faces;
  result.removed_faces = pass.removed_faces;
  result.patches = pass.exterior.patches;
  result.rays = pass.exterior.rays;
  result.changed = !pass.unchanged;
  if (pass.unchanged) {
    result.mesh = mesh;
  } else {
    settle(pass.assembly, options, result, progress);
    const auto& is_new = pass.assembly.vertex_is_new;
    result.new_vertices = static_cast<std::size_t>(std::count(is_new.begin(), is_new.end(), 1));
    result.copied_vertices = pass.assembly.copies;
    result.mesh = std::move(pass.assembly.mesh);
  }
  if (options.outermost) {
    result.dropped_components = drop_enclosed_components(result.mesh);
    result.changed |= result.dropped_components > 0;
  }
  if (options.refuse && result.changed) {
    throw GoalError("the mesh needs cleaning (" + std::to_string(result.pairs) +
                    " intersecting face pairs, " + std::to_string(result.removed_faces) +
                    " faces to remove) and --refuse forbids it");
  }
  return result;
}

}  // namespace transformesh
