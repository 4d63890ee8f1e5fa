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

/// Options as they are written; the rest are in `remesh`.
struct RemeshChoices {
  std::optional<long> faces;    ///< to decimate to, instead of remeshing
  std::string align;            ///< the mesh to whose sharp edges to align, instead
  std::optional<Length> error;  ///< to decimate within, instead of or besides
  std::optional<Length> edge, min_edge, max_edge, adaptive, min_film, pinch;
  std::string only = "all";
  std::string flip = "valence";
  std::string smooth = "tangential";
  std::string feature_angle = "auto";
  std::vector<double> smooth_twice;
  bool source_points = false;  ///< to be written
  KeepOutOption keep_out;
  RemeshOptions remesh;
};

void declare_remeshing(Program& program, RemeshChoices& choices);

/// For the document. Reads the surface to keep out of, which stays with the choices. Fills in the
/// default lengths, so that settings and report show them.
RemeshOptions remesh_options(RemeshChoices& choices, const Document& document, Run& run);

/// The same where nothing but the alignment is to be done. Throws UsageError for other options.
AlignOptions align_options(RemeshChoices& choices, const Document& document, Run& run);

/// The same where faces are to be decimated. Throws UsageError where options of both are given.
DecimateOptions decimate_options(RemeshChoices& choices, const Document& document, Run& run);

}  // namespace transformesh::tool
