/// The inputs that the corpus generates. Every kind of degenerate geometry has cases of several
/// sizes and seeds. Each is written as doubles and, if floats can hold it, as floats.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh::corpus {

/// The required outcome of tm-clean for an input.
enum class Outcome {
  clean,         ///< a certified result
  by_winding,    ///< a certified result, or exit 4 if no winding number reaches the winding level
  inside_out,    ///< exit 4: by construction no winding number reaches the winding level
  not_oriented,  ///< exit 3: two faces traverse an edge in the same direction
};

struct Case {
  std::string kind;  ///< a row of the printed table
  std::string name;  ///< unique within its kind
  std::function<Mesh()> make;
  Outcome outcome = Outcome::clean;
  int winding_level = 1;
  bool fits_float = true;  ///< the mesh still has the property of its kind after rounding to float
  /// Smallest gap or part as a fraction of the largest coordinate. If only a few numbers lie in
  /// between, many samples of a correct result are undecided.
  double feature = 1;
  /// Volume of the correct result, if it is known in closed form.
  std::optional<double> volume{};
};

using Cases = std::vector<Case>;

void add_coplanar_cases(Cases& cases);
void add_contact_cases(Cases& cases);
void add_degenerate_cases(Cases& cases);
void add_nesting_cases(Cases& cases);
void add_coordinate_cases(Cases& cases);
void add_random_cases(Cases& cases);
void add_open_cases(Cases& cases);
void add_wall_cases(Cases& cases);
void add_workload_cases(Cases& cases);

}  // namespace transformesh::corpus
