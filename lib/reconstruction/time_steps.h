/// The time steps of a movie, as given on a command line.
#pragma once

#include <string>
#include <vector>

namespace transformesh {

struct TimeStep {
  std::string text;  ///< replaces {}: the line, or the path of the folder
  std::string name;  ///< the last component of `text`
};

/// Returns the lines of a file that are not blank, or the folders in a folder or matching a
/// pattern, in natural order. Throws InputError if there is none. Throws UsageError if two of them
/// have the same name.
std::vector<TimeStep> time_steps(const std::string& where);

/// Returns the path with each {} replaced by the text of the time step.
std::string place_of(std::string where, const TimeStep& step);

}  // namespace transformesh
