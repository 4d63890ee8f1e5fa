/// Groups faces that meet and are coplanar; each group is cut together in one plane (paper 3.2.3).
/// Cost: close to O(n + k) for n faces and k pairs. Exact; deterministic.
#pragma once

#include <span>
#include <vector>

#include "clean/intersect/contacts.h"
#include "support/raw_vector.h"

namespace transformesh {

/// Faces that are cut together, usually a single face.
struct Plane {
  /// Ascending; of several faces with the same three points only the first.
  std::span<const Index> faces;
  /// Intersections of these faces with faces of other planes.
  std::span<const Meeting* const> meetings;
};

class Planes {
 public:
  /// Keeps a reference to `meetings`.
  Planes(const WeldedMesh& welded, const std::vector<Meeting>& meetings);
  Planes(const WeldedMesh& welded, std::vector<Meeting>&& meetings) = delete;

  /// Returns the number of planes. Planes are sorted by their first faces.
  std::size_t size() const { return face_offsets_.size() - 1; }
  Plane operator[](std::size_t plane) const {
    return {{faces_.data() + face_offsets_[plane], faces_.data() + face_offsets_[plane + 1]},
            {meetings_.data() + meeting_offsets_[plane],
             meetings_.data() + meeting_offsets_[plane + 1]}};
  }
  /// Returns the index of the plane of a face, or no_index if the face has no intersections and
  /// stays whole.
  Index plane_of(Index face) const { return plane_of_[face]; }
  bool is_whole(Index face) const { return plane_of_[face] == no_index; }
  std::size_t whole_faces() const { return plane_of_.size() - cut_faces_.size(); }

 private:
  void find_cut_faces(const WeldedMesh& welded);
  void number_planes(const WeldedMesh& welded);
  void file_faces(const WeldedMesh& welded);
  void file_meetings();

  const std::vector<Meeting>& all_meetings_;
  std::vector<Index> plane_of_;
  RawVector<Index> cut_faces_;  ///< faces that are cut, ascending
  std::size_t count_ = 0;
  std::vector<Index> face_offsets_, faces_;
  std::vector<Index> meeting_offsets_;
  std::vector<const Meeting*> meetings_;
};

}  // namespace transformesh
