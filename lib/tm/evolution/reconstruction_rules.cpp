#include "tm/evolution/reconstruction_rules.h"

#include <algorithm>

#include "tm/support/number.h"

namespace transformesh {
namespace {

constexpr double share_at_rest = 0.015;
constexpr double improvement = 0.99;
constexpr double least_coverage_kept = 0.9;
constexpr double least_pixels_kept = 0.5;
/// Of the vertices: fewer outside of silhouettes are none that come in.
constexpr double outside_share = 0.002;
constexpr double entering_share = 0.9;
/// A little below 2, which scales are not exactly.
constexpr double late_scale = 1.99;

constexpr std::size_t exploded_components = 100;
constexpr double exploded_share = 0.3;
/// Of the agreement with silhouettes: as much as the edges of the start leave open.
constexpr double agreement_lost = 0.005;
constexpr double most_disagreement = 0.2;
constexpr double most_doubtful = 0.03;
constexpr double wide_deg = 40;

double real(std::size_t count) { return static_cast<double>(count); }

std::string in_words_of(const SurfaceDoubt& doubt) {
  if (doubt.disagreement > most_disagreement)
    return "photographs disagree by " + fixed(doubt.disagreement, 2) + " beyond their noise";
  const auto thin = std::find_if(doubt.places.begin(), doubt.places.end(),
                                 [](const DoubtfulPlace& place) { return place.is_thin; });
  if (thin != doubt.places.end())
    return "photographs disagree on a film or fin around " + in_words(*thin);
  if (doubt.share > most_doubtful)
    return "photographs disagree on " + fixed(100 * doubt.share, 1) +
           " % of the surface, most around " + in_words(doubt.places.front());
  return {};
}

std::ptrdiff_t fault_count(const std::string& faults) {
  return faults.empty() ? 0 : 1 + std::count(faults.begin(), faults.end(), '+');
}

}  // namespace

PassVerdict LevelRule::add(const Pass& pass) {
  const PhotoStepResult& last = pass.steps.last;
  const bool is_first = done_ == 0;
  if (is_first) {
    coverage_ = pass.steps.first.coverage;
    pixels_ = pass.steps.first.pixels;
  }
  PassVerdict verdict;
  verdict.is_lost = last.coverage < least_coverage_kept * coverage_ ||
                    real(last.pixels) < least_pixels_kept * real(pixels_);
  const bool is_slow = last.mean_share < share_at_rest ||
                       (!is_first && last.dissimilarity > improvement * before_.dissimilarity);
  const bool enters = real(last.outside) > outside_share * real(pass.mesh.vertices) &&
                      (is_first || real(last.outside) < entering_share * real(before_.outside));
  const bool is_other = !is_first && pass.mesh.topology != before_.topology;
  const bool changes = enters || is_other;
  verdict.is_at_rest = !verdict.is_lost && is_slow && !changes;
  verdict.is_late = is_other && is_late_scale(pass.level.scale);
  ++done_;
  verdict.is_done = verdict.is_at_rest || done_ >= (changes ? 2 * passes_ : passes_);

  coverage_ = read_back(significant(coverage_, 6));
  before_ = {read_back(significant(last.dissimilarity, 6)), last.outside, pass.mesh.topology};
  return verdict;
}

void LevelRule::remember(Memory& memory) {
  memory("pass", done_)("dissimilarity", before_.dissimilarity)("outside", before_.outside);
  memory("components", before_.topology.components)("genus", before_.topology.genus);
  memory("coverage", coverage_)("pixels", pixels_);
}

bool is_late_scale(double scale) { return scale < late_scale; }

int WindowRadii::at(double scale) const { return is_late_scale(scale) ? fine : coarse; }

bool is_wide(std::span<const ViewPair> pairs) {
  double sum = 0;
  double views = 0;
  for (std::size_t i = 0; i < pairs.size(); ++views) {
    double nearest = 180;
    const std::size_t view = pairs[i].first;
    for (; i < pairs.size() && pairs[i].first == view; ++i)
      nearest = std::min(nearest, pairs[i].angle_deg);
    sum += nearest;
  }
  return sum > wide_deg * views;
}

bool is_torn(std::size_t pixels_of_start, std::size_t pixels_now) {
  return real(pixels_now) < 0.95 * real(pixels_of_start);
}

bool is_exploded(const Pass& pass, std::size_t components_of_start) {
  const PhotoStepResult& first = pass.steps.first;
  const PhotoStepResult& last = pass.steps.last;
  const std::size_t components = pass.mesh.topology.components;
  if (components > exploded_components && components > 10 * components_of_start) return true;
  if (real(last.outside) > exploded_share * real(pass.mesh.vertices) &&
      last.outside > first.outside)
    return true;
  return last.coverage < exploded_share && last.coverage < first.coverage / 2;
}

double robust_loss(std::optional<double> factor, double dissimilarity) {
  const double loss = factor.value_or(dissimilarity < 0.25 ? 1 : 0) * dissimilarity;
  return loss > 0 ? read_back(significant(std::clamp(loss, 0.001, 1000.0), 9)) : 0;
}

std::string ReconstructionFaults::in_words(const SurfaceEvidence& evidence) const {
  if (lost_at > 0)
    return "photographs compare less of the surface after scale " + fixed(lost_at, 4) +
           " than before";
  if (!is_at_rest) return "the surface was not at rest after the last pass";
  if (late_at > 0)
    return "components or holes came or went as late as at scale " + fixed(late_at, 4) +
           ": maybe films that no photograph shows";
  if (evidence.agreement < evidence.first_agreement - agreement_lost)
    return "the outline agrees with the silhouettes by " + fixed(evidence.agreement, 3) +
           ", that of the start by " + fixed(evidence.first_agreement, 3);
  return in_words_of(evidence.doubt);
}

std::string tracking_faults(const SurfaceQuality& surface, const SurfaceQuality& reference) {
  std::string faults;
  const auto add = [&](bool is_fault, const char* name) {
    if (is_fault && !faults.empty()) faults += '+';
    if (is_fault) faults += name;
  };
  add(surface.dissimilarity > 1.3 * reference.dissimilarity, "dissimilarity");
  add(surface.coverage < 0.9 * reference.coverage, "coverage");
  add(surface.least_agreement < reference.least_agreement - 0.03, "silhouettes");
  return faults;
}

bool is_better(const SurfaceQuality& anew, const SurfaceQuality& tracked,
               const SurfaceQuality& reference) {
  const auto of_anew = fault_count(tracking_faults(anew, reference));
  const auto of_tracked = fault_count(tracking_faults(tracked, reference));
  return of_anew < of_tracked ||
         (of_anew == of_tracked && anew.dissimilarity < tracked.dissimilarity);
}

}  // namespace transformesh
