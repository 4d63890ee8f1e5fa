/// A chain: a random body, and programs of which each reads the output of the one before.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "corpus/chains/program.h"

namespace chains {

struct ChainOptions {
  std::string bin;     ///< folder of the programs
  std::string folder;  ///< keeps all meshes and commands in this folder; if empty, keeps nothing
  ProgramLimits limits;
};

struct Fault {
  std::string kind;  ///< kind of the finding; "refused" if the program ended with exit code 3 or 4
  std::string pair;  ///< labels of the program before and of the program that failed
  std::string text;
};

struct ChainRecord {
  std::uint64_t seed = 0;
  std::string mode;      ///< option of the runner that repeats this chain
  std::string commands;  ///< commands in the syntax of a shell
  std::vector<std::string> pairs;
  std::vector<Fault> faults;
  int programs = 0;
  bool is_rotated_with_contact = false;
  double cpu_seconds = 0;   ///< sum over all programs
  double most_seconds = 0;  ///< time of the slowest program
};

ChainRecord run_chain(std::uint64_t seed, const ChainOptions& options);

}  // namespace chains
