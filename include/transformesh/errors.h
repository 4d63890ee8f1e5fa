/// Errors that the library throws. Each has a kind, a message (`sentence`) and the values in it.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "transformesh/error_kind.h"

namespace transformesh {

/// Values that the message of an error contains.
struct ErrorData {
  std::vector<std::size_t> faces = {};                  ///< indices of faces
  std::optional<std::array<std::size_t, 2>> edge = {};  ///< indices of the edge's vertices
  std::optional<std::array<double, 3>> position = {};   ///< coordinates in input units
  std::vector<std::size_t> counts = {};  ///< numbers of elements, in the order of the message
  std::vector<double> lengths = {};      ///< lengths that the message states, in its order
  std::string name = {};                 ///< name of a file, folder, view or argument
};

/// An error or a warning. `sentence` is its message: one line, or empty if there is no problem. It
/// names no remedy: callers choose the remedy by `kind`.
struct Problem {
  ErrorKind kind = ErrorKind::other;
  std::string sentence = {};
  ErrorData data = {};
};

class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& sentence) : Error(ErrorKind::other, sentence) {}
  Error(ErrorKind kind, const std::string& sentence, ErrorData data = {});
  explicit Error(Problem problem);

  const Problem& problem() const { return *problem_; }
  ErrorKind kind() const { return problem_->kind; }
  const ErrorData& data() const { return problem_->data; }

 private:
  std::shared_ptr<const Problem> problem_;
};

// clang-format off
/// An argument or option is invalid.
struct UsageError : Error { using Error::Error; };
/// The input is unreadable, malformed, or does not meet the preconditions of the operation.
struct InputError : Error { using Error::Error; };
/// The goal cannot be reached from valid input: there is no result.
struct GoalError : Error { using Error::Error; };
/// A file could not be written.
struct OutputError : Error { using Error::Error; };
/// The progress callback has cancelled the operation.
struct CancelledError : std::runtime_error { using runtime_error::runtime_error; };
// clang-format on

}  // namespace transformesh
