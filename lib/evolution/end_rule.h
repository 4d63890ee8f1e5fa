/// Evaluates the rule that ends an evolution (UntilRule in evolve.h) after each iteration.
#pragma once

#include "evolution/loop/stop_rules.h"
#include "transformesh/evolve.h"

namespace transformesh {

class EndRule {
 public:
  explicit EndRule(const UntilRule& rule) : rule_(rule) {}

  /// Returns whether the evolution ends after this iteration.
  bool add(const IterationResult& last) {
    const auto components = static_cast<long>(last.topology.components);
    if (rule_.components && *rule_.components == components) return true;
    if (rule_.genus && *rule_.genus == last.topology.genus) return true;
    if (rule_.is_stalled)
      return stalled_.add(last.displaced.rms_displacement) || last.displaced.moved == 0;
    return last.displaced.max_displacement < rule_.least_movement;
  }
  void remember(LoopState& loop_state) { stalled_.remember(loop_state); }

 private:
  UntilRule rule_;
  StalledRule stalled_;
};

}  // namespace transformesh
