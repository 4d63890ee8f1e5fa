/// The target of a morph (paper 5.2): a mesh, or points with normals.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "transformesh/control.h"
#include "transformesh/mesh.h"
#include "transformesh/mesh_io.h"

namespace transformesh {

/// A mesh without faces is a set of points.
struct Target {
  Mesh mesh;
  std::vector<Vec3>
      normals;  ///< normal of each point, of unit length or zero; empty for a mesh with faces
  bool has_estimated_normals = false;  ///< normals were computed from neighboring points
  std::vector<double> thickness;       ///< local thickness at each vertex if measured, else empty
  bool has_spatial_order = false;      ///< faces are sorted for quick searches
  std::string unit;                    ///< name of the unit of the file; empty if unknown
  std::vector<std::string> notes;      ///< changes made while reading, one line each
  bool is_prepared = false;            ///< the target was checked before it was written to its file

  bool is_mesh() const { return !mesh.faces.empty(); }
};

/// Makes a target of a mesh. Normals of points are the vertex columns nx ny nz if present, else
/// they are estimated. Vertices of a mesh that no face uses are dropped. Equal positions are joined
/// if border edges coincide. Throws InputError if there are no vertices, if a closed mesh is inside
/// out, and for normals that are not finite. O(n log n).
Target make_target(Mesh mesh);

/// Reads a target from a file's bytes: a mesh in any format of read_mesh(), or points. Points are
/// PLY without faces, or text with lines of x y z or x y z nx ny nz. `name` is the name of the file
/// in messages. Throws InputError as read_mesh() and make_target() do.
Target read_target(std::string_view bytes, const std::string& name, const ReadOptions& = {});

/// Checks that a morph can reach a target; only the orientation of faces decides on which side of
/// the target a vertex is. Throws InputError if neighboring faces disagree, and for a closed mesh
/// that is inside out. Returns a warning for each reason to doubt a result: the target is open, or
/// intersects itself. O(n log n).
std::vector<Problem> check_target(const Target& target, const std::string& name,
                                  const Progress& progress = Progress());

}  // namespace transformesh
