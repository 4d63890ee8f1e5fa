/// tm-wrap: makes a rough closed mesh around points.
#include <algorithm>
#include <optional>
#include <utility>

#include "frame/run.h"
#include "io/streams/streams.h"
#include "mesh/location_text.h"
#include "step/prepare_target.h"
#include "support/counted.h"
#include "transformesh/errors.h"
#include "transformesh/wrap.h"
#include "views/wrap/outliers.h"
#include "views/wrap/scale_normalization.h"

namespace {

using namespace transformesh;

struct Options {
  std::string method = "auto";
  std::optional<Length> alpha;
  Length offset = parse_length("0.33%");
  bool keep_outliers = false;
};

struct Points {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;  ///< normals of all points, or empty
};

/// Returns the points without outliers. Vertices of a mesh are all kept.
Points without_outliers(const Mesh& cloud, const std::vector<Vec3>& normals, const Options& options,
                        tool::Run& run) {
  std::vector<Index> outliers;
  if (cloud.faces.empty() && !options.keep_outliers) outliers = find_outliers(cloud.positions);
  run.report("outliers", outliers.size());
  if (outliers.empty()) return {cloud.positions, normals};
  run.note(counted(outliers.size(), "outlier") + " left out, the first at " +
           point_text(cloud.positions[outliers[0]]) + "; --keep-outliers wraps all points");
  Points points;
  for (Index i = 0; i < cloud.positions.size(); ++i) {
    if (std::ranges::binary_search(outliers, i)) continue;
    points.positions.push_back(cloud.positions[i]);
    if (!normals.empty()) points.normals.push_back(normals[i]);
  }
  return points;
}

Mesh wrap_positions(const std::vector<Vec3>& positions, const Options& options, tool::Run& run) {
  AlphaWrapOptions wrap;
  if (options.alpha) wrap.alpha = run.length(*options.alpha);
  wrap.offset = run.length(options.offset);
  AlphaWrap result = alpha_wrap(positions, wrap);
  run.report("alpha", result.alpha);
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
  const ReadResult read = read_mesh(run.in().read_bytes(path), name, run.in().reading(path));
  const Mesh& cloud = read.document.mesh;
  run.say().note_all(read.notes);
  run.report("points", cloud.positions.size());
  const auto [positions, normals] = without_outliers(
      cloud, cloud.faces.empty() ? stored_normals(cloud) : std::vector<Vec3>(), options, run);
  if (options.method == "poisson" && normals.empty())
    throw InputError(name + ": the points have no normals, which --method poisson needs");
  run.in().set_basis(diagonal_of(positions));
  const bool is_poisson = options.method != "alpha" && !normals.empty();
  if (is_poisson) note_without_normal(normals, run);
  run.report("method", is_poisson ? "poisson" : "alpha");

  run.progress()("wrap");
  run.document().mesh =
      is_poisson ? poisson_wrap(positions, normals) : wrap_positions(positions, options, run);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  tool::Program program{"tm-wrap",
                        "[OPTION]... [POINTS]",
                        "Wraps points in a rough closed mesh",
                        {tool::Reads::file}};
  program.options.choice(
      "method", &options.method, {"auto", "poisson", "alpha"},
      "poisson needs normals; auto: poisson where there are normals, else alpha");
  program.options.length(
      "alpha", &options.alpha,
      "of alpha: radius of the smallest ball that is kept out (default: as small as does "
      "not get in between the points)");
  program.options.length("offset", &options.offset,
                         "of alpha: how far from the points vertices are");
  program.options.flag("keep-outliers", &options.keep_outliers,
                       "wrap points that are far from all others, too");
  program.epilog = "POINTS are PLY, OFF or lines of x y z [nx ny nz]; of a mesh, its vertices.";
  program.example = "tm-sample --distance 2% mesh.ply | tm-wrap > wrapped.ply";
  return program.run(argc, argv, [&](tool::Run& run) { wrap(options, run); });
}
