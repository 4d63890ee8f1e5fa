#include "options/clean_notes.h"

#include "frame/column_notes.h"
#include "support/counted.h"
#include "support/number.h"

namespace transformesh::tool {
namespace {

/// For open meshes, generalized winding numbers decide which parts are inside. A decision is
/// reported if the number differs from the threshold by less than this. With a larger margin, more
/// correct decisions would be reported.
constexpr double small_margin = 0.1;
/// A movement of the surface by rounding and its repair is reported if it exceeds this number of
/// spacings. The spacing of floats is this multiple of the spacing of doubles.
constexpr double float_spacing = 0x1p29;

}  // namespace

void note_cleaning(const CleanResult& result, Run& run) {
  note_dropped_lists(result.dropped_columns, run);
  note_dropped_sources(result.dropped_source_points, source_of_step, run);
  if (result.is_whole)
    run.note(
        "rounding makes faces intersect in the box: the whole mesh was cleaned to remove these "
        "intersections");
  if (result.rounding_spacings > float_spacing)
    run.note("repair of faces that rounding broke moved the surface by up to " +
             shortest_text(result.rounding_displacement) +
             ", farther than rounding to floats does");
  if (result.merge_refused > 0)
    run.note(counted(result.merge_refused, "flat region") +
             (result.merge_refused == 1 ? " keeps its faces" : " keep their faces") +
             ": with fewer faces, it would intersect other faces or fold over");
  if (result.separation_refused > 0)
    run.note(counted(result.separation_refused, "vertex") +
             (result.separation_refused == 1 ? " stays" : " stay") +
             " at the position of another: it is on a border, or faces would intersect");
  if (result.decided_by_number > 0 && result.least_margin < small_margin)
    run.note("generalized winding numbers decided " + counted(result.decided_by_number, "part") +
             " of the open mesh, one of them by a margin of only " +
             shortest_text(result.least_margin));
}

}  // namespace transformesh::tool
