#include "clean/stitch/orient.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>

#include "clean/exterior/angular_order.h"
#include "clean/stitch/coincident_sheets.h"
#include "clean/stitch/orientation_check.h"
#include "clean/stitch/sheet_alignment.h"
#include "mesh/disjoint_sets.h"
#include "mesh/edges.h"
#include "mesh/local_measures.h"
#include "mesh/location_text.h"
#include "mesh/surface_columns.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

/// Faces connected across edges of two faces, or of coincident copies of two faces. Each copy is
/// connected separately (coincident_sheets.h).
struct Sheet {
  std::vector<Index> faces;
  /// True if the faces of the sheet are consistently oriented in the input, and also agree with
  /// other sheets at edges of more than two faces.
  bool agreed = true;
  bool has_border = false;  ///< true if the sheet has a border edge (an edge of one face)
  /// True if `agreed` is true for this sheet and for all sheets that coincide with it. Stored only
  /// for one sheet of each set of coincident sheets: copies_.find(sheet).
  bool copies_agreed = true;
  /// Six times the signed volume of the tetrahedra from one point to the faces of the sheet. The
  /// point is the mean corner of the sheet's group (sheets linked by edges of more than two faces).
  double volume = 0;
};

class Orienter {
 public:
  Orienter(const Mesh& mesh, bool keeps_most);
  std::vector<char> find_reversed();

 private:
  void collect_sheet(Index first);
  [[noreturn]] void refuse(Index halfedge, Index across) const;
  bool points_forward(Index halfedge) const;
  void link_sheets();
  void orient_group(const std::vector<Index>& group);
  void measure_volumes(const std::vector<Index>& group);
  double volume(Index sheet) const;
  void improve(std::vector<Index> group, bool has_border);
  void try_outwards(const std::vector<Index>& group);
  void face_outwards(const std::vector<Index>& group);
  void face_as_most(const std::vector<Index>& group);
  void reverse_group(const std::vector<Index>& group);

  const Mesh& mesh_;
  const double scale_;  ///< power of two for coordinates, so that volumes do not overflow
  const bool keeps_most_;
  const Edges edges_;
  /// For each halfedge, the opposite halfedge in the neighboring face of the same sheet, or
  /// no_index.
  std::vector<Index> across_;
  std::vector<Index> sheet_of_;  ///< for each face, the index of its sheet (connected faces)
  /// 1 for each face whose orientation disagrees with the first face of its sheet, so that it must
  /// be reversed.
  std::vector<char> is_reversed_;
  std::vector<Sheet> sheets_;
  std::vector<char> sheet_is_reversed_;
  SheetAlignment links_{0};
  /// Sets of coincident sheets. If one sheet of a set is inconsistently oriented in the input, the
  /// groups (linked sheets) of all sheets of the set are oriented.
  DisjointSets copies_{0};
};

Orienter::Orienter(const Mesh& mesh, bool keeps_most)
    : mesh_(mesh),
      scale_(std::ldexp(1.0, -std::max(extreme_exponent(mesh), -1000))),
      keeps_most_(keeps_most),
      edges_(without_collapsed(mesh.faces), mesh.positions.size()),
      across_(neighbors_in_layers(mesh, edges_)),
      sheet_of_(mesh.faces.size(), no_index),
      is_reversed_(mesh.faces.size(), 0) {
  for (Index first = 0; first < mesh.faces.size(); ++first) {
    if (sheet_of_[first] == no_index) collect_sheet(first);
  }
  sheet_is_reversed_.assign(sheets_.size(), 0);
  links_ = SheetAlignment(sheets_.size());
  copies_ = DisjointSets(sheets_.size());
  link_sheets();
  for (Index sheet = 0; sheet < sheets_.size(); ++sheet)
    if (!sheets_[sheet].agreed) sheets_[copies_.find(sheet)].copies_agreed = false;
}

// True if the halfedge runs from the smaller to the larger vertex index after its face is oriented
// consistently with the first face of its sheet.
bool Orienter::points_forward(Index h) const {
  return is_forward(mesh_.faces, h) != (is_reversed_[h / 3] != 0);
}

void Orienter::collect_sheet(Index first) {
  const auto number = static_cast<Index>(sheets_.size());
  Sheet& sheet = sheets_.emplace_back();
  sheet.faces.push_back(first);
  sheet_of_[first] = number;
  for (std::size_t i = 0; i < sheet.faces.size(); ++i) {
    for (Index k = 0; k < 3; ++k) {
      const Index h = 3 * sheet.faces[i] + k, across = across_[h];
      if (across == no_index) continue;
      if (sheet_of_[across / 3] == no_index) {
        sheet_of_[across / 3] = number;
        is_reversed_[across / 3] = points_forward(h) == points_forward(across);
        if (is_reversed_[across / 3]) sheet.agreed = false;
        sheet.faces.push_back(across / 3);
      } else if (points_forward(h) == points_forward(across)) {
        refuse(h, across);
      }
    }
  }
}

void Orienter::refuse(Index halfedge, Index across) const {
  const Index first = std::min(halfedge, across) / 3, second = std::max(halfedge, across) / 3;
  ErrorData data = edge_data(mesh_, halfedge);
  data.faces = {first, second};
  throw InputError(ErrorKind::one_sided,
                   "faces " + std::to_string(first) + " and " + std::to_string(second) +
                       " cannot have consistent orientations at the " + edge_text(mesh_, halfedge) +
                       ": the surface has only one side, like a Moebius strip",
                   std::move(data));
}

// Links the sheets that end at the same edges of more than two faces (sheet_alignment.h). Marks
// sheets that have borders, joins sheets that coincide, and marks sheets whose orientation
// disagrees with other sheets.
void Orienter::link_sheets() {
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const auto halfedges = edges_.halfedges(e);
    if (halfedges.size() == 1) sheets_[sheet_of_[halfedges[0] / 3]].has_border = true;
    if (halfedges.size() <= 2) continue;
    if (across_[halfedges[0]] != no_index)
      for (const Index h : halfedges) copies_.join(sheet_of_[h / 3], sheet_of_[halfedges[0] / 3]);
    std::map<Index, int> sums;
    int sum_before = 0;
    for (const Index h : halfedges) {
      sums[sheet_of_[h / 3]] += points_forward(h) ? 1 : -1;
      sum_before += points_forward(h) != (is_reversed_[h / 3] != 0) ? 1 : -1;
    }
    links_.add_edge(sums);
    if (std::abs(sum_before) <= 1) continue;
    for (const auto& [sheet, sum] : sums)
      if (sum != 0) sheets_[sheet].agreed = false;
  }
  links_.find_kinds();
}

void Orienter::measure_volumes(const std::vector<Index>& group) {
  Vec3 middle = Vec3::Zero();
  std::size_t count = 0;
  for (const Index sheet : group) {
    for (const Index f : sheets_[sheet].faces) {
      for (const Index v : mesh_.faces[f]) middle += scale_ * mesh_.positions[v];
    }
    count += 3 * sheets_[sheet].faces.size();
  }
  middle /= static_cast<double>(count);
  for (const Index sheet : group) {
    for (const Index f : sheets_[sheet].faces) {
      const auto& [i, j, k] = mesh_.faces[f];
      const Vec3 a = scale_ * mesh_.positions[i] - middle, b = scale_ * mesh_.positions[j] - middle;
      const double part = a.cross(b).dot(scale_ * mesh_.positions[k] - middle);
      sheets_[sheet].volume += is_reversed_[f] ? -part : part;
    }
  }
}

double Orienter::volume(Index sheet) const {
  return sheet_is_reversed_[sheet] ? -sheets_[sheet].volume : sheets_[sheet].volume;
}

// Reverses sheets of a group, the sheets with the smallest volume first, until no reversal is an
// improvement. A reversal is an improvement if it increases the agreement of the sheets. The
// agreement is the number of pairs of faces that traverse a common edge in opposite directions,
// minus the pairs with equal directions (sheet_alignment.h). If it stays the same and the group has
// no border, a larger volume is an improvement, too. Each reversal is an improvement, so the loop
// ends.
void Orienter::improve(std::vector<Index> group, bool has_border) {
  std::stable_sort(group.begin(), group.end(), [&](Index a, Index b) {
    return std::abs(sheets_[a].volume) < std::abs(sheets_[b].volume);
  });
  links_.sum_up(group, sheet_is_reversed_);
  for (bool changed = true; changed;) {
    changed = false;
    for (const Index sheet : group) {
      const bool was_reversed = sheet_is_reversed_[sheet] != 0;
      const std::int64_t agree = links_.agreement(sheet, was_reversed);
      if (agree > 0 || (agree == 0 && (has_border || volume(sheet) >= 0))) continue;
      links_.reverse(sheet, was_reversed);
      sheet_is_reversed_[sheet] = !was_reversed;
      changed = true;
    }
  }
}

// Repeats improve() from another start, in which each sheet has a positive volume. Keeps the new
// result if it is at least as good as the previous one. The agreement of the sheets
// (sheet_alignment.h) is compared first, then the volume.
void Orienter::try_outwards(const std::vector<Index>& group) {
  const auto score = [&] {
    links_.sum_up(group, sheet_is_reversed_);
    std::int64_t agree = 0;
    double sum = 0;
    for (const Index sheet : group) {
      agree += links_.agreement(sheet, sheet_is_reversed_[sheet] != 0);
      sum += volume(sheet);
    }
    return std::pair(agree, std::abs(sum));
  };
  const std::vector<char> before = sheet_is_reversed_;
  const auto score_before = score();
  for (const Index sheet : group) sheet_is_reversed_[sheet] = sheets_[sheet].volume < 0;
  improve(group, false);
  if (score() < score_before) sheet_is_reversed_ = before;
}

void Orienter::reverse_group(const std::vector<Index>& group) {
  for (const Index sheet : group) sheet_is_reversed_[sheet] = !sheet_is_reversed_[sheet];
}

void Orienter::face_outwards(const std::vector<Index>& group) {
  double sum = 0;
  for (const Index sheet : group) sum += volume(sheet);
  if (sum < 0) reverse_group(group);
}

void Orienter::face_as_most(const std::vector<Index>& group) {
  std::size_t reversed = 0, count = 0;
  for (const Index sheet : group) {
    for (const Index f : sheets_[sheet].faces)
      reversed += is_reversed_[f] != sheet_is_reversed_[sheet] ? 1 : 0;
    count += sheets_[sheet].faces.size();
  }
  if (2 * reversed > count) reverse_group(group);
}

void Orienter::orient_group(const std::vector<Index>& group) {
  const auto has_border = [&](Index sheet) { return sheets_[sheet].has_border; };
  const auto agreed = [&](Index sheet) { return sheets_[copies_.find(sheet)].copies_agreed; };
  if (std::all_of(group.begin(), group.end(), agreed)) {
    for (const Index sheet : group) sheet_is_reversed_[sheet] = 0;
    return;
  }
  measure_volumes(group);
  const bool is_open = std::any_of(group.begin(), group.end(), has_border);
  if (group.size() > 1) improve(group, is_open);
  if (is_open) {
    face_as_most(group);
  } else {
    if (group.size() > 1) try_outwards(group);
    keeps_most_ ? face_as_most(group) : face_outwards(group);
  }
}

std::vector<char> Orienter::find_reversed() {
  for (Index first = 0; first < sheets_.size(); ++first) {
    const std::vector<Index> group = links_.align(first, sheet_is_reversed_);
    if (!group.empty()) orient_group(group);
  }
  std::vector<char> is_reversed(mesh_.faces.size());
  for (std::size_t f = 0; f < is_reversed.size(); ++f) {
    is_reversed[f] = is_reversed_[f] != sheet_is_reversed_[sheet_of_[f]];
  }
  return is_reversed;
}

}  // namespace

std::size_t orient_faces(Mesh& mesh, bool keeps_most) {
  const std::vector<char> is_reversed = Orienter(mesh, keeps_most).find_reversed();
  for (std::size_t f = 0; f < is_reversed.size(); ++f) {
    if (!is_reversed[f]) continue;
    std::swap(mesh.faces[f][1], mesh.faces[f][2]);
    reverse_corner_lists(mesh, static_cast<Index>(f));
  }
  return static_cast<std::size_t>(std::count(is_reversed.begin(), is_reversed.end(), 1));
}

bool can_be_oriented(Mesh mesh) {
  try {
    orient_faces(mesh);
  } catch (const InputError&) {
    return false;
  }
  return describe_misorientation(mesh).empty();
}

}  // namespace transformesh
