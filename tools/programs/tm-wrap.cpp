/// tm-wrap: makes a rough closed mesh around points.
#include <algorithm>
#include <optional>
#include <utility>

#include "frame/run.h"
#include "io/streams/streams.h"
#include "options/wrap_points.h"
#include "support/counted.h"
#include "transformesh/errors.h"
#include "transformesh/wrap.h"
#include "views/wrap/scale_normalization.h"

namespace {

using namespace transformesh;

struct Options {
  std::string method = "auto";
  std::optional<Length> alpha;
  std::optional<Length> offset;
  bool keep_outliers = false;
};

/// Returns 0, which stands for the library's default, if the option is not given.
double size_of(const std::optional<Length>& length, const std::string& option, tool::Run& run) {
  if (!length) return 0;
  const double size = run.length(*length);
  if (size == 0) throw UsageError(option + " must be above 0");
  return size;
}

Mesh wrap_positions(const std::vector<Vec3>& positions, const Options& options, tool::Run& run) {
  AlphaWrap result = alpha_wrap(positions, {size_of(options.alpha, "--alpha", run),
                                            size_of(options.offset, "--offset", run)});
  run.report("alpha", result.alpha);
  run.report("offset", result.offset);
  run.report("least_distance", result.least_distance);
  return std::move(result.mesh);
}

void note_without_normal(const std::vector<Vec3>& normals, tool::Run& run) {
  const auto count = std::count(normals.begin(), normals.end(), Vec3(Vec3::Zero()));
  if (count > 0)
    run.note(counted(static_cast<std::size_t>(count), "point") + " without a normal left out");
  run.report("points_without_normal", static_cast<std::size_t>(count));
}

void wrap(const Options& options, tool::Run& run) {
  run.progress()("read");
  const std::string& path = run.in().name();
  const std::string name = input_name(path);
  const Mesh cloud = tool::read_cloud(path, name, run);
  run.report("points", cloud.positions.size());
  const auto [positions, normals] = tool::points_of(cloud, options.keep_outliers, run);
  if (options.method == "poisson" && normals.empty())
    throw InputError(name + ": the points have no normals, which --method poisson needs");
  run.in().set_basis(diagonal_of(positions));
  const bool is_poisson = options.method != "alpha" && !normals.empty();
  if (is_poisson && (options.alpha || options.offset))
    throw UsageError(
        "the method for these points is poisson, and --alpha and --offset need --method alpha");
  if (is_poisson) note_without_normal(normals, run);
  run.report("method", is_poisson ? "poisson" : "alpha");

  run.progress()("wrap");
  run.document().mesh =
      is_poisson ? poisson_wrap(positions, normals) : wrap_positions(positions, options, run);
  tool::note_absurd(run.document().mesh, positions.size(), run);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  tool::Program program{"tm-wrap",
                        "[OPTION]... [POINTS]",
                        "Makes a rough closed mesh around points",
                        {tool::Reads::file}};
  program.options.choice(
      "method", &options.method, {"auto", "poisson", "alpha"},
      "poisson needs normals; auto: poisson if the points have normals, else alpha");
  program.options.length("alpha", &options.alpha,
                         "for alpha: radius of the smallest ball that stays outside (default: the "
                         "smallest for which the wrap is not hollow)");
  program.options.length("offset", &options.offset,
                         "for alpha: distance of the vertices from the points (default: an eighth "
                         "of the points' spacing, at most 0.33%)");
  program.options.flag("keep-outliers", &options.keep_outliers,
                       "also wrap outliers, and points with large errors or short tracks");
  program.epilog =
      "POINTS is a PLY or OFF file, COLMAP's points3D, or a text with lines\n"
      "x y z [nx ny nz]. If the file holds a mesh, the vertices are used.";
  program.example = "tm-sample --distance 2% mesh.ply | tm-wrap > wrapped.ply";
  return program.run(argc, argv, [&](tool::Run& run) { wrap(options, run); });
}
