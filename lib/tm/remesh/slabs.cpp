#include "tm/remesh/slabs.h"

#include <algorithm>
#include <optional>

#include "tm/support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t fewest_slabs = 4;
constexpr std::size_t most_slabs = 64;
constexpr std::size_t least_vertices = 1024;  ///< in a slab
constexpr std::size_t bins = 2048;

/// How many living vertices there are along the longest side of the box around them.
struct Histogram {
  Eigen::Index axis = 0;
  double origin = 0;
  double width = 0;  ///< of a bin; 0 where all are in one place
  std::vector<std::size_t> counts = std::vector<std::size_t>(bins, 0);
  std::size_t total = 0;

  explicit Histogram(const EditableMesh& mesh) {
    Vec3 low = Vec3::Constant(HUGE_VAL);
    Vec3 high = -low;
    for (Index v = 0; v < mesh.vertex_slots(); ++v) {
      if (!mesh.has_vertex(v)) continue;
      low = low.cwiseMin(mesh.position(v));
      high = high.cwiseMax(mesh.position(v));
      ++total;
    }
    const double side = total == 0 ? 0 : (high - low).maxCoeff(&axis);
    origin = low[axis];
    width = side / bins;
    if (!(width > 0)) return;
    for (Index v = 0; v < mesh.vertex_slots(); ++v)
      if (mesh.has_vertex(v)) ++counts[bin_of(mesh.position(v)[axis])];
  }

  std::size_t bin_of(double coordinate) const {
    return std::min(bins - 1, static_cast<std::size_t>((coordinate - origin) / width));
  }

  /// Planes between that many slabs with about as many vertices each; nothing where one comes out
  /// too thin.
  std::optional<std::vector<double>> cuts(std::size_t slabs, double least_thickness) const {
    std::vector<double> result;
    std::size_t below = 0;
    for (std::size_t bin = 0; bin < bins && result.size() + 1 < slabs; ++bin) {
      below += counts[bin];
      if (below * slabs < total * (result.size() + 1)) continue;
      const double cut = origin + static_cast<double>(bin + 1) * width;
      if (!result.empty() && cut - result.back() < least_thickness) return std::nullopt;
      result.push_back(cut);
    }
    if (result.size() + 1 < slabs) return std::nullopt;
    return result;
  }
};

}  // namespace

Slabs::Slabs(const EditableMesh& mesh, double least_thickness) {
  const Histogram histogram(mesh);
  for (std::size_t count = fewest_slabs; histogram.width > 0 && count <= most_slabs; count *= 2) {
    if (histogram.total < count * least_vertices) break;
    const auto cuts = histogram.cuts(count, least_thickness);
    if (!cuts) break;
    slabs_.assign(count, {histogram.axis});
    for (std::size_t i = 0; i + 1 < count; ++i) slabs_[i].high = slabs_[i + 1].low = (*cuts)[i];
  }
  sort_vertices(mesh);
}

Slabs::Slabs(const EditableMesh& mesh) { sort_vertices(mesh); }

void Slabs::sort_vertices(const EditableMesh& mesh) {
  vertices_.resize(slabs_.size());
  of_vertex_.assign(mesh.vertex_slots(), 0);
  const auto is_below = [&](const MeshSlab& slab, double along) { return slab.high <= along; };
  for (Index v = 0; v < mesh.vertex_slots(); ++v) {
    if (!mesh.has_vertex(v)) continue;
    const double along = mesh.position(v)[slabs_[0].axis];
    const auto slab = std::lower_bound(slabs_.begin(), slabs_.end() - 1, along, is_below);
    of_vertex_[v] = static_cast<std::uint8_t>(slab - slabs_.begin());
    vertices_[of_vertex_[v]].push_back(v);
  }
}

void Slabs::for_each(const std::function<void(std::size_t slab)>& edit,
                     const std::function<void(std::size_t slab)>& finish) const {
  for (std::size_t parity = 0; parity < std::min<std::size_t>(2, size()); ++parity) {
    parallel_for((size() + 1 - parity) / 2, 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) edit(2 * i + parity);
    });
    for (std::size_t slab = parity; slab < size(); slab += 2) finish(slab);
  }
}

}  // namespace transformesh
