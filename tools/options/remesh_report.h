/// The entries of tm-remesh's report that have notes beside them.
#pragma once

#include "frame/run.h"
#include "mesh/location_text.h"
#include "support/counted.h"
#include "support/number.h"
#include "transformesh/remesh.h"

namespace transformesh::tool {

/// The shortest edge is named, with advice, only if one length holds for the whole mesh.
inline void report_dropped(const RemeshResult::RemovedComponents& dropped,
                           const RemeshOptions& options, Run& run) {
  run.report("components_dropped", dropped.count);
  run.report("components_dropped_faces", dropped.faces);
  run.report("components_dropped_area", dropped.area);
  run.report("components_dropped_volume", dropped.volume);
  if (dropped.count == 0) return;
  const bool is_uniform = options.size_column.empty() && options.adaptive_error == 0;
  run.note(counted(dropped.count, "component") + " of " + counted(dropped.faces, "face") +
           ", area " + significant(dropped.area, 3) + " and volume " +
           significant(dropped.volume, 3) + " dropped: smaller than the shortest edge " +
           (is_uniform ? significant(options.min_edge, 3) + "; a smaller --min-edge keeps more"
                       : "there"));
}

inline void report_slivers(const RemeshResult& result, Run& run) {
  const Vec3& at = result.first_sliver;
  run.report("degenerate_faces", result.degenerate_faces);
  run.report("slivers_kept", result.slivers_kept);
  run.report("faces_without_area", result.faces_without_area);
  if (result.slivers_kept == 0) return;
  run.report("first_sliver", std::vector<double>{at.x(), at.y(), at.z()});
  run.note(
      counted(result.slivers_kept, "sliver") + " kept, the first at " + point_text(at) +
      ": removing such thin faces would make the surface intersect itself or change its topology");
}

}  // namespace transformesh::tool
