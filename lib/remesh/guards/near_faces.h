/// The two kinds of surfaces for TriangleCover. NearCandidates tests each of a few faces; NearInput
/// searches all faces of a mesh in a tree.
#pragma once

#include <algorithm>
#include <vector>

#include "geometry/search/closest_point.h"
#include "remesh/guards/face_tree.h"
#include "remesh/guards/near_triangle.h"
#include "remesh/guards/triangle_cover.h"

namespace transformesh {

struct NearCandidate {
  Index face;
  NearTriangle triangle;
};

/// A few faces, as a surface for TriangleCover. used() lists the faces that cover a part of the
/// triangle.
class NearCandidates {
 public:
  NearCandidates(const std::vector<NearCandidate>& all, double limit) : all_(all), limit_(limit) {}
  double limit() const { return limit_; }
  double squared_distance(const Vec3& point, Index i) const {
    return all_[i].triangle.squared_distance(point);
  }
  Index nearest(const Vec3& point, Index /*hint*/) const {
    Index best = no_index;
    double least = limit_;
    for (Index i = 0; i < all_.size(); ++i) {
      const double squared = squared_distance(point, i);
      if (!(best == no_index ? squared <= least : squared < least)) continue;
      best = i;
      least = squared;
    }
    return best;
  }
  Index near_all(const CoverTriangle& corners) {
    for (Index i = 0; i < all_.size(); ++i) {
      if (!(squared_distance(corners[0].point, i) <= limit_ &&
            squared_distance(corners[1].point, i) <= limit_ &&
            squared_distance(corners[2].point, i) <= limit_))
        continue;
      if (std::find(used_.begin(), used_.end(), i) == used_.end()) used_.push_back(i);
      return i;
    }
    return no_index;
  }
  const std::vector<Index>& used() const { return used_; }

 private:
  const std::vector<NearCandidate>& all_;
  double limit_;
  std::vector<Index> used_;
};

/// All faces of the input, as a surface for TriangleCover.
class NearInput {
 public:
  /// If `tree` is not null, it is searched instead of `query`, with the same results.
  NearInput(const Mesh& input, const ClosestPointQuery& query, const FaceTree* tree,
            double distance)
      : input_(input),
        query_(query),
        tree_(tree),
        distance_(distance),
        limit_(distance * distance) {}
  double limit() const { return limit_; }
  double squared_distance(const Vec3& point, Index face) const {
    return NearTriangle(triangle_of(input_, face)).squared_distance(point);
  }
  Index nearest(const Vec3& point, Index hint) const {
    const Index face = tree_ != nullptr ? tree_->closest_face_within(point, distance_, hint)
                                        : query_.closest_face_within(point, distance_, hint);
    return face != no_index && squared_distance(point, face) <= limit_ ? face : no_index;
  }
  Index near_all(const CoverTriangle& corners) const {
    for (const CoverCorner& corner : corners)
      if (is_near_all(corner.face, corners)) return corner.face;
    const Vec3 middle = (corners[0].point + corners[1].point + corners[2].point) / 3;
    const Index face = nearest(middle, corners[0].face);
    return face != no_index && is_near_all(face, corners) ? face : no_index;
  }

 private:
  bool is_near_all(Index face, const CoverTriangle& corners) const {
    const NearTriangle triangle(triangle_of(input_, face));
    return triangle.squared_distance(corners[0].point) <= limit_ &&
           triangle.squared_distance(corners[1].point) <= limit_ &&
           triangle.squared_distance(corners[2].point) <= limit_;
  }

  const Mesh& input_;
  const ClosestPointQuery& query_;
  const FaceTree* tree_;
  double distance_;
  double limit_;
};

}  // namespace transformesh
