// The workloads of tm-shape in several sizes, and rotated. Rotation and rounding move coplanar
// faces and common points slightly apart, in many places at once.
#include "corpus/build.h"
#include "corpus/cases.h"
#include "helpers/shape_options.h"

namespace transformesh::corpus {
namespace {

void add_turned(Cases& cases, const std::string& kind, long faces, long seed) {
  const double angle = 0.1 + 0.37 * static_cast<double>(seed);
  cases.push_back({"turned", kind + "/" + named("faces", faces) + "/" + named("seed", seed), [=] {
                     const auto count = static_cast<std::size_t>(faces);
                     return turned(test::workload(kind, count, static_cast<std::uint64_t>(seed)),
                                   angle);
                   }});
}

}  // namespace

void add_workload_cases(Cases& cases) {
  for (const std::string kind :
       {"two-spheres", "folded", "tangle", "dumbbell", "many-spheres", "boxes", "pinch"})
    for (const long faces : {300, 1500, 6000})
      for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        if (kind == "dumbbell" && faces < 1200) continue;  // these shapes need more faces
        cases.push_back(
            {"workload",
             kind + "/" + named("faces", faces) + "/" + named("seed", static_cast<long>(seed)),
             [=] { return test::workload(kind, static_cast<std::size_t>(faces), seed); }});
      }
  for (long seed = 1; seed <= 6; ++seed) {
    for (const long faces : {300, 800}) add_turned(cases, "boxes", faces, seed);
    for (const std::string kind : {"pinch", "tangle"}) add_turned(cases, kind, 800, seed);
  }
  add_turned(cases, "boxes", 2500, 1);
}

}  // namespace transformesh::corpus
