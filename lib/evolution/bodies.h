/// Evolves several bodies in one mesh without contact between them. A face column holds the number
/// of the body of each face. Each body is moved, cleaned and remeshed separately, and keeps a gap
/// from all others (limit_movements.h, RemeshOptions::keep_out). Bodies move one after the other,
/// in ascending order of their numbers, so that later bodies avoid the new positions of earlier
/// ones. Bodies may be nested. Cost of an iteration: O(n log n) per body, for n faces of all
/// bodies.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "transformesh/error_kind.h"
#include "transformesh/iteration.h"

namespace transformesh {

struct BodyContact {
  std::string column;  ///< face column that numbers the bodies
  double gap = 0;      ///< least allowed distance between two bodies, in input units; > 0
};

/// One body of a mesh. `vertices` maps each vertex of the body to the vertex of the whole mesh.
struct Body {
  Document document;
  double number = 0;
  std::vector<Index> vertices;
};

/// Returns the bodies in ascending order of their numbers. A vertex that faces of several bodies
/// share becomes a vertex of each of these bodies. Throws InputError if the mesh has no such face
/// column.
std::vector<Body> split_bodies(const Document& document, const std::string& column);

/// Replaces the mesh of `document` by all bodies, with their numbers in the face column. Comments
/// stay.
void join_bodies(const std::vector<Body>& bodies, const std::string& column, Document& document);

/// Cleans each body separately. Returns the sums of components and genus.
Topology clean_bodies(Document& document, const BodyContact& contact, bool outermost,
                      const Progress& progress);

struct BodiesResult {
  IterationResult iteration;  ///< sums over all bodies
  double remeshed = 0;        ///< change of volume by remeshing, of bodies that were not cleaned
};

/// Makes one iteration. `displacements` has an entry per vertex of the document. A body that
/// shrinks to nothing is removed if `may_vanish` returns true for the kind of the error. Throws
/// InputError, naming a body, if two bodies intersect.
BodiesResult iterate_bodies(Document& document, const std::vector<Vec3>& displacements,
                            const BodyContact& contact, const IterationOptions& options,
                            const std::function<bool(ErrorKind)>& may_vanish,
                            const Progress& progress);

}  // namespace transformesh
