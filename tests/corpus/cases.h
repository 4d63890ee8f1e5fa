/// The inputs that the corpus generates. Every kind of degenerate geometry has its cases, of
/// several sizes and seeds; each is written as doubles and, where floats can hold it, as floats.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mesh/mesh.h"

namespace transformesh::corpus {

/// What tm-clean must do with an input, because of what that input is.
enum class Outcome {
  clean,         ///< a result that is certified
  by_winding,    ///< the same, unless no winding number reaches the winding level: then exit 4
  inside_out,    ///< no winding number reaches the winding level, by construction: exit 4
  not_oriented,  ///< two faces run along an edge the same way: exit 3
};

struct Case {
  std::string kind;  ///< a row of the table
  std::string name;  ///< unique within its kind
  std::function<Mesh()> make;
  Outcome outcome = Outcome::clean;
  int winding_level = 1;
  bool fits_float = true;  ///< in floats it is still what its kind says
  /// Its smallest gap or part, as a share of its largest coordinate. Where only a few numbers lie
  /// in between, many samples of a right result are undecided.
  double feature = 1;
  /// Of the result, where it is known in closed form.
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
