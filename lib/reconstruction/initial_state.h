/// What a reconstruction (paper 5.3) begins with, in its record: so a run that goes on has it too.
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
  std::optional<Mesh> outlined;  ///< the hull whose outlines take the place of masks
  /// Of a hull that was opened: the scale of the photographs that did. Longer edges than those of
  /// that scale would close hollows.
  std::optional<double> coarsest;
};

struct InitialStateOptions {
  InitialMeshOptions initial;
  PairOptions pairs;
};

/// As make_initial_mesh(), and the hull is opened where that is wanted and photographs see into
/// hollows (opened_hull.h). Of a document without a mesh given the comments count.
InitialState make_initial_state(const Document& document, std::vector<View>& views,
                                const InitialStateOptions& options, Record& record,
                                const Progress& progress = Progress());

/// In the record of a run that goes on. Throws InputError where it is not there.
InitialState read_initial_state(const Record& record);

}  // namespace transformesh
