#include "tm/clean/intersect/any_intersection.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "tm/clean/intersect/intersect.h"
#include "tm/support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t few_faces = 20000;  ///< are all searched at once
constexpr std::size_t sampled_faces = 1024;
constexpr std::size_t things_per_task = 8192;
constexpr int axes = 3;
constexpr unsigned cells_per_axis = 128;
constexpr std::size_t many_cells = 64;  ///< a face in more is large, and may touch any other

using Cell = std::array<std::uint8_t, 4>;  ///< the last is not used

/// The cells around a face: those from low to high.
struct CellRange {
  Cell low, high;
  std::size_t size() const {
    std::size_t size = 1;
    for (int axis = 0; axis < axes; ++axis) size *= high[axis] - low[axis] + 1U;
    return size;
  }
};

/// A grid over a mesh, with the cell of each vertex.
class VertexCells {
 public:
  explicit VertexCells(const Mesh& mesh) : mesh_(mesh), cells_(mesh.positions.size()) {
    Vec3 low = mesh.positions[0], high = low;
    for (const Vec3& point : mesh.positions) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
    const double per_length = (cells_per_axis - 1) / (high - low).maxCoeff();
    is_usable_ = std::isfinite(per_length) && per_length > 0;
    if (!is_usable_) return;
    parallel_for(cells_.size(), things_per_task, [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v)
        for (int axis = 0; axis < axes; ++axis)
          cells_[v][axis] =
              static_cast<std::uint8_t>((mesh.positions[v][axis] - low[axis]) * per_length);
    });
  }

  /// Not where the mesh has no extent, or more than numbers hold.
  bool is_usable() const { return is_usable_; }

  CellRange around(Index face) const {
    const auto& [a, b, c] = mesh_.faces[face];
    CellRange range{cells_[a], cells_[a]};
    for (int axis = 0; axis < axes; ++axis)
      for (const Index vertex : {b, c}) {
        range.low[axis] = std::min(range.low[axis], cells_[vertex][axis]);
        range.high[axis] = std::max(range.high[axis], cells_[vertex][axis]);
      }
    return range;
  }

 private:
  const Mesh& mesh_;
  std::vector<Cell> cells_;
  bool is_usable_ = false;
};

/// Cells that are marked.
class MarkedCells {
 public:
  void mark(const CellRange& range) {
    visit(range, [&](std::size_t row, std::uint64_t bits) {
      rows_[row] |= bits;
      return true;
    });
  }

  bool has_any(const CellRange& range) const {
    bool found = false;
    visit(range, [&](std::size_t row, std::uint64_t bits) {
      found = (rows_[row] & bits) != 0;
      return !found;
    });
    return found;
  }

 private:
  static constexpr unsigned word = 64;

  // Calls visit(word, bits) for the words that hold the cells, until it returns false.
  template <class Visit>
  static void visit(const CellRange& range, const Visit& visit) {
    for (std::size_t x = range.low[0]; x <= range.high[0]; ++x)
      for (std::size_t y = range.low[1]; y <= range.high[1]; ++y)
        for (std::size_t z = range.low[2]; z <= range.high[2]; ++z)
          if (!visit(((x * cells_per_axis + y) * cells_per_axis + z) / word,
                     std::uint64_t{1} << z % word))
            return;
  }

  std::vector<std::uint64_t> rows_ =
      std::vector<std::uint64_t>(cells_per_axis * cells_per_axis * cells_per_axis / word, 0);
};

// By multiples of the golden section, which are spread evenly however many there are.
Index sampled_face(std::size_t i, std::size_t faces) {
  constexpr std::uint64_t golden_section = 0x9e3779b97f4a7c15ULL;  // of 2^64
  const auto share = static_cast<double>(i * golden_section) * 0x1p-64;
  return static_cast<Index>(
      std::min(share * static_cast<double>(faces), static_cast<double>(faces - 1)));
}

// The sampled faces and all that may touch one of them.
std::vector<Index> faces_near_samples(const Mesh& mesh, const VertexCells& cells) {
  MarkedCells marked;
  for (std::size_t i = 0; i < sampled_faces; ++i) {
    const CellRange range = cells.around(sampled_face(i, mesh.faces.size()));
    if (range.size() <= many_cells) marked.mark(range);
  }
  std::vector<char> is_near(mesh.faces.size());
  parallel_for(mesh.faces.size(), things_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f) {
      const CellRange range = cells.around(static_cast<Index>(f));
      is_near[f] = range.size() > many_cells || marked.has_any(range) ? 1 : 0;
    }
  });
  std::vector<Index> result;
  for (std::size_t f = 0; f < is_near.size(); ++f)
    if (is_near[f]) result.push_back(static_cast<Index>(f));
  return result;
}

Mesh part_of(const Mesh& mesh, const std::vector<Index>& faces) {
  Mesh part;
  std::vector<Index> number(mesh.positions.size(), no_index);
  for (const Index f : faces) {
    Face face = mesh.faces[f];
    for (Index& vertex : face) {
      Index& known = number[vertex];
      if (known == no_index) {
        known = static_cast<Index>(part.positions.size());
        part.positions.push_back(mesh.positions[vertex]);
      }
      vertex = known;
    }
    part.faces.push_back(face);
  }
  return part;
}

bool samples_intersect(const Mesh& mesh) {
  const VertexCells cells(mesh);
  if (!cells.is_usable()) return false;
  const std::vector<Index> faces = faces_near_samples(mesh, cells);
  // Where most are near, all may as well be searched.
  if (faces.size() > mesh.faces.size() / 4) return false;
  return !find_intersections(part_of(mesh, faces)).empty();
}

}  // namespace

bool has_intersections(const Mesh& mesh, const Progress& progress) {
  progress("intersect");
  if (mesh.faces.size() > few_faces && samples_intersect(mesh)) return true;
  return !find_intersections(mesh, progress).empty();
}

}  // namespace transformesh
