/// Option --smooth of tm-remesh and of programs that run an evolution.
#pragma once

#include <string>

#include "support/number.h"
#include "transformesh/errors.h"
#include "transformesh/remesh.h"

namespace transformesh::tool {

/// Parses `tangential` (the default of RemeshOptions), `none` or a factor. Throws UsageError.
inline void read_smoothing(const std::string& text, RemeshOptions& options) {
  if (text == "tangential") return;
  options.smoothing = text == "none" ? Smoothing::none : Smoothing::laplace;
  if (text == "none") return;
  const auto factor = number_in<double>(text);
  if (!factor)
    throw UsageError("--smooth: '" + text +
                     "' is not a number; write tangential, none or a factor such as 0.1");
  options.smooth_first = *factor;
}

}  // namespace transformesh::tool
