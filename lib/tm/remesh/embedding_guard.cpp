#include "tm/remesh/embedding_guard.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace transformesh {
namespace {

constexpr std::uint32_t all_directions = 0x1fff1fff;
/// A direction counts as seeing a front when cosine to the normal is above this.
constexpr float least_cosine = 0.03F;
/// Cells are this many longest edges wide: most patches reach nine tenths of one from their centre,
/// and each face that meets that ball has a corner within 0.58 of one.
constexpr double cell_edges = 1.5;
constexpr double corner_reach = 0.58;
constexpr int key_bits = 21;

/// Four numbers that the processor treats at once (an extension that GCC and Clang share).
using Floats = float __attribute__((vector_size(16)));
using Words = std::int32_t __attribute__((vector_size(16)));

/// Thirteen directions in fours, padded with none: the axes, the diagonals of a cube's faces, and
/// its diagonals.
struct FourDirections {
  Floats x, y, z, length;
  Words bits;
};
constexpr float face = 1.41421356F;
constexpr float cube = 1.73205081F;
constexpr std::array<FourDirections, 4> directions_tested{{
    {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 0}, {1, 1, 1, face}, {1, 2, 4, 8}},
    {{1, 0, 0, 1}, {-1, 1, 1, 0}, {0, 1, -1, 1}, {face, face, face, face}, {16, 32, 64, 128}},
    {{-1, 1, 1, 1}, {0, 1, 1, -1}, {1, 1, -1, 1}, {face, cube, cube, cube}, {256, 512, 1024, 2048}},
    {{-1, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}, {cube, 1, 1, 1}, {4096, 0, 0, 0}},
}};

/// Bit k where direction k sees the front of a face with that normal, bit 16 + k where the opposite
/// direction does. Single precision is far finer than the margin of least_cosine; where it
/// overflows or underflows, nothing is seen.
std::uint32_t seeing_directions(const Vec3& normal) {
  const auto x = static_cast<float>(normal.x());
  const auto y = static_cast<float>(normal.y());
  const auto z = static_cast<float>(normal.z());
  const float least = least_cosine * std::sqrt(x * x + y * y + z * z);
  Words front{};
  Words back{};
  for (const FourDirections& four : directions_tested) {
    const Floats along = four.x * x + four.y * y + four.z * z;
    const Floats needed = four.length * least;
    front |= (along > needed) & four.bits;
    back |= (along < -needed) & four.bits;
  }
  const Words both = front | back << 16;
  return static_cast<std::uint32_t>(both[0] | both[1] | both[2] | both[3]);
}

Vec3 lowest(const Triangle& triangle) {
  return triangle[0].cwiseMin(triangle[1]).cwiseMin(triangle[2]);
}
Vec3 highest(const Triangle& triangle) {
  return triangle[0].cwiseMax(triangle[1]).cwiseMax(triangle[2]);
}

bool boxes_touch(const Triangle& first, const Triangle& second) {
  return (lowest(first).array() <= highest(second).array()).all() &&
         (lowest(second).array() <= highest(first).array()).all();
}

/// Whether the direction clearly sees the front of the triangle.
bool sees(const Vec3& direction, const Triangle& triangle) {
  const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  const double along = direction.dot(normal);
  return along > 0 && along * along > least_cosine * least_cosine * normal.squaredNorm();
}

/// The space between two planes across a direction.
class Slab {
 public:
  explicit Slab(const Vec3& direction) : direction_(direction) {}
  void extend(const Triangle& triangle) {
    for (const Vec3& corner : triangle) {
      low_ = std::min(low_, direction_.dot(corner));
      high_ = std::max(high_, direction_.dot(corner));
    }
  }
  /// Counts what is within rounding as meeting.
  bool meets(const Triangle& triangle) const {
    const double a = direction_.dot(triangle[0]);
    const double b = direction_.dot(triangle[1]);
    const double c = direction_.dot(triangle[2]);
    const double margin = 1e-12 * (std::abs(low_) + std::abs(high_) + std::abs(a));
    return std::max({a, b, c}) >= low_ - margin && std::min({a, b, c}) <= high_ + margin;
  }

 private:
  Vec3 direction_;
  double low_ = HUGE_VAL;
  double high_ = -HUGE_VAL;
};

double longest_edge_of(const EditableMesh& mesh) {
  double longest = 0;
  for (Index h = 0; h < mesh.halfedge_slots(); ++h) {
    if (mesh.is_edge(h)) longest = std::max(longest, mesh.squared_length(h));
  }
  return std::sqrt(longest);
}

}  // namespace

void Patch::clear() {
  made.clear();
  normals.clear();
  replaced.clear();
  vertices.clear();
}

EmbeddingGuard::EmbeddingGuard(const EditableMesh& mesh, double longest_edge)
    : mesh_(mesh),
      longest_edge_(std::max(longest_edge, longest_edge_of(mesh))),
      cell_size_(cell_edges * longest_edge_),
      places_(mesh.vertex_slots()),
      stamp_(mesh.face_slots(), 0) {
  Vec3 low = Vec3::Constant(HUGE_VAL);
  Vec3 high = -low;
  for (Index v = 0; v < mesh.vertex_slots(); ++v) {
    if (!mesh.has_vertex(v)) continue;
    low = low.cwiseMin(mesh.position(v));
    high = high.cwiseMax(mesh.position(v));
  }
  // a margin of cells on each side, and as many cells as a key can count
  cell_size_ = std::max(cell_size_, (high - low).maxCoeff() / (1 << (key_bits - 3)));
  origin_ = low - Vec3::Constant(8 * cell_size_);
  label_components();
  fill_cells();
}

void EmbeddingGuard::label_components() {
  std::vector<Index> stack;
  std::vector<Index> members;
  for (Index seed = 0; seed < mesh_.vertex_slots(); ++seed) {
    if (!mesh_.has_vertex(seed) || stamp_[mesh_.outgoing(seed) / 3] != 0) continue;
    members.clear();
    bool closed = true;
    stack.assign(1, mesh_.outgoing(seed) / 3);
    stamp_[stack[0]] = 1;
    while (!stack.empty()) {
      const Index face = stack.back();
      stack.pop_back();
      members.push_back(face);
      for (Index h = 3 * face; h < 3 * face + 3; ++h) {
        const Index opposite = mesh_.opposite(h);
        closed &= opposite != no_index;
        if (opposite == no_index || stamp_[opposite / 3] != 0) continue;
        stamp_[opposite / 3] = 1;
        stack.push_back(opposite / 3);
      }
    }
    if (!closed) continue;
    for (const Index face : members) {
      for (Index h = 3 * face; h < 3 * face + 3; ++h) places_[mesh_.source(h)].component = seed;
    }
  }
  stamp_now_ = 1;
}

EmbeddingGuard::Key EmbeddingGuard::key_of(const Vec3& position) const {
  const Vec3 at = (position - origin_) / cell_size_;
  Key key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double limit = (1 << key_bits) - 2;
    key = (key << key_bits) | static_cast<Key>(std::clamp(at[axis], 1.0, limit));
  }
  return key;
}

Index EmbeddingGuard::find_cell(Key key) const {
  const std::size_t mask = table_.size() - 1;
  std::size_t slot = (static_cast<std::uint64_t>(key) * 0x9e3779b97f4a7c15ULL) >> 32;
  for (;; ++slot) {
    const Index cell = table_[slot & mask];
    if (cell == no_index || cells_[cell].key == key) return cell;
  }
}

void EmbeddingGuard::grow_table() {
  table_.assign(std::max<std::size_t>(1024, 2 * table_.size()), no_index);
  const std::size_t mask = table_.size() - 1;
  for (Index cell = 0; cell < cells_.size(); ++cell) {
    std::size_t slot = (static_cast<std::uint64_t>(cells_[cell].key) * 0x9e3779b97f4a7c15ULL) >> 32;
    while (table_[slot & mask] != no_index) ++slot;
    table_[slot & mask] = cell;
  }
}

Index EmbeddingGuard::make_cell(Key key, Index component) {
  const auto cell = static_cast<Index>(cells_.size());
  const std::uint32_t directions = component == no_index ? 0 : all_directions;
  cells_.push_back({key, directions, directions, no_index, component});
  if (2 * cells_.size() > table_.size()) {
    grow_table();
  } else {
    const std::size_t mask = table_.size() - 1;
    std::size_t slot = (static_cast<std::uint64_t>(key) * 0x9e3779b97f4a7c15ULL) >> 32;
    while (table_[slot & mask] != no_index) ++slot;
    table_[slot & mask] = cell;
  }
  return cell;
}

template <class Visit>
void EmbeddingGuard::for_each_cell_around(Key key, const Visit& visit) const {
  for (Key dx = -1; dx <= 1; ++dx) {
    for (Key dy = -1; dy <= 1; ++dy) {
      for (Key dz = -1; dz <= 1; ++dz) {
        const Index cell =
            find_cell(key + dx * (Key{1} << (2 * key_bits)) + dy * (Key{1} << key_bits) + dz);
        if (cell != no_index) visit(cell);
      }
    }
  }
}

void EmbeddingGuard::fill_cells() {
  grow_table();
  for (Index v = 0; v < mesh_.vertex_slots(); ++v) {
    if (!mesh_.has_vertex(v)) continue;
    const Key key = key_of(mesh_.position(v));
    Index cell = find_cell(key);
    if (cell == no_index) cell = make_cell(key, places_[v].component);
    if (cells_[cell].component != places_[v].component) cells_[cell].directions = 0;
    insert(v, cell);
  }
  for (Index face = 0; face < mesh_.face_slots(); ++face) {
    if (!mesh_.has_face(face)) continue;
    const std::uint32_t directions = seeing_directions(mesh_.face_normal(face));
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      cells_[places_[mesh_.source(h)].cell].directions &= directions;
      places_[mesh_.source(h)].seeing &= directions;
    }
  }
  for (Cell& cell : cells_) dilate(cell);
}

void EmbeddingGuard::dilate(Cell& cell) const {
  cell.around = cell.directions;
  for_each_cell_around(cell.key, [&](Index other) {
    const bool alike = cells_[other].component == cell.component;
    cell.around &= alike ? cells_[other].directions : 0;
  });
}

void EmbeddingGuard::restrict_cell(Index cell, std::uint32_t directions) {
  const std::uint32_t left = cells_[cell].directions & directions;
  if (left == cells_[cell].directions) return;
  cells_[cell].directions = left;
  for_each_cell_around(cells_[cell].key, [&](Index other) { cells_[other].around &= left; });
}

void EmbeddingGuard::insert(Index vertex, Index cell) {
  const Index next = cells_[cell].first_vertex;
  places_[vertex].cell = cell;
  places_[vertex].next = next;
  places_[vertex].previous = no_index;
  if (next != no_index) places_[next].previous = vertex;
  cells_[cell].first_vertex = vertex;
}

void EmbeddingGuard::remove(Index vertex) {
  const Index next = places_[vertex].next;
  const Index previous = places_[vertex].previous;
  if (next != no_index) places_[next].previous = previous;
  if (previous != no_index) {
    places_[previous].next = next;
  } else {
    cells_[places_[vertex].cell].first_vertex = next;
  }
}

void EmbeddingGuard::forget(Index vertex) { remove(vertex); }

void EmbeddingGuard::commit(const Patch& patch) {
  const Key key = key_of(mesh_.position(patch.centre));
  if (key != cells_[places_[patch.centre].cell].key) change_cell(patch.centre, key);
  for (const Index vertex : patch.vertices) {
    restrict_cell(places_[vertex].cell, directions_);
    places_[vertex].seeing &= directions_;
  }
}

void EmbeddingGuard::change_cell(Index vertex, Key key) {
  const Index component = places_[vertex].component;
  remove(vertex);
  Index cell = find_cell(key);
  if (cell == no_index) {
    cell = make_cell(key, component);
    dilate(cells_[cell]);
    for_each_cell_around(key, [&](Index other) {
      if (cells_[other].component != component) cells_[other].around = 0;
    });
  } else if (cells_[cell].component != component) {
    restrict_cell(cell, 0);
  }
  insert(vertex, cell);
}

bool EmbeddingGuard::allows(const Patch& patch) {
  if (is_certified(patch)) return true;
  if (!(patch.longest_squared <= longest_edge_ * longest_edge_)) return false;
  enclose(patch);
  if (is_seen_around(patch)) return true;
  find_faces_near(patch);
  return is_height_field(patch) || (!meets_itself(patch) && !meets_others(patch));
}

bool EmbeddingGuard::is_certified(const Patch& patch) {
  directions_ = patch.longest_squared <= longest_edge_ * longest_edge_ ? all_directions : 0;
  for (const Vec3& normal : patch.normals) directions_ &= seeing_directions(normal);
  if ((directions_ & cells_[places_[patch.centre].cell].around) == 0) return false;

  // the ball around the centre must hold the patch
  const double radius = cell_size_ - corner_reach * longest_edge_;
  const Vec3& centre = mesh_.position(patch.centre);
  for (const Index vertex : patch.vertices) {
    if ((mesh_.position(vertex) - centre).squaredNorm() > radius * radius) return false;
  }
  return (patch.centre_position - centre).squaredNorm() <= radius * radius;
}

Triangle EmbeddingGuard::triangle_of(Index face) const {
  return {mesh_.position(mesh_.source(3 * face)), mesh_.position(mesh_.source(3 * face + 1)),
          mesh_.position(mesh_.source(3 * face + 2))};
}

/// The box around both patches, and of it the slab between two planes that hold them, is convex, so
/// that lines in it may be followed (as in a ball).
bool EmbeddingGuard::is_height_field(const Patch& patch) const {
  const Index component = places_[patch.centre].component;
  if (component == no_index) return false;
  Vec3 direction = Vec3::Zero();
  for (const Vec3& normal : patch.normals) direction += normal;
  direction.normalize();
  Slab slab(direction);
  for (const Triangle& triangle : patch.made) slab.extend(triangle);
  for (const Index face : patch.replaced) slab.extend(triangle_of(face));

  const auto is_seen = [&](Index face) {
    return places_[mesh_.source(3 * face)].component == component &&
           sees(direction, triangle_of(face));
  };
  return std::all_of(patch.made.begin(), patch.made.end(),
                     [&](const Triangle& triangle) { return sees(direction, triangle); }) &&
         std::all_of(patch.replaced.begin(), patch.replaced.end(), is_seen) &&
         std::all_of(near_.begin(), near_.end(),
                     [&](Index face) { return !slab.meets(triangle_of(face)) || is_seen(face); });
}

bool EmbeddingGuard::meets_itself(const Patch& patch) const {
  for (std::size_t i = 0; i < patch.made.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (boxes_touch(patch.made[i], patch.made[j]) && may_touch(patch.made[i], patch.made[j])) {
        return true;
      }
    }
  }
  return false;
}

bool EmbeddingGuard::meets_others(const Patch& patch) const {
  return std::any_of(near_.begin(), near_.end(), [&](Index face) {
    const Triangle other = triangle_of(face);
    return std::any_of(patch.made.begin(), patch.made.end(), [&](const Triangle& triangle) {
      return boxes_touch(triangle, other) && may_touch(triangle, other);
    });
  });
}

/// The box around both patches.
void EmbeddingGuard::enclose(const Patch& patch) {
  low_ = high_ = patch.centre_position;
  const auto extend = [&](const Triangle& triangle) {
    low_ = low_.cwiseMin(lowest(triangle));
    high_ = high_.cwiseMax(highest(triangle));
  };
  for (const Triangle& triangle : patch.made) extend(triangle);
  for (const Index face : patch.replaced) extend(triangle_of(face));
  const Vec3 reach = Vec3::Constant(corner_reach * longest_edge_);
  low_corner_ = low_ - reach;
  high_corner_ = high_ + reach;
}

/// The certificate of is_height_field() for all faces at the vertices around, which is more than it
/// needs.
bool EmbeddingGuard::is_seen_around(const Patch& patch) const {
  const Index component = places_[patch.centre].component;
  std::uint32_t directions = component == no_index ? 0 : directions_;
  for (const Index vertex : patch.vertices) directions &= places_[vertex].seeing;
  if (directions == 0) return false;
  return for_each_cell_near([&](const Cell& cell) {
    const bool restricts = cell.component != component || (directions & ~cell.directions) != 0;
    for (Index v = restricts ? cell.first_vertex : no_index; v != no_index; v = places_[v].next) {
      const Place& place = places_[v];
      const std::uint32_t left = place.component == component ? directions & place.seeing : 0;
      if (left != directions && is_around(v)) directions = left;
    }
    return directions != 0;
  });
}

/// Fills near_ with the faces, other than those that give way, whose boxes touch the patches'.
void EmbeddingGuard::find_faces_near(const Patch& patch) {
  near_.clear();
  ++stamp_now_;
  for (const Index face : patch.replaced) stamp_[face] = stamp_now_;
  const auto add_if_near = [&](Index halfedge) {
    const Index face = halfedge / 3;
    if (stamp_[face] == stamp_now_) return;
    stamp_[face] = stamp_now_;
    const Triangle triangle = triangle_of(face);
    if ((lowest(triangle).array() <= high_.array()).all() &&
        (highest(triangle).array() >= low_.array()).all())
      near_.push_back(face);
  };
  for_each_cell_near([&](const Cell& cell) {
    for (Index v = cell.first_vertex; v != no_index; v = places_[v].next) {
      if (is_around(v)) mesh_.for_each_outgoing(v, add_if_near);
    }
    return true;
  });
}

bool EmbeddingGuard::is_around(Index vertex) const {
  const Vec3& position = mesh_.position(vertex);
  return (position.array() >= low_corner_.array()).all() &&
         (position.array() <= high_corner_.array()).all();
}

/// Calls visit(cell) until it returns false. At least one corner of every face that meets the box
/// lies in one of them, and is around.
template <class Visit>
bool EmbeddingGuard::for_each_cell_near(const Visit& visit) const {
  const Key first = key_of(low_corner_);
  const Key last = key_of(high_corner_);
  constexpr Key axis_mask = (Key{1} << key_bits) - 1;
  for (Key x = first >> (2 * key_bits); x <= last >> (2 * key_bits); ++x) {
    for (Key y = (first >> key_bits) & axis_mask; y <= ((last >> key_bits) & axis_mask); ++y) {
      for (Key z = first & axis_mask; z <= (last & axis_mask); ++z) {
        const Index cell = find_cell((x << (2 * key_bits)) | (y << key_bits) | z);
        if (cell != no_index && !visit(cells_[cell])) return false;
      }
    }
  }
  return true;
}

}  // namespace transformesh
