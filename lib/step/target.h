/// What a morph moves towards: a mesh, or points with normals.
#pragma once

#include <string>
#include <vector>

#include "geometry/search/closest_point.h"
#include "mesh/mesh.h"

namespace transformesh {

/// Points are a mesh without faces.
struct Target {
  Mesh mesh;
  /// Of points only: one each, of unit length or zero where undefined. A mesh has its faces.
  std::vector<Vec3> normals;
  bool has_estimated_normals = false;
  std::vector<double> thickness;  ///< local_thickness() where measured, else empty
  FaceOrder face_order = FaceOrder::any;
  std::vector<std::string> notes;  ///< what was changed when the target was read, one line each
  bool is_prepared = false;  ///< read from what write_target() wrote, of what was checked before
  bool is_mesh() const { return !mesh.faces.empty(); }
};

/// Makes a target of a mesh as read. Of points, the vertex columns nx ny nz are taken where
/// present, else normals are estimated (estimate_normals.h). Vertices of a mesh that no face uses
/// are dropped, and equal places are joined if border edges lie upon each other, as in a soup.
/// Throws InputError where there is nothing, where a closed mesh is inside out (all of it would be
/// outside), and for normals that are not finite.
Target make_target(Mesh mesh);

/// Sorts faces spatially unless they are, and drops their columns. Of faces at the same distance
/// the first one wins, so that their order decides on last digits.
void order_spatially(Target& target);

/// The vertex columns nx ny nz, of unit length or zero; nothing where one is missing. Throws
/// InputError for normals that are not finite.
std::vector<Vec3> stored_normals(const Mesh& mesh);

/// Stores normals as the vertex columns nx ny nz, from where make_target takes those of points.
void set_normal_columns(Mesh& mesh, const std::vector<Vec3>& normals);

}  // namespace transformesh
