/// Runs the pipelines of README.md and docs/recipes.md on random bodies instead of the shapes
/// there.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "corpus/chains/chain.h"

namespace chains {

/// Returns the commands as README.md and docs/recipes.md print them.
std::vector<std::string> readme_commands();

/// Runs all commands on the body of this seed, and judges every mesh that they write.
ChainRecord run_readme(std::uint64_t seed, const ChainOptions& options);

}  // namespace chains
