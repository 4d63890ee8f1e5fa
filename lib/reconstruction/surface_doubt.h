/// Finds places of a reconstructed surface (paper 5.3) that its photographs do not confirm.
///
/// The doubt of a vertex is the disagreement of photographs around it beyond their noise
/// (WindowSums::excess of disagreement.h), from 0 to 1. It is 1 if the vertex is visible in fewer
/// than two views. A doubtful place is a connected set of vertices that are visible in two views
/// and have a doubt above one half. It is thin, such as a thin sheet or a fin, if the surface is
/// less than six pixels thick at more than half of its vertices (local_thickness.h). It has a
/// handle if a loop in it does not separate the surface: photographs then contradict all of a
/// handle or tunnel there (place_loops.h).
///
/// Places are also found by windows of 3x3 pixels. A film across a hole that photographs show at
/// grazing angles is narrow in the photographs. Larger windows there contain mostly the surface
/// around the hole, on which photographs agree. Narrower films are found by a trial
/// (filled_hollows.h).
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
  /// Sums over the windows around each vertex (Disagreement::of_vertex).
  std::vector<WindowSums> sums;
  std::vector<double> of_vertex;  ///< doubt of each vertex, rounded to six digits
  /// Doubtful places of at least 25 squared pixels, the largest first.
  std::vector<DoubtfulPlace> places;
  /// Doubtful places by windows of 3x3 pixels, also of at least 25 squared pixels.
  std::vector<DoubtfulPlace> small_window_places;
  double small_window_share = 0;  ///< area of these places, as a fraction of the visible area
  /// Thin places that fewer than two views observe (unobserved_fins()).
  std::vector<DoubtfulPlace> unobserved_fins;
  /// Places that fill hollows of the object (filled_hollows()), the largest first.
  std::vector<DoubtfulPlace> filled_hollows;
  /// Hidden places of at least 25 squared pixels, the largest first (hidden_vertices.h).
  std::vector<DoubtfulPlace> hidden_places;
  double hidden_share = 0;  ///< area of the hidden places, as a fraction of the area of the mesh
  double share = 0;         ///< area of the doubtful places, as a fraction of the visible area
  double disagreement = 0;  ///< disagreement beyond noise, over all windows (WindowSums::excess)
  double floor = 0;         ///< mean dissimilarity that would result from noise alone
};

/// Limit of WindowSums::excess around a vertex, above which photographs contradict the surface
/// there. Chosen by hand.
inline constexpr double contradicted = 0.5;

/// Number of rings of neighbors whose windows decide together about a vertex. Carving of two
/// touching tori separated no more of them with one ring. Other values were not measured.
inline constexpr int doubt_rings = 2;

/// Adds to the WindowSums of each vertex those of its neighbors, `rings` times, so that no single
/// window decides.
std::vector<WindowSums> spread(std::vector<WindowSums> sums, const UniformLaplacian& laplacian,
                               int rings);

/// Returns the marked vertices that are connected to `first` by marked vertices, and clears their
/// marks.
std::vector<Index> take_connected(Index first, const UniformLaplacian& laplacian,
                                  std::vector<bool>& is_marked);

/// Returns the vertices of each thin sheet or fin. Fewer than two views observe each of its sides.
/// `sums` is Disagreement::of_vertex. A fin is a connected set of unobserved vertices where the
/// surface is less than twelve pixels thick. It is less than six pixels thick on an area of at
/// least 25 squared pixels. Gaps and observed opposite sheets do not count.
std::vector<std::vector<Index>> unobserved_fins(const Mesh& mesh,
                                                const std::vector<WindowSums>& sums, double pixel,
                                                const Progress& progress = {});

/// Measures a surface by photographs of full size: `scene` must have scale 1. Throws as
/// disagreement() and local_thickness() do. Takes twice as long as disagreement(), three times
/// if a filled hollow is possible, and also local_thickness() if there are doubtful places. The
/// result does not depend on the number of threads.
SurfaceDoubt surface_doubt(const Mesh& mesh, const PhotoScene& scene, double least_cosine,
                           const PhotoconsistencyOptions& options = {},
                           const Progress& progress = {});

/// Name of the vertex column that set_doubt_column() writes.
inline constexpr const char* doubt_column = "doubt";
void set_doubt_column(Mesh& mesh, const SurfaceDoubt& doubt);

/// Returns text such as "12.5,3,-4 (412 square pixels, thin, with a handle)", with four digits per
/// coordinate.
std::string in_words(const DoubtfulPlace& place);

}  // namespace transformesh
