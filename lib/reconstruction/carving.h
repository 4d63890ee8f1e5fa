/// Removes parts of a surface that photographs contradict: thin sheets across holes, bridges
/// between strands, and fillings of narrow gaps. The visual hull has such parts.
/// Reference: Kutulakos & Seitz, "A theory of shape by space carving", IJCV 38(3), 2000. Unlike
/// there, the surface of a mesh recedes, not voxels, and photographs compare windows, not colors.
///
/// The surface of a hull contains the object, so that a part on which photographs disagree lies
/// outside of the object. Each round moves such parts inwards and then takes a short sweep: remesh,
/// steps towards agreement of the photographs, clean. The steps bring confirmed parts back to the
/// object. If the two sides of a thin sheet meet, cleaning removes the sheet there.
#pragma once

#include <functional>
#include <vector>

#include "transformesh/document.h"
#include "transformesh/mesh.h"
#include "views/photo/disagreement.h"

namespace transformesh {

/// Measures that decide whether a surface is better than that before carving, from photographs at
/// one scale.
struct CarvingEvidence {
  /// Sums over the windows around each vertex (Disagreement::of_vertex).
  std::vector<WindowSums> of_vertex;
  double outline = 1;  ///< mean intersection over union of the surface's outlines and exact masks
};

struct CarvingStages {
  std::function<CarvingEvidence(const Mesh&)> measure;
  std::function<void(Document&)> clean;
  std::function<void(Document&)> sweep;   ///< takes a few steps
  std::function<void(Document&)> settle;  ///< takes the steps of a full sweep
  std::function<void()> keep;  ///< called after the document is replaced by a better surface
  double distance = 0;         ///< largest movement of a vertex in a round; input units
};

/// Carves until photographs contradict at most 0.5 % of the observed surface, in at most 16 rounds.
/// After every four rounds, calls `settle` and compares the surface with the last one that was
/// kept. The surface is kept if its score is higher by 0.1 % and `outline` is less than 0.001 below
/// that before carving. The score is the weight of windows where photographs agree, times (1 - s /
/// 2), where s is the contradicted fraction of the observed area. Carving ends at a surface that is
/// not kept, if `clean` doubles the number of faces, or if a stage throws anything but
/// CancelledError. The document is the last surface that was kept; it is unchanged if none was
/// kept.
void carve(Document& document, const CarvingStages& stages);

}  // namespace transformesh
