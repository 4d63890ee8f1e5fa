/// Samples the implicit function of the visual hull, which hull.h defines, on a regular grid.
/// Extracts its zero set by marching tetrahedra.
///
/// The grid is processed in blocks of nodes. If a block is entirely outside of one silhouette, or
/// inside all silhouettes, one distance lookup per view suffices for all of its nodes. At the nodes
/// of other blocks, the function is computed one by one. O(views * (blocks + sampled nodes)) time;
/// 4 bytes per node.
#include "transformesh/hull.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "raster/camera.h"
#include "support/number.h"
#include "support/parallel.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "views/cameras/view.h"
#include "views/hull/contour_distance.h"
#include "views/hull/hull_values.h"
#include "views/hull/marching_tetrahedra.h"

namespace transformesh {
namespace {

constexpr double most_nodes = 1 << 28;  ///< largest number of grid nodes: 1 GiB of values
/// Side of a block, in nodes. Larger blocks are less often entirely inside or outside of
/// silhouettes; smaller blocks save fewer lookups.
constexpr std::size_t block_nodes = 8;
/// Upper bound of the error of interpolated distances from a contour, in pixels.
constexpr double distance_slack_px = 1;

/// One view with its silhouette. Projects points in space to the view, and looks up their distance
/// from the contour of the silhouette.
struct Carver {
  Projection projection;
  double focal_length = 1;
  PackableImage distances;

  struct Reading {
    double distance_px = 0;
    double depth = 0;
    bool is_known = false;
  };

  Reading read(const Vec3& point) const {
    const Vec3 q = projection.leftCols<3>() * point + projection.col(3);
    if (!(q.z() > 0)) return {};
    const float distance = distance_at(distances, q.x() / q.z(), q.y() / q.z());
    return {distance, q.z(), !std::isnan(distance)};
  }
};

std::vector<Carver> make_carvers(std::span<const View> views) {
  std::vector<const View*> usable;
  for (const View& view : views)
    if (!view.silhouette.empty()) usable.push_back(&view);
  if (usable.empty()) throw InputError("no view has a silhouette");
  std::vector<Carver> carvers(usable.size());
  parallel_for(usable.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const PinholeCamera& camera = usable[i]->camera;
      carvers[i] = {camera.projection(), camera.focal_length(),
                    signed_distance(usable[i]->silhouette)};
      if (usable[i]->silhouette.is_packed())
        carvers[i].distances.pack(PackableImage::Kind::distances);
    }
  });
  return carvers;
}

double field(const std::vector<Carver>& carvers, const Vec3& point) {
  double value = -std::numeric_limits<double>::infinity();
  for (const Carver& carver : carvers) {
    const Carver::Reading reading = carver.read(point);
    if (reading.is_known)
      value = std::max(value, reading.distance_px * reading.depth / carver.focal_length);
  }
  return value;
}

enum class Verdict { carved, kept, open };

/// Bounding rectangle of the image of a box in a view, in pixels.
struct Footprint {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
  bool is_before_camera = true;

  Footprint(const Projection& projection, const Box& box) {
    for (int corner = 0; corner < 8; ++corner) {
      Vec3 point;
      for (int axis = 0; axis < 3; ++axis)
        point[axis] = (corner >> axis & 1) != 0 ? box.max()[axis] : box.min()[axis];
      const Vec3 q = projection.leftCols<3>() * point + projection.col(3);
      is_before_camera = is_before_camera && q.z() > 0;
      low = low.cwiseMin(q.hnormalized());
      high = high.cwiseMax(q.hnormalized());
    }
  }

  double reach() const { return (high - low).norm() / 2; }
  bool is_in(const PackableImage& image) const {
    return low.minCoeff() >= -0.5 && high.x() <= image.width - 0.5 &&
           high.y() <= image.height - 0.5;
  }
  bool is_beside(const PackableImage& image) const {
    return high.x() < -0.5 || high.y() < -0.5 || low.x() > image.width - 0.5 ||
           low.y() > image.height - 0.5;
  }
};

/// Decides from one view whether a whole box is outside of its silhouette (carved) or inside
/// (kept), if possible. Distances from the contour are 1-Lipschitz in the image. The distance at
/// the center of the footprint therefore bounds all distances in the footprint.
Verdict verdict_of(const Carver& carver, const Box& box) {
  const Footprint footprint(carver.projection, box);
  if (!footprint.is_before_camera) return Verdict::open;
  if (footprint.is_beside(carver.distances)) return Verdict::kept;
  const Eigen::Vector2d middle = (footprint.low + footprint.high) / 2;
  const float distance = distance_at(carver.distances, middle.x(), middle.y());
  const double margin = footprint.reach() + distance_slack_px;
  if (distance < -margin) return Verdict::kept;
  if (distance > margin && footprint.is_in(carver.distances)) return Verdict::carved;
  return Verdict::open;
}

Verdict verdict_of(const std::vector<Carver>& carvers, const Box& box) {
  Verdict verdict = Verdict::kept;
  for (const Carver& carver : carvers) {
    const Verdict single = verdict_of(carver, box);
    if (single == Verdict::carved) return Verdict::carved;
    if (single == Verdict::open) verdict = Verdict::open;
  }
  return verdict;
}

/// Computes the implicit function of the visual hull (F in hull.h) at the nodes of a grid, block by
/// block.
class Sampler {
 public:
  Sampler(const std::vector<Carver>& carvers, ValueGrid& grid)
      : carvers_(carvers), grid_(grid), far_(static_cast<float>(4 * grid.spacing)) {
    for (int axis = 0; axis < 3; ++axis)
      blocks_[axis] = (grid.nodes[axis] + block_nodes - 1) / block_nodes;
  }

  void run(const Progress& progress) {
    grid_.values.assign(grid_.nodes[0] * grid_.nodes[1] * grid_.nodes[2], far_);
    for (std::size_t z = 0; z < blocks_[2]; ++z) {
      progress("carve", static_cast<double>(z) / static_cast<double>(blocks_[2]));
      parallel_for(blocks_[0] * blocks_[1], 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) fill({i % blocks_[0], i / blocks_[0], z});
      });
    }
  }

 private:
  using Site = std::array<std::size_t, 3>;

  Vec3 place(const Site& site) const { return grid_.position(site[0], site[1], site[2]); }

  void fill(const Site& block) {
    Site low, high;
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = block[axis] * block_nodes;
      high[axis] = std::min(low[axis] + block_nodes, grid_.nodes[axis]);
    }
    // The tested box also contains the layer of cells below the block along each axis. If the
    // verdict is carved or kept, the surface thus meets no grid edge that ends in the block from
    // below.
    const Vec3 cell = Vec3::Constant(grid_.spacing);
    const Verdict verdict = verdict_of(carvers_, Box{place(low) - cell, place(high)});
    if (verdict == Verdict::carved) return;  // run() has already set all nodes to outside
    for (std::size_t z = low[2]; z < high[2]; ++z)
      for (std::size_t y = low[1]; y < high[1]; ++y)
        for (std::size_t x = low[0]; x < high[0]; ++x) measure({x, y, z}, verdict);
  }

  void measure(const Site& site, Verdict verdict) {
    for (int axis = 0; axis < 3; ++axis)
      if (site[axis] == 0 || site[axis] + 1 == grid_.nodes[axis]) return;
    float value = -far_;
    if (verdict == Verdict::open)
      value = static_cast<float>(std::clamp<double>(field(carvers_, place(site)), -far_, far_));
    grid_.values[grid_.index(site[0], site[1], site[2])] = value;
  }

  const std::vector<Carver>& carvers_;
  ValueGrid& grid_;
  /// Values are clamped to [-far_, far_], because only the sign of farther values matters.
  float far_;
  Site blocks_{};
};

void check_hull_options(const HullOptions& options) {
  if (options.resolution < 4 || options.resolution > 4096)
    throw UsageError("the resolution of a hull must be between 4 and 4096");
  if (options.edge && !(*options.edge > 0)) throw UsageError("the cells of a hull need a size > 0");
  if (!(options.keep >= 0 && options.keep <= 1))
    throw UsageError("the share of components to keep must be between 0 and 1");
  if (options.box && !((options.box->max() - options.box->min()).minCoeff() > 0))
    throw UsageError(
        "the box is empty: each coordinate of its first corner must be less than that of its "
        "second corner");
}

/// Creates a grid around the box. All nodes on the boundary of the grid lie outside of the box.
ValueGrid make_grid(const Box& box, const HullOptions& options) {
  const Vec3 size = box.max() - box.min();
  ValueGrid grid;
  grid.spacing = options.edge.value_or(size.maxCoeff() / options.resolution);
  double count = 1;
  for (int axis = 0; axis < 3; ++axis) count *= std::ceil(size[axis] / grid.spacing) + 3;
  if (!(count <= most_nodes))
    throw UsageError("the cells of the hull are too small for a box of this size: it needs " +
                     significant(count, 3) +
                     " grid nodes, more than the maximum of 2^28; use larger cells");
  for (int axis = 0; axis < 3; ++axis) {
    const double cells = std::ceil(size[axis] / grid.spacing) + 2;
    grid.nodes[axis] = static_cast<std::size_t>(cells) + 1;
    grid.origin[axis] = (box.min()[axis] + box.max()[axis]) / 2 - cells * grid.spacing / 2;
  }
  return grid;
}

struct Measured {
  ValueGrid grid;
  Box box;
};

Measured measured(std::span<const View> views, const HullOptions& options,
                  const Progress& progress) {
  check_hull_options(options);
  progress("contours");
  const std::vector<Carver> carvers = make_carvers(views);
  const Box box = options.box ? *options.box : silhouette_box(views);
  Measured measured{make_grid(box, options), box};
  Sampler(carvers, measured.grid).run(progress);
  return measured;
}

}  // namespace

std::size_t drop_components(Mesh& mesh, double keep) {
  const Components parts = connected_components(mesh);
  double largest = 0;
  for (const Component& part : parts.components) largest = std::max(largest, part.volume);
  std::size_t kept = 0;
  std::vector<bool> keeps_part;
  for (const Component& part : parts.components) {
    keeps_part.push_back(part.volume > 0 && part.volume >= keep * largest);
    kept += keeps_part.back() ? 1 : 0;
  }
  std::vector<bool> keeps_face;
  for (const Index part : parts.of_face) keeps_face.push_back(keeps_part[part]);
  mesh = select_faces(mesh, keeps_face);
  return parts.components.size() - kept;
}

ValueGrid hull_values(std::span<const View> views, const HullOptions& options,
                      const Progress& progress) {
  return measured(views, options, progress).grid;
}

HullResult visual_hull(std::span<const View> views, const HullOptions& options,
                       const Progress& progress) {
  const Measured field = measured(views, options, progress);
  progress("march");
  HullResult result{march_tetrahedra(field.grid), field.box, field.grid.spacing};
  if (result.mesh.faces.empty())
    throw InputError("no point is inside all silhouettes: check the cameras, or use smaller cells");
  result.dropped_components = drop_components(result.mesh, options.keep);
  return result;
}

HullResult visual_hull(const Views& views, const HullOptions& options, const Progress& progress) {
  return visual_hull(std::span<const View>(views.list()), options, progress);
}

}  // namespace transformesh
