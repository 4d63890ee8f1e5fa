/// Cuts and rounds the faces of a box as clean() of the whole mesh does, but reads only the faces
/// around them. How a face is rounded depends on the pieces of neighboring faces. These pieces
/// depend on all faces that intersect the neighbors, and on the faces coplanar with those faces.
/// Cost: O(n) to select faces, and that of cleaning the selected faces.
#pragma once

#include <memory>
#include <optional>

#include "clean/arrange/planes.h"
#include "clean/box/box_submesh.h"
#include "clean/box/faces_around.h"
#include "clean/box/replace_faces.h"
#include "clean/exterior/surroundings.h"
#include "geometry/search/cell_grid.h"
#include "transformesh/clean.h"

namespace transformesh {

/// A mesh that is the whole mesh or a part of it, with its relation to the whole mesh.
struct Region {
  bool is_whole = true;
  Box held;  ///< the mesh contains every face of the whole mesh that touches this box
  ReferencePoint reference;  ///< a point in `held`, with its winding number
  double cell_size = 1;      ///< cell size; the mesh contains four rings of faces, by cells of this
                             ///< size, around own faces
};

/// Number of rings around own faces of which all pieces are needed. The first ring are the
/// neighbors of own faces; the second ring affects rounding.
inline constexpr int rings_of_complete = 2;
/// Number of rings around complete faces. The first ring are the faces that meet complete faces;
/// the second ring determines their planes.
inline constexpr int rings_around_complete = 2;

/// Returns the region of a whole closed mesh: all of space, with a reference point outside the
/// mesh.
Region whole_region(const Mesh& mesh);

class BoxPart {
 public:
  /// Keeps references to all arguments.
  BoxPart(const Mesh& mesh, const Region& region, const std::vector<bool>& is_own,
          const CleanOptions& options, const Progress& progress);

  /// Returns the pieces of own faces, and of some other faces. Returns nothing if rounding breaks
  /// faces. Throws GoalError if faces outside the region are needed.
  std::optional<CleanedFaces> clean(CleanResult& counts);

 private:
  void find_complete();
  bool complete_planes();
  void check_held() const;
  bool are_held(const std::vector<bool>& faces) const;
  void count_pairs(CleanResult& counts) const;
  Surroundings surroundings();

  const Mesh& mesh_;
  const Region& region_;
  const std::vector<bool>& is_own_;
  const CleanOptions& options_;
  const Progress& progress_;
  CellGrid grid_;
  std::vector<bool> is_complete_;  ///< true for each complete face of the mesh
  CellMarks covered_;              ///< cells of the complete faces and of the rings around them
  Box own_box_;  ///< bounding box of the first vertices of own faces, with a margin
  BoxSubmesh part_;
  std::shared_ptr<const WeldedMesh> welded_;
  std::vector<Meeting> meetings_;
};

}  // namespace transformesh
