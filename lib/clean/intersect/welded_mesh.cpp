#include "clean/intersect/welded_mesh.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <utility>

#include "mesh/position_hash.h"
#include "support/first_of_equal.h"
#include "support/numbered_selection.h"
#include "support/parallel.h"
#include "support/raw_vector.h"
#include "transformesh/control.h"

namespace transformesh {
namespace {

/// If there are at most this many hashes, one thread adds all of them. Affects time only.
constexpr std::size_t few_hashes = 4096;

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

/// Bit sets that prove of most hashes that they occur only once. Hashes without this proof may
/// occur more often. The bit sets fit into the cache, so only few items need a lookup in a hash
/// table.
class SingleHashes {
 public:
  explicit SingleHashes(const RawVector<std::uint64_t>& hashes)
      : mask_(std::bit_ceil(bits_each * hashes.size() + word) - 1),
        once_(mask_ / word + 1),
        twice_(once_.size()) {
    // Each thread owns a range of the words of the bit sets. It adds the hashes whose bits are in
    // these words, and skips all other hashes.
    const std::size_t parts = hashes.size() > few_hashes ? allowed_thread_count() : 1;
    parallel_for(parts, 1, [&](std::size_t from, std::size_t to) {
      const std::size_t first = from * once_.size() / parts;
      const std::size_t count = to * once_.size() / parts - first;
      for (const std::uint64_t hash : hashes)
        if (place_of(hash) - first < count) add(hash);
    });
  }

  bool is_single(std::uint64_t hash) const {
    return (twice_[place_of(hash)] >> (hash % word) & 1) == 0;
  }

 private:
  /// Bits per item. With fewer bits, more hashes share a bit with another hash, and seem to occur
  /// twice.
  static constexpr std::size_t bits_each = 16;
  static constexpr std::size_t word = 64;  ///< bits per word

  std::size_t place_of(std::uint64_t hash) const { return (hash & mask_) / word; }
  void add(std::uint64_t hash) {
    const std::uint64_t bit = std::uint64_t{1} << (hash % word);
    const std::size_t place = place_of(hash);
    twice_[place] |= once_[place] & bit;
    once_[place] |= bit;
  }

  std::size_t mask_;
  std::vector<std::uint64_t> once_, twice_;
};

// Lists the points that may have duplicates, ascending.
RawVector<Index> find_repeated(const std::vector<Vec3>& points) {
  RawVector<std::uint64_t> hash_of(points.size());
  parallel_for_each(points.size(), [&](Index i) { hash_of[i] = position_hash(points[i]); });
  const SingleHashes hashes(hash_of);
  const NumberedSelection repeated(points.size(),
                                   [&](std::size_t i) { return !hashes.is_single(hash_of[i]); });
  return repeated.list();
}

void number_points(const Mesh& mesh, WeldedMesh& welded) {
  const std::vector<Vec3>& positions = mesh.positions;
  welded.vertex_of = find_first_vertices(positions);
  welded.point_of = welded.vertex_of;
  const NumberedSelection points(positions.size(),
                                 [&](std::size_t v) { return welded.vertex_of[v] == v; });
  if (points.size() < positions.size()) {
    const std::vector<Index> first = welded.vertex_of;
    welded.vertex_of.resize(points.size());
    points.visit([&](std::size_t v, std::size_t point) {
      welded.point_of[v] = static_cast<Index>(point);
      welded.vertex_of[point] = static_cast<Index>(v);
    });
    parallel_for_each(first.size(), [&](Index v) {
      if (first[v] != v) welded.point_of[v] = welded.point_of[first[v]];
    });
  }
  welded.points.resize(welded.vertex_of.size());
  parallel_for_each(welded.points.size(), [&](Index p) {
    welded.points[p] = positions[welded.vertex_of[p]] + Vec3::Zero();
  });
}

// Computes `opposites`. Returns, in ascending order, the faces that may have copies (faces with the
// same three points). If two faces of an edge have the same third corner, both are listed. All
// faces at an edge of more than two faces are listed.
RawVector<Index> find_opposites(WeldedMesh& welded) {
  std::vector<char> is_repeated(welded.faces.size(), 0);
  welded.opposites.resize(3 * welded.faces.size());
  const auto corner = [&](Index h, Index i) { return welded.faces[h / 3][(h + i) % 3]; };
  const auto mark = [&](Index h) {
    std::atomic_ref(is_repeated[h / 3]).store(1, std::memory_order_relaxed);
  };
  parallel_for_each(welded.edges.size(), [&](Index e) {
    const auto halfedges = welded.edges.halfedges(e);
    const Index h = halfedges.front(), other = halfedges.back();
    if (halfedges.size() == 2 && corner(h, 0) != corner(other, 0)) {
      welded.opposites[h] = other;
      welded.opposites[other] = h;
    } else {
      for (const Index single : halfedges) welded.opposites[single] = no_index;
    }
    if (halfedges.size() == 1) return;
    if (halfedges.size() == 2 && corner(h, 2) != corner(other, 2)) return;
    std::for_each(halfedges.begin(), halfedges.end(), mark);
  });
  const NumberedSelection repeated(is_repeated.size(),
                                   [&](std::size_t f) { return is_repeated[f] != 0; });
  return repeated.list();
}

void find_copies(WeldedMesh& welded) {
  const std::vector<Face>& faces = welded.faces;
  const RawVector<Index> repeated = find_opposites(welded);
  FirstOfEqual copies(repeated.size());
  welded.has_copies = false;
  welded.first_copy.resize(faces.size());
  parallel_for_each(faces.size(), [&](Index f) { welded.first_copy[f] = f; });
  for (const Index f : repeated) {
    const auto is_copy = [&](Index other) { return sorted(faces[other]) == sorted(faces[f]); };
    welded.first_copy[f] = copies.find_or_insert(hash(faces[f]), f, is_copy);
    welded.has_copies |= welded.first_copy[f] != f;
  }
}

// True if the face has no area. The exact test is not needed if the projected area of the face in
// some direction is certainly positive.
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

// For most vertices, the hash alone proves that no other vertex has this position.
std::vector<Index> find_first_vertices(const std::vector<Vec3>& positions) {
  const RawVector<Index> repeated = find_repeated(positions);
  FirstOfEqual vertices(repeated.size());
  std::vector<Index> first(positions.size());
  parallel_for_each(first.size(), [&](Index v) { first[v] = v; });
  for (const Index v : repeated)
    first[v] = vertices.find_or_insert(position_hash(positions[v]), v, [&](Index other) {
      return positions[other] == positions[v];
    });
  return first;
}

WeldedMesh weld(const Mesh& mesh) {
  WeldedMesh welded;
  number_points(mesh, welded);
  welded.frame = BoxFrame(welded.points);
  welded.faces.resize(mesh.faces.size());
  std::vector<char> has_area(mesh.faces.size());
  welded.directions.resize(mesh.faces.size());
  welded.face_of.resize(mesh.faces.size());
  parallel_for_each(mesh.faces.size(), [&](Index f) {
    const auto& [a, b, c] = mesh.faces[f];
    const Face face{welded.point_of[a], welded.point_of[b], welded.point_of[c]};
    welded.faces[f] = face;
    welded.directions[f] =
        directions_of_face(welded.points[face[0]], welded.points[face[1]], welded.points[face[2]]);
    has_area[f] = is_degenerate(welded, face, welded.directions[f]) ? 0 : 1;
    welded.face_of[f] = f;
  });
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
