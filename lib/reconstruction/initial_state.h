/// The initial state of a reconstruction (paper 5.3). It is stored in the record of the run
/// (evolution/loop/record.h), so that a resumed run has the same initial state.
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
  std::optional<Mesh> outlined;  ///< InitialMesh::outlined: hull of thresholded silhouettes
  /// Coarsest scale of the reconstruction, if depth maps were used to open hollows of the hull
  /// (opened_hull.h). It is the scale of these depth maps. At coarser scales, edges are longer and
  /// would close the hollows again.
  std::optional<double> coarsest;
  /// InitialMesh::unclipped: the cleaned given mesh, if the initial mesh is only a part of it.
  std::optional<Document> unclipped;
  /// Reason why the mesh is made from depth maps (dense_surface.h); empty if it is not.
  std::string why_dense;
  /// Scale at which the refinement of a given mesh begins (first_scale.h), if it was computed.
  std::optional<double> first_scale;
};

struct InitialStateOptions {
  InitialMeshOptions initial;
  PairOptions pairs;
};

/// Calls make_initial_mesh(). If the result is a hull and `opens_hollows` is true, removes fillings
/// of hollows that photographs show (opened_hull.h). If no mesh is given, only the file format and
/// comments of `document` are used.
InitialState make_initial_state(const Document& document, std::vector<View>& views,
                                const InitialStateOptions& options, Record& record,
                                const Progress& progress = Progress());

/// Sets InitialState::first_scale and stores it in the record.
void set_first_scale(InitialState& initial_state, double scale, Record& record);

/// Reads the initial state from the record of a resumed run. Throws InputError if the record has
/// none.
InitialState read_initial_state(const Record& record);

}  // namespace transformesh
