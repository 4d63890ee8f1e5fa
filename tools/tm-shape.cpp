/// tm-shape: closed meshes out of nothing, as sources, targets and workloads.
#include "suggestion.h"
#include "tm/evolve/shapes.h"
#include "tool.h"

namespace {

using namespace transformesh;

struct Options {
  std::vector<std::string> words;
  long faces = 0;
  long count = 0;
  std::optional<Length> edge, radius, tube, gap, neck, noise;
  long seed = 1;
  std::vector<double> center = {0, 0, 0};
  std::string around;
};

// The options that do not depend on what 1% refers to.
ShapeOptions plain_options(const Options& options, tool::Run& run) {
  if (options.words.empty()) throw UsageError("no KIND given: say what to make, see --help");
  ShapeOptions shape;
  shape.kind = options.words[0];
  const std::string nearest = tool::nearest_name(shape.kind, shape_kinds());
  if (nearest != shape.kind) {
    throw UsageError("unknown kind of shape '" + shape.kind + "'; did you mean '" + nearest + "'?");
  }
  shape.parameters.assign(options.words.begin() + 1, options.words.end());
  if (options.faces > 0) shape.faces = options.faces;
  if (options.count > 0) shape.count = options.count;
  shape.seed = static_cast<std::uint64_t>(options.seed);
  shape.center = {options.center[0], options.center[1], options.center[2]};
  if (!options.around.empty()) shape.around = bounding_box(run.read(options.around).mesh);
  return shape;
}

// 1% is of the box to go around; else the sizes refer to the shape of default size, and then the
// edge to the shape of that size.
void resolve_lengths(ShapeOptions& shape, const Options& options, tool::Run& run) {
  const auto resolve = [&run](const std::optional<Length>& length, std::optional<double>& value) {
    if (length) value = run.length(*length);
  };
  const auto set_basis = [&] {
    run.set_basis(shape.around ? shape.around->diagonal() : shape_diagonal(shape));
  };
  set_basis();
  resolve(options.radius, shape.radius);
  resolve(options.tube, shape.tube);
  resolve(options.gap, shape.gap);
  resolve(options.neck, shape.neck);
  set_basis();
  resolve(options.noise, shape.noise);
  resolve(options.edge, shape.edge);
}

Document make(const Options& options, tool::Run& run) {
  ShapeOptions shape = plain_options(options, run);
  resolve_lengths(shape, options, run);
  Document document;
  document.mesh = make_shape(shape, run.progress());
  return document;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  tool::Program program("tm-shape", "[OPTION]... KIND [PARAMETER]...", "Makes a closed mesh");
  program.words(&options.words, "KIND [PARAMETER]...", "what to make");
  program.integer("faces", &options.faces, 1, 1000000000, "number of faces, about (default 10000)");
  program.length("edge", &options.edge, "or mean edge length, about");
  program.length("radius", &options.radius, "sphere, folded, torus, torus-knot, tangle: radius");
  program.length("tube", &options.tube, "torus, torus-knot, tangle: radius of the tube");
  program.length("gap", &options.gap, "two-spheres, tori: between the two", true);
  program.length("neck", &options.neck, "dumbbell: radius of the neck, negative: inverted", true);
  program.integer("count", &options.count, 1, 1000000, "many-spheres, boxes: how many");
  program.length("noise", &options.noise, "smooth noise along the normals");
  program.seed(&options.seed);
  program.point("center", &options.center, "where to put the shape");
  program.text("around", &options.around, "FILE", "sphere: around the box of that mesh");
  return program.source(argc, argv, [&](tool::Run& run) { return make(options, run); });
}
