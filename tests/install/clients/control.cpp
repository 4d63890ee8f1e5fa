// Limits the number of threads, counts calls of a progress callback and cancels an operation.
#include <transformesh/control.h>
#include <transformesh/shapes.h>

using namespace transformesh;

int main() {
  const std::size_t without_limit = allowed_thread_count();
  {
    const ThreadLimit outer(3);
    const ThreadLimit inner(2);
    if (allowed_thread_count() != 2) return 1;
  }
  if (allowed_thread_count() != without_limit || without_limit < 1) return 1;
  int calls = 0;
  const Progress count([&](std::string_view, double) { return ++calls > 0; });
  make_shape({.kind = "torus", .faces = 2000}, count);
  const Progress stop([](std::string_view, double) { return false; });
  try {
    make_shape({.kind = "torus", .faces = 2000}, stop);
  } catch (const CancelledError&) {
    return calls > 0 ? 0 : 1;
  }
  return 1;
}
