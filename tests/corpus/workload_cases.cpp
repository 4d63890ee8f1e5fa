// The workloads of tm-shape, in several sizes.
#include "corpus/build.h"
#include "corpus/cases.h"
#include "helpers/shape_options.h"

namespace transformesh::corpus {

void add_workload_cases(Cases& cases) {
  for (const std::string kind :
       {"two-spheres", "folded", "tangle", "dumbbell", "many-spheres", "boxes", "pinch"})
    for (const long faces : {300, 1500, 6000})
      for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        if (kind == "dumbbell" && faces < 1200) continue;  // cannot be made of so few
        cases.push_back(
            {"workload",
             kind + "/" + named("faces", faces) + "/" + named("seed", static_cast<long>(seed)),
             [=] { return test::workload(kind, static_cast<std::size_t>(faces), seed); }});
      }
}

}  // namespace transformesh::corpus
