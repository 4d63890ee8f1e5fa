/// A little figure of tubes that crosses its arms and lets go: the frames of a movie.
#pragma once

#include "mesh/mesh.h"
#include "support/progress.h"

namespace transformesh::shapes {

/// The figure at a time from 0 to 1, 2.2 tall, facing z. Its arms, held out ahead at 0, are crossed
/// before the chest at 0.5 and raised at 1. Forearms less than 0.05 apart are joined by a bridge,
/// which closes a ring of arms and chest: the genus is 1 then, else 0. But for this bridge the
/// surface moves continuously.
Mesh figure(double time, std::size_t faces, const Progress& progress);

}  // namespace transformesh::shapes
