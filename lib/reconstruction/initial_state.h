/// The initial state of a reconstruction (paper 5.3). It is stored in the record, so that a resumed
/// run has the same.
#pragma once

#include <optional>
#include <vector>

#include "evolution/loop/record.h"
#include "reconstruction/initial_mesh.h"
#include "views/cameras/view.h"
#include "views/cameras/view_pairs.h"

namespace transformesh {

struct InitialState {
  Document document;
  std::optional<Mesh> outlined;  ///< hull whose outlines replace masks
  /// Scale of the photographs that opened the hull, if it was opened. Longer edges, as at coarser
  /// scales, would close hollows.
  std::optional<double> coarsest;
  /// The given mesh, cleaned, if the initial mesh is a part of it.
  std::optional<Document> unclipped;
  /// Reason why the mesh is made from depth maps (dense_surface.h); empty if it is not.
  std::string why_dense;
  std::optional<double> first_scale;  ///< scale to begin with (first_scale.h), if it was chosen
};

struct InitialStateOptions {
  InitialMeshOptions initial;
  PairOptions pairs;
};

/// Calls make_initial_mesh(). Then opens the hull if `opens_hollows` is true and photographs show
/// hollows (opened_hull.h). If no mesh is given, only the comments of `document` are used.
InitialState make_initial_state(const Document& document, std::vector<View>& views,
                                const InitialStateOptions& options, Record& record,
                                const Progress& progress = Progress());

/// Sets InitialState::first_scale, also in the record.
void set_first_scale(InitialState& initial_state, double scale, Record& record);

/// Reads the initial state from the record of a resumed run. Throws InputError if the record has
/// none.
InitialState read_initial_state(const Record& record);

}  // namespace transformesh
