/// Finds places of a reconstructed surface (paper 5.3) that its photographs do not confirm.
///
/// The doubt of a vertex is the disagreement of photographs around it beyond their noise
/// (WindowSums::excess of disagreement.h), from 0 to 1. It is 1 if the vertex is visible in fewer
/// than two views. A place is a connected set of visible vertices with a doubt above one half. It
/// is thin, such as a thin sheet or a fin, if most of it has another side of the surface within six
/// pixels (local_thickness.h).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "transformesh/reconstruct.h"
#include "views/photo/disagreement.h"
#include "views/photo/photo_scene.h"
#include "views/photo/thin_plate.h"

namespace transformesh {

struct SurfaceDoubt {
  std::vector<WindowSums> sums;       ///< Disagreement::of_vertex
  std::vector<double> of_vertex;      ///< rounded to six digits
  std::vector<DoubtfulPlace> places;  ///< areas of at least 25 squared pixels, the largest first
  double share = 0;                   ///< area of the places, as a fraction of the visible area
  double disagreement = 0;            ///< WindowSums::excess of all windows
  double floor = 0;                   ///< mean dissimilarity that noise explains
};

/// Excess of the windows around a vertex above which photographs contradict it. Chosen by hand.
inline constexpr double contradicted = 0.5;

/// Rings of vertices whose windows are compared together for a doubt. One ring opened no more of
/// two tori that touch when carving; other values were not measured.
inline constexpr int doubt_rings = 2;

/// Adds to the sums of each vertex those of its neighbors, `rings` times, so that no single window
/// decides.
std::vector<WindowSums> spread(std::vector<WindowSums> sums, const UniformLaplacian& laplacian,
                               int rings);

/// Returns the marked vertices that are connected to `first` by marked vertices, and clears their
/// marks.
std::vector<Index> take_connected(Index first, const UniformLaplacian& laplacian,
                                  std::vector<bool>& is_marked);

/// Measures a surface by a scene at scale 1. Throws and costs as disagreement(), and as
/// local_thickness() if there are places. The result does not depend on the number of threads.
SurfaceDoubt surface_doubt(const Mesh& mesh, const PhotoScene& scene, double least_cosine,
                           const PhotoconsistencyOptions& options = {},
                           const Progress& progress = {});

/// Writes the vertex column `doubt`.
inline constexpr const char* doubt_column = "doubt";
void set_doubt_column(Mesh& mesh, const SurfaceDoubt& doubt);

/// Returns text such as "12.5,3,-4 (412 square pixels, thin)", with four digits per coordinate.
std::string in_words(const DoubtfulPlace& place);

}  // namespace transformesh
