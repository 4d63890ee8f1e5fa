/// The time steps of a movie, as a command line names them.
#pragma once

#include <string>
#include <vector>

namespace transformesh {

struct TimeStep {
  std::string text;  ///< what {} stands for: the line, or the path of the folder
  std::string name;  ///< the last part of it
};

/// The lines of a file that are not blank; or in natural order the folders in a folder, or what a
/// quoted pattern matches. Throws InputError where there is none, UsageError where two of them have
/// one name.
std::vector<TimeStep> time_steps(const std::string& where);

/// A place, with {} replaced.
std::string place_of(std::string where, const TimeStep& step);

}  // namespace transformesh
