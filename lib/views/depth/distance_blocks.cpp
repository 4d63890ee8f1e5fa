#include "views/depth/distance_blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/parallel.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

constexpr std::size_t side = DistanceBlocks::side;
constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
using Site = std::array<std::size_t, 3>;

Site site_of(std::size_t number, const Site& counts) {
  return {number % counts[0], number / counts[0] % counts[1], number / counts[0] / counts[1]};
}

std::size_t number_of(const Site& site, const Site& counts) {
  return (site[2] * counts[1] + site[1]) * counts[0] + site[0];
}

Site block_counts(const NodeGrid& grid) {
  return {grid.nodes[0] / side, grid.nodes[1] / side, grid.nodes[2] / side};
}

NodeGrid grid_around(const Box& box, double spacing) {
  // Limit of the number of nodes, because edge keys (grid_cubes.h) must be below 2^64.
  constexpr double most_nodes = 1e15;
  NodeGrid grid{box.min(), spacing, {}};
  double count = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double blocks =
        std::ceil((box.max()[axis] - box.min()[axis]) / (spacing * static_cast<double>(side))) + 1;
    count *= blocks * static_cast<double>(side);
    if (!(count < most_nodes))
      throw UsageError("the cells are too small for a box of this size: use larger cells");
    grid.nodes[static_cast<std::size_t>(axis)] = static_cast<std::size_t>(blocks) * side;
  }
  return grid;
}

/// Collects the blocks near the surface in a depth map.
class NearBlocks {
 public:
  NearBlocks(const NodeGrid& grid, const Box& box, double reach)
      : grid_(grid), counts_(block_counts(grid)), box_(box), reach_(reach) {}

  std::vector<std::uint64_t> of(const DepthSurface& surface) {
    const GrayImage& depth = surface.depth();
    for (int y = 0; y < depth.height; ++y)
      for (int x = 0; x < depth.width; ++x)
        if (depth.at(x, y) > 0) add_around(surface.point_of(x, y));
    sort();
    return std::move(keys_);
  }

 private:
  // Adds the blocks that intersect a cube around `point`, whose half side is `reach_`.
  void add_around(const Vec3& point) {
    if (!box_.contains(point)) return;
    Site low{}, high{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double at =
          point[static_cast<Eigen::Index>(axis)] - grid_.origin[static_cast<Eigen::Index>(axis)];
      const double block = grid_.spacing * static_cast<double>(side);
      low[axis] = static_cast<std::size_t>(std::max(0.0, (at - reach_) / block));
      high[axis] = std::min(counts_[axis] - 1, static_cast<std::size_t>((at + reach_) / block));
    }
    if (low == last_low_ && high == last_high_) return;
    last_low_ = low;
    last_high_ = high;
    for (std::size_t z = low[2]; z <= high[2]; ++z)
      for (std::size_t y = low[1]; y <= high[1]; ++y)
        for (std::size_t x = low[0]; x <= high[0]; ++x)
          keys_.push_back(number_of({x, y, z}, counts_));
  }

  void sort() {
    std::sort(keys_.begin(), keys_.end());
    keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
  }

  const NodeGrid& grid_;
  Site counts_;
  const Box& box_;
  double reach_;
  Site last_low_{1}, last_high_{};
  std::vector<std::uint64_t> keys_;
};

std::vector<std::uint64_t> blocks_near(const NodeGrid& grid, const Box& box, double reach,
                                       std::span<const DepthSurface> surfaces) {
  std::vector<std::vector<std::uint64_t>> of_view(surfaces.size());
  parallel_for(surfaces.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      of_view[i] = NearBlocks(grid, box, reach).of(surfaces[i]);
  });
  std::vector<std::uint64_t> keys;
  for (const auto& some : of_view) keys.insert(keys.end(), some.begin(), some.end());
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  return keys;
}

/// Returns the weighted mean distance of a point from the surfaces, truncated at `reach`; NaN if
/// the weight is below `least_weight`.
float mean_distance(const Vec3& point, double reach, double least_weight,
                    std::span<const DepthSurface> surfaces) {
  double sum = 0, weight = 0;
  for (const DepthSurface& surface : surfaces) {
    const std::optional<SurfaceDistance> found = surface.distance_of(point);
    if (!found || found->distance < -reach) continue;
    sum += found->cosine * std::min(found->distance, reach);
    weight += found->cosine;
  }
  return weight < least_weight ? unknown : static_cast<float>(sum / weight);
}

Site first_node(const DistanceBlocks& blocks, std::size_t block) {
  const Site at = site_of(blocks.keys[block], block_counts(blocks.grid));
  return {at[0] * side, at[1] * side, at[2] * side};
}

/// Number of nodes along the side of a block that is extended by one node at both ends.
constexpr std::size_t side_around = side + 2;

/// Returns the index of a node in the result of values_around(). `site` holds the indices of the
/// node along x, y and z, relative to the first node of the block. An index of -1 is allowed:
/// unsigned addition wraps around.
std::size_t number_around(const Site& site) {
  return number_of({site[0] + 1, site[1] + 1, site[2] + 1},
                   {side_around, side_around, side_around});
}

/// Returns the values of a block that is extended by one node on all sides.
std::vector<float> values_around(const DistanceBlocks& blocks, std::size_t block) {
  const Site start = first_node(blocks, block);
  std::vector<float> values;
  values.reserve(side_around * side_around * side_around);
  // The index -1 wraps around to a large number, which is outside of the grid, so that its value is
  // unknown.
  for (std::size_t z = 0; z < side_around; ++z)
    for (std::size_t y = 0; y < side_around; ++y)
      for (std::size_t x = 0; x < side_around; ++x)
        values.push_back(
            blocks.value_or_unknown({start[0] + x - 1, start[1] + y - 1, start[2] + z - 1}));
  return values;
}

/// Returns the mean of the known values among the 3x3x3 nodes whose middle is `at`.
float mean_around(std::span<const float> values, const Site& at) {
  float sum = 0, count = 0;
  for (std::size_t k = 0; k < 27; ++k) {
    const Site step = site_of(k, {3, 3, 3});
    const float value =
        values[number_around({at[0] + step[0] - 1, at[1] + step[1] - 1, at[2] + step[2] - 1})];
    if (std::isnan(value)) continue;
    sum += value;
    ++count;
  }
  return sum / count;
}

/// Replaces each known value by mean_around().
void smooth(DistanceBlocks& blocks) {
  std::vector<float> values(blocks.values.size());
  parallel_for(blocks.keys.size(), 16, [&](std::size_t first, std::size_t last) {
    for (std::size_t block = first; block < last; ++block) {
      const std::vector<float> around = values_around(blocks, block);
      for (std::size_t i = 0; i < DistanceBlocks::size; ++i) {
        const std::size_t node = block * DistanceBlocks::size + i;
        const bool is_known = !std::isnan(blocks.values[node]);
        values[node] = is_known ? mean_around(around, site_of(i, {side, side, side})) : unknown;
      }
    }
  });
  blocks.values = std::move(values);
}

GridCube cube_at(const NodeGrid& grid, const Site& start, std::span<const float> values,
                 const Site& at) {
  GridCube cube;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Site site{at[0] + (corner & 1), at[1] + (corner >> 1 & 1), at[2] + (corner >> 2)};
    cube.values[corner] = values[number_around(site)];
    cube.nodes[corner] = grid.index(start[0] + site[0], start[1] + site[1], start[2] + site[2]);
  }
  return cube;
}

std::vector<EdgeKeyFace> faces_in(const DistanceBlocks& blocks, std::size_t block) {
  const std::vector<float> values = values_around(blocks, block);
  const Site start = first_node(blocks, block);
  std::vector<EdgeKeyFace> faces;
  for (std::size_t i = 0; i < DistanceBlocks::size; ++i)
    cut_cube(cube_at(blocks.grid, start, values, site_of(i, {side, side, side})), faces);
  return faces;
}

}  // namespace

float DistanceBlocks::value_or_unknown(const std::array<std::size_t, 3>& node) const {
  const Site counts = block_counts(grid);
  const Site block{node[0] / side, node[1] / side, node[2] / side};
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (block[axis] >= counts[axis]) return unknown;
  const std::uint64_t key = number_of(block, counts);
  const auto at = std::lower_bound(keys.begin(), keys.end(), key);
  if (at == keys.end() || *at != key) return unknown;
  return values[static_cast<std::size_t>(at - keys.begin()) * size +
                number_of({node[0] % side, node[1] % side, node[2] % side}, {side, side, side})];
}

DistanceBlocks fuse_distances(const Box& box, double spacing,
                              std::span<const DepthSurface> surfaces,
                              const DistanceBlocksOptions& options, const Progress& progress) {
  progress("fuse depths");
  DistanceBlocks blocks;
  blocks.grid = grid_around(box, spacing);
  const double reach = options.truncation * spacing;
  blocks.keys = blocks_near(blocks.grid, box, reach, surfaces);
  blocks.values.resize(blocks.keys.size() * DistanceBlocks::size);
  parallel_for(blocks.keys.size(), 16, [&](std::size_t first, std::size_t last) {
    for (std::size_t block = first; block < last; ++block) {
      const Site start = first_node(blocks, block);
      for (std::size_t i = 0; i < DistanceBlocks::size; ++i) {
        const Site in = site_of(i, {side, side, side});
        const Vec3 point =
            blocks.grid.position(start[0] + in[0], start[1] + in[1], start[2] + in[2]);
        blocks.values[block * DistanceBlocks::size + i] =
            box.contains(point) ? mean_distance(point, reach, options.least_weight, surfaces)
                                : unknown;
      }
    }
  });
  for (int round = 0; round < options.smoothing; ++round) smooth(blocks);
  return blocks;
}

Mesh march_blocks(const DistanceBlocks& blocks) {
  std::vector<std::vector<EdgeKeyFace>> of_block(blocks.keys.size());
  parallel_for(blocks.keys.size(), 16, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) of_block[i] = faces_in(blocks, i);
  });
  std::vector<EdgeKeyFace> faces;
  for (const auto& some : of_block) faces.insert(faces.end(), some.begin(), some.end());
  return mesh_of_cut_edges(blocks.grid, faces, [&](std::size_t node) {
    return blocks.value_or_unknown(site_of(node, blocks.grid.nodes));
  });
}

}  // namespace transformesh
