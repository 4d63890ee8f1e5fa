/// Errors that the library throws. Each has a kind, data and a sentence (problem.h). The exit codes
/// of programs are 2 to 5 for the four classes that derive from Error.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "support/problem.h"

namespace transformesh {

/// Base of the errors. Copies share one Problem, so that copying never throws.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& sentence) : Error(ErrorKind::other, sentence) {}
  Error(ErrorKind kind, const std::string& sentence, ErrorData data = {})
      : Error(Problem{kind, sentence, std::move(data)}) {}
  explicit Error(Problem problem);

  const Problem& problem() const { return *problem_; }
  ErrorKind kind() const { return problem_->kind; }
  const ErrorData& data() const { return problem_->data; }

 private:
  std::shared_ptr<const Problem> problem_;
};

/// An option or argument makes no sense: the caller's mistake.
struct UsageError : Error {
  using Error::Error;
};

/// Input is unreadable, malformed, or not what the operation needs.
struct InputError : Error {
  using Error::Error;
};

/// The goal cannot be reached from valid input; no result exists.
struct GoalError : Error {
  using Error::Error;
};

/// A file could not be written: the disk is full, the folder missing, the descriptor closed.
struct OutputError : Error {
  using Error::Error;
};

/// The progress callback asked to stop.
struct CancelledError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws the error that is being handled again, with `prefix` before its sentence. Its class, kind
/// and data stay. An exception that is not an Error is thrown unchanged.
[[noreturn]] void rethrow_with_prefix(const std::string& prefix);

}  // namespace transformesh
