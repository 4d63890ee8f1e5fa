#include "clean/intersect/welded_mesh.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <numeric>
#include <utility>

#include "support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t things_per_task = 4096;  ///< affects time only

std::uint64_t hash(const Vec3& p) {
  std::uint64_t h = 0x9e3779b97f4a7c15ULL;
  for (int i = 0; i < 3; ++i) {
    h ^= std::bit_cast<std::uint64_t>(p[i] + 0.0);  // the sum turns -0 into 0
    h *= 0xff51afd7ed558ccdULL;
    h ^= h >> 32;
  }
  return h;
}

Face sorted(Face face) {
  std::sort(face.begin(), face.end());
  return face;
}

std::uint64_t hash(const Face& face) {
  std::uint64_t h = 0x9e3779b97f4a7c15ULL;
  for (const Index point : sorted(face)) {
    h = (h ^ point) * 0xff51afd7ed558ccdULL;
    h ^= h >> 32;
  }
  return h;
}

/// Distinguishes hashes that occur once from hashes that may occur more often. The bits fit into
/// the cache, so only few items need a lookup in a table.
class SingleHashes {
 public:
  explicit SingleHashes(std::size_t count)
      : mask_(std::bit_ceil(bits_each * count + word) - 1),
        once_(mask_ / word + 1),
        twice_(once_.size()) {}

  void add(std::uint64_t hash) {
    const std::uint64_t bit = std::uint64_t{1} << (hash % word);
    const std::size_t place = (hash & mask_) / word;
    twice_[place] |= once_[place] & bit;
    once_[place] |= bit;
  }
  bool is_single(std::uint64_t hash) const {
    return (twice_[(hash & mask_) / word] >> (hash % word) & 1) == 0;
  }

 private:
  /// Bits per item. With fewer bits, more hashes that occur once seem to be repeated.
  static constexpr std::size_t bits_each = 16;
  static constexpr std::size_t word = 64;  ///< bits per word
  std::size_t mask_;
  std::vector<std::uint64_t> once_, twice_;
};

/// Finds the first of equal items by a hash table with open addressing, whose slots hold item
/// numbers.
class FirstOfEqual {
 public:
  explicit FirstOfEqual(std::size_t count) : slots_(std::bit_ceil(2 * count + 1), no_index) {}

  /// Returns the number of the first item that is equal to `thing`. Inserts `thing` if there is
  /// none.
  template <class IsEqual>
  Index find(std::uint64_t hash, Index thing, const IsEqual& is_equal) {
    std::size_t slot = (hash >> 20) & (slots_.size() - 1);
    while (slots_[slot] != no_index && !is_equal(slots_[slot]))
      slot = (slot + 1) & (slots_.size() - 1);
    if (slots_[slot] == no_index) slots_[slot] = thing;
    return slots_[slot];
  }

 private:
  std::vector<Index> slots_;
};

// Marks the points that may have duplicates.
std::vector<char> find_repeated(const std::vector<Vec3>& points) {
  std::vector<std::uint64_t> hash_of(points.size());
  parallel_for(points.size(), things_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) hash_of[i] = hash(points[i]);
  });
  SingleHashes hashes(points.size());
  for (const std::uint64_t hash : hash_of) hashes.add(hash);
  std::vector<char> is_repeated(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    is_repeated[i] = hashes.is_single(hash_of[i]) ? 0 : 1;
  return is_repeated;
}

// Returns for each vertex the first vertex at the same position. The hash alone decides for most
// vertices.
std::vector<Index> find_first_vertices(const std::vector<Vec3>& positions, bool& has_repeats) {
  const std::vector<char> is_repeated = find_repeated(positions);
  FirstOfEqual vertices(std::count(is_repeated.begin(), is_repeated.end(), 1));
  std::vector<Index> first(positions.size());
  std::iota(first.begin(), first.end(), Index{0});
  has_repeats = false;
  for (Index v = 0; v < positions.size(); ++v) {
    if (!is_repeated[v]) continue;
    first[v] = vertices.find(hash(positions[v]), v,
                             [&](Index other) { return positions[other] == positions[v]; });
    has_repeats |= first[v] != v;
  }
  return first;
}

void number_points(const Mesh& mesh, WeldedMesh& welded) {
  const std::vector<Vec3>& positions = mesh.positions;
  bool has_repeats = false;
  welded.vertex_of = find_first_vertices(positions, has_repeats);
  welded.point_of = welded.vertex_of;
  if (has_repeats) {
    Index count = 0;
    for (Index v = 0; v < positions.size(); ++v) {
      const Index first = welded.vertex_of[v];
      welded.point_of[v] = first == v ? count : welded.point_of[first];
      welded.vertex_of[count] = v;
      count += first == v ? 1 : 0;
    }
    welded.vertex_of.resize(count);
  }
  welded.points.resize(welded.vertex_of.size());
  for (std::size_t p = 0; p < welded.points.size(); ++p)
    welded.points[p] = positions[welded.vertex_of[p]] + Vec3::Zero();
}

// Computes `opposites`, and marks the faces that may have copies. Copies share each edge, with the
// same opposite corner. All faces at an edge of more than two faces are marked.
std::vector<char> find_opposites(WeldedMesh& welded) {
  std::vector<char> is_repeated(welded.faces.size(), 0);
  welded.opposites.assign(3 * welded.faces.size(), no_index);
  const auto corner = [&](Index h, Index i) { return welded.faces[h / 3][(h + i) % 3]; };
  const auto mark = [&](Index h) {
    std::atomic_ref(is_repeated[h / 3]).store(1, std::memory_order_relaxed);
  };
  parallel_for(welded.edges.size(), things_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t e = first; e < last; ++e) {
      const auto halfedges = welded.edges.halfedges(e);
      if (halfedges.size() == 1) continue;
      const Index h = halfedges[0], other = halfedges[1];
      if (halfedges.size() == 2 && corner(h, 0) != corner(other, 0)) {
        welded.opposites[h] = other;
        welded.opposites[other] = h;
      }
      if (halfedges.size() == 2 && corner(h, 2) != corner(other, 2)) continue;
      std::for_each(halfedges.begin(), halfedges.end(), mark);
    }
  });
  return is_repeated;
}

void find_copies(WeldedMesh& welded) {
  const std::vector<Face>& faces = welded.faces;
  const std::vector<char> is_repeated = find_opposites(welded);
  FirstOfEqual copies(std::count(is_repeated.begin(), is_repeated.end(), 1));
  welded.first_copy.resize(faces.size());
  for (Index f = 0; f < faces.size(); ++f) {
    const auto is_copy = [&](Index other) { return sorted(faces[other]) == sorted(faces[f]); };
    welded.first_copy[f] = is_repeated[f] ? copies.find(hash(faces[f]), f, is_copy) : f;
  }
}

// A face with positive projected area in some direction is certainly not degenerate.
bool is_degenerate(const WeldedMesh& welded, const Face& face, FaceDirections directions) {
  return directions.looks == 0 &&
         (is_collapsed(face) ||
          collinear(welded.points[face[0]], welded.points[face[1]], welded.points[face[2]]));
}

template <class Thing>
void keep_marked(const std::vector<char>& marks, std::vector<Thing>& things) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < things.size(); ++i)
    if (marks[i]) things[count++] = things[i];
  things.resize(count);
}

}  // namespace

WeldedMesh weld(const Mesh& mesh) {
  WeldedMesh welded;
  number_points(mesh, welded);
  welded.frame = BoxFrame(welded.points);
  std::vector<Face> by_points(mesh.faces.size());
  std::vector<char> has_area(mesh.faces.size());
  welded.directions.resize(mesh.faces.size());
  parallel_for(mesh.faces.size(), things_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f) {
      const auto& [a, b, c] = mesh.faces[f];
      const Face face{welded.point_of[a], welded.point_of[b], welded.point_of[c]};
      by_points[f] = face;
      welded.directions[f] = directions_of_face(welded.points[face[0]], welded.points[face[1]],
                                                welded.points[face[2]]);
      has_area[f] = is_degenerate(welded, face, welded.directions[f]) ? 0 : 1;
    }
  });
  welded.faces = std::move(by_points);
  welded.face_of.resize(welded.faces.size());
  std::iota(welded.face_of.begin(), welded.face_of.end(), Index{0});
  if (std::count(has_area.begin(), has_area.end(), 0) > 0) {
    keep_marked(has_area, welded.faces);
    keep_marked(has_area, welded.face_of);
    keep_marked(has_area, welded.directions);
  }
  index_faces(welded);
  return welded;
}

void index_faces(WeldedMesh& welded) {
  welded.edges = Edges(welded.faces, welded.points.size());
  find_copies(welded);
}

}  // namespace transformesh
