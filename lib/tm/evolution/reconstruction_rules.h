/// What the passes of a reconstruction (paper 5.3) decide: plain values in, a verdict out.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "tm/evolution/iteration.h"
#include "tm/evolution/memory.h"
#include "tm/evolution/scales.h"
#include "tm/evolution/surface_doubt.h"
#include "tm/views/cameras/view_pairs.h"
#include "tm/views/photo/photo_steps.h"

namespace transformesh {

/// A pass that was made.
struct Pass {
  Level level;
  IterationResult mesh;
  PhotoStepsResult steps;
};

/// Below 2: where the topology should be found, and photographs show what is thin.
bool is_late_scale(double scale);

struct PassVerdict {
  bool is_done = false;     ///< go on with the next level
  bool is_at_rest = false;  ///< hardly moves, and neither enters silhouettes nor changes topology
  /// Since the level began the share of pixels that are compared fell by a tenth, or their number
  /// by half: a surface that photographs agree on because less of it is compared.
  bool is_lost = false;
  /// Components or holes came or went at a scale below 2: films and necks do, and photographs hold
  /// none.
  bool is_late = false;
};

/// When a level of coarse to fine is done: where vertices move by less than 1.5 % of an edge or
/// photographs agree by less than a hundredth better than after the pass before, or after so many
/// passes; but while vertices come in from outside of silhouettes or the topology changes, not
/// before twice as many.
class LevelRule {
 public:
  explicit LevelRule(std::size_t passes = 4) : passes_(passes) {}

  PassVerdict add(const Pass& pass);
  /// A level begins.
  void begin() { *this = LevelRule(passes_); }
  /// After the last pass, with the six digits that the rule remembers.
  double dissimilarity() const { return before_.dissimilarity; }

  void remember(Memory& memory);

 private:
  std::size_t passes_;
  std::size_t done_ = 0;
  struct LastPass {
    double dissimilarity = 0;
    std::size_t outside = 0;
    Topology topology;
  };
  LastPass before_;
  double coverage_ = 0;  ///< that the level began with
  std::size_t pixels_ = 0;
};

/// Radii of the windows in which photographs are compared: larger ones at scale 2 and above find
/// the way where a surface is far off or there is little texture, smaller ones below show detail.
struct WindowRadii {
  int coarse = 3;
  int fine = 3;

  int at(double scale) const;
};

/// Whether even the nearest of the views with which one is compared is on average more than 40
/// degrees apart. Pairs of the same first view stand together.
bool is_wide(std::span<const ViewPair> pairs);

/// Whether edges were too long, so that thin parts of the object are gone, and with them a
/// twentieth of the pixels that are compared. A start that was only too large loses fewer.
bool is_torn(std::size_t pixels_of_start, std::size_t pixels_now);

/// Whether the surface flies apart in a pass: more than 100 components, ten times those of the
/// start; or three tenths of the vertices outside of silhouettes, more than when the pass began; or
/// less than three tenths of the pixels compared, half the share that it was. Such a surface never
/// comes back.
bool is_exploded(const Pass& pass, std::size_t components_of_start);

/// Disagreement at which windows pull by a quarter, at last: `factor` times the mean, which is
/// the dissimilarity. Without a factor it is 1 below a dissimilarity of 0.25 and 0 above, as there
/// not a few windows are wrong. 0: all pull alike.
double robust_loss(std::optional<double> factor, double dissimilarity);

/// What the end of a reconstruction is judged by, beside its passes.
struct SurfaceEvidence {
  double first_agreement = 1;  ///< with exact masks, of the start, as the mean over the views
  double agreement = 1;        ///< of the result
  SurfaceDoubt doubt;
};

/// What keeps the end of a reconstruction from being converged.
struct ReconstructionFaults {
  double lost_at = 0;  ///< scale after which less of the surface was compared than before; 0: none
  double late_at = 0;  ///< scale at which the topology changed late; 0: none
  bool is_at_rest = false;

  /// The first one, empty where there is none. Beside the above: the outline agrees with masks by
  /// 0.005 less than that of the start, photographs disagree by more than 0.2 beyond their noise or
  /// on more than 3 % of what is seen, or a thin place is doubtful.
  std::string in_words(const SurfaceEvidence& evidence) const;
  void remember(Memory& memory) { memory("lost", lost_at)("late", late_at)("rest", is_at_rest); }
};

/// How good the surface of a time step is.
struct SurfaceQuality {
  double dissimilarity = 3;  ///< no surface has more than 2: one that was lost has all faults
  double coverage = 0;
  double least_agreement = 0;  ///< with a silhouette, over the views

  void remember(Memory& memory) {
    memory("dissimilarity", dissimilarity)("coverage", coverage)("agreement", least_agreement);
  }
};

/// What is worse than in the last surface that did not begin with the one before: `dissimilarity`
/// by 1.3 times, `coverage` by a tenth, `silhouettes` by 0.03; joined by +.
std::string tracking_faults(const SurfaceQuality& surface, const SurfaceQuality& reference);

/// Whether a surface made anew is better than the one that was tracked: fewer faults, or as many
/// and less dissimilarity.
bool is_better(const SurfaceQuality& anew, const SurfaceQuality& tracked,
               const SurfaceQuality& reference);

}  // namespace transformesh
