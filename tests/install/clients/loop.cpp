// Removes the folder of a state and checks the defaults of the options of a loop.
#include <transformesh/loop.h>

#include <filesystem>

using namespace transformesh;

int main() {
  const LoopOptions options{.record = {.state = "loop-state"}};
  if (options.iterations != 1000 || options.on_iteration || options.record.resume) return 1;
  if (options.record.every != 10 || !options.record.frames.empty()) return 1;
  std::filesystem::create_directory(options.record.state);
  remove_state(options.record.state);
  return std::filesystem::exists(options.record.state) ? 1 : 0;
}
