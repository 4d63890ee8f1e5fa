/// The options of remeshing.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tm/remesh/remesh.h"
#include "tool.h"

namespace transformesh::tool {

/// Options as they are written.
struct RemeshChoices {
  std::optional<Length> min_edge;
  std::optional<Length> max_edge;
  std::string size_column;
  std::optional<Length> adaptive;
  long iterations = 1;
  std::string flip = "valence";
  std::string smooth = "tangential";
  std::vector<double> smooth_twice;
  double feature_angle = 180;
  bool keep_border = false;
  bool project = false;
};

void declare_remeshing(Program& program, RemeshChoices& options);

/// --smooth: `tangential`, which is the options' default, `none` or a factor. Throws UsageError.
void read_smoothing(const std::string& text, RemeshOptions& options);

/// For the document. Fills in the default lengths, so that settings and report show them.
RemeshOptions remesh_options(RemeshChoices& options, const Document& document, Run& run);

}  // namespace transformesh::tool
