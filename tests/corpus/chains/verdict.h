/// Compares the promises of the man pages with the facts about a program's input and output.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "corpus/chains/mesh_facts.h"
#include "corpus/chains/steps.h"

namespace chains {

struct Finding {
  std::string kind;  ///< one word, by which findings are counted
  std::string text;
};

struct Passage {
  const Step& step;
  const TriangleMesh& input;
  const MeshFacts& before;
  const TriangleMesh& output;
  const MeshFacts& after;
  const std::string& report;      ///< JSON
  std::optional<double> volume;   ///< of the output where it is known
  Type coarsest = Type::float64;  ///< scalar type that coordinates have been rounded to so far
  bool was_cleaned = false;       ///< the input is the union of what it came from
  bool is_flat = false;  ///< all edges of the body turn by 45 degrees or more, or not at all
};

std::vector<Finding> find_faults(const Passage& passage);

}  // namespace chains
