#include "corpus/chains/readme.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "corpus/chains/bodies.h"
#include "corpus/chains/mesh_facts.h"
#include "corpus/chains/work_folder.h"

namespace chains {
namespace {

struct Pipeline {
  std::string preparation;  ///< script that makes the meshes that the command needs from the body
  std::string command;      ///< the command as printed; if empty, only the preparation is run
  std::string output;
};

/// `solids.ply` holds the parts of a body, and `b.ply` a convex part that overlaps it.
const std::vector<Pipeline> pipelines = {
    {"tm-clean solids.ply > a.ply", "", "a.ply"},
    {"", "tm-boolean union a.ply b.ply > union.ply", "union.ply"},
    {"", "tm-boolean intersection a.ply b.ply > intersection.ply", "intersection.ply"},
    {"", "tm-boolean difference a.ply b.ply > difference.ply", "difference.ply"},
    {"", "tm-morph-step --target b.ply < a.ply | tm-clean | tm-remesh > next.ply", "next.ply"},
    {"cp union.ply body.ply", "tm-offset --distance 2% body.ply > thicker.ply", "thicker.ply"},
    {"tm-remesh --reference-edge 2% difference.ply > scan.ply", "", "scan.ply"},
    {"", "tm-remesh --only smooth --smooth 0.3 --iterations 5 scan.ply > smooth.ply", "smooth.ply"},
    {"", "tm-remesh --faces 5000 scan.ply > light.ply", "light.ply"},
    {"tm-remesh --reference-edge 4% difference.ply > body.ply", "", "body.ply"},
    {"", "tm-displace --normal-speed -0.12x body.ply | tm-clean | tm-remesh -o body.ply",
     "body.ply"},
    {"", "tm-displace --normal-speed -0.12x body.ply | tm-clean | tm-remesh -o body.ply",
     "body.ply"},
    {"tm-remesh --reference-edge 6% union.ply > target.ply; "
     "tm-shape sphere --around target.ply --faces 1000 -o source.ply; "
     "edge=$(tm-info --get edge_mean target.ply)",
     "tm-morph source.ply --target target.ply --reference-edge $edge -o result.ply --csv log.csv",
     "result.ply"},
    {"edge=$(tm-info --get edge_mean target.ply)",
     "tm-clean --outermost --reference-edge $edge -o now.ply source.ply", "now.ply"},
    {"",
     "tm-morph-step --target target.ply now.ply | tm-clean --outermost | "
     "tm-remesh --smooth 0.1 --feature-angle 180 -o now.ply",
     "now.ply"},
    {"tm-convert --format ply-ascii target.ply | awk '/^element vertex/ { n = $3 } "
     "/^element face/ { print \"property double vx\\nproperty double vy\\nproperty double vz\" } "
     "inside && n-- > 0 { print $0, -$2 * $3, $1 * $3, 0; next } /^end_header/ { inside = 1 } "
     "{ print }' > twist.ply",
     "tm-displace --time-step 0.1 --alpha 2 twist.ply | tm-clean | tm-remesh > twisted.ply",
     "twisted.ply"},
    {"cp target.ply box.ply",
     "tm-evolve box.ply -o round.ply --iterations 20 --step 'tm-displace --curvature-speed 0.001'",
     "round.ply"},
    {"tm-convert -o scan.stl solids.ply", "tm-repair scan.stl | tm-remesh > repaired.ply",
     "repaired.ply"},
};

/// Returns a convex body whose center is a corner of the other one, so that they overlap.
TriangleMesh second_operand(const TriangleMesh& first, Random& random) {
  Body body = random_body(random);
  while (!body.is_single_solid) body = random_body(random);
  TriangleMesh& mesh = body.solids;
  const double scale = 0.6 * diagonal(first) / diagonal(mesh);
  Point from{};
  for (const Point& p : mesh.points)
    for (std::size_t k = 0; k < 3; ++k) from[k] += p[k] / static_cast<double>(mesh.points.size());
  const Point to = random.pick(first.points);
  for (Point& p : mesh.points)
    for (std::size_t k = 0; k < 3; ++k) p[k] = to[k] + scale * (p[k] - from[k]);
  mesh.type = Type::float64;
  return mesh;
}

/// Returns a body without a cutter, of about unit size at the origin, so that lengths in the
/// recipes fit it.
TriangleMesh first_operand(Random& random, bool& is_rotated_with_contact) {
  Body body = random_body(random);
  while (body.is_single_solid) body = random_body(random);
  is_rotated_with_contact = body.is_rotated && body.has_coplanar_contact;
  const double scale = 2 / diagonal(body.solids);
  const Point from = body.solids.points.front();
  for (Point& p : body.solids.points)
    for (std::size_t k = 0; k < 3; ++k) p[k] = scale * (p[k] - from[k]);
  body.solids.type = Type::float64;
  return body.solids;
}

class ReadmeRun {
 public:
  ReadmeRun(std::uint64_t seed, const ChainOptions& options)
      : options_(options), folder_(options.folder), random_(seed) {
    record_.seed = seed;
    record_.mode = "--pipelines ";
    const TriangleMesh solids = first_operand(random_, record_.is_rotated_with_contact);
    folder_.write("solids.ply", write_ply(solids));
    folder_.write("b.ply", write_ply(second_operand(solids, random_)));
  }

  ChainRecord run() {
    for (const Pipeline& pipeline : pipelines)
      if (!run(pipeline)) break;
    check_volumes();
    return record_;
  }

 private:
  void note(const std::string& kind, const std::string& text) {
    record_.faults.push_back({kind, record_.pairs.back(), text});
  }

  bool run(const Pipeline& pipeline) {
    record_.pairs.push_back(pipeline.command.empty() ? pipeline.preparation : pipeline.command);
    record_.programs += static_cast<int>(
        std::count(record_.pairs.back().begin(), record_.pairs.back().end(), '|') + 1);
    const std::string script = "cd '" + (folder_ / "") + "'; " + pipeline.preparation +
                               (pipeline.preparation.empty() ? "" : "\n") + pipeline.command;
    const ProgramResult result =
        run_program("/bin/bash", {"-euo", "pipefail", "-c", script}, {}, options_.limits);
    record_.cpu_seconds += result.cpu_seconds;
    record_.most_seconds = std::max(record_.most_seconds, result.cpu_seconds);
    if (result.exit_code != 0) {
      const bool is_refusal = result.exit_code == 3 || result.exit_code == 4;
      note(result.is_hung ? "hang"
           : is_refusal   ? "refused"
                          : "crash",
           "exit code " + std::to_string(result.exit_code) + ": " + in_one_line(result.messages));
      return false;
    }
    return judge_output(pipeline.output);
  }

  bool judge_output(const std::string& name) {
    const MeshFacts facts = judge(read_mesh(folder_.read(name)));
    facts_[name] = facts;
    const std::size_t before = record_.faults.size();
    if (!facts.is_valid()) note("index", name);
    if (facts.intersections > 0)
      note("intersects", name + ": " + std::to_string(facts.intersections) + " pairs");
    if (facts.no_area > 0) note("no-area", name + ": " + std::to_string(facts.no_area) + " faces");
    if (!facts.is_manifold()) note("not-manifold", name);
    if (!facts.is_closed()) note("open", name);
    if (facts.faces == 0 || facts.volume <= 0) note("volume", name + " encloses nothing");
    return record_.faults.size() == before;
  }

  /// Checks that volumes of union, intersection and difference add up.
  void check_volumes() {
    if (!facts_.contains("difference.ply")) return;
    const double a = facts_["a.ply"].volume;
    const double b = judge(read_mesh(folder_.read("b.ply"))).volume;
    const double united = facts_["union.ply"].volume, common = facts_["intersection.ply"].volume;
    const double differs = std::max(std::abs(a + b - united - common),
                                    std::abs(a - common - facts_["difference.ply"].volume));
    if (differs > 1e-9 * (a + b)) note("volume", "the volumes do not add up");
  }

  const ChainOptions& options_;
  WorkFolder folder_;
  Random random_;
  ChainRecord record_;
  std::map<std::string, MeshFacts> facts_;
};

}  // namespace

std::vector<std::string> readme_commands() {
  std::vector<std::string> commands;
  for (const Pipeline& pipeline : pipelines)
    if (!pipeline.command.empty()) commands.push_back(pipeline.command);
  return commands;
}

ChainRecord run_readme(std::uint64_t seed, const ChainOptions& options) {
  return ReadmeRun(seed, options).run();
}

}  // namespace chains
