#include "clean/exterior/surroundings.h"

#include <algorithm>

#include "geometry/search/float_box.h"

namespace transformesh {
namespace {

/// The axis along which faces are sorted for rays along another one.
int sorting_axis(int axis) { return (axis + 1) % 3; }

bool overlap_across(const Vec3& low, const Vec3& high, const Vec3& other_low,
                    const Vec3& other_high, int axis) {
  for (const int i : {(axis + 1) % 3, (axis + 2) % 3})
    if (high[i] < other_low[i] || low[i] > other_high[i]) return false;
  return true;
}

}  // namespace

FarFaces::FarFaces(const Mesh& mesh, const std::vector<bool>& left_out, const Vec3& low,
                   const Vec3& high)
    : mesh_(&mesh) {
  const auto for_each = [&](const auto& visit) {
    for (Index f = 0; f < mesh.faces.size(); ++f) {
      if (left_out[f]) continue;
      const Triangle t = triangle_of(mesh, f);
      const Vec3 least = t[0].cwiseMin(t[1]).cwiseMin(t[2]);
      const Vec3 most = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
      for (int axis = 0; axis < 3; ++axis)
        if (overlap_across(least, most, low, high, axis)) visit(axis, f, least, most);
    }
  };

  // Counted first, so that no list takes more than it holds.
  std::array<std::size_t, 3> counts{};
  for_each([&](int axis, Index, const Vec3&, const Vec3&) { ++counts[axis]; });
  for (std::size_t axis = 0; axis < 3; ++axis) along_[axis].reserve(counts[axis]);
  for_each([&](int axis, Index f, const Vec3& least, const Vec3& most) {
    const int along = sorting_axis(axis);
    along_[axis].push_back({float_below(least[along]), float_above(most[along]), f});
  });
  for (std::vector<Entry>& entries : along_) {
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
      return a.least != b.least ? a.least < b.least : a.face < b.face;
    });
    for (std::size_t i = 1; i < entries.size(); ++i)
      entries[i].most = std::max(entries[i].most, entries[i - 1].most);
  }
}

void FarFaces::visit_overlaps(const Vec3& low, const Vec3& high, int axis,
                              const std::function<bool(const Triangle&)>& visit) const {
  const std::vector<Entry>& entries = along_[axis];
  const double least = low[sorting_axis(axis)], most = high[sorting_axis(axis)];
  auto entry = std::partition_point(entries.begin(), entries.end(),
                                    [&](const Entry& e) { return e.most < least; });
  for (; entry != entries.end() && entry->least <= most; ++entry) {
    const Triangle t = triangle_of(*mesh_, entry->face);
    if ((t[0].cwiseMin(t[1]).cwiseMin(t[2]).array() <= high.array()).all() &&
        (t[0].cwiseMax(t[1]).cwiseMax(t[2]).array() >= low.array()).all() && !visit(t))
      return;
  }
}

}  // namespace transformesh
