/// Turns faces so that neighbours agree which side is outside.
///
/// Faces that hang together across edges of two faces are a sheet; they turn until they run
/// opposite ways along those edges. Sheets that end at edges of more faces turn as a whole, until
/// as many faces run one way along such an edge as the other, or one more, as far as possible:
/// solids that share edges or faces get their insides back. Where that leaves a choice, the larger
/// volume decides. What so hangs together is a group. If it did not agree before, it then looks
/// outwards where none of its edges has one face only, and the way most faces did otherwise. A
/// group that agreed is left alone, inside out or not.
/// Volumes are in doubles. O(n log n); deterministic.
#pragma once

#include "tm/mesh/mesh.h"

namespace transformesh {

/// Equal vertices are one index. Returns the number of faces turned. Throws InputError, naming the
/// place, where a sheet has one side only.
std::size_t orient_faces(Mesh& mesh);

}  // namespace transformesh
