/// tm-checkmanifold: tests whether a mesh is an oriented manifold, and states where it has defects.
#include "frame/advice.h"
#include "frame/run.h"
#include "repair/crack_tolerance.h"
#include "support/number.h"
#include "transformesh/check_mesh.h"
#include "transformesh/errors.h"

namespace {

using namespace transformesh;

struct Options {
  CheckMeshOptions check;
  std::string certify;
  std::optional<long> winding_level;
  bool pass = false;
};

/// Returns the sentence of a problem with its remedy. If the mesh has cracks, the remedy is to join
/// their sides, because filling would close cracks with patches.
std::string with_remedy(const Problem& problem, const Mesh& mesh, const tool::Run& run) {
  const Cracks cracks = problem.kind == ErrorKind::not_closed ? find_cracks(mesh) : Cracks();
  if (!(cracks.tolerance > 0)) return tool::with_advice(problem, run.program());
  return problem.sentence + "; borders nearly meet along cracks of up to " +
         significant(cracks.width, 3) + ": tm-stitch --tolerance " +
         significant(cracks.tolerance, 3) + " joins them";
}

void check(const Document& document, Options& options, tool::Run& run) {
  if (options.winding_level && options.certify.empty())
    throw UsageError("--level needs --certify INPUT");
  Mesh input;
  if (!options.certify.empty()) {
    input = run.in().read(options.certify).mesh;
    options.check.certified = &input;
    options.check.winding_level = static_cast<int>(options.winding_level.value_or(1));
  }
  options.check.coordinate = document.style.coordinate;
  const MeshCheck found = check_mesh(document.mesh, options.check, run.progress());
  run.report(entries_of(found));
  run.answer(found.problems.empty());
  if (found.problems.empty()) return;
  const std::string problem = with_remedy(found.problems.front(), document.mesh, run);
  run.report("problem", problem);
  if (!options.pass) return;
  run.note(problem);
  run.out().write_nothing();
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  tool::Program program{"tm-checkmanifold",
                        "[OPTION]... [INPUT]",
                        "Checks that a mesh is an oriented manifold, and reports where it is not",
                        {tool::Reads::mesh},
                        {tool::Writes::answer}};
  program.options.flag("closed", &options.check.closed, "count borders as problems");
  program.options.flag("intersections", &options.check.intersections,
                       "count intersecting faces as problems");
  program.options.text("certify", &options.certify, "FILE",
                       "check by samples that the mesh is the boundary of the points with winding "
                       "number >= N in FILE, where --level sets N");
  program.options.integer("level", &options.winding_level, 1, 1000000,
                          "winding level of --certify (default 1)");
  program.options.flag(
      "pass", &options.pass,
      "write the mesh instead of the report; if there is a problem, write nothing and exit with 1");
  program.output.is_mesh = [&] { return options.pass; };
  program.example = "tm-checkmanifold --closed --intersections mesh.ply";
  return program.run(argc, argv, [&](tool::Run& run) { check(run.document(), options, run); });
}
