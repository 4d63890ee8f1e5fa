#include "tm/remesh/split.h"

#include <cmath>

#include "tm/remesh/edge_queue.h"

namespace transformesh {
namespace {

class Splitter {
 public:
  Splitter(EditableMesh& mesh, double max_edge, bool keep_border)
      : mesh_(mesh), limit_(max_edge * max_edge), keep_border_(keep_border) {}

  std::size_t run(const Progress& progress) {
    for (Index h = 0; h < mesh_.halfedge_slots(); ++h) {
      if (mesh_.is_edge(h)) push(h);
    }
    const double first = static_cast<double>(queue_.size());
    for (double tried = 0; !queue_.empty(); ++tried) {
      if (std::fmod(tried, 4096) == 0) progress("split", tried / (tried + first));
      const QueuedEdge edge = queue_.top();
      queue_.pop();
      if (edge.is_current(mesh_)) split(edge.halfedge);
    }
    return splits_;
  }

 private:
  void push(Index halfedge) {
    if (mesh_.scaled_squared_length(halfedge) <= limit_) return;
    if (keep_border_ && mesh_.is_border(halfedge)) return;
    queue_.emplace(mesh_, halfedge);
  }

  void split(Index halfedge) {
    const Vec3& source = mesh_.position(mesh_.source(halfedge));
    const Vec3& target = mesh_.position(mesh_.target(halfedge));
    const Vec3 middle = mesh_.rounded(0.5 * source + 0.5 * target);
    if (middle == source || middle == target) return;
    const Index vertex = mesh_.split(halfedge, middle);
    ++splits_;

    // the edges at the new vertex, and those around it, some of which have a new name
    mesh_.for_each_outgoing(vertex, [&](Index outgoing) {
      push(outgoing);
      push(next_halfedge(outgoing));
      if (mesh_.is_border(previous_halfedge(outgoing))) push(previous_halfedge(outgoing));
    });
  }

  EditableMesh& mesh_;
  double limit_;
  bool keep_border_;
  EdgeQueue<LongerFirst> queue_;
  std::size_t splits_ = 0;
};

}  // namespace

std::size_t split_long_edges(EditableMesh& mesh, double max_edge, bool keep_border,
                             const Progress& progress) {
  return Splitter(mesh, max_edge, keep_border).run(progress);
}

}  // namespace transformesh
