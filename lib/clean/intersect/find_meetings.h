/// Finds the pairs of faces of a welded mesh that intersect, with their contacts (contacts.h).
#pragma once

#include <cstddef>
#include <vector>

#include "transformesh/control.h"

namespace transformesh {

struct Meeting;
struct WeldedMesh;

/// Finds what find_intersections() of intersect.h finds. The first of several equal faces stands
/// for its copies: pairs of copies are not listed.
std::vector<Meeting> find_meetings(const WeldedMesh& welded, const Progress& progress);

/// Returns the number of pairs of faces if every copy counts.
std::size_t count_pairs(const WeldedMesh& welded, const std::vector<Meeting>& meetings);

}  // namespace transformesh
