#include "views/depth/depth_fusion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "raster/camera.h"
#include "support/parallel.h"
#include "views/cameras/view.h"

namespace transformesh {
namespace {

/// Grid nodes per parallel task; affects time only.
constexpr std::size_t nodes_per_task = 1 << 14;
/// A grid node counts as unobserved if, averaged over neighboring nodes, at most this number of
/// views has a distance for it. Values of unobserved nodes are found by diffusion. With a larger
/// limit, diffusion replaces more measured values in regions with few depths.
constexpr float unheard = 0.5F;

/// One view's depth map with its projection. It shows whether a point in space is in front of the
/// visible surface (free) or behind it (solid).
struct Witness {
  Projection projection;
  const GrayImage* depths;

  /// Returns the depth of the surface at the pixel of the point, minus the depth of the point. The
  /// result is positive in front of the surface. Returns nothing if that pixel has no known depth.
  std::optional<double> free_way(const Vec3& point) const {
    const Vec3 q = projection.leftCols<3>() * point + projection.col(3);
    if (!(q.z() > 0)) return std::nullopt;
    const double x = std::floor(q.x() / q.z() + 0.5);
    const double y = std::floor(q.y() / q.z() + 0.5);
    if (!(x >= 0 && y >= 0 && x < depths->width && y < depths->height)) return std::nullopt;
    const float depth = depths->at(static_cast<int>(x), static_cast<int>(y));
    if (!(depth > 0)) return std::nullopt;
    return depth - q.z();
  }
};

/// For each node, the sum and the number of its distances from the surfaces in depth maps.
/// Distances are in units of the truncation.
struct Votes {
  std::vector<float> sum;
  std::vector<float> count;
};

class Fusion {
 public:
  Fusion(const ValueGrid& hull, std::span<const View> views, std::span<const DepthMap> maps,
         const DepthFusionOptions& options)
      : hull_(hull), options_(options), reach_(options.truncation * hull.spacing) {
    for (std::size_t i = 0; i < views.size(); ++i)
      witnesses_.push_back({views[i].camera.projection(), &maps[i].depth});
    votes_.sum.assign(hull.values.size(), 0);
    votes_.count.assign(hull.values.size(), 0);
  }

  ValueGrid run() {
    over_layers([this](std::size_t z) { vote(z); });
    for (int axis = 0; axis < 3; ++axis) {
      blur(votes_.sum, axis);
      blur(votes_.count, axis);
    }
    std::vector<float> means = means_of_votes();
    continue_into_unseen(means);
    ValueGrid opened = hull_;
    for (std::size_t i = 0; i < opened.values.size(); ++i)
      if (means[i] > -1)
        opened.values[i] = std::max(opened.values[i], means[i] * static_cast<float>(reach_));
    return opened;
  }

 private:
  void over_layers(const std::function<void(std::size_t)>& work) const {
    parallel_for(hull_.nodes[2], 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t z = first; z < last; ++z) work(z);
    });
  }
  std::vector<float> means_of_votes() const;
  bool is_unseen(std::size_t node) const {
    return hull_.values[node] < 0 && votes_.count[node] <= unheard;
  }
  std::vector<std::size_t> unseen_nodes() const;
  void continue_into_unseen(std::vector<float>& means) const;
  void vote(std::size_t z);
  void blur(std::vector<float>& values, int axis) const;

  const ValueGrid& hull_;
  DepthFusionOptions options_;
  double reach_;
  std::vector<Witness> witnesses_;
  Votes votes_;
};

// Returns the mean distance at each node inside the hull, in units of the truncation. The mean
// includes `prior` additional distances of -1, which mean solid. Nodes outside the hull get -1.
std::vector<float> Fusion::means_of_votes() const {
  const auto prior = static_cast<float>(options_.prior);
  std::vector<float> means(hull_.values.size(), -1.0F);
  for (std::size_t i = 0; i < means.size(); ++i)
    if (hull_.values[i] < 0) means[i] = (votes_.sum[i] - prior) / (votes_.count[i] + prior);
  return means;
}

/// Returns the indices of unobserved nodes that are not on the boundary of the grid.
std::vector<std::size_t> Fusion::unseen_nodes() const {
  std::vector<std::size_t> nodes;
  for (std::size_t z = 1; z + 1 < hull_.nodes[2]; ++z)
    for (std::size_t y = 1; y + 1 < hull_.nodes[1]; ++y)
      for (std::size_t x = 1; x + 1 < hull_.nodes[0]; ++x)
        if (is_unseen(hull_.index(x, y, z))) nodes.push_back(hull_.index(x, y, z));
  return nodes;
}

// Diffusion: repeatedly replaces the value of each unobserved node by the mean of its neighbors
// inside the hull.
void Fusion::continue_into_unseen(std::vector<float>& means) const {
  const std::vector<std::size_t> nodes = unseen_nodes();
  const std::array<std::size_t, 3> strides{1, hull_.nodes[0], hull_.nodes[0] * hull_.nodes[1]};
  std::vector<float> next(nodes.size());
  for (int round = 0; round < options_.rounds; ++round) {
    parallel_for(nodes.size(), nodes_per_task, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        float sum = 0;
        float count = 0;
        for (const std::size_t stride : strides) {
          for (const std::size_t neighbor : {nodes[i] - stride, nodes[i] + stride}) {
            if (!(hull_.values[neighbor] < 0)) continue;
            sum += means[neighbor];
            ++count;
          }
        }
        next[i] = count > 0 ? sum / count : -1;
      }
    });
    for (std::size_t i = 0; i < nodes.size(); ++i) means[nodes[i]] = next[i];
  }
}

void Fusion::vote(std::size_t z) {
  for (std::size_t y = 0; y < hull_.nodes[1]; ++y) {
    for (std::size_t x = 0; x < hull_.nodes[0]; ++x) {
      const std::size_t node = hull_.index(x, y, z);
      if (!(hull_.values[node] < 0)) continue;
      const Vec3 point = hull_.position(x, y, z);
      for (const Witness& witness : witnesses_) {
        const std::optional<double> way = witness.free_way(point);
        if (!way || *way < -reach_) continue;
        votes_.sum[node] += static_cast<float>(std::min(*way / reach_, 1.0));
        votes_.count[node] += 1;
      }
    }
  }
}

// Replaces the value of each node inside the hull by a mean along `axis`, over the nearest nodes
// that are inside the hull.
void Fusion::blur(std::vector<float>& values, int axis) const {
  std::vector<float> blurred(values.size(), 0);
  std::array<std::size_t, 3> strides{1, hull_.nodes[0], hull_.nodes[0] * hull_.nodes[1]};
  const std::size_t stride = strides[static_cast<std::size_t>(axis)];
  const auto reach = static_cast<std::ptrdiff_t>(options_.blur);
  over_layers([&](std::size_t z) {
    for (std::size_t y = 0; y < hull_.nodes[1]; ++y) {
      for (std::size_t x = 0; x < hull_.nodes[0]; ++x) {
        const std::size_t node = hull_.index(x, y, z);
        if (!(hull_.values[node] < 0)) continue;
        const std::array<std::size_t, 3> site{x, y, z};
        const auto at = static_cast<std::ptrdiff_t>(site[static_cast<std::size_t>(axis)]);
        const auto end =
            static_cast<std::ptrdiff_t>(hull_.nodes[static_cast<std::size_t>(axis)]) - 1;
        float sum = 0;
        int count = 0;
        for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(at - reach, 0);
             i <= std::min(at + reach, end); ++i) {
          const std::size_t other = node + static_cast<std::size_t>(i - at) * stride;
          if (!(hull_.values[other] < 0)) continue;
          sum += values[other];
          ++count;
        }
        blurred[node] = sum / static_cast<float>(count);
      }
    }
  });
  values = std::move(blurred);
}

}  // namespace

ValueGrid fuse_depths(const ValueGrid& hull, std::span<const View> views,
                      std::span<const DepthMap> maps, const DepthFusionOptions& options,
                      const Progress& progress) {
  progress("fuse depths");
  return Fusion(hull, views, maps, options).run();
}

}  // namespace transformesh
