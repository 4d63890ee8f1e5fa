/// tm-displace: one explicit step of an evolution with any velocity.
#include <optional>

#include "frame/column_notes.h"
#include "frame/displacement_report.h"
#include "frame/keep_out_option.h"
#include "frame/run.h"
#include "transformesh/displace.h"
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

VelocityOptions velocity_of(const Options& options, tool::Run& run) {
  VelocityOptions velocity;
  if (options.normal_speed) velocity.normal_speed = run.length(*options.normal_speed);
  velocity.curvature_speed = options.curvature_speed;
  velocity.mask = options.mask;
  return velocity;
}

void move(Document& document, Options& options, tool::Run& run) {
  Mesh& mesh = document.mesh;
  const std::vector<Vec3> velocities = velocities_of(mesh, velocity_of(options, run));
  options.displace.keep_out = options.keep_out.options(run);
  options.displace.coordinate = document.style.coordinate;
  run.progress()("displace");
  const DisplaceResult result = displace(mesh, velocities, options.displace);
  tool::note_new_normals(result.new_normals, run);
  run.report(entries_of(result));
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
  program.options.length(
      "normal-speed", &options.normal_speed,
      "speed along the vertex normals, as LENGTH per unit of time, added to vx vy vz "
      "if the mesh has them; negative: inwards (default 0)",
      true);
  program.options.number("curvature-speed", &options.curvature_speed, -1e300, 1e300,
                         "factor of a mean-curvature flow, which is also added; a sphere of radius "
                         "R shrinks with speed NUMBER / R");
  program.options.number("time-step", &options.displace.time_step, -1e300, 1e300,
                         "time by which velocities are multiplied");
  program.options.number(
      "alpha", &options.displace.alpha, 0, 1e300,
      "largest movement of a vertex, as a fraction of the mean length of its edges");
  program.options.text("mask", &options.mask, "COLUMN",
                       "multiply velocities by this vertex property; 0 fixes a vertex");
  options.keep_out.declare(program);
  program.epilog =
      "Velocities are the vertex properties vx vy vz. Any program can write them:\n"
      "  my-velocities < a.ply | tm-displace | tm-clean | tm-remesh > b.ply";
  program.example = "tm-displace --normal-speed 0.01 mesh.ply | tm-clean | tm-remesh > next.ply";
  return program.run(argc, argv, [&](tool::Run& run) { move(run.document(), options, run); });
}
