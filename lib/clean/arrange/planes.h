/// The planes in which faces that meet are cut: coplanar faces that meet are cut together (paper
/// 3.2.3). Cost: O(n + k) for k pairs. Exact; deterministic.
#pragma once

#include <span>
#include <vector>

#include "clean/intersect/contacts.h"

namespace transformesh {

/// Faces that are cut together, usually a single one.
struct Plane {
  std::span<const Index> faces;              ///< ascending; of copies only the first
  std::span<const Meeting* const> meetings;  ///< of these with faces in other planes
};

class Planes {
 public:
  /// Keeps a reference to the meetings.
  Planes(const WeldedMesh& welded, const std::vector<Meeting>& meetings);
  Planes(const WeldedMesh& welded, std::vector<Meeting>&& meetings) = delete;

  /// In the order of their first faces.
  std::size_t size() const { return face_offsets_.size() - 1; }
  Plane operator[](std::size_t plane) const {
    return {{faces_.data() + face_offsets_[plane], faces_.data() + face_offsets_[plane + 1]},
            {meetings_.data() + meeting_offsets_[plane],
             meetings_.data() + meeting_offsets_[plane + 1]}};
  }
  /// The plane of a face; no_index for one that is whole.
  Index plane_of(Index face) const { return plane_of_[face]; }
  bool is_whole(Index face) const { return plane_of_[face] == no_index; }

 private:
  void number_planes(const WeldedMesh& welded);
  void file_faces(const WeldedMesh& welded);
  void file_meetings();

  const std::vector<Meeting>& all_meetings_;
  std::vector<Index> plane_of_;
  std::size_t count_ = 0;
  std::vector<Index> face_offsets_, faces_;
  std::vector<Index> meeting_offsets_;
  std::vector<const Meeting*> meetings_;
};

}  // namespace transformesh
