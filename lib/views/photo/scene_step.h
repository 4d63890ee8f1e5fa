/// One step that moves a surface so that calibrated photographs agree better on it. All photographs
/// have been shrunk by a common factor (photo_scene.h). Vertices move along their normals.
///
/// PhotoStepRule::gauss_newton minimizes a quadratic model with three terms: the energy of the
/// photographs, the bending energy of a thin plate (thin_plate.h) and the squared distances from
/// silhouettes. `damping` is added to the second derivative of the first term at a vertex: once per
/// compared pixel, and divided by the squared side of a pixel. The step is independent of units,
/// contrast and scale.
///
/// PhotoStepRule::gradient is the step of the TransforMesh paper: vertices move by -`time_step`
/// times the gradient of the energy per unit of area. That gradient is in length^-3. Hence
/// `time_step` is in length^4 and depends on the units of the mesh. In addition, vertices move by
/// the fraction `silhouettes` of their distance from silhouettes (contour_gaps.h). They also move
/// by the fraction `smoothing` of the way to the mean of their neighbors.
#pragma once

#include "transformesh/photo_step.h"
#include "views/photo/photo_scene.h"

namespace transformesh {

/// Does the same as photo_step() of photo_step.h, for photographs that were already reduced.
PhotoStepResult photo_step(Mesh& mesh, const PhotoScene& scene,
                           const PhotoStepOptions& options = {}, const Progress& progress = {});

}  // namespace transformesh
