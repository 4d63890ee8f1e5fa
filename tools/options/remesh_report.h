/// Notes of tm-remesh about dropped components, remaining slivers, and wanted numbers of faces that
/// were not reached.
#pragma once

#include "frame/run.h"
#include "mesh/location_text.h"
#include "support/counted.h"
#include "support/number.h"
#include "transformesh/decimate.h"
#include "transformesh/remesh.h"

namespace transformesh::tool {

/// Prints a note about dropped components. The note states the shortest allowed edge and a remedy
/// only if this limit is the same on the whole surface.
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

inline void note_decimation(const DecimateResult& result, const DecimateOptions& options,
                            Run& run) {
  if (options.faces == 0) return;
  if (!options.error && result.merged_faces > 0)
    run.note("collapses alone left more than " + std::to_string(options.faces) +
             " faces, so flat faces were merged first, which moves them by rounding errors");
  if (result.merged_faces > 0 && result.faces + 1 < options.faces)
    run.note(counted(result.faces, "face") + " left, fewer than the " +
             std::to_string(options.faces) + " wanted, as flat faces were merged");
  if (!options.error || result.faces <= options.faces) return;
  run.note(counted(result.faces, "face") + " left, more than the " + std::to_string(options.faces) +
           " wanted: further collapses would exceed the error, change the topology or make the "
           "surface touch itself; a larger --error leaves fewer");
}

}  // namespace transformesh::tool
