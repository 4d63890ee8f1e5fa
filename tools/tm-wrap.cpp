/// tm-wrap: a rough closed mesh around points.
#include <algorithm>
#include <optional>
#include <utility>

#include "frame/run.h"
#include "tm/io/streams/streams.h"
#include "tm/step/target_file.h"
#include "tm/support/counted.h"
#include "tm/support/error.h"
#include "tm/views/wrap/unit_scale.h"
#include "tm/views/wrap/wrap.h"

namespace {

using namespace transformesh;

struct Options {
  std::string method = "auto";
  std::optional<Length> alpha;
  Length offset = parse_length("0.33%");
};

Mesh wrap_positions(const std::vector<Vec3>& positions, const Options& options, tool::Run& run) {
  AlphaWrapOptions wrap;
  if (options.alpha) wrap.alpha = run.length(*options.alpha);
  wrap.offset = run.length(options.offset);
  AlphaWrap result = alpha_wrap(positions, wrap);
  run.report("alpha", result.alpha);
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
  const std::string name = input_name(run.input());
  const auto [document, notes] =
      read_mesh_or_points(run.read_bytes(run.input()), name, run.reading());
  const Mesh& cloud = document.mesh;
  run.note_read(notes, true);
  const std::vector<Vec3> normals =
      cloud.faces.empty() ? stored_normals(cloud) : std::vector<Vec3>();
  if (options.method == "poisson" && normals.empty())
    throw InputError(name + ": the points have no normals, which --method poisson needs");
  run.set_basis(diagonal_of(cloud.positions));
  const bool is_poisson = options.method != "alpha" && !normals.empty();
  if (is_poisson) note_without_normal(normals, run);
  run.report("points", cloud.positions.size());
  run.report("method", is_poisson ? "poisson" : "alpha");

  run.progress()("wrap");
  run.document().mesh = is_poisson ? poisson_wrap(cloud.positions, normals)
                                   : wrap_positions(cloud.positions, options, run);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  tool::Program program{"tm-wrap", "[OPTION]... [POINTS]", "Wraps points in a rough closed mesh",
                        tool::Reads::file};
  program.choice("method", &options.method, {"auto", "poisson", "alpha"},
                 "poisson needs normals; auto: poisson where there are normals, else alpha");
  program.length(
      "alpha", &options.alpha,
      "of alpha: radius of the smallest ball that is kept out (default: as small as does "
      "not get in between the points)");
  program.length("offset", &options.offset, "of alpha: how far from the points");
  program.epilog = "POINTS are PLY, OFF or lines of x y z [nx ny nz]; of a mesh, its vertices.";
  return program.run(argc, argv, [&](tool::Run& run) { wrap(options, run); });
}
