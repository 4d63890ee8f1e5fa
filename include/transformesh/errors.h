/// The five ways in which the library refuses. Every message is one line that says what is wrong,
/// where (line, byte offset, face and vertex id, coordinate) and what to do next. The frame in
/// tools/ maps the first four to the exit codes 2 to 5; it cancels nothing, as a signal ends
/// the process.
#pragma once

#include <stdexcept>

namespace transformesh {

/// An option or argument that makes no sense: the caller's mistake.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Input that is unreadable, malformed, or not what the operation needs.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The goal cannot be reached from valid input; no result exists.
struct GoalError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file could not be written: the disk is full, the folder missing, the descriptor closed.
struct OutputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The progress callback asked to stop.
struct CancelledError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace transformesh
