// Catches the exceptions of the library by their type, and an unknown shape as a UsageError.
#include <transformesh/errors.h>
#include <transformesh/shapes.h>

#include <string>

using namespace transformesh;

template <typename Error>
bool is_caught_as_runtime_error() {
  try {
    throw Error("message");
  } catch (const std::runtime_error& error) {
    return error.what() == std::string("message");
  }
}

int main() {
  if (!is_caught_as_runtime_error<InputError>() || !is_caught_as_runtime_error<GoalError>() ||
      !is_caught_as_runtime_error<OutputError>() || !is_caught_as_runtime_error<CancelledError>())
    return 1;
  try {
    make_shape({.kind = "no such shape"});
  } catch (const UsageError& error) {
    return std::string(error.what()).find('\n') == std::string::npos ? 0 : 1;
  }
  return 1;
}
