/// tm-sample: samples points on a surface.
#include "frame/run.h"
#include "transformesh/errors.h"
#include "transformesh/sample.h"

namespace {

using namespace transformesh;

struct Choices {
  std::optional<Length> distance;
  SampleOptions sample;
};

void sample(Document& document, const Choices& choices, tool::Run& run) {
  SampleOptions options = choices.sample;
  if ((options.count > 0) == choices.distance.has_value())
    throw UsageError(
        "give either --count, the number of points, or --distance, the smallest distance between "
        "two of them");
  if (choices.distance) {
    options.distance = run.length(*choices.distance);
    if (!(options.distance > 0)) throw UsageError("--distance must be above 0");
  }
  document.mesh = sample_surface(document.mesh, options, run.progress());
  run.report("points", document.mesh.positions.size());

  // The output is a point cloud with normals. The default format is that of the input, but PLY
  // instead of OFF. OFF is written only if an option or the file name requests it.
  document.other_elements.clear();
  document.style.element_order = {"vertex"};
  if (document.style.format == Format::off) document.style.format = Format::ply_little;
}

}  // namespace

int main(int argc, char** argv) {
  Choices choices;
  tool::Program program{"tm-sample", "[OPTION]... --count N|--distance LENGTH [INPUT]",
                        "Samples points with normals on a surface"};
  program.options
      .integer("count", &choices.sample.count, 0, 100000000, "number of points, uniform by area")
      .default_text.clear();
  program.options.length(
      "distance", &choices.distance,
      "smallest distance between two points of a Poisson-disk sampling, instead of --count");
  program.options.seed(&choices.sample.seed);
  program.example = "tm-sample --count 1000 mesh.ply > points.ply";
  return program.run(argc, argv, [&](tool::Run& run) { sample(run.document(), choices, run); });
}
