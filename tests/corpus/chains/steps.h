/// Random walks over what a pipe can join: the programs that may follow a mesh, with options that
/// users give them.
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
  std::string program;  ///< without "tm-"
  std::vector<std::string> arguments;
  std::map<std::string, std::string> files;  ///< name and bytes of the files that arguments name
  double volume_factor = 1;                  ///< of an affine map: the magnitude of its determinant
  /// True if area and volume of flat bodies must stay within a thousandth: tm-remesh with edges of
  /// 2 % that keeps sharp edges.
  bool keeps_measures = false;

  std::string label()
      const;  ///< program with the option that makes it another one: "remesh --faces"
  std::string command() const;  ///< as a shell takes it
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
  bool is_cut = false;             ///< the cutter is in the mesh already
  int steps_left = 1;              ///< with the one to be chosen
};

Step next_step(const Situation& now, Random& random);

}  // namespace chains
