#include "clean/arrange/planes.h"

#include <numeric>
#include <optional>

#include "mesh/disjoint_sets.h"
#include "support/numbered_selection.h"

namespace transformesh {
namespace {

/// Groups items by bucket (counting sort). `for_each` must call its argument with the bucket and
/// the value of each item. This function calls `for_each` twice; the order of items must be the
/// same.
template <class Item, class ForEach>
void file(std::size_t buckets, const ForEach& for_each, std::vector<Index>& offsets,
          std::vector<Item>& items) {
  offsets.assign(buckets + 1, 0);
  for_each([&](Index bucket, const Item&) { ++offsets[bucket + 1]; });
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  items.resize(offsets.back());
  std::vector<Index> next(offsets.begin(), offsets.end() - 1);
  for_each([&](Index bucket, const Item& item) { items[next[bucket]++] = item; });
}

}  // namespace

Planes::Planes(const WeldedMesh& welded, const std::vector<Meeting>& meetings)
    : all_meetings_(meetings), plane_of_(welded.faces.size(), no_index) {
  find_cut_faces(welded);
  number_planes(welded);
  file_faces(welded);
  file_meetings();
}

// Lists the faces that are cut, ascending: faces that intersect another face, and faces with the
// same three points as another face.
void Planes::find_cut_faces(const WeldedMesh& welded) {
  std::vector<char> is_cut(welded.faces.size(), 0);
  for (const Meeting& meeting : all_meetings_) is_cut[meeting.first] = is_cut[meeting.second] = 1;
  for (Index f = 0; welded.has_copies && f < welded.faces.size(); ++f) {
    const Index first = welded.first_copy[f];
    if (first != f) is_cut[first] = is_cut[f] = 1;
  }
  cut_faces_ =
      NumberedSelection(is_cut.size(), [&](std::size_t f) { return is_cut[f] != 0; }).list();
}

// Numbers the sets of coplanar faces that meet. The root of each set is its least face; hence
// planes are numbered in the order of their first faces.
void Planes::number_planes(const WeldedMesh& welded) {
  std::optional<DisjointSets> sets;
  for (const Meeting& meeting : all_meetings_) {
    if (!meeting.contacts.coplanar) continue;
    if (!sets) sets.emplace(welded.faces.size());
    sets->join(meeting.first, meeting.second);
  }
  for (const Index f : cut_faces_) {
    const bool is_copy = welded.first_copy[f] != f;
    const Index first = is_copy ? welded.first_copy[f] : sets ? sets->find(f) : f;
    plane_of_[f] = first == f ? static_cast<Index>(count_++) : plane_of_[first];
  }
}

void Planes::file_faces(const WeldedMesh& welded) {
  const auto for_each = [&](const auto& visit) {
    for (const Index f : cut_faces_)
      if (welded.first_copy[f] == f) visit(plane_of_[f], f);
  };
  file(count_, for_each, face_offsets_, faces_);
}

void Planes::file_meetings() {
  const auto for_each = [&](const auto& visit) {
    for (const Meeting& meeting : all_meetings_) {
      if (meeting.contacts.coplanar) continue;
      visit(plane_of_[meeting.first], &meeting);
      visit(plane_of_[meeting.second], &meeting);
    }
  };
  file(count_, for_each, meeting_offsets_, meetings_);
}

}  // namespace transformesh
