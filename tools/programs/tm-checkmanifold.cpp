/// tm-checkmanifold: whether a mesh is an oriented manifold, and where it is not.
#include "frame/advice.h"
#include "frame/run.h"
#include "geometry/numbers/predicates.h"
#include "support/counted.h"
#include "transformesh/certify.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"
#include "transformesh/manifold.h"

namespace {

using namespace transformesh;

struct Options {
  bool closed = false;
  bool intersections = false;
  std::string certify;
  std::optional<long> winding_level;
  bool pass = false;
};

void report_counts(const Mesh& mesh, const ManifoldReport& found, tool::Run& run) {
  const Components parts = connected_components(mesh);
  run.report("manifold", found.is_manifold());
  run.report("oriented", found.is_oriented());
  run.report("closed", found.is_closed());
  run.report("nonmanifold_edges", found.nonmanifold_edges.size());
  run.report("nonmanifold_vertices", found.nonmanifold_vertices.size());
  run.report("misoriented_edges", found.misoriented_edges.size());
  run.report("collapsed_faces", found.collapsed_faces.size());
  run.report("border_edges", found.border_halfedges.size());
  run.report("touching_borders", found.touching_borders);
  run.report("boundary_loops", found.boundary_loops);
  run.report("degenerate_faces", degenerate_faces(mesh).size());
  run.report("isolated_vertices", found.isolated_vertices.size());
  run.report("components", parts.components.size());
  run.report("genus", parts.genus());
}

std::string describe_intersections(const std::vector<FacePair>& pairs) {
  if (pairs.empty()) return {};
  const bool is_one = pairs.size() == 1;
  return counted(pairs.size(), "pair") +
         (is_one ? " of faces intersects: faces " : " of faces intersect, the first are faces ") +
         std::to_string(pairs[0].first) + " and " + std::to_string(pairs[0].second) +
         "; remove them with tm-clean";
}

std::string describe_degenerate(const std::vector<Index>& faces) {
  if (faces.empty()) return {};
  const bool is_one = faces.size() == 1;
  return counted(faces.size(), "face") +
         (is_one ? " has no area, face " : " have no area, the first is face ") +
         std::to_string(faces[0]);
}

Certificate certify_document(const Document& document, const Mesh& input, const Options& options,
                             tool::Run& run) {
  CertifyOptions library_options;
  library_options.winding_level = static_cast<int>(options.winding_level.value_or(1));
  library_options.coordinate = document.style.coordinate;
  Certificate certificate = certify(input, document.mesh, library_options, run.progress());
  run.report("winding", certificate.input_is_closed ? "tested" : "not tested, the input is open");
  run.report("certified_samples", certificate.samples);
  run.report("undecided_samples", certificate.undecided);
  run.report("undecided_share", certificate.undecided_share());
  run.report("wrong_samples", certificate.wrong);
  if (certificate.input_is_closed) run.report("margin", certificate.margin);
  return certificate;
}

void check(const Document& document, const Options& options, tool::Run& run) {
  const Mesh& mesh = document.mesh;
  const bool certifies = !options.certify.empty();
  if (options.winding_level && !certifies) throw UsageError("--level needs --certify INPUT");
  run.progress()("checking edges and vertices");
  const ManifoldReport found = check_manifold(mesh);
  report_counts(mesh, found, run);
  const auto describe = [&](bool is_closed) {
    return tool::with_advice(manifold_problem(mesh, found, is_closed), run.program());
  };
  std::vector<std::string> problems = {describe(options.closed)};
  if (options.intersections || certifies) {
    const std::vector<FacePair> pairs = find_intersections(mesh, run.progress());
    run.report("intersections", pairs.size());
    problems.push_back(describe_intersections(pairs));
  }
  if (certifies) {
    const Certificate certificate =
        certify_document(document, run.read(options.certify).mesh, options, run);
    problems.push_back(describe(certificate.input_is_closed));
    problems.push_back(describe_degenerate(degenerate_faces(mesh)));
    problems.push_back(certificate.problem);
  }
  std::erase(problems, "");
  if (!problems.empty()) run.report("problem", problems.front());
  if (!problems.empty() && options.pass) {
    run.note(problems.front());
    run.write_nothing();
  }
  run.answer(problems.empty());
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  tool::Program program{"tm-checkmanifold", "[OPTION]... [INPUT]",
                        "Checks that a mesh is an oriented manifold, and reports where it is not",
                        tool::Reads::mesh, tool::Writes::answer};
  program.flag("closed", &options.closed, "a border is a problem too");
  program.flag("intersections", &options.intersections, "faces that intersect are a problem too");
  program.text("certify", &options.certify, "FILE",
               "the mesh is the boundary of winding number >= LEVEL of FILE, by samples");
  program.integer("level", &options.winding_level, 1, 1000000,
                  "the winding level of --certify (default: 1)");
  program.flag("pass", &options.pass,
               "pass the mesh on; on a problem write nothing and exit with 1");
  program.writes_mesh_if = [&] { return options.pass; };
  return program.run(argc, argv, [&](tool::Run& run) { check(run.document(), options, run); });
}
