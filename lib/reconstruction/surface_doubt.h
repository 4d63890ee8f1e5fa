/// Which places of a reconstructed surface (paper 5.3) its photographs do not back.
///
/// The doubt of a vertex is how much photographs disagree around it beyond their noise
/// (WindowSums::excess of disagreement.h): from 0 to 1, and 1 where no two views see it. A place is
/// where neighbors have more than one half, and are seen. It is a thin one, a thin sheet or a fin,
/// where most of it has another side of the surface within six pixels (local_thickness.h).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "transformesh/reconstruct.h"
#include "views/photo/disagreement.h"
#include "views/photo/photo_scene.h"

namespace transformesh {

struct SurfaceDoubt {
  std::vector<double> of_vertex;      ///< with six digits
  std::vector<DoubtfulPlace> places;  ///< of at least 25 squared pixels, the largest first
  double share = 0;                   ///< of the places in the area that is seen
  double disagreement = 0;            ///< WindowSums::excess of all windows
  double floor = 0;                   ///< mean dissimilarity that noise explains
};

/// Of a scene at scale 1. Throws and costs as disagreement(), and local_thickness() where there are
/// places. The same for any number of threads.
SurfaceDoubt surface_doubt(const Mesh& mesh, const PhotoScene& scene, double least_cosine,
                           const PhotoconsistencyOptions& options = {},
                           const Progress& progress = {});

/// The vertex column `doubt`.
inline constexpr const char* doubt_column = "doubt";
void set_doubt_column(Mesh& mesh, const SurfaceDoubt& doubt);

/// "12.5,3,-4 (412 square pixels, thin)", with a position of four digits.
std::string in_words(const DoubtfulPlace& place);

}  // namespace transformesh
