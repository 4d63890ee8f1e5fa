/// tm-shape: generates closed meshes, for use as sources, targets and test inputs.
#include "frame/run.h"
#include "support/suggestion.h"
#include "transformesh/shapes.h"

namespace {

using namespace transformesh;

struct Options {
  ShapeOptions shape;
  std::optional<Length> edge, radius, tube, gap, neck, noise;
  std::string around, of;
};

// Returns the options of the library without lengths, which resolve_lengths() sets.
ShapeOptions plain_options(const Options& options, tool::Run& run) {
  const std::vector<std::string>& words = run.in().names();
  if (words.empty()) throw UsageError("KIND is missing: give one, for example sphere; see --help");
  ShapeOptions shape = options.shape;
  shape.kind = words[0];
  const std::string nearest = nearest_name(shape.kind, shape_kinds());
  if (nearest != shape.kind) {
    throw UsageError("unknown kind of shape '" + shape.kind +
                     (is_near(shape.kind, nearest) ? "'; did you mean '" + nearest + "'?"
                                                   : "'; list all kinds with --help"));
  }
  shape.parameters.assign(words.begin() + 1, words.end());
  if (!options.around.empty()) shape.around = bounding_box(run.in().read(options.around).mesh);
  if ((shape.kind == "hull") == options.of.empty())
    throw UsageError("hull and --of FILE need each other: FILE holds the mesh or the points");
  if (!options.of.empty()) shape.points = run.in().read(options.of).mesh.positions;
  return shape;
}

// Sets the lengths of the shape. Percentages refer to the bounding box of the mesh of --around.
// Without --around, they refer to the bounding box of the shape, with default values for lengths
// that are not set yet.
void resolve_lengths(ShapeOptions& shape, const Options& options, tool::Run& run) {
  const auto resolve = [&](const std::optional<Length>& length, std::optional<double>& value) {
    if (!length) return;
    if (length->unit == Length::Unit::diagonal)
      run.in().set_basis(shape.around ? diagonal_of(*shape.around) : shape_diagonal(shape));
    value = run.length(*length);
  };
  resolve(options.radius, shape.radius);
  resolve(options.tube, shape.tube);
  resolve(options.gap, shape.gap);
  resolve(options.neck, shape.neck);
  resolve(options.noise, shape.noise);
  resolve(options.edge, shape.edge);
}

void make(const Options& options, tool::Run& run) {
  ShapeOptions shape = plain_options(options, run);
  resolve_lengths(shape, options, run);
  run.document().mesh = make_shape(shape, run.progress());
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  tool::Program program{
      "tm-shape", "[OPTION]... KIND [PARAMETER]...", "Makes a closed mesh", {tool::Reads::words}};
  program.words = {"KIND [PARAMETER]...", "kind of shape, see below"};
  program.words.choices = shape_kinds();
  program.options.integer("faces", &options.shape.faces, 1, 1000000000,
                          "approximate number of faces (default 10000)");
  program.options.length("edge", &options.edge,
                         "approximate mean length of the edges, instead of --faces");
  program.options.length(
      "radius", &options.radius,
      "radius of a sphere, or of the ring of a torus or a knot (default: by KIND)");
  program.options.length("tube", &options.tube,
                         "radius of the tube of a torus or a knot (default: by KIND)");
  program.options.length(
      "gap", &options.gap,
      "distance between two spheres or tori; negative: they overlap (default: by KIND)", true);
  program.options.length(
      "neck", &options.neck,
      "radius of the neck of a dumbbell, from 0.01 to 0.45; negative: the neck is "
      "inverted (default 0.15)",
      true);
  program.options.integer(
      "count", &options.shape.count, 1, 1000000,
      "number of spheres of many-spheres (default 40) or of boxes (default 50)");
  program.options.length("noise", &options.noise,
                         "amplitude of smooth noise along the normals (default 0; folded: 38%)");
  program.options.seed(&options.shape.seed);
  program.options.point("center", &options.shape.center, "position of the shape's origin");
  program.options.text("around", &options.around, "FILE",
                       "make a sphere around the bounding box of the mesh in FILE");
  program.options.text("of", &options.of, "FILE", "mesh or points for hull");
  program.lengths =
      "A LENGTH is 0.02 (output units) or 1% (of the diagonal of the shape's bounding box, or of "
      "the mesh in FILE with --around).";
  program.epilog =
      "Kinds: sphere, dented, ellipsoid A B C, box A B C, cylinder RADIUS HEIGHT,\n"
      "cone RADIUS HEIGHT, hull, torus, genus N, torus-knot P Q, two-spheres, tori,\n"
      "dumbbell, bowl, figure T; intersecting themselves: folded sphere|torus,\n"
      "tangle P Q, many-spheres, boxes, pinch. Every parameter has a default.";
  program.example = "tm-shape torus --faces 2000 > torus.ply";
  return program.run(argc, argv, [&](tool::Run& run) { make(options, run); });
}
