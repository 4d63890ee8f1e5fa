/// Kinds of errors and warnings, in terms of the mesh given. A caller chooses the remedy by kind.
#pragma once

namespace transformesh {

enum class ErrorKind {
  other,                ///< a problem without a special remedy
  not_closed,           ///< the mesh has borders
  not_joined,           ///< border edges coincide: the mesh is a soup of triangles
  not_oriented,         ///< two faces traverse their common edge in the same direction
  not_orientable,       ///< no reversal of faces orients the mesh
  overlapping_sheets,   ///< to orient the mesh, coincident sheets must be split
  one_sided,            ///< the surface is not orientable, like a Moebius strip
  not_manifold,         ///< the mesh is not an oriented manifold
  self_intersections,   ///< faces intersect
  inside_out,           ///< faces are oriented inwards
  double_sided,         ///< most faces of a solid coincide with a reversed face
  double_sided_sheet,   ///< most faces of an open sheet coincide with a reversed face
  canceling_faces,      ///< all faces coincide with a reversed face
  no_area,              ///< no face has an area
  no_positive_winding,  ///< no point has a positive winding number
  no_such_level,        ///< no point has a winding number >= winding level
  component_too_small,  ///< every component is smaller than the shortest edge
  surface_vanished,     ///< the surface of an evolution shrinks to nothing
  thinner_than_rounding,
  float_rounding_failed,     ///< faces intersect when coordinates are rounded to float
  double_rounding_failed,    ///< faces intersect when coordinates are rounded to double
  coordinates_too_large,     ///< intersections are beyond the range of coordinates
  needs_cleaning,            ///< cleaning would change the mesh, which the caller forbids
  box_in_open_mesh,          ///< only a closed mesh can be cleaned in a box
  static_test_of_open_mesh,  ///< the static test needs a closed mesh, with integer winding numbers
  decimation_stuck,          ///< no further edge can be collapsed without breaking a guarantee
  meets_keep_out,            ///< the mesh intersects the obstacle to keep out of
  bad_reference_edge,        ///< the comment of a mesh file that gives a length is not positive
  unknown_format,            ///< the bytes are in no known mesh format
  no_velocity,               ///< the mesh has no velocity
  no_source_points,          ///< the mesh has no columns with source points
  no_segments,               ///< a file holds no line segments
  no_color_property,         ///< a range of colors is given without a property
  texture_too_small,         ///< the charts do not fit in the texture
  target_open,               ///< the target has borders
  target_not_solid,          ///< the target is open, not manifold, or intersects itself
  source_apart,              ///< the source does not overlap all of the target
  edges_too_long,            ///< edges are too long for the target
  uniform_edges_too_long,    ///< edges of uniform length are too long at narrow places
  outside_hull,              ///< the mesh is outside of the visual hull
  scene_behind_cameras,      ///< the coordinate system of the cameras is left-handed
  views_disagree,            ///< many silhouettes do not fit the visual hull
  few_views_disagree,        ///< a few silhouettes do not fit the visual hull
  bad_state,                 ///< the state of a run cannot be continued
  other_settings,            ///< the state is of a run with other settings
  interrupted_run,           ///< a new run would overwrite the state of an interrupted one
  not_a_run                  ///< a folder does not hold a run
};

/// Returns the name of the enumerator, such as "not_oriented".
const char* name_of(ErrorKind kind);

}  // namespace transformesh
