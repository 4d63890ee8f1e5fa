/// Notes of tm-remesh about components that it dropped and slivers that it kept.
#pragma once

#include "frame/run.h"
#include "mesh/location_text.h"
#include "support/counted.h"
#include "support/number.h"
#include "transformesh/remesh.h"

namespace transformesh::tool {

/// The shortest edge is named, with advice, only if one length holds for the whole mesh.
inline void note_dropped(const RemeshResult::RemovedComponents& dropped,
                         const RemeshOptions& options, Run& run) {
  if (dropped.count == 0) return;
  const bool is_uniform = options.size_column.empty() && options.adaptive_error == 0;
  run.note(counted(dropped.count, "component") + " of " + counted(dropped.faces, "face") +
           ", area " + significant(dropped.area, 3) + " and volume " +
           significant(dropped.volume, 3) + " dropped: smaller than the shortest edge " +
           (is_uniform ? significant(options.min_edge, 3) + "; a smaller --min-edge keeps more"
                       : "there"));
}

inline void note_slivers(const RemeshResult& result, Run& run) {
  if (result.slivers_kept == 0) return;
  run.note(
      counted(result.slivers_kept, "sliver") + " kept, the first at " +
      point_text(result.first_sliver) +
      ": removing such thin faces would make the surface intersect itself or change its topology");
}

}  // namespace transformesh::tool
