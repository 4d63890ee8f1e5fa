/// One step towards photographs that are prepared at one scale (photo_scene.h).
///
/// gauss_newton: movements d along the vertex normals that lower the quadratic model of the energy,
/// damped by `damping` compared pixels a squared pixel, plus the bending of a thin plate
/// (thin_plate.h) and a quadratic pull towards silhouettes. Independent of units, contrast and
/// scale. gradient: the paper's d = -t (gradient of the energy per unit of area), in length^-3: t
/// is in length^4 and depends on the units of the mesh. Silhouettes pull by their fraction of the
/// gap, and vertices move by `smoothing` of the distance to the mean of their neighbors.
#pragma once

#include "transformesh/photo_step.h"
#include "views/photo/photo_scene.h"

namespace transformesh {

/// Does what photo_step() of photo_step.h does.
PhotoStepResult photo_step(Mesh& mesh, const PhotoScene& scene,
                           const PhotoStepOptions& options = {}, const Progress& progress = {});

}  // namespace transformesh
