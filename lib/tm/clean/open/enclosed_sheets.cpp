#include "tm/clean/open/enclosed_sheets.h"

#include <algorithm>

#include "tm/clean/exterior/patches.h"
#include "tm/clean/open/space_cells.h"
#include "tm/mesh/disjoint_sets.h"
#include "tm/mesh/edges.h"

namespace transformesh {
namespace {

/// The faces of a soup that hang together across edges of two, and the edges.
class Sheets {
 public:
  explicit Sheets(const Soup& soup);

  std::vector<Index> sheet_of;  ///< per face: the first face of its sheet
  /// How many faces more run up than down along an edge, the marked ones left out.
  int sum_along(std::size_t edge, const std::vector<char>& left_out) const;
  /// Restores marked sheets until those still marked leave no border where they were.
  void restore_needed(std::vector<char>& marks) const;

 private:
  const Soup& soup_;
  Edges edges_;
};

Sheets::Sheets(const Soup& soup) : soup_(soup), edges_(soup.faces, soup.points.size()) {
  DisjointSets sets(soup.faces.size());
  const std::vector<Index> across = neighbors_across(edges_, soup.faces.size());
  const auto runs_up = [&](Index h) {
    return soup.faces[h / 3][h % 3] < soup.faces[h / 3][(h % 3 + 1) % 3];
  };
  for (Index h = 0; h < across.size(); ++h) {
    if (across[h] != no_index && runs_up(h) != runs_up(across[h])) sets.join(h / 3, across[h] / 3);
  }
  for (Index f = 0; f < soup.faces.size(); ++f) sheet_of.push_back(sets.find(f));
}

int Sheets::sum_along(std::size_t edge, const std::vector<char>& left_out) const {
  int sum = 0;
  for (const Index h : edges_.halfedges(edge)) {
    const Face& face = soup_.faces[h / 3];
    if (!left_out[h / 3]) sum += face[h % 3] < face[(h % 3 + 1) % 3] ? 1 : -1;
  }
  return sum;
}

void Sheets::restore_needed(std::vector<char>& marks) const {
  for (bool is_stable = false; !is_stable;) {
    is_stable = true;
    std::vector<char> needed(marks.size(), 0);
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (sum_along(e, marks) == 0) continue;
      for (const Index h : edges_.halfedges(e)) {
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

// Marks patches that contradict the cells beside them, deep within the body. Cells that they no
// longer part may show more of them.
std::vector<char> find_contradictions(const Arrangement& arrangement, const Patches& patches,
                                      int level) {
  std::vector<char> contradicts(patches.size(), 0);
  for (bool is_stable = false; !is_stable;) {
    is_stable = true;
    const SpaceCells cells(arrangement, patches, contradicts);
    for (Index patch = 0; patch < patches.size(); ++patch) {
      const int front = cells.winding_in_front_of(patch);
      const int behind = cells.winding_behind(patch);
      const int step = arrangement.pieces[patches.pieces[patch].front()].winding;
      if (contradicts[patch] || std::min(front, behind) < level || behind == front + step) continue;
      contradicts[patch] = 1;
      is_stable = false;
    }
  }
  return contradicts;
}

// Marks the faces of sheets that consist of such patches. Pieces that cancel out say nothing.
std::vector<char> mark_contradictions(const Arrangement& arrangement, int level) {
  const Soup& soup = *arrangement.soup;
  const Patches patches(arrangement);
  const std::vector<char> contradicts = find_contradictions(arrangement, patches, level);
  const Sheets sheets(soup);
  std::vector<char> seen(soup.faces.size(), 0);
  std::vector<char> agrees(soup.faces.size(), 0);
  for (std::size_t p = 0; p < arrangement.pieces.size(); ++p) {
    if (patches.patch_of[p] == no_index) continue;
    for (const PieceSource& source : arrangement.sources_of(arrangement.pieces[p])) {
      const Index sheet = sheets.sheet_of[source.face];
      (contradicts[patches.patch_of[p]] ? seen : agrees)[sheet] = 1;
    }
  }
  std::vector<char> marks(soup.faces.size());
  for (Index f = 0; f < marks.size(); ++f) {
    const Index sheet = sheets.sheet_of[f];
    marks[f] = seen[sheet] && !agrees[sheet] ? 1 : 0;
  }
  return marks;
}

bool any(const std::vector<char>& marks) {
  return std::find(marks.begin(), marks.end(), 1) != marks.end();
}

}  // namespace

Soup without_faces(const Soup& soup, const std::vector<char>& marks) {
  Soup rest = soup;
  rest.faces.clear();
  rest.face_of.clear();
  for (Index f = 0; f < soup.faces.size(); ++f) {
    if (marks[f]) continue;
    rest.faces.push_back(soup.faces[f]);
    rest.face_of.push_back(soup.face_of[f]);
  }
  return rest;
}

// Where faces lie upon each other, what contradicts may show only when others are gone.
std::vector<char> find_enclosed_sheets(const Arrangement& arrangement, int level,
                                       const Progress& progress) {
  const Soup& soup = *arrangement.soup;
  std::vector<char> marks(soup.faces.size(), 0);
  std::vector<char> found = mark_contradictions(arrangement, level);
  while (any(found)) {
    for (Index f = 0, i = 0; f < marks.size(); ++f) {
      if (!marks[f]) marks[f] = found[i++];
    }
    const auto rest = std::make_shared<const Soup>(without_faces(soup, marks));
    found =
        mark_contradictions(arrange(rest, find_intersections(*rest, progress), progress), level);
  }
  if (any(marks)) Sheets(soup).restore_needed(marks);
  return marks;
}

}  // namespace transformesh
