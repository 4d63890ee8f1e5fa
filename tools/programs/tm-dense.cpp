/// tm-dense: makes a surface from calibrated photographs without masks.
#include "frame/run.h"
#include "options/source_options.h"
#include "support/counted.h"
#include "views/cameras/view_files.h"
#include "views/depth/dense_surface.h"
#include "views/depth/viewed_region.h"
#include "views/wrap/sparse_points.h"

namespace {

using namespace transformesh;

struct Options {
  ViewSources sources;
  std::optional<Box> box;
  std::optional<Length> edge;
};

void declare(tool::Program& program, Options& options) {
  program.options
      .text("cameras", &options.sources.cameras, "WHERE", "file, folder or pattern of the cameras")
      .is_needed = true;
  program.options
      .text("images", &options.sources.images, "WHERE",
            "file, folder or pattern of the photographs")
      .is_needed = true;
  program.options.box(
      "box", &options.box, "X0,Y0,Z0,X1,Y1,Z1",
      "lower and upper corner of the box to search (default: around the sparse points, or "
      "around the point at which the cameras look)");
  program.options.length("edge", &options.edge, "size of a grid cell (default: 1.5 pixels)");
  tool::declare_reading(program, options.sources);
}

std::optional<Box> box_to_search(const Options& options, tool::Run& run) {
  if (options.box) return options.box;
  const std::vector<Vec3> points = sparse_points_beside(options.sources.cameras);
  run.report("sparse_points", points.size());
  return box_of_points(points);
}

void report(const DenseSurface& result, tool::Run& run) {
  run.report({{"scale", result.scale},
              {"cell", result.cell},
              {"pixels", result.pixels},
              {"consistent_pixels", result.consistent},
              {"idle_views", result.idle_views.size()},
              {"dropped_components", result.dropped_components}});
  for (const std::string& name : result.idle_views)
    run.note("the view '" + name + "' adds nothing: no depth in it agrees with other views");
  if (result.dropped_components > 0)
    run.note(counted(result.dropped_components, "small component") + " dropped");
}

void make(const Options& options, tool::Run& run) {
  ViewSources sources = options.sources;
  sources.on_note = [&run](const std::string& text) { run.note(text); };
  run.progress()("read views");
  const std::vector<View> views = views_from(sources);
  run.report("views", views.size());
  DenseOptions dense;
  dense.box = box_to_search(options, run);
  if (options.edge) {
    const Box searched = dense.box ? *dense.box : box_of(viewed_region(views, std::nullopt));
    run.in().set_basis(diagonal_of(searched));
    dense.cell = run.length(*options.edge);
  }
  DenseSurface result = dense_surface(views, dense, run.progress());
  report(result, run);
  run.document().mesh = std::move(result.mesh);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  tool::Program program{"tm-dense",
                        "[OPTION]... --cameras WHERE --images WHERE",
                        "Makes a surface from calibrated photographs without masks",
                        {tool::Reads::nothing}};
  declare(program, options);
  program.lengths =
      "A LENGTH is 0.02 (in the units of the cameras) or 1% (of the diagonal of the box).";
  program.example = "tm-dense --cameras par.txt --images photos > scene.ply";
  return program.run(argc, argv, [&](tool::Run& run) { make(options, run); });
}
