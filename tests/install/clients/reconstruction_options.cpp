// Reads the defaults of the options and the window radius at a coarse and at a fine scale.
#include <transformesh/reconstruction_options.h>

using namespace transformesh;

int main() {
  ReconstructionOptions options;
  options.windows = {.coarse = 4, .fine = 2};
  if (options.windows.at(2) != 4 || options.windows.at(1) != 2) return 1;
  if (options.initial.is_given || options.scales.coarsest || options.iterations) return 1;
  return options.sweeps == 4 && options.momentum < 1 && !options.on_sweep ? 0 : 1;
}
