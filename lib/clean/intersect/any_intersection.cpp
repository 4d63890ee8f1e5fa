#include "clean/intersect/any_intersection.h"

#include <algorithm>
#include <cstdint>

#include "clean/intersect/corner_cells.h"
#include "mesh/mesh_of_faces.h"
#include "support/parallel.h"
#include "transformesh/intersect.h"

namespace transformesh {
namespace {

/// Meshes with at most this number of faces are searched without sampling. The number is a choice:
/// a full search of so few faces is fast. With four times the samples, no face is sampled twice.
constexpr std::size_t few_faces = 4096;
/// Number of sampled faces. `sampled_cells_per_axis` is the resolution of the grid in which the
/// faces near the sampled faces are found. Both are choices: with more samples or larger cells, the
/// first search takes longer, and it detects rarer self-intersections.
constexpr std::size_t sampled_faces = 1024;
constexpr std::size_t things_per_task = 8192;  ///< affects time only
constexpr unsigned sampled_cells_per_axis = 128;
/// A face that overlaps more grid cells than this is large, and counts as near every sample.
constexpr std::size_t many_cells = 64;

class MarkedCells {
 public:
  explicit MarkedCells(const CornerCells& cells)
      : cells_(cells), words_((cells.count() + word - 1) / word, 0) {}

  void mark(const CellRange& range) {
    cells_.for_each(range, [&](std::size_t cell) {
      words_[cell / word] |= std::uint64_t{1} << cell % word;
      return true;
    });
  }

  bool has_any(const CellRange& range) const {
    bool found = false;
    cells_.for_each(range, [&](std::size_t cell) {
      found = (words_[cell / word] >> cell % word & 1) != 0;
      return !found;
    });
    return found;
  }

 private:
  static constexpr std::size_t word = 64;  ///< bits per word
  const CornerCells& cells_;
  std::vector<std::uint64_t> words_;
};

// Returns the face of sample `i`. The multiples of the golden ratio, modulo 1, are spread evenly
// over [0, 1) for any number of samples.
Index sampled_face(std::size_t i, std::size_t faces) {
  // The fractional part of the golden ratio, times 2^64.
  constexpr std::uint64_t golden_section = 0x9e3779b97f4a7c15ULL;
  const auto share = static_cast<double>(i * golden_section) * 0x1p-64;
  return static_cast<Index>(
      std::min(share * static_cast<double>(faces), static_cast<double>(faces - 1)));
}

std::vector<Index> all_sampled_faces(const Mesh& mesh) {
  std::vector<Index> samples(sampled_faces);
  for (std::size_t i = 0; i < sampled_faces; ++i) samples[i] = sampled_face(i, mesh.faces.size());
  return samples;
}

// Returns the sampled faces, all faces that share a grid cell with a sampled face, and all large
// faces.
std::vector<Index> faces_near_samples(const Mesh& mesh, const CornerCells& cells,
                                      const std::vector<Index>& samples) {
  MarkedCells marked(cells);
  for (const Index sample : samples) {
    const CellRange range = cells.around(mesh.faces[sample]);
    if (range.size() <= many_cells) marked.mark(range);
  }
  std::vector<char> is_near(mesh.faces.size());
  parallel_for(mesh.faces.size(), things_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f) {
      const CellRange range = cells.around(mesh.faces[f]);
      is_near[f] = range.size() > many_cells || marked.has_any(range) ? 1 : 0;
    }
  });
  std::vector<Index> result;
  for (std::size_t f = 0; f < is_near.size(); ++f)
    if (is_near[f]) result.push_back(static_cast<Index>(f));
  return result;
}

bool intersect(const Mesh& mesh, const std::vector<Index>& faces) {
  return !find_intersections(mesh_of_faces(mesh, faces)).empty();
}

// Returns true if sampled faces intersect each other, which is soon found in a dense soup, or faces
// near them.
bool samples_intersect(const Mesh& mesh) {
  const std::vector<Index> samples = all_sampled_faces(mesh);
  if (intersect(mesh, samples)) return true;
  const CornerCells cells(mesh.positions, sampled_cells_per_axis);
  if (!cells.is_usable()) return false;
  const std::vector<Index> faces = faces_near_samples(mesh, cells, samples);
  // Do not search the sample if it contains more than a quarter of all faces: the search of all
  // faces costs hardly more.
  if (faces.size() > mesh.faces.size() / 4) return false;
  return intersect(mesh, faces);
}

}  // namespace

bool has_intersections(const Mesh& mesh, const Progress& progress) {
  progress("intersect");
  if (mesh.faces.size() > few_faces && samples_intersect(mesh)) return true;
  return !find_intersections(mesh, progress).empty();
}

}  // namespace transformesh
