/// Draws random chains of programs that can be joined by pipes, with options that users would
/// choose.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "corpus/chains/bodies.h"
#include "corpus/chains/mesh_facts.h"
#include "corpus/chains/random.h"

namespace chains {

/// One program of a chain.
struct Step {
  std::string program;  ///< name without "tm-"
  std::vector<std::string> arguments;
  // bytes of the files that arguments name, by file name
  std::map<std::string, std::string> files;
  double volume_factor = 1;  ///< determinant of an affine map, in magnitude
  /// True if area and volume of bodies with flat sides must stay within a thousandth: for tm-remesh
  /// with edges of 2 % that keeps sharp edges.
  bool keeps_measures = false;

  std::string label()
      const;  ///< program with the option that changes its operation, such as "remesh --faces"
  std::string command() const;  ///< the command in the syntax of a shell
};

/// The state of a chain before its next step.
struct Situation {
  const Body& body;
  const TriangleMesh& mesh;
  const MeshFacts& facts;
  const std::string& before_last;  ///< file that the last program read
  const std::string& bytes;        ///< file that the last program wrote
  std::string previous;            ///< label of the last program
  bool is_soup = false;            ///< the mesh was written as STL
  bool is_raw = true;              ///< no program has changed the body yet
  bool is_cut = false;             ///< the cutter is in the mesh already, or no longer fits it
  int steps_left = 1;              ///< including the step to be chosen
};

Step next_step(const Situation& now, Random& random);

}  // namespace chains
