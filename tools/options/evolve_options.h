/// Options of tm-evolve, and their conversion to options of the library.
#pragma once

#include <optional>
#include <string>

#include "frame/loop_options.h"
#include "frame/run.h"
#include "options/time_options.h"
#include "transformesh/evolve.h"

namespace transformesh::tool {

struct EvolveChoices {
  std::string step;
  std::string until;
  std::string smooth;
  bool keep_cavities = false;
  DisplaceOptions displace;
  IterationOptions iteration;
  bool curved = false;
  std::optional<Length> adaptive, min_film, pinch;
  TimeChoices time;
  LoopChoices loop;

  bool is_in_time() const { return time.end > 0; }
};

void declare_evolve(Program& program, EvolveChoices& choices);

/// Throws UsageError if options of the two kinds of evolution, with and without --time, are mixed.
void check_evolve(const EvolveChoices& choices, const Program& program);

/// Returns the options of evolve(), with lengths resolved for the mesh of the run.
EvolveOptions evolution_of(const EvolveChoices& choices, Run& run);

}  // namespace transformesh::tool
