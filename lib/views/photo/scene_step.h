/// One step towards photographs that are prepared at one scale (photo_scene.h). Vertices move along
/// their normals.
///
/// `gauss_newton` minimizes a quadratic model: the energy of the photographs, the bending energy of
/// a thin plate (thin_plate.h) and quadratic attraction to silhouettes. `damping` is added to the
/// curvature of the first term, in compared pixels per squared pixel. The step is independent of
/// units, contrast and scale.
///
/// `gradient` is the paper's step: vertices move by -`time_step` times the gradient of the energy
/// per unit of area. That gradient is in length^-3. Hence `time_step` is in length^4 and depends on
/// the units of the mesh. In addition, vertices move by the fraction `silhouettes` of their gap to
/// silhouettes, and by the fraction `smoothing` towards the mean of their neighbors.
#pragma once

#include "transformesh/photo_step.h"
#include "views/photo/photo_scene.h"

namespace transformesh {

/// Equals photo_step() of photo_step.h, for a prepared scene.
PhotoStepResult photo_step(Mesh& mesh, const PhotoScene& scene,
                           const PhotoStepOptions& options = {}, const Progress& progress = {});

}  // namespace transformesh
