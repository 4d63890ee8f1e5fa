/// Options for views and their silhouettes, which are read from masks or computed from photographs.
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

/// Declares --least-agreement, --drop-bad-views and --mirror.
void declare_view_check(Program& program, ViewCheckChoices& choices, ViewSources& sources);

/// Checks whether the silhouettes of the views agree. Removes the views that disagree if `choices`
/// requests this, and prints a note about each removed view. Throws the errors of check_views() of
/// view_check.h.
ViewCheck check_views(std::vector<View>& views, const ViewCheckChoices& choices, Run& run);

/// Declares --cameras, --silhouettes, --images, --threshold, --blur, --close and
/// --write-silhouettes.
void declare_silhouettes(Program& program, SilhouetteOptions& options);

/// Returns the views with silhouettes, from masks or from photographs. Writes the silhouettes if a
/// folder is given. Throws UsageError unless either --silhouettes or --images is given. Throws the
/// errors of views_from().
std::vector<View> views_with_silhouettes(const SilhouetteOptions& options, Run& run);

/// Parse --threshold (empty for `auto`) and --keep (1 for `largest`, 0 for `all`). Throw UsageError
/// for other texts.
std::optional<double> threshold_intensity(const std::string& threshold);
double hull_share(const std::string& keep);

/// Writes the silhouette of the mesh in each view to NAME.png in the folder.
void write_outlines(const Mesh& mesh, const std::vector<View>& views, const std::string& folder,
                    Run& run);

}  // namespace transformesh::tool
