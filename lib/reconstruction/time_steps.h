/// Finds the time steps of a movie from a text file or from folders.
#pragma once

#include <string>
#include <vector>

namespace transformesh {

struct TimeStep {
  /// Text that replaces {} in paths: a line of the file, or the path of a folder.
  std::string text;
  std::string name;  ///< last component of the path `text`
};

/// If `where` is a file, returns its lines that are not blank. Otherwise returns the folders in the
/// folder `where`, or those that match the pattern `where`, in natural order. Throws InputError if
/// there is none. Throws UsageError if two of them have the same name.
std::vector<TimeStep> time_steps(const std::string& where);

/// Returns the path with each {} replaced by the text of the time step.
std::string place_of(std::string where, const TimeStep& step);

}  // namespace transformesh
