/// tm-clean: removes self-intersections (section 3 of the TransforMesh paper).
#include "clean/box/clean_box.h"
#include "frame/run.h"
#include "io/comments.h"
#include "options/clean_notes.h"
#include "options/clean_options.h"
#include "transformesh/components.h"

using namespace transformesh;

namespace {

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
  tool::note_cleaning(result, run);
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
  tool::Program program{
      "tm-clean", "[OPTION]... [INPUT]",
      "Removes self-intersections; keeps the boundary of the points with winding number >= 1"};
  program.output.is_clean = true;
  program.input.soups = tool::Soups::own;
  program.input.takes_tiles = true;
  tool::declare_cleaning(program, choices);
  program.example = "tm-clean self-intersecting.ply > clean.ply";
  return program.run(argc, argv,
                     [&](tool::Run& run) { clean_document(run.document(), choices, run); });
}
