#include "clean/rounding/intersection_cache.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <string_view>
#include <unordered_map>

namespace transformesh {
namespace {

// Hashed by their bytes; a zero of the other sign makes another one, which is tested again.
struct TriangleHash {
  std::size_t operator()(const Triangle& t) const {
    std::array<char, 9 * sizeof(double)> bytes;
    for (std::size_t i = 0; i < 3; ++i)
      std::memcpy(bytes.data() + 3 * sizeof(double) * i, t[i].data(), 3 * sizeof(double));
    return std::hash<std::string_view>()({bytes.data(), bytes.size()});
  }
};

constexpr Index several = no_index;

// Which of the triangles each of them is, but of those that are there twice.
std::unordered_map<Triangle, Index, TriangleHash> number(const std::vector<Triangle>& triangles) {
  std::unordered_map<Triangle, Index, TriangleHash> numbers;
  for (Index i = 0; i < triangles.size(); ++i) {
    const auto [at, is_first] = numbers.emplace(triangles[i], i);
    if (!is_first) at->second = several;
  }
  return numbers;
}

}  // namespace

void IntersectionCache::begin(const Mesh& mesh) {
  before_.assign(mesh.faces.size(), no_index);
  if (triangles_.empty()) return;
  const auto numbers = number(triangles_);
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const auto at = numbers.find(triangle_of(mesh, f));
    if (at != numbers.end()) before_[f] = at->second;
  }
}

std::optional<bool> IntersectionCache::cross(Index f, Index g) const {
  const auto [first, second] = std::minmax(before_[f], before_[g]);
  if (second == no_index || first == second) return std::nullopt;
  if (!is_new_[first] && !is_new_[second]) return std::nullopt;
  return std::binary_search(intersections_.begin(), intersections_.end(), std::pair(first, second));
}

void IntersectionCache::end(const Mesh& mesh, std::vector<char> is_new,
                            std::vector<FacePair> intersections) {
  triangles_.clear();
  if (intersections.empty()) return;  // as a rule that was the last search
  for (Index f = 0; f < mesh.faces.size(); ++f) triangles_.push_back(triangle_of(mesh, f));
  is_new_ = std::move(is_new);
  intersections_ = std::move(intersections);
}

}  // namespace transformesh
