#include "tm/clean/stitch/orient.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdlib>
#include <map>
#include <queue>
#include <string>

#include "tm/mesh/edges.h"
#include "tm/mesh/location_text.h"
#include "tm/support/error.h"

namespace transformesh {
namespace {

struct Sheet {
  std::vector<Index> faces;
  bool agreed = true;              ///< with itself, and at its ends with others
  bool has_border = false;         ///< an edge of one face
  double volume = 0;               ///< six times that of the cone from the middle of the group
  std::map<Index, int> agreement;  ///< with sheets that end at the same edges: by how many pairs of
                                   ///< faces more it would like both to turn, or none, than one
};

/// Relative to how the faces of a sheet agree with its first.
struct Step {
  int strength;
  Index sheet;
  char turn;
  bool operator<(const Step& other) const {
    if (strength != other.strength) return strength < other.strength;
    return sheet != other.sheet ? sheet > other.sheet : turn > other.turn;
  }
};

class Orienter {
 public:
  explicit Orienter(const Mesh& mesh);
  std::vector<char> find_turns();

 private:
  void collect_sheet(Index first);
  [[noreturn]] void refuse(Index halfedge, Index across) const;
  bool runs_up(Index halfedge) const;
  void link_sheets();
  void link_sheets_at_edge(const std::map<Index, int>& sums, bool agreed);
  std::vector<Index> align_group(Index first);
  void orient_group(const std::vector<Index>& group);
  void measure_volumes(const std::vector<Index>& group);
  double volume(Index sheet) const;
  int agreement(Index sheet) const;
  void improve(std::vector<Index> group, bool has_border);
  void try_outwards(const std::vector<Index>& group);
  void face_outwards(const std::vector<Index>& group);
  void face_as_most(const std::vector<Index>& group);
  void turn_group(const std::vector<Index>& group);

  const Mesh& mesh_;
  const Edges edges_;
  std::vector<Index> across_;    ///< per halfedge of an edge of two: the other one
  std::vector<Index> sheet_of_;  ///< per face
  std::vector<char> turned_;     ///< per face: to agree with the first of its sheet
  std::vector<Sheet> sheets_;
  std::vector<char> sheet_turned_;
  std::vector<char> is_aligned_;
};

Orienter::Orienter(const Mesh& mesh)
    : mesh_(mesh),
      edges_(without_collapsed(mesh.faces), mesh.positions.size()),
      across_(neighbors_across(edges_, mesh.faces.size())),
      sheet_of_(mesh.faces.size(), no_index),
      turned_(mesh.faces.size(), 0) {
  for (Index first = 0; first < mesh.faces.size(); ++first) {
    if (sheet_of_[first] == no_index) collect_sheet(first);
  }
  sheet_turned_.assign(sheets_.size(), 0);
  is_aligned_.assign(sheets_.size(), 0);
  link_sheets();
}

// As the face is to be turned.
bool Orienter::runs_up(Index h) const {
  return (halfedge_source(mesh_, h) < halfedge_target(mesh_, h)) != (turned_[h / 3] != 0);
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
        turned_[across / 3] = runs_up(h) == runs_up(across);
        if (turned_[across / 3]) sheet.agreed = false;
        sheet.faces.push_back(across / 3);
      } else if (runs_up(h) == runs_up(across)) {
        refuse(h, across);
      }
    }
  }
}

void Orienter::refuse(Index halfedge, Index across) const {
  throw InputError("faces " + std::to_string(std::min(halfedge, across) / 3) + " and " +
                   std::to_string(std::max(halfedge, across) / 3) + " cannot agree at the " +
                   edge_text(mesh_, halfedge) +
                   ", however faces are turned: the surface has one side only, like a Moebius "
                   "strip; cut it open or remove that part");
}

// Sheets that end at the same edge are to run opposite ways there.
void Orienter::link_sheets() {
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const auto halfedges = edges_.halfedges(e);
    if (halfedges.size() == 1) sheets_[sheet_of_[halfedges[0] / 3]].has_border = true;
    if (halfedges.size() <= 2) continue;
    std::map<Index, int> sums;
    int sum_before = 0;
    for (const Index h : halfedges) {
      sums[sheet_of_[h / 3]] += runs_up(h) ? 1 : -1;
      sum_before += runs_up(h) != (turned_[h / 3] != 0) ? 1 : -1;
    }
    link_sheets_at_edge(sums, std::abs(sum_before) <= 1);
  }
}

void Orienter::link_sheets_at_edge(const std::map<Index, int>& sums, bool agreed) {
  for (const auto& [sheet, sum] : sums) {
    if (sum == 0) continue;
    if (!agreed) sheets_[sheet].agreed = false;
    for (const auto& [other, other_sum] : sums) {
      if (sheet != other && other_sum != 0) sheets_[sheet].agreement[other] -= sum * other_sum;
    }
  }
}

// Visits the sheets that are linked with the first, along the strongest links first.
std::vector<Index> Orienter::align_group(Index first) {
  std::vector<Index> group;
  std::priority_queue<Step> steps;
  steps.push({0, first, 0});
  while (!steps.empty()) {
    const Step step = steps.top();
    steps.pop();
    if (is_aligned_[step.sheet]) continue;
    is_aligned_[step.sheet] = 1;
    sheet_turned_[step.sheet] = step.turn;
    group.push_back(step.sheet);
    for (const auto& [next, agreement] : sheets_[step.sheet].agreement) {
      const char turn = agreement < 0 ? !step.turn : step.turn;
      steps.push({std::abs(agreement), next, turn});
    }
  }
  return group;
}

void Orienter::measure_volumes(const std::vector<Index>& group) {
  Vec3 middle = Vec3::Zero();
  std::size_t count = 0;
  for (const Index sheet : group) {
    for (const Index f : sheets_[sheet].faces) {
      for (const Index v : mesh_.faces[f]) middle += mesh_.positions[v];
    }
    count += 3 * sheets_[sheet].faces.size();
  }
  middle /= static_cast<double>(count);
  for (const Index sheet : group) {
    for (const Index f : sheets_[sheet].faces) {
      const auto& [i, j, k] = mesh_.faces[f];
      const Vec3 a = mesh_.positions[i] - middle, b = mesh_.positions[j] - middle;
      const double part = a.cross(b).dot(mesh_.positions[k] - middle);
      sheets_[sheet].volume += turned_[f] ? -part : part;
    }
  }
}

double Orienter::volume(Index sheet) const {
  return sheet_turned_[sheet] ? -sheets_[sheet].volume : sheets_[sheet].volume;
}

int Orienter::agreement(Index sheet) const {
  int sum = 0;
  for (const auto& [other, agreement] : sheets_[sheet].agreement) {
    sum += sheet_turned_[sheet] == sheet_turned_[other] ? agreement : -agreement;
  }
  return sum;
}

// Turns sheets, small ones first, while that makes more of them agree, or as many and the volume
// larger: so it ends.
void Orienter::improve(std::vector<Index> group, bool has_border) {
  std::stable_sort(group.begin(), group.end(), [&](Index a, Index b) {
    return std::abs(sheets_[a].volume) < std::abs(sheets_[b].volume);
  });
  for (bool changed = true; changed;) {
    changed = false;
    for (const Index sheet : group) {
      const int agree = agreement(sheet);
      if (agree > 0 || (agree == 0 && (has_border || volume(sheet) >= 0))) continue;
      sheet_turned_[sheet] = !sheet_turned_[sheet];
      changed = true;
    }
  }
}

// From where all look outwards one by one, if that leads further than from where they are.
void Orienter::try_outwards(const std::vector<Index>& group) {
  const auto score = [&] {
    long agree = 0;
    double sum = 0;
    for (const Index sheet : group) {
      agree += agreement(sheet);
      sum += volume(sheet);
    }
    return std::pair(agree, std::abs(sum));
  };
  const std::vector<char> before = sheet_turned_;
  const auto score_before = score();
  for (const Index sheet : group) sheet_turned_[sheet] = sheets_[sheet].volume < 0;
  improve(group, false);
  if (score() < score_before) sheet_turned_ = before;
}

void Orienter::turn_group(const std::vector<Index>& group) {
  for (const Index sheet : group) sheet_turned_[sheet] = !sheet_turned_[sheet];
}

void Orienter::face_outwards(const std::vector<Index>& group) {
  double sum = 0;
  for (const Index sheet : group) sum += volume(sheet);
  if (sum < 0) turn_group(group);
}

void Orienter::face_as_most(const std::vector<Index>& group) {
  std::size_t turns = 0, count = 0;
  for (const Index sheet : group) {
    for (const Index f : sheets_[sheet].faces) turns += turned_[f] != sheet_turned_[sheet] ? 1 : 0;
    count += sheets_[sheet].faces.size();
  }
  if (2 * turns > count) turn_group(group);
}

void Orienter::orient_group(const std::vector<Index>& group) {
  const auto has_border = [&](Index sheet) { return sheets_[sheet].has_border; };
  const auto agreed = [&](Index sheet) { return sheets_[sheet].agreed; };
  if (std::all_of(group.begin(), group.end(), agreed)) {
    for (const Index sheet : group) sheet_turned_[sheet] = 0;
    return;
  }
  measure_volumes(group);
  const bool is_open = std::any_of(group.begin(), group.end(), has_border);
  if (group.size() > 1) improve(group, is_open);
  if (is_open) {
    face_as_most(group);
  } else {
    if (group.size() > 1) try_outwards(group);
    face_outwards(group);
  }
}

std::vector<char> Orienter::find_turns() {
  for (Index first = 0; first < sheets_.size(); ++first) {
    if (!is_aligned_[first]) orient_group(align_group(first));
  }
  std::vector<char> turns(mesh_.faces.size());
  for (std::size_t f = 0; f < turns.size(); ++f) {
    turns[f] = turned_[f] != sheet_turned_[sheet_of_[f]];
  }
  return turns;
}

}  // namespace

std::size_t orient_faces(Mesh& mesh) {
  const std::vector<char> turns = Orienter(mesh).find_turns();
  for (std::size_t f = 0; f < turns.size(); ++f) {
    if (turns[f]) std::swap(mesh.faces[f][1], mesh.faces[f][2]);
  }
  return static_cast<std::size_t>(std::count(turns.begin(), turns.end(), 1));
}

}  // namespace transformesh
