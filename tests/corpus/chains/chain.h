/// One chain: a random body, and programs that take it one after the other.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "corpus/chains/program.h"

namespace chains {

struct ChainOptions {
  std::string bin;     ///< folder of the programs
  std::string folder;  ///< keeps every mesh and the commands there; empty: keeps nothing
  ProgramLimits limits;
};

struct Fault {
  std::string kind;  ///< "refused" if the program ended with exit code 3 or 4
  std::string pair;  ///< the program and the one before it
  std::string text;
};

struct ChainRecord {
  std::uint64_t seed = 0;
  std::string mode;      ///< option of the runner that repeats this chain
  std::string commands;  ///< as a shell takes them
  std::vector<std::string> pairs;
  std::vector<Fault> faults;
  int programs = 0;
  bool is_rotated_with_contact = false;
  double cpu_seconds = 0;   ///< of the programs
  double most_seconds = 0;  ///< of one program
};

ChainRecord run_chain(std::uint64_t seed, const ChainOptions& options);

}  // namespace chains
