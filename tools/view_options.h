/// The options by which programs name silhouettes, and how silhouettes come out of photographs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frame/run.h"
#include "tm/views/cameras/view_files.h"
#include "tm/views/hull/silhouette.h"

namespace transformesh::tool {

struct SilhouetteOptions {
  ViewSources sources;
  std::string threshold = "auto";
  double blur = ThresholdOptions().blur;
  double close = ThresholdOptions().close;
  std::string masks;  ///< folder to write to
};

/// --cameras, --silhouettes, --images, --threshold, --blur, --close and --write-silhouettes.
void declare_silhouettes(Program& program, SilhouetteOptions& options);

/// The views with silhouettes: those of the masks, else those of the photographs. Writes them where
/// that was asked for. Throws UsageError unless there is either, and what views_from throws.
std::vector<View> views_with_silhouettes(const SilhouetteOptions& options, Run& run);

/// The value of --threshold, none for auto, and of --keep. Throw UsageError for anything else.
std::optional<double> threshold_level(const std::string& threshold);
double hull_share(const std::string& keep);

/// Writes what the mesh covers in each view, which has a silhouette, to NAME.png in the folder.
void write_outlines(const Mesh& mesh, const std::vector<View>& views, const std::string& folder,
                    Run& run);

}  // namespace transformesh::tool
