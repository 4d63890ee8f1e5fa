#include "tm/clean/pass/clean_pass.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "tm/clean/arrange/arrange.h"
#include "tm/clean/exterior/close_borders.h"
#include "tm/clean/intersect/intersect.h"
#include "tm/clean/open/enclosed_sheets.h"
#include "tm/clean/stitch/orientation_check.h"
#include "tm/mesh/disjoint_sets.h"
#include "tm/mesh/manifold.h"
#include "tm/support/error.h"

namespace transformesh {
namespace {

// Whether borders that hang together lie on each other all the way, and run alike: they are the
// rims of a patch that is inside out.
bool has_turned_patch(const Soup& soup, const Mesh& mesh) {
  const std::vector<Index> border = check_manifold(mesh).border_halfedges;
  const auto ends_of = [&](Index h) {
    const Face& f = mesh.faces[h / 3];
    return std::minmax({soup.point_of[f[h % 3]], soup.point_of[f[(h % 3 + 1) % 3]]});
  };
  std::map<std::pair<Index, Index>, int> borders_at;
  DisjointSets rims(soup.points.size());
  for (const Index h : border) {
    ++borders_at[ends_of(h)];
    rims.join(ends_of(h).first, ends_of(h).second);
  }

  std::set<Index> free_somewhere;
  for (const auto& [ends, count] : borders_at)
    if (count == 1) free_somewhere.insert(rims.find(ends.first));
  return std::any_of(borders_at.begin(), borders_at.end(), [&](const auto& edge) {
    return !free_somewhere.contains(rims.find(edge.first.first));
  });
}

// Whether indices say what positions say: a soup, a seam or a singular vertex is to be stitched.
bool is_stitched(const Mesh& mesh, const Borders& borders) {
  const ManifoldReport report = check_manifold(mesh);
  std::size_t border_edges = 0;
  for (const auto& loop : borders.loops) border_edges += loop.size();
  return report.is_manifold() && report.is_oriented() &&
         report.border_halfedges.size() == border_edges;
}

// Of a stitched mesh borders may lie upon each other and run alike: clean makes such, where two
// sheets end at a third. Turning sheets does not mend that; what it mends is refused.
bool ends_at_sheets(const Soup& soup, const Mesh& mesh, const Borders& borders) {
  return is_stitched(mesh, borders) &&
         !(has_turned_patch(soup, mesh) && can_be_oriented(soup, mesh));
}

// What all steps of a pass know of the mesh.
struct Scene {
  std::shared_ptr<const Soup> soup;
  Borders borders;
  std::vector<FacePair> pairs;
  Arrangement arrangement;
};

Scene read_scene(const Mesh& mesh, const PassOptions& options, const Progress& progress) {
  Scene scene;
  scene.soup = std::make_shared<const Soup>(make_soup(mesh));
  scene.borders = find_borders(*scene.soup, mesh);
  if (options.check_orientation && !scene.borders.is_oriented &&
      !ends_at_sheets(*scene.soup, mesh, scene.borders)) {
    refuse_orientation(*scene.soup, mesh);
  }
  scene.pairs = find_intersections(*scene.soup, progress);
  if (scene.pairs.size() <= options.most_pairs)
    scene.arrangement = arrange(scene.soup, scene.pairs, progress);
  return scene;
}

// Without them the mesh may be closed. Returns how many faces these are.
std::size_t leave_out_enclosed_sheets(const Mesh& mesh, int level, Scene& scene,
                                      const Progress& progress) {
  const std::vector<char> marks = find_enclosed_sheets(scene.arrangement, level, progress);
  std::vector<char> left_out(mesh.faces.size(), 0);
  for (std::size_t f = 0; f < marks.size(); ++f) left_out[scene.soup->face_of[f]] = marks[f];
  const auto count = static_cast<std::size_t>(std::count(marks.begin(), marks.end(), 1));
  if (count == 0) return 0;
  scene.soup = std::make_shared<const Soup>(without_faces(*scene.soup, marks));
  scene.borders = find_borders(*scene.soup, mesh, left_out);
  scene.arrangement = arrange(scene.soup, find_intersections(*scene.soup, progress), progress);
  return count;
}

void refuse_borders(std::size_t count) {
  throw UsageError("--method static needs a closed mesh; this one has " + std::to_string(count) +
                   (count == 1 ? " border" : " borders") + ": use --method grow");
}

}  // namespace

CleanPass run_clean_pass(const Mesh& mesh, const PassOptions& options, const Progress& progress) {
  progress("intersect");
  Scene scene = read_scene(mesh, options, progress);
  CleanPass pass;
  pass.pairs = scene.pairs.size();
  if (pass.pairs > options.most_pairs) return pass;
  pass.is_open = !scene.borders.loops.empty();
  if (pass.is_open) {
    pass.removed_faces = leave_out_enclosed_sheets(mesh, options.level, scene, progress);
    const std::size_t borders = scene.borders.loops.size();
    if (borders > 0 && options.method == ExteriorMethod::static_test) refuse_borders(borders);
  }
  const Arrangement& arrangement = scene.arrangement;
  pass.exterior = find_exterior(arrangement, options.level, options.method,
                                close_borders(*scene.soup, scene.borders.loops), progress);

  const auto& kept = pass.exterior.kept;
  const auto whole_end = kept.begin() + static_cast<std::ptrdiff_t>(arrangement.whole_pieces);
  pass.cut_faces = scene.soup->faces.size() - arrangement.whole_pieces;
  pass.removed_faces += static_cast<std::size_t>(std::count(kept.begin(), whole_end, 0));
  pass.unchanged = pass.cut_faces == 0 && pass.removed_faces == 0 &&
                   scene.soup->faces.size() == mesh.faces.size() &&
                   is_stitched(mesh, scene.borders);
  progress("stitch");
  if (!pass.unchanged) pass.assembly = assemble(mesh, arrangement, kept);
  return pass;
}

}  // namespace transformesh
