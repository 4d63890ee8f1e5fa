#include "clean/open/enclosed_sheets.h"

#include <algorithm>
#include <memory>

#include "clean/exterior/angular_order.h"
#include "clean/exterior/patches.h"
#include "clean/intersect/find_meetings.h"
#include "clean/open/space_cells.h"
#include "mesh/disjoint_sets.h"
#include "mesh/edges.h"

namespace transformesh {
namespace {

/// The sheets of a welded mesh: faces connected across edges of two faces.
class Sheets {
 public:
  /// Keeps a reference to `welded`.
  explicit Sheets(const WeldedMesh& welded);

  std::vector<Index> sheet_of;  ///< for each face the first face of its sheet
  /// Returns the number of forward faces minus the number of backward faces along an edge. Faces
  /// with a nonzero `left_out` entry do not count.
  int sum_along(std::size_t edge, const std::vector<char>& left_out) const;
  /// Clears the marks of sheets until removing the marked sheets leaves no border.
  void restore_needed(std::vector<char>& marks) const;

 private:
  const WeldedMesh& welded_;
};

Sheets::Sheets(const WeldedMesh& welded) : welded_(welded) {
  DisjointSets sets(welded.faces.size());
  const std::vector<Index> across = neighbors_across(welded_.edges, welded.faces.size());
  const auto points_forward = [&](Index h) { return is_forward(welded.faces, h); };
  for (Index h = 0; h < across.size(); ++h) {
    if (across[h] != no_index && points_forward(h) != points_forward(across[h]))
      sets.join(h / 3, across[h] / 3);
  }
  for (Index f = 0; f < welded.faces.size(); ++f) sheet_of.push_back(sets.find(f));
}

int Sheets::sum_along(std::size_t edge, const std::vector<char>& left_out) const {
  int sum = 0;
  for (const Index h : welded_.edges.halfedges(edge)) {
    if (!left_out[h / 3]) sum += is_forward(welded_.faces, h) ? 1 : -1;
  }
  return sum;
}

void Sheets::restore_needed(std::vector<char>& marks) const {
  for (bool is_stable = false; !is_stable;) {
    is_stable = true;
    std::vector<char> needed(marks.size(), 0);
    for (std::size_t e = 0; e < welded_.edges.size(); ++e) {
      if (sum_along(e, marks) == 0) continue;
      for (const Index h : welded_.edges.halfedges(e)) {
        if (!marks[h / 3]) continue;
        needed[sheet_of[h / 3]] = 1;
        is_stable = false;
      }
    }
    for (Index f = 0; f < marks.size(); ++f) {
      if (needed[sheet_of[f]]) marks[f] = 0;
    }
  }
}

// Returns 1 for each patch that contradicts the winding numbers of the cells on both sides, if both
// cells are inside the body. A patch contradicts them if their difference is not its multiplicity:
// the number of coincident faces, with sign. Cells on both sides of a marked patch are merged,
// which may lead to further contradictions.
std::vector<char> find_contradictions(const Arrangement& arrangement, const Patches& patches,
                                      int winding_level) {
  std::vector<char> contradicts(patches.size(), 0);
  for (bool is_stable = false; !is_stable;) {
    is_stable = true;
    const SpaceCells cells(arrangement, patches, contradicts);
    for (Index patch = 0; patch < patches.size(); ++patch) {
      const int front = cells.winding_in_front_of(patch);
      const int behind = cells.winding_behind(patch);
      const int step = arrangement.pieces[patches.pieces[patch].front()].multiplicity;
      if (contradicts[patch] || std::min(front, behind) < winding_level || behind == front + step)
        continue;
      contradicts[patch] = 1;
      is_stable = false;
    }
  }
  return contradicts;
}

// Returns 1 for each face of a sheet (set of connected faces) that bounds nothing: all its pieces
// contradict the winding numbers of the cells on both sides. Pieces of multiplicity 0 (coincident
// faces that cancel out) are ignored.
std::vector<char> mark_contradictions(const Arrangement& arrangement, int winding_level) {
  const WeldedMesh& welded = *arrangement.welded;
  const Patches patches(arrangement);
  const std::vector<char> contradicts = find_contradictions(arrangement, patches, winding_level);
  const Sheets sheets(welded);
  std::vector<char> seen(welded.faces.size(), 0);
  std::vector<char> agrees(welded.faces.size(), 0);
  for (std::size_t p = 0; p < arrangement.pieces.size(); ++p) {
    if (patches.patch_of[p] == no_index) continue;
    for (const PieceSource& source : arrangement.sources_of(arrangement.pieces[p])) {
      const Index sheet = sheets.sheet_of[source.face];
      (contradicts[patches.patch_of[p]] ? seen : agrees)[sheet] = 1;
    }
  }
  std::vector<char> marks(welded.faces.size());
  for (Index f = 0; f < marks.size(); ++f) {
    const Index sheet = sheets.sheet_of[f];
    marks[f] = seen[sheet] && !agrees[sheet] ? 1 : 0;
  }
  return marks;
}

bool any(const std::vector<char>& marks) {
  return std::find(marks.begin(), marks.end(), 1) != marks.end();
}

WeldedMesh without_faces(const WeldedMesh& welded, const std::vector<char>& marks) {
  WeldedMesh rest = welded;
  rest.faces.clear();
  rest.face_of.clear();
  rest.directions.clear();
  for (Index f = 0; f < welded.faces.size(); ++f) {
    if (marks[f]) continue;
    rest.faces.push_back(welded.faces[f]);
    rest.face_of.push_back(welded.face_of[f]);
    rest.directions.push_back(welded.directions[f]);
  }
  index_faces(rest);
  return rest;
}

Arrangement arrange_without(const WeldedMesh& welded, const std::vector<char>& marks,
                            const Progress& progress) {
  const auto rest = std::make_shared<const WeldedMesh>(without_faces(welded, marks));
  return arrange(rest, find_meetings(*rest, progress), progress);
}

}  // namespace

// Removes the enclosed sheets that were found, and repeats the search until it finds none. If faces
// coincide, some enclosed sheets are found only after other sheets are removed.
std::vector<char> find_enclosed_sheets(const Arrangement& arrangement, int winding_level,
                                       const Progress& progress) {
  const WeldedMesh& welded = *arrangement.welded;
  std::vector<char> marks(welded.faces.size(), 0);
  std::vector<char> found = mark_contradictions(arrangement, winding_level);
  while (any(found)) {
    for (Index f = 0, i = 0; f < marks.size(); ++f) {
      if (!marks[f]) marks[f] = found[i++];
    }
    found = mark_contradictions(arrange_without(welded, marks, progress), winding_level);
  }
  if (any(marks)) Sheets(welded).restore_needed(marks);
  return marks;
}

}  // namespace transformesh
