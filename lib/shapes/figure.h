/// A small human figure made of tubes that crosses and raises its arms: the frames of a movie.
#pragma once

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh::shapes {

/// Returns the figure at a time in [0, 1]. It is 2.2 tall and faces z. The arms are stretched
/// forward at 0, crossed in front of the chest at 0.5, and raised at 1. Forearms less than 0.05
/// apart are joined by a bridge. The bridge closes a ring of arms and chest: the genus is then 1,
/// otherwise 0. Except for the bridge, the surface moves continuously.
Mesh figure(double time, std::size_t faces, const Progress& progress);

}  // namespace transformesh::shapes
