/// Cuts and rounds the faces of a box as clean() of the whole mesh does, and reads only faces
/// around them. How a face is rounded depends on the pieces of the faces beside it. These pieces
/// depend on every face that intersects their faces, and on the faces in one plane with that face.
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

/// A mesh that is a part of the whole mesh, or all of it.
struct Region {
  bool is_whole = true;
  Box held;                  ///< every face of the whole mesh that touches this is in the mesh
  ReferencePoint reference;  ///< in `held`
  double cell_size = 1;      ///< four rings by these cells around own faces are in the mesh
};

/// Rings of faces around the own ones of which all pieces are needed: the faces beside them, and
/// the faces beside these, which take part in rounding.
inline constexpr int rings_of_complete = 2;
/// Rings around faces of which all pieces are needed: the faces that meet them, and the faces that
/// these meet, which decide on planes.
inline constexpr int rings_around_complete = 2;

/// Returns the region of a whole closed mesh: all of space, and a point outside.
Region whole_region(const Mesh& mesh);

class BoxPart {
 public:
  /// Keeps references.
  BoxPart(const Mesh& mesh, const Region& region, const std::vector<bool>& is_own,
          const CleanOptions& options, const Progress& progress);

  /// Returns the pieces of the own faces, and some of others. Empty if rounding breaks faces.
  /// Throws GoalError if faces are needed that are not in the region.
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
  std::vector<bool> is_complete_;  ///< per face of the mesh
  CellMarks covered_;              ///< cells of faces around complete ones
  Box own_box_;                    ///< around the first vertices of own faces
  BoxSubmesh part_;
  std::shared_ptr<const WeldedMesh> welded_;
  std::vector<Meeting> meetings_;
};

}  // namespace transformesh
