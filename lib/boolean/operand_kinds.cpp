#include "boolean/operand_kinds.h"

#include <algorithm>
#include <set>
#include <unordered_map>

#include "clean/exterior/ray_cast_front_winding.h"
#include "clean/intersect/contacts.h"
#include "mesh/edges.h"

namespace transformesh {
namespace {

/// Finds the connected components of operands, and facts that determine the OperandKind of each
/// operand.
class OperandParts {
 public:
  OperandParts(const WeldedMesh& welded, const JoinedOperands& operands)
      : welded_(welded), operands_(operands), operand_(operands.is_reversed.size()) {}
  std::vector<OperandKind> classify(std::span<const Meeting> meetings);

 private:
  struct Facts {
    /// True if an edge is traversed more often in one direction than in the other.
    bool is_open = false;
    /// True if an edge has more than two faces; faces are not connected across this edge.
    bool is_crowded = false;
    bool has_copies = false;    ///< true if two faces have the same three points
    bool meets_part = false;    ///< true if two faces of the same connected component intersect
    bool meets_itself = false;  ///< true if any two faces of the operand intersect
    /// Least and largest winding number just in front of the components of the operand; the range
    /// includes 0. If the operand is subtracted, and thus reversed, these are the numbers before
    /// the reversal.
    int least = 0, most = 0;
  };

  Index operand_of(Index face) const { return operands_.operand_of[welded_.face_of[face]]; }
  void find_components();
  void collect_component(Index first);
  void pair_at_crowded_edges();
  void pair_at_edge(std::span<const Index> halfedges);
  void find_copies();
  void note_meeting(Index first, Index second);
  void note_meetings(std::span<const Meeting> meetings);
  void cast_rays();
  int winding_in_front_of(Index seed, const RayCastFrontWinding& ray) const;
  static bool is_known(const Facts& facts);
  static OperandKind kind(const Facts& facts);

  const WeldedMesh& welded_;
  const JoinedOperands& operands_;
  std::vector<Facts> operand_;
  /// Opposite of each halfedge among the faces of the same operand; no_index if there is none, or
  /// more than one.
  std::vector<Index> opposites_;
  std::vector<Index> component_of_;  ///< component of each face
  std::vector<Index> seeds_;         ///< the first face of each component
  /// Maps the first of several faces with equal corners to all of them.
  std::unordered_map<Index, std::set<Index>> copies_;
};

// Pairs the halfedges at an edge, separately for each operand. Also notes whether an operand is
// open at this edge, or has more than two faces there.
void OperandParts::pair_at_edge(std::span<const Index> halfedges) {
  for (const Index h : halfedges) {
    Facts& facts = operand_[operand_of(h / 3)];
    const auto is_forward = [&](Index k) {
      return welded_.faces[k / 3][k % 3] == welded_.faces[h / 3][h % 3];
    };
    Index other = no_index;
    int faces = 0, sum = 0;
    for (const Index k : halfedges) {
      if (operand_of(k / 3) != operand_of(h / 3)) continue;
      ++faces;
      sum += is_forward(k) ? 1 : -1;
      if (k != h) other = k;
    }
    facts.is_open |= sum != 0;
    facts.is_crowded |= faces > 2;
    if (faces == 2 && sum == 0) opposites_[h] = other;
  }
}

void OperandParts::pair_at_crowded_edges() {
  opposites_ = welded_.opposites;
  bool is_crowded = false;
  for (Index h = 0; h < opposites_.size(); ++h) {
    Index& other = opposites_[h];
    if (other != no_index && operand_of(other / 3) != operand_of(h / 3)) other = no_index;
    is_crowded |= other == no_index;
  }
  for (std::size_t e = 0; is_crowded && e < welded_.edges.size(); ++e) {
    const auto halfedges = welded_.edges.halfedges(e);
    if (opposites_[halfedges[0]] == no_index) pair_at_edge(halfedges);
  }
}

void OperandParts::collect_component(Index first) {
  const auto component = static_cast<Index>(seeds_.size());
  seeds_.push_back(first);
  component_of_[first] = component;
  std::vector<Index> stack{first};
  while (!stack.empty()) {
    const Index face = stack.back();
    stack.pop_back();
    for (Index i = 0; i < 3; ++i) {
      const Index other = opposites_[3 * face + i];
      if (other == no_index || component_of_[other / 3] != no_index) continue;
      component_of_[other / 3] = component;
      stack.push_back(other / 3);
    }
  }
}

void OperandParts::find_components() {
  pair_at_crowded_edges();
  component_of_.assign(welded_.faces.size(), no_index);
  for (Index f = 0; f < component_of_.size(); ++f)
    if (component_of_[f] == no_index) collect_component(f);
}

// Collects groups of faces with the same three points. This is necessary because the intersecting
// pairs (Meeting) contain only the first face of each group, and no pairs within a group.
void OperandParts::find_copies() {
  for (Index f = 0; f < welded_.faces.size(); ++f) {
    const Index first = welded_.first_copy[f];
    if (first == f) continue;
    copies_[first].insert({first, f});
  }
  for (const auto& [first, faces] : copies_) {
    std::set<Index> seen;
    for (const Index face : faces)
      if (!seen.insert(operand_of(face)).second) operand_[operand_of(face)].has_copies = true;
  }
}

void OperandParts::note_meeting(Index first, Index second) {
  if (operand_of(first) != operand_of(second)) return;
  Facts& facts = operand_[operand_of(first)];
  facts.meets_itself = true;
  facts.meets_part |= component_of_[first] == component_of_[second];
}

void OperandParts::note_meetings(std::span<const Meeting> meetings) {
  const auto visit_copies = [&](Index face, const auto& visit) {
    const auto copies = copies_.find(face);
    if (copies == copies_.end()) return visit(face);
    for (const Index copy : copies->second) visit(copy);
  };
  for (const Meeting& meeting : meetings)
    visit_copies(meeting.first, [&](Index first) {
      visit_copies(meeting.second, [&](Index second) { note_meeting(first, second); });
    });
}

int OperandParts::winding_in_front_of(Index seed, const RayCastFrontWinding& ray) const {
  const bool is_alone = !operand_[operand_of(seed)].meets_itself;
  int winding = 0;
  for (const FaceCrossing& crossing : ray.crossings_in_front_of(seed)) {
    if (operand_of(crossing.face) != operand_of(seed)) continue;
    if (is_alone || component_of_[crossing.face] == component_of_[seed])
      winding += crossing.winding;
  }
  return winding;
}

// Finds the winding number of an operand in front of each of its components. If faces of the
// operand intersect, each ray counts only faces of the component from which it starts.
void OperandParts::cast_rays() {
  const RayCastFrontWinding ray(welded_, seeds_.size());
  for (const Index seed : seeds_) {
    Facts& facts = operand_[operand_of(seed)];
    if (!is_known(facts)) continue;
    const int winding = winding_in_front_of(seed, ray);
    const int front = operands_.is_reversed[operand_of(seed)] ? -winding - 1 : winding;
    facts.least = std::min(facts.least, front);
    facts.most = std::max(facts.most, front);
  }
}

bool OperandParts::is_known(const Facts& facts) {
  return !facts.is_open && !facts.has_copies && !facts.meets_part &&
         !(facts.meets_itself && facts.is_crowded);
}

OperandKind OperandParts::kind(const Facts& facts) {
  if (!is_known(facts) || facts.least < 0) return OperandKind::unknown;
  return facts.meets_itself || facts.most > 0 ? OperandKind::not_negative : OperandKind::simple;
}

std::vector<OperandKind> OperandParts::classify(std::span<const Meeting> meetings) {
  find_components();
  find_copies();
  note_meetings(meetings);
  cast_rays();
  std::vector<OperandKind> kinds;
  for (const Facts& facts : operand_) kinds.push_back(kind(facts));
  return kinds;
}

}  // namespace

std::vector<OperandKind> find_operand_kinds(const WeldedMesh& welded,
                                            std::span<const Meeting> meetings,
                                            const JoinedOperands& operands) {
  return OperandParts(welded, operands).classify(meetings);
}

}  // namespace transformesh
