/// The options of tm-remesh.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frame/keep_out_option.h"
#include "frame/run.h"
#include "transformesh/align_features.h"
#include "transformesh/decimate.h"
#include "transformesh/remesh.h"

namespace transformesh::tool {

/// Values of the options on the command line. Values that need no conversion are stored in
/// `remesh`. The others are converted by the functions below.
struct RemeshChoices {
  /// Number of faces to which the mesh is decimated instead of remeshed.
  std::optional<std::size_t> faces;
  /// Mesh to whose sharp edges the input is aligned instead of remeshed.
  std::string align;
  std::optional<Length> error;  ///< largest error of decimation; may be combined with `faces`
  std::optional<Length> edge, min_edge, max_edge, adaptive, min_film, pinch;
  std::string smooth = "tangential";
  std::string feature_angle = "auto";
  std::vector<double> smooth_twice;
  bool source_points = false;  ///< true: write the point of the input to which each vertex belongs
  KeepOutOption keep_out;
  RemeshOptions remesh;
};

void declare_remeshing(Program& program, RemeshChoices& choices);

/// Returns the options of remesh() for a document. Reads the obstacle of --keep-out, which
/// `choices` owns. Sets default lengths in `choices`, so that settings and report show them.
RemeshOptions remesh_options(RemeshChoices& choices, const Document& document, Run& run);

/// Returns the options of align_features(). Throws UsageError if other options are given.
AlignOptions align_options(RemeshChoices& choices, const Document& document, Run& run);

/// Returns the options of decimate(). Throws UsageError if options of remeshing are given.
DecimateOptions decimate_options(RemeshChoices& choices, const Document& document, Run& run);

}  // namespace transformesh::tool
