/// Queues of edges, sorted by their lengths in units of the local size. Entries are not updated if
/// the mesh changes; is_current() tests whether an entry still describes an edge.
#pragma once

#include <queue>
#include <vector>

#include "remesh/halfedges/editable_mesh.h"

namespace transformesh {

struct QueuedEdge {
  double squared_length;
  Index halfedge;
  Index source;
  Index target;

  QueuedEdge(const EditableMesh& mesh, Index h)
      : squared_length(mesh.scaled_squared_length(h)),
        halfedge(h),
        source(mesh.source(h)),
        target(mesh.target(h)) {}
  bool is_current(const EditableMesh& mesh) const {
    return mesh.source(halfedge) == source && mesh.target(halfedge) == target &&
           mesh.scaled_squared_length(halfedge) == squared_length;
  }
};

struct ShorterFirst {
  bool operator()(const QueuedEdge& a, const QueuedEdge& b) const {
    if (a.squared_length != b.squared_length) return a.squared_length > b.squared_length;
    return a.halfedge > b.halfedge;
  }
};
struct LongerFirst {
  bool operator()(const QueuedEdge& a, const QueuedEdge& b) const {
    if (a.squared_length != b.squared_length) return a.squared_length < b.squared_length;
    return a.halfedge > b.halfedge;
  }
};
template <class Order>
using EdgeQueue = std::priority_queue<QueuedEdge, std::vector<QueuedEdge>, Order>;

}  // namespace transformesh
