/// The pipelines of the README on random bodies instead of its own shapes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "corpus/chains/chain.h"

namespace chains {

/// The commands as the README prints them.
std::vector<std::string> readme_commands();

/// Runs all of them on the body of this seed; every mesh that they write is judged.
ChainRecord run_readme(std::uint64_t seed, const ChainOptions& options);

}  // namespace chains
