#include "options/wrap_points.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "mesh/location_text.h"
#include "step/prepare_target.h"
#include "support/counted.h"
#include "transformesh/components.h"
#include "views/wrap/colmap_points.h"
#include "views/wrap/doubtful_points.h"
#include "views/wrap/outliers.h"

namespace transformesh::tool {
namespace {

/// Erases points, and states their number on stderr and in the report. `why` is the reason that the
/// message states; it may be empty.
void leave_out(const std::vector<Index>& points, const std::string& noun, const std::string& why,
               const std::string& key, Points& cloud, Run& run) {
  run.report(key, points.size());
  if (points.empty()) return;
  run.note(counted(points.size(), noun) + why + " left out, the first at " +
           point_text(cloud.positions[points[0]]) + "; --keep-outliers wraps all points");
  Points rest;
  for (Index i = 0; i < cloud.positions.size(); ++i) {
    if (std::ranges::binary_search(points, i)) continue;
    rest.positions.push_back(cloud.positions[i]);
    if (!cloud.normals.empty()) rest.normals.push_back(cloud.normals[i]);
  }
  cloud = std::move(rest);
}

}  // namespace

Mesh read_cloud(const std::string& path, const std::string& name, Run& run) {
  const auto bytes = run.in().read_bytes(path);
  if (auto points = read_colmap_points({bytes, name})) return std::move(*points);
  ReadResult read = read_mesh(bytes, name, run.in().reading(path));
  run.say().note_all(read.notes);
  return std::move(read.document.mesh);
}

Points points_of(const Mesh& cloud, bool keeps_outliers, Run& run) {
  Points points{cloud.positions, cloud.faces.empty() ? stored_normals(cloud) : std::vector<Vec3>()};
  if (!cloud.faces.empty() || keeps_outliers) {
    run.report("outliers", std::size_t{0});
    return points;
  }
  const Columns& columns = cloud.vertex_columns;
  const std::vector<Index> large = with_large_error(reprojection_errors(columns));
  std::vector<Index> short_tracks;
  std::ranges::set_difference(with_short_track(track_lengths(columns)), large,
                              std::back_inserter(short_tracks));
  for (Index& point : short_tracks)
    point -= static_cast<Index>(std::ranges::lower_bound(large, point) - large.begin());
  leave_out(large, "point", " with a large reprojection error", "large_errors", points, run);
  leave_out(short_tracks, "point", " in fewer than three photographs", "short_tracks", points, run);
  leave_out(find_outliers(points.positions), "outlier", "", "outliers", points, run);
  return points;
}

void note_absurd(const Mesh& mesh, std::size_t points, Run& run) {
  const std::size_t components = connected_components(mesh).components.size();
  run.report("components", components);
  if (components > 1)
    run.note("the wrap has " + counted(components, "component") +
             ": are there several objects, or stray points?");
  // A wrap whose faces are as small as the points allow has at least one face for every ten points.
  constexpr std::size_t most_points_per_face = 10;
  if (mesh.faces.size() * most_points_per_face < points)
    run.note("the wrap of " + counted(points, "point") + " has only " +
             counted(mesh.faces.size(), "face") + ": are there stray points far away?");
}

}  // namespace transformesh::tool
