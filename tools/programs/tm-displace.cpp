/// tm-displace: one explicit step of an evolution with any velocity.
#include <optional>

#include "frame/displacement_report.h"
#include "frame/keep_out_option.h"
#include "frame/run.h"
#include "mesh/touching_borders.h"
#include "transformesh/displace.h"
#include "transformesh/errors.h"
#include "transformesh/velocity.h"

namespace {

using namespace transformesh;

struct Options {
  DisplaceOptions displace;
  std::optional<Length> normal_speed;
  double curvature_speed = 0;
  std::string mask;
  tool::KeepOutOption keep_out;
};

void add(std::vector<Vec3>& velocities, const std::vector<Vec3>& more) {
  for (std::size_t v = 0; v < velocities.size(); ++v) velocities[v] += more[v];
}

std::vector<Vec3> velocities_of(const Mesh& mesh, const Options& options, tool::Run& run) {
  const bool has_speed = options.normal_speed || options.curvature_speed != 0;
  if (!has_speed && !has_column_velocities(mesh)) {
    throw InputError(
        "the mesh lacks a velocity, the vertex properties vx vy vz; give --normal-speed or "
        "--curvature-speed instead");
  }
  if (has_speed) refuse_touching_borders(mesh);
  std::vector<Vec3> velocities(mesh.positions.size(), Vec3::Zero());
  if (!has_speed || has_column_velocities(mesh)) add(velocities, column_velocities(mesh));
  if (options.normal_speed)
    add(velocities, normal_velocities(mesh, run.length(*options.normal_speed)));
  if (options.curvature_speed != 0)
    add(velocities, curvature_velocities(mesh, options.curvature_speed));
  return velocities;
}

void move(Document& document, Options& options, tool::Run& run) {
  Mesh& mesh = document.mesh;
  std::vector<Vec3> velocities = velocities_of(mesh, options, run);
  if (!options.mask.empty()) apply_mask(mesh, options.mask, velocities);
  options.displace.keep_out = options.keep_out.options(run);
  options.displace.coordinate = document.style.coordinate;
  run.progress()("displace");
  const DisplaceResult result = displace(mesh, velocities, options.displace);
  report_displacement(result, run);
  run.report("held_back", result.held_back);
  options.keep_out.note_near(result.near_keep_out, run);
  note_clamped(result, options.displace.alpha, "use a smaller --time-step, or a larger --alpha",
               run);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  tool::Program program{"tm-displace", "[OPTION]... [INPUT]",
                        "Moves vertices by their velocities, one explicit step"};
  program.length("normal-speed", &options.normal_speed,
                 "speed along the vertex normals, added to vx vy vz where the mesh has them", true);
  program.number("curvature-speed", &options.curvature_speed, -1e300, 1e300,
                 "mean-curvature flow: speed times the mean curvature, added likewise; a sphere of "
                 "radius R shrinks by SPEED / R");
  program.number("time-step", &options.displace.time_step, -1e300, 1e300,
                 "time by which velocities are multiplied");
  program.number("alpha", &options.displace.alpha, 0, 1e300,
                 "clamp on the movement, as a fraction of the mean edge at the vertex");
  program.text("mask", &options.mask, "COLUMN",
               "multiply velocities by this vertex property; 0 holds a vertex fast");
  options.keep_out.declare(program);
  program.epilog =
      "Velocities are the vertex properties vx vy vz. Any program may compute them:\n"
      "  my-velocities < a.ply | tm-displace | tm-clean | tm-remesh > b.ply";
  return program.run(argc, argv, [&](tool::Run& run) { move(run.document(), options, run); });
}
