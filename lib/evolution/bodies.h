/// Several bodies in one mesh, told apart by a face column, which evolve together and never meet.
/// Each is moved, cleaned and remeshed by itself, and kept away from all others by a gap
/// (limit_movements.h, RemeshOptions::keep_out). Bodies move one after the other in ascending order
/// of their numbers, so that the later ones keep away from where the earlier ones have moved.
/// Bodies may be nested. Cost of an iteration: O(n log n) for each body, n being the faces of all.
#pragma once

#include <string>
#include <vector>

#include "transformesh/iteration.h"

namespace transformesh {

struct BodyContact {
  std::string column;  ///< face column that numbers the bodies
  double gap = 0;      ///< least distance of two bodies; input units; > 0
};

/// One body, and the vertex of the whole mesh for each of its vertices.
struct Body {
  Document document;
  double number = 0;
  std::vector<Index> vertices;
};

/// Returns the bodies in ascending order of their numbers. A vertex of faces of several bodies
/// becomes a vertex of each. Throws InputError if there is no such face column.
std::vector<Body> split_bodies(const Document& document, const std::string& column);

/// Joins bodies to one mesh with their numbers in the column. Comments are those of `document`.
void join_bodies(const std::vector<Body>& bodies, const std::string& column, Document& document);

/// Cleans each body by itself. Returns the sums of components and genus.
Topology clean_bodies(Document& document, const BodyContact& contact, bool outermost,
                      const Progress& progress);

/// Makes one iteration; `displacements` are those of the vertices of all bodies. Throws InputError
/// if two bodies intersect, with the numbers of the bodies.
IterationResult iterate_bodies(Document& document, const std::vector<Vec3>& displacements,
                               const BodyContact& contact, const IterationOptions& options,
                               const Progress& progress);

}  // namespace transformesh
