/// Variants of the functions in evolve.h, evolve_in_time.h, morph.h and track.h that record the run
/// in a Record that the caller has opened. LoopOptions::record is ignored.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "evolution/loop/record.h"
#include "transformesh/evolve_in_time.h"
#include "transformesh/morph.h"

namespace transformesh {

EvolveResult evolve(Document& document, const Step& step, const EvolveOptions& options,
                    const LoopOptions& loop, Record& record, const Progress& progress = Progress());

TimeResult evolve_in_time(Document& document, const Motion& motion, const TimeOptions& time,
                          const EvolveOptions& options, const LoopOptions& loop, Record& record,
                          const Progress& progress = Progress());

MorphResult morph(Document& document, const Target& target, const MorphOptions& options,
                  const LoopOptions& loop, Record& record, const Progress& progress = Progress());

TrackResult track(Document& document, const std::vector<std::string>& names,
                  const std::function<Target(std::size_t frame)>& target_of,
                  const MorphOptions& options, const LoopOptions& loop, Record& record,
                  const Progress& progress = Progress());

/// Returns a text such as "vertices moved less far than their velocities prescribe in 30 of 30
/// iterations, at most 87 % of them: clamped to 0.2 of the mean edge". Pre: vertices were clamped
/// in an iteration.
std::string clamps_in_words(const EvolveResult& result, double alpha);

/// Returns "converged", "stalled" or "iteration_limit".
const char* name_of(MorphStop stop);

}  // namespace transformesh
