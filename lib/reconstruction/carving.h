/// Opens parts of a surface that no photographs confirm: films across holes, bridges between
/// strands, and fillings of narrow gaps, all of which the visual hull has.
/// Reference: Kutulakos & Seitz, "A theory of shape by space carving", IJCV 38(3), 2000. Unlike
/// there, the surface of a mesh recedes, not voxels, and photographs compare windows, not colors.
///
/// The surface of a hull contains the object, so that a part on which photographs disagree lies
/// outside of the object. Each round moves such parts inwards and then takes a sweep, whose steps
/// bring confirmed parts back to the object. If the two sides of a film meet, cleaning opens it.
#pragma once

#include <functional>
#include <vector>

#include "transformesh/document.h"
#include "transformesh/mesh.h"
#include "views/photo/disagreement.h"

namespace transformesh {

/// Evidence for a surface at a scale.
struct CarvingEvidence {
  std::vector<WindowSums> of_vertex;  ///< Disagreement::of_vertex
  double outline = 1;                 ///< mean overlap with exact masks
};

struct CarvingStages {
  std::function<CarvingEvidence(const Mesh&)> measure;
  std::function<void(Document&)> sweep;   ///< cleans, then takes a short sweep
  std::function<void(Document&)> settle;  ///< takes a sweep
  std::function<void()> keep;             ///< called after each settled surface that is kept
  double distance = 0;                    ///< largest movement in a round
};

/// Carves until at most 0.5 % of the observed surface is contradicted, at most 16 rounds. After
/// every four rounds the surface settles and is judged. It is kept if the score rises by 0.1 % and
/// the outline is less than 0.001 below that before carving. The score is the weight of windows on
/// parts on which photographs agree, reduced by half of the contradicted share of the surface.
/// Carving ends at a surface that is not kept, or if a stage throws anything but CancelledError.
/// The document is the last surface that was kept, or else unchanged.
void carve(Document& document, const CarvingStages& stages);

}  // namespace transformesh
