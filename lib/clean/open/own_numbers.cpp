#include "clean/open/own_numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

#include "clean/exterior/angular_order.h"

namespace transformesh {
namespace {

/// Half of the width of bounds above which a number is computed. A smaller value computes more
/// numbers, a larger one leaves more patches undecided. Affects time only.
constexpr double most_uncertain = 0.05;

/// Bound of the error of a computed number, far above rounding errors.
constexpr double error_of_number = 1e-6;

/// The number at the point `at` is at most `uncertainty` away from `number`.
struct Estimate {
  Vec3 at;
  double number, uncertainty;
};

struct Patch {
  Box box{};
  double gradient = 0;       ///< bound in the box
  double area = 0;           ///< twice the area of `largest`
  Index largest = no_index;  ///< the largest piece
};

double farthest_distance(const Vec3& point, const Box& box) {
  return (point - box.min()).cwiseAbs().cwiseMax((box.max() - point).cwiseAbs()).stableNorm();
}

}  // namespace

/// Carries estimates of the number of one component from patch to patch.
class OwnNumbers::Growth {
 public:
  Growth(OwnNumbers& numbers, Index component, std::span<const std::vector<Index>* const> patches)
      : arrangement_(numbers.arrangement_),
        winding_(numbers.winding_),
        component_(component),
        gradient_(winding_.mesh_of(component)),
        estimates_(patches.size()) {
    for (const std::vector<Index>* pieces : patches) add_patch(*pieces);
    const std::vector<Step>& steps = numbers.steps_[component];
    steps_of_.resize(patches.size());
    for (const Step& step : steps) {
      // A patch may contain pieces of several components, if their borders coincide. It has the
      // component of one of them, so that a step to another piece may lead to no patch.
      if (!patch_of_.contains(step.from) || !patch_of_.contains(step.to)) continue;
      const Index from = patch_of_[step.from], to = patch_of_[step.to];
      if (from == to) continue;
      steps_of_[from].push_back({from, to, step.difference, step.at});
      steps_of_[to].push_back({to, from, -step.difference, step.at});
    }
  }

  std::vector<NumberBounds> bounds() {
    std::vector<Index> order(patches_.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return patches_[a].area > patches_[b].area; });
    for (const Index first : order)
      if (std::isfinite(patches_[first].gradient) && !estimates_[first]) grow_from(first);
    std::vector<NumberBounds> result(patches_.size());
    for (std::size_t p = 0; p < result.size(); ++p) result[p] = bounds_of(p);
    return result;
  }

 private:
  void add_patch(const std::vector<Index>& pieces) {
    Patch patch;
    for (const Index p : pieces) {
      patch_of_[p] = static_cast<Index>(patches_.size());
      const auto& [a, b, c] = arrangement_.pieces[p].corners;
      const Vec3 at = arrangement_.position(a);
      for (const Index corner : {a, b, c}) patch.box.extend(arrangement_.position(corner));
      const double area =
          (arrangement_.position(b) - at).cross(arrangement_.position(c) - at).stableNorm();
      if (patch.largest != no_index && area <= patch.area) continue;
      patch.area = area;
      patch.largest = p;
    }
    patch.gradient = gradient_.in(patch.box);
    patches_.push_back(patch);
  }

  Estimate compute(const Patch& patch) {
    return {winding_.centroid(patch.largest), winding_.number_at(component_, patch.largest),
            error_of_number};
  }

  static double half_width(const Estimate& estimate, const Patch& patch) {
    return estimate.uncertainty + patch.gradient * farthest_distance(estimate.at, patch.box);
  }

  void grow_from(Index first) {
    std::queue<Index> front;
    const auto reach = [&](Index patch, const Estimate& estimate) {
      estimates_[patch] = estimate;
      front.push(patch);
    };
    reach(first, compute(patches_[first]));
    for (; !front.empty(); front.pop()) {
      const Index from = front.front();
      for (const Step& step : steps_of_[from])
        if (std::isfinite(patches_[step.to].gradient) && !estimates_[step.to])
          reach(step.to, improved(carried(step), patches_[step.to]));
    }
  }

  Estimate carried(const Step& step) const {
    const Estimate& from = *estimates_[step.from];
    const double change = patches_[step.from].gradient * (step.at - from.at).stableNorm();
    return {step.at, from.number + step.difference, from.uncertainty + change};
  }

  // Returns a computed number instead of an estimate that is too uncertain. Keeps the estimate if
  // the computed number contradicts it: then the piece is so thin that rounding has moved its
  // centroid across another part of the surface.
  Estimate improved(const Estimate& estimate, const Patch& patch) {
    const double width = half_width(estimate, patch);
    if (width <= most_uncertain) return estimate;
    const Estimate computed = compute(patch);
    return std::abs(computed.number - estimate.number) <= width + error_of_number ? computed
                                                                                  : estimate;
  }

  NumberBounds bounds_of(std::size_t p) const {
    const auto& estimate = estimates_[p];
    const double width =
        estimate ? half_width(*estimate, patches_[p]) : std::numeric_limits<double>::infinity();
    const double number = estimate ? estimate->number : 0;
    return {number - width, number + width};
  }

  const Arrangement& arrangement_;
  ComponentWinding& winding_;
  Index component_;
  BorderGradient gradient_;
  std::vector<Patch> patches_;
  std::map<Index, Index> patch_of_;          ///< patch of each piece
  std::vector<std::vector<Step>> steps_of_;  ///< for each patch, the steps to other patches
  std::vector<std::optional<Estimate>> estimates_;
};

OwnNumbers::OwnNumbers(const Arrangement& arrangement, ComponentWinding& winding)
    : arrangement_(arrangement), winding_(winding), cancelled_(arrangement.point_count()) {
  for (const Piece& piece : arrangement.pieces)
    if (piece.multiplicity == 0)
      for (const Index corner : piece.corners) cancelled_[corner] = 1;
}

void OwnNumbers::add_edge(std::span<const Index> sorted, Index component) {
  const auto& pieces = arrangement_.pieces;
  const Index source = halfedge_source(pieces, sorted[0]);
  const Index target = halfedge_target(pieces, sorted[0]);
  if (cancelled_[source] && cancelled_[target]) return;
  std::vector<Index> own;
  for (const Index h : sorted) {
    const Piece& piece = pieces[h / 3];
    if (winding_.component_of(h / 3) != component) {
      if (piece.source_count > 1) return;
      continue;
    }
    if (piece.source_count != 1) return;
    own.push_back(h);
  }
  int balance = 0;
  for (const Index h : own) balance += is_forward(pieces, h) ? -1 : 1;
  if (balance != 0) return;
  // The winding number decreases from the back of a piece to its front.
  const Vec3 at = arrangement_.position(source) / 2 + arrangement_.position(target) / 2;
  for (std::size_t i = 1; i < own.size(); ++i) {
    const double before = is_forward(pieces, own[i - 1]) ? -0.5 : 0.5;
    const double after = is_forward(pieces, own[i]) ? -0.5 : 0.5;
    steps_[component].push_back({own[i - 1] / 3, own[i] / 3, before + after, at});
  }
}

std::vector<NumberBounds> OwnNumbers::bound(Index component,
                                            std::span<const std::vector<Index>* const> patches) {
  return Growth(*this, component, patches).bounds();
}

}  // namespace transformesh
