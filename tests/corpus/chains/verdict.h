/// Compares the promises of the man pages with measured facts about a program's input and output.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "corpus/chains/mesh_facts.h"
#include "corpus/chains/steps.h"

namespace chains {

struct Finding {
  std::string kind;  ///< one word; the summary counts findings by kind
  std::string text;
};

struct Passage {
  const Step& step;
  const TriangleMesh& input;
  const MeshFacts& before;
  const TriangleMesh& output;
  const MeshFacts& after;
  const std::string& report;     ///< report of the program in JSON
  std::optional<double> volume;  ///< correct volume of the output, if it is known
  // coarsest scalar type to which coordinates have been rounded so far
  Type coarsest = Type::float64;
  /// True if tm-clean has united the parts of the input, and no later program may have turned a
  /// component inside out.
  bool was_cleaned = false;
  // the faces at every edge of the body are coplanar or meet at 45 degrees or more
  bool is_flat = false;
};

std::vector<Finding> find_faults(const Passage& passage);

}  // namespace chains
