/// Controls the loop of an evolution, and its files: a state, a CSV file with a row for each
/// iteration, and meshes as frames.
///
/// The state is a folder with the last mesh and the variables of the loop. It is replaced
/// atomically after each iteration. A run that was ended in any way, even killed, can be resumed
/// from its state, and then writes the same bytes as an uninterrupted run. Resuming removes rows of
/// the CSV file that are newer than the state.
#pragma once

#include <functional>
#include <string>

#include "transformesh/errors.h"

namespace transformesh {

/// Files with an empty name are not written.
struct RecordOptions {
  std::string state;  ///< folder that stores the state of the run
  /// Text of all settings; a run continues only if its state has equal text.
  std::string settings;
  bool resume = false;     ///< continue from the state if there is one
  bool restart = false;    ///< delete the state of an interrupted run and begin again
  std::string frames;      ///< folder for frame-00000.ply and so on; empty meshes are not written
  std::size_t every = 10;  ///< iterations from one frame to the next
  std::string csv;         ///< CSV file with a row for each iteration
  std::string events;      ///< CSV file of the events (events.h) of loops that find them
  bool is_alone = false;   ///< throw OutputError if another process uses the state
  bool keep_state_at_end = false;  ///< the caller calls remove_state() after saving the result
};

struct LoopOptions {
  std::size_t iterations = 1000;  ///< largest number of iterations, including earlier runs
  std::function<void(const std::string& message)> on_iteration = {};
  /// Loops throw UsageError if the state has other settings, or is of an interrupted run and
  /// neither `resume` nor `restart` is set. They throw InputError if the folder holds no state, and
  /// OutputError if another process uses the state or a file cannot be written.
  RecordOptions record = {};
};

/// Removes the folder of a state with its files.
void remove_state(const std::string& folder);

}  // namespace transformesh
