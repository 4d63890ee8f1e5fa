/// tm-hull: the visual hull of calibrated silhouettes.
#include "frame/run.h"
#include "options/view_options.h"
#include "reconstruction/reconstruction_entries.h"
#include "transformesh/hull.h"
#include "views/cameras/view.h"
#include "views/hull/hull_values.h"

namespace {

using namespace transformesh;

struct Options {
  tool::SilhouetteOptions silhouettes;
  tool::ViewCheckChoices check;
  HullOptions hull;
  std::optional<Length> edge;
  std::string keep = "largest";
  std::string outlines;  ///< output folder for the silhouettes of the hull; empty: none
};

void declare(tool::Program& program, Options& options) {
  tool::declare_silhouettes(program, options.silhouettes);
  program.options.box("box", &options.hull.box, "X0,Y0,Z0,X1,Y1,Z1",
                      "lower and upper corner of the box that contains the hull (default: bounding "
                      "box derived from "
                      "the silhouettes)");
  program.options.integer("resolution", &options.hull.resolution, 4, 4096,
                          "number of grid cells along the longest side of the box");
  program.options.length("edge", &options.edge, "size of a grid cell, instead of --resolution");
  program.options.text("keep", &options.keep, "largest|all|SHARE",
                       "components to keep: the largest, all, or those of at least this share of "
                       "the largest one's volume");
  tool::declare_view_check(program, options.check, options.silhouettes.sources);
  program.options.text(
      "write-outlines", &options.outlines, "FOLDER",
      "also write the silhouette of the hull in each view to this folder, as NAME.png");
}

void make(const Options& options, tool::Run& run) {
  HullOptions hull = options.hull;
  hull.keep = tool::hull_share(options.keep);
  std::vector<View> views = tool::views_with_silhouettes(options.silhouettes, run);
  const ViewCheck check = tool::check_views(views, options.check, run);
  if (!hull.box) hull.box = silhouette_box(views);
  run.in().set_basis(diagonal_of(*hull.box));
  if (options.edge) hull.edge = run.length(*options.edge);

  HullResult result = visual_hull(views, hull, run.progress());
  run.report(entries_of(check, views.size()));
  run.report("cell", result.cell);
  run.report("dropped_components", result.dropped_components);
  if (!options.outlines.empty()) tool::write_outlines(result.mesh, views, options.outlines, run);
  run.document().mesh = std::move(result.mesh);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  tool::Program program{"tm-hull",
                        "[OPTION]... --cameras WHERE --silhouettes WHERE|--images WHERE",
                        "Makes the visual hull of calibrated silhouettes",
                        {tool::Reads::nothing}};
  declare(program, options);
  program.lengths =
      "A LENGTH is 0.02 (in the units of the cameras) or 1% (of the diagonal of the box).";
  program.example = "tm-hull --cameras par.txt --silhouettes masks > hull.ply";
  return program.run(argc, argv, [&](tool::Run& run) { make(options, run); });
}
