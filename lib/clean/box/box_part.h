/// Cuts and rounds the faces of a box as clean() of the whole mesh does, but reads only the faces
/// around them. The rounding of a face depends on the pieces of its neighbors. These pieces depend
/// on all faces that intersect the neighbors, and on further faces in the planes of the
/// intersecting faces. Cost: O(n) to select faces, and that of cleaning the selected faces.
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

/// Describes whether the loaded mesh is the whole mesh or a part of it, and which part.
struct Region {
  bool is_whole = true;
  Box held;  ///< the loaded mesh contains every face of the whole mesh that touches this box
  ReferencePoint reference;  ///< a point in `held`, with its winding number
  /// Width of the grid cells that define rings of faces: the next ring contains the faces that
  /// share a cell with the previous ones. The loaded mesh contains four rings around the faces to
  /// clean.
  double cell_size = 1;
};

/// Number of rings of faces around own faces (the faces to clean) of which all pieces are needed.
/// The first ring contains the neighbors of own faces; the second ring affects rounding. Own faces
/// and these rings are called complete faces.
inline constexpr int rings_of_complete = 2;
/// Number of further rings around complete faces (of which all pieces are needed). The first of
/// them contains the faces that meet complete faces; the second determines with which coplanar
/// faces they are cut.
inline constexpr int rings_around_complete = 2;

/// Returns the description of a whole closed mesh: `held` is all of space, and the reference point
/// is outside the mesh.
Region whole_region(const Mesh& mesh);

class BoxPart {
 public:
  /// Keeps references to all arguments.
  BoxPart(const Mesh& mesh, const Region& region, const std::vector<bool>& is_own,
          const CleanOptions& options, const Progress& progress);

  /// Returns the pieces of the faces to clean (own faces), and of some other faces. Returns nothing
  /// if faces intersect or have no area after rounding. Throws GoalError if faces outside the
  /// region are needed.
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
  /// True for each face of the mesh of which all pieces are needed.
  std::vector<bool> is_complete_;
  /// Grid cells of the faces of which all pieces are needed, and of the ring of faces around them.
  CellMarks covered_;
  Box own_box_;  ///< bounding box of the first corners of the faces to clean, with a margin
  BoxSubmesh part_;
  std::shared_ptr<const WeldedMesh> welded_;
  std::vector<Meeting> meetings_;
};

}  // namespace transformesh
