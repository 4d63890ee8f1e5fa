#include "tm/evolution/reconstruction_rules.h"

#include <algorithm>

#include "tm/evolution/csv_row.h"

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

double real(std::size_t count) { return static_cast<double>(count); }

std::ptrdiff_t fault_count(const std::string& faults) {
  return faults.empty() ? 0 : 1 + std::count(faults.begin(), faults.end(), '+');
}

}  // namespace

PassVerdict LevelRule::add(const PassMeasures& m) {
  const bool is_first = done_ == 0;
  if (is_first) {
    coverage_ = m.first_coverage;
    pixels_ = m.first_pixels;
  }
  PassVerdict verdict;
  verdict.is_lost = m.coverage < least_coverage_kept * coverage_ ||
                    real(m.pixels) < least_pixels_kept * real(pixels_);
  const bool is_slow = m.mean_share < share_at_rest ||
                       (!is_first && m.dissimilarity > improvement * before_.dissimilarity);
  const bool enters = real(m.outside) > outside_share * real(m.vertices) &&
                      (is_first || real(m.outside) < entering_share * real(before_.outside));
  const bool is_other = !is_first && m.topology != before_.topology;
  const bool changes = enters || is_other;
  verdict.is_at_rest = !verdict.is_lost && is_slow && !changes;
  verdict.is_late = is_other && m.scale < late_scale;
  ++done_;
  verdict.is_done = verdict.is_at_rest || done_ >= (changes ? 2 * passes_ : passes_);

  coverage_ = read_back(significant(coverage_, 6));
  before_ = {read_back(significant(m.dissimilarity, 6)), m.outside, m.topology};
  return verdict;
}

Values LevelRule::values() const {
  return {{"pass", real(done_)},
          {"dissimilarity", before_.dissimilarity},
          {"outside", real(before_.outside)},
          {"components", real(before_.topology.components)},
          {"genus", static_cast<double>(before_.topology.genus)},
          {"coverage", coverage_},
          {"pixels", real(pixels_)}};
}

void LevelRule::restore(const Values& values) {
  const auto count = [&](const char* name) {
    return static_cast<std::size_t>(value_or(values, name, 0));
  };
  done_ = count("pass");
  before_ = {value_or(values, "dissimilarity", 0),
             count("outside"),
             {count("components"), static_cast<long>(value_or(values, "genus", 0))}};
  coverage_ = value_or(values, "coverage", 0);
  pixels_ = count("pixels");
}

bool is_torn(std::size_t pixels_of_start, std::size_t pixels_now) {
  return real(pixels_now) < 0.95 * real(pixels_of_start);
}

double robust_loss(std::optional<double> factor, double dissimilarity) {
  const double loss = factor.value_or(dissimilarity < 0.25 ? 1 : 0) * dissimilarity;
  return loss > 0 ? read_back(significant(std::clamp(loss, 0.001, 1000.0), 9)) : 0;
}

std::string fault_of(const ReconstructionFaults& faults) {
  if (faults.lost_at > 0)
    return "photographs compare less of the surface after scale " + fixed(faults.lost_at, 4) +
           " than before";
  if (!faults.is_at_rest) return "the surface was not at rest after the last pass";
  if (faults.late_at > 0)
    return "components or holes came or went as late as at scale " + fixed(faults.late_at, 4) +
           ": maybe films that no photograph shows";
  return {};
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
