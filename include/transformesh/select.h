/// Selects the faces of a mesh that meet all of several conditions. Faces and vertices keep their
/// order and columns; vertices that no face uses are dropped. The mesh may be open, a soup, or of
/// any orientation. A mesh does not change if a function throws. Deterministic. Cost: O(n log n).
/// A component contains a point if its generalized winding number there does not round to 0
/// (Jacobson et al., "Robust inside-outside segmentation", ACM TOG 32(4), 2013).
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "transformesh/components.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

namespace transformesh {

/// Conditions on faces. Conditions that are not set hold for every face.
struct SelectionOptions {
  std::optional<std::size_t> largest;       ///< number of the largest components to keep
  double at_least = 0;                      ///< least size of a component; 0: any size
  ComponentSize by = ComponentSize::faces;  ///< measure of the size of a component
  /// `COLUMN OP NUMBER`, with OP one of < <= = != >= >. COLUMN is a face column, else a vertex
  /// column: then all three corners must meet the condition.
  std::string where;
  std::optional<Box> box;  ///< closed box that must contain all corners of a selected face
  /// Selects the innermost component that contains this point, or else the closest component.
  std::optional<Vec3> around;
  std::optional<std::vector<bool>> mask;  ///< true for each face that may be selected
  bool invert = false;                    ///< select the faces that do not meet the conditions
};

struct SelectionResult {
  std::size_t selected_faces = 0, dropped_faces = 0;
  std::optional<bool> contains_point;  ///< true if the component of `around` contains the point
  double distance = 0;                 ///< distance of `around` from the surface; input units
};

/// Keeps the selected faces. Throws UsageError for an invalid condition, InputError if there is no
/// such column or the mask has the wrong length, and GoalError if no face is selected.
SelectionResult select(Mesh& mesh, const SelectionOptions& options);

/// The plane normal * x = offset. A cut keeps the side to which the normal points.
struct CutPlane {
  Vec3 normal;
  double offset;
};

/// Cuts faces along the plane. Drops lists of texture coordinates; returns true if there were any.
/// Both cuts throw UsageError for a normal of length 0, and GoalError if nothing is left.
bool cut_open(Mesh& mesh, const CutPlane& plane);
/// Cuts and closes the cut as clean() does. Throws InputError if the mesh is not closed.
void cut_closed(Mesh& mesh, const CutPlane& plane, Scalar coordinate = Scalar::float64,
                const Progress& progress = Progress());
/// Returns the segments in which faces meet the plane; closed curves if the mesh is closed.
std::vector<std::pair<Vec3, Vec3>> plane_section(const Mesh& mesh, const CutPlane& plane);

}  // namespace transformesh
