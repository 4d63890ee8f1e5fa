/// tm-clean: removes self-intersections (paper 3).
#include "clean/box/clean_box.h"
#include "frame/column_notes.h"
#include "frame/run.h"
#include "io/comments.h"
#include "options/clean_options.h"
#include "support/counted.h"
#include "support/number.h"
#include "transformesh/components.h"

using namespace transformesh;

namespace {

/// A generalized winding number that is this close to the other decision is reported.
constexpr double small_margin = 0.1;

void note_changes(const CleanResult& result, tool::Run& run) {
  tool::note_dropped_lists(result.dropped_columns, run);
  tool::note_dropped_sources(result.dropped_source_points, tool::source_of_step, run);
  if (result.is_whole)
    run.note("rounding makes faces intersect in the box: the whole mesh was cleaned to mend that");
  if (result.merge_refused > 0)
    run.note(counted(result.merge_refused, "flat region") +
             (result.merge_refused == 1 ? " keeps its faces" : " keep their faces") +
             ": covered with fewer, they would intersect others or fold");
  if (result.separation_refused > 0)
    run.note(counted(result.separation_refused, "vertex") +
             (result.separation_refused == 1 ? " stays" : " stay") +
             " in the place of another: on a border, or faces would intersect");
  if (result.decided_by_number > 0 && result.least_margin < small_margin)
    run.note("generalized winding numbers decided " + counted(result.decided_by_number, "part") +
             " of the open mesh, one of them by a margin of only " +
             shortest_text(result.least_margin));
}

void clean_document(Document& document, const tool::CleanChoices& choices, tool::Run& run) {
  const CleanOptions options = tool::clean_options(choices, run);
  const std::optional<Tile> tile = tile_of(document.style.comments);
  CleanResult result = tile ? clean_tile(document.mesh, *tile, options, run.progress())
                            : clean(document.mesh, options, run.progress());
  document.mesh = std::move(result.mesh);
  if (tile) {
    drop_tile_comments(document.style.comments);
    document.style.comments.push_back(cleaned_tile_comment(tile->name));
  }
  add_planarity(document.style.comments, result.merge_displacement);
  note_changes(result, run);
  if (options.box || tile)
    run.report({{"box_faces", result.box_faces}, {"whole_mesh", result.is_whole}});
  run.report(entries_of(result));
  if (!run.shows_report()) return;
  const Components components = connected_components(document.mesh);
  run.report({{"components", components.components.size()}, {"genus", components.genus()}});
}

}  // namespace

int main(int argc, char** argv) {
  tool::CleanChoices choices;
  tool::Program program{"tm-clean", "[OPTION]... [INPUT]",
                        "Removes self-intersections: the boundary of winding number >= 1"};
  program.output.is_clean = true;
  program.input.soups = tool::Soups::own;
  tool::declare_cleaning(program, choices);
  return program.run(argc, argv,
                     [&](tool::Run& run) { clean_document(run.document(), choices, run); });
}
