/// The options by which programs name silhouettes, and how silhouettes come out of photographs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frame/run.h"
#include "transformesh/hull.h"
#include "views/cameras/view.h"
#include "views/cameras/view_files.h"
#include "views/hull/silhouette.h"
#include "views/hull/view_check.h"

namespace transformesh::tool {

struct SilhouetteOptions {
  ViewSources sources;
  std::string threshold = "auto";
  double blur = ThresholdOptions().blur;
  double close = ThresholdOptions().close;
  std::string masks;  ///< output folder for masks
};

struct ViewCheckChoices {
  double least_agreement = ViewCheckOptions().least_agreement;
  bool drops_bad_views = false;
};

/// --least-agreement, --drop-bad-views and, for the cameras, --mirror.
void declare_view_check(Program& program, ViewCheckChoices& choices, ViewSources& sources);

/// Looks whether the views agree, and tells which are left out.
/// Throws what check_views throws.
ViewCheck check_views(std::vector<View>& views, const ViewCheckChoices& choices, Run& run);

/// --cameras, --silhouettes, --images, --threshold, --blur, --close and --write-silhouettes.
void declare_silhouettes(Program& program, SilhouetteOptions& options);

/// The views with silhouettes: those of the masks, else those of the photographs. Writes them where
/// that was asked for. Throws UsageError unless there is either, and what views_from throws.
std::vector<View> views_with_silhouettes(const SilhouetteOptions& options, Run& run);

/// The value of --threshold, none for auto, and of --keep. Throw UsageError for anything else.
std::optional<double> threshold_intensity(const std::string& threshold);
double hull_share(const std::string& keep);

/// Writes what the mesh covers in each view, which has a silhouette, to NAME.png in the folder.
void write_outlines(const Mesh& mesh, const std::vector<View>& views, const std::string& folder,
                    Run& run);

}  // namespace transformesh::tool
