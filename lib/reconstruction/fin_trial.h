/// Removes thin sheets and fins that fewer than two photographs show, such as remainders of the
/// visual hull in a hole. Neither photographs nor carving (carving.h) move them.
#pragma once

#include <functional>

#include "reconstruction/carving.h"
#include "transformesh/control.h"
#include "transformesh/document.h"

namespace transformesh {

struct FinTrialStages {
  std::function<CarvingEvidence(const Mesh&)> measure;
  std::function<void(Document&)> clean;
};

/// Cuts all unobserved fins off a copy (unobserved_fins() of surface_doubt.h), closes the openings
/// by smooth patches, and calls `clean`. The copy replaces the document if its outline agrees no
/// less with exact masks, and its fins have fewer vertices. `pixel` is the size of a pixel at the
/// object, in input units. Returns true if the document was replaced. Returns false if an opening
/// stays open, or if filling, cleaning or measuring the copy throws anything but CancelledError.
/// Precondition: the mesh is a closed oriented manifold.
bool try_without_fins(Document& document, double pixel, const FinTrialStages& stages,
                      const Progress& progress = {});

}  // namespace transformesh
