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
  constexpr double most_nodes = 1e15;  // Numbers of edges must be below 2^64.
  NodeGrid grid{box.min(), spacing, {}};
  double count = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double blocks =
        std::ceil((box.max()[axis] - box.min()[axis]) / (spacing * static_cast<double>(side))) + 1;
    count *= blocks * static_cast<double>(side);
    if (!(count < most_nodes)) throw UsageError("the cells are too small for a box of this size");
    grid.nodes[static_cast<std::size_t>(axis)] = static_cast<std::size_t>(blocks) * side;
  }
  return grid;
}

/// Collects the blocks near the surface of a view.
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
  // Adds the blocks that the cube around a point meets.
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

/// Returns the mean distance of a point from the surfaces, truncated at `reach`.
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

/// Values of a block and of the first nodes of the blocks behind it.
class BlockCubes {
 public:
  BlockCubes(const DistanceBlocks& blocks, std::size_t block)
      : grid_(blocks.grid), start_(site_of(blocks.keys[block], block_counts(blocks.grid))) {
    for (std::size_t& coordinate : start_) coordinate *= side;
    for (std::size_t z = 0; z <= side; ++z)
      for (std::size_t y = 0; y <= side; ++y)
        for (std::size_t x = 0; x <= side; ++x) {
          const bool is_own = x < side && y < side && z < side;
          values_.push_back(
              is_own ? blocks.values[block * DistanceBlocks::size +
                                     number_of({x, y, z}, {side, side, side})]
                     : blocks.value_or_unknown({start_[0] + x, start_[1] + y, start_[2] + z}));
        }
  }

  void cut(std::vector<EdgeKeyFace>& faces) const {
    for (std::size_t z = 0; z < side; ++z)
      for (std::size_t y = 0; y < side; ++y)
        for (std::size_t x = 0; x < side; ++x) cut_cube(cube_at(x, y, z), faces);
  }

 private:
  GridCube cube_at(std::size_t x, std::size_t y, std::size_t z) const {
    GridCube cube;
    for (unsigned corner = 0; corner < 8; ++corner) {
      const Site site{x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2)};
      cube.values[corner] = values_[number_of(site, {side + 1, side + 1, side + 1})];
      cube.nodes[corner] =
          grid_.index(start_[0] + site[0], start_[1] + site[1], start_[2] + site[2]);
    }
    return cube;
  }

  const NodeGrid& grid_;
  Site start_;
  std::vector<float> values_;
};

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
  const Site counts = block_counts(blocks.grid);
  parallel_for(blocks.keys.size(), 16, [&](std::size_t first, std::size_t last) {
    for (std::size_t block = first; block < last; ++block) {
      const Site at = site_of(blocks.keys[block], counts);
      for (std::size_t i = 0; i < DistanceBlocks::size; ++i) {
        const Site in = site_of(i, {side, side, side});
        const Vec3 point =
            blocks.grid.position(at[0] * side + in[0], at[1] * side + in[1], at[2] * side + in[2]);
        blocks.values[block * DistanceBlocks::size + i] =
            mean_distance(point, reach, options.least_weight, surfaces);
      }
    }
  });
  return blocks;
}

Mesh march_blocks(const DistanceBlocks& blocks) {
  std::vector<std::vector<EdgeKeyFace>> of_block(blocks.keys.size());
  parallel_for(blocks.keys.size(), 16, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) BlockCubes(blocks, i).cut(of_block[i]);
  });
  std::vector<EdgeKeyFace> faces;
  for (const auto& some : of_block) faces.insert(faces.end(), some.begin(), some.end());
  return mesh_of_cut_edges(blocks.grid, faces, [&](std::size_t node) {
    return blocks.value_or_unknown(site_of(node, blocks.grid.nodes));
  });
}

}  // namespace transformesh
