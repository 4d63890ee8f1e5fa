// Cleaning: the result is a manifold without self-intersections, closed if the input is, with the
// correct winding numbers, and cleaning it again changes nothing. Only a mesh that is not oriented
// or encloses nothing may be refused.
#include "transformesh/clean.h"

#include "clean/certify/certify.h"
#include "fuzz/tiny_mesh.h"
#include "geometry/numbers/predicates.h"
#include "mesh/coordinate_spacing.h"
#include "transformesh/intersect.h"
#include "transformesh/manifold.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;
using namespace transformesh::fuzz;

namespace {

CleanOptions clean_options(Choices& choices) {
  CleanOptions options;
  const unsigned choice = choices.byte();
  if (choice & 1) options.coordinate = Scalar::float32;
  if (choice & 2) options.winding_level = 2;
  if (choice & 4) options.outermost = true;
  if (choice & 8) options.method = ExteriorMethod::static_test;
  return options;
}

/// Returns the problem that a certificate reports. Undecided samples are not a problem, because
/// these meshes have many parts that are very close to each other.
std::string wrong_samples(const Mesh& input, const Mesh& output, const CleanOptions& options) {
  if (options.outermost) return {};
  const Certificate certificate =
      certify(input, output, {options.winding_level, options.coordinate, 200});
  return certificate.wrong > 0 ? certificate.problem : std::string();
}

void check_floats(const Mesh& mesh) {
  for (const Vec3& position : mesh.positions)
    demand(position == position.cast<float>().cast<double>(), "a coordinate that is no float");
}

void check_result(const Mesh& input, const CleanResult& result, const CleanOptions& options,
                  bool is_closed) {
  const Mesh& mesh = result.mesh;
  const std::string problem = manifold_problem(mesh, check_manifold(mesh), is_closed).sentence;
  demand(problem.empty(), problem);
  demand(find_intersections(mesh).empty(), "crossings are left");
  demand(!result.changed || degenerate_faces(mesh).empty(), "faces without area are left");
  if (options.coordinate == Scalar::float32) check_floats(mesh);
  const std::string wrong = wrong_samples(input, mesh, options);
  demand(wrong.empty(), wrong);
}

void check_again(const Mesh& mesh, CleanOptions options) {
  options.winding_level = 1;
  demand(!clean(mesh, options).changed, "what is clean is changed");
}

void check_refusal(const Mesh& input, const std::string& message, const CleanOptions& options,
                   bool is_closed) {
  demand(message.find("rounding leaves") == std::string::npos, message);
  if (!is_closed) return;
  const std::string wrong = wrong_samples(input, Mesh(), options);
  demand(wrong.empty(), message + ", but " + wrong);
}

}  // namespace

void transformesh::fuzz::run_target(std::string_view bytes) {
  Choices choices(bytes);
  const CleanOptions options = clean_options(choices);
  Mesh mesh = tiny_mesh(choices);
  if (mesh.faces.empty()) return;
  const bool is_closed = is_closed_by_position(mesh);
  try {
    round_positions(mesh, options.coordinate);
  } catch (const GoalError&) {
    return;  // floats are too coarse for this mesh
  }
  try {
    const CleanResult result = clean(mesh, options);
    check_result(mesh, result, options, is_closed);
    if (is_closed) check_again(result.mesh, options);
  } catch (const GoalError& error) {
    check_refusal(mesh, error.what(), options, is_closed);
  } catch (const InputError& error) {
    demand(!is_closed, error.what());
  } catch (const UsageError& error) {
    demand(options.method == ExteriorMethod::static_test && !is_closed, error.what());
  }
}
