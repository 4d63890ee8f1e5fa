/// Describes iterations of an evolution in words and as columns of a CSV file.
#pragma once

#include <string>

#include "evolution/loop/csv_row.h"
#include "transformesh/iteration.h"

namespace transformesh {

/// Returns a text such as "812 faces, 1 part, genus 0".
std::string in_words(std::size_t faces, const Topology& topology);

/// Returns a text such as "812 faces, components 1, genus 0".
std::string in_short(std::size_t faces, const Topology& topology);

/// Return a fraction of the vertices in [0, 1]: of those that moved, and of those whose movement
/// was clamped.
double moved_share(const IterationResult& result);
double clamped_share(const IterationResult& result);

/// Add the CSV columns that all loops have: measure_mesh() those of the mesh after the iteration,
/// measure_times() the mean edge before the iteration and the times of its stages.
void measure_mesh(const IterationResult& result, CsvRow& row);
void measure_times(const IterationResult& result, CsvRow& row);

}  // namespace transformesh
