#include "transformesh/reconstruct.h"

#include <algorithm>
#include <limits>

#include "evolution/loop/csv_row.h"
#include "evolution/loop/iteration_text.h"
#include "evolution/loop/loop.h"
#include "evolution/loop/record.h"
#include "evolution/loop/stages.h"
#include "evolution/loop/stopwatch.h"
#include "io/document/round_as_written.h"
#include "reconstruction/convergence.h"
#include "reconstruction/image_scales.h"
#include "reconstruction/initial_mesh.h"
#include "reconstruction/initial_state.h"
#include "reconstruction/recorded_reconstruction.h"
#include "reconstruction/scale_rule.h"
#include "reconstruction/start_comparison.h"
#include "reconstruction/surface_doubt.h"
#include "reconstruction/sweep_rules.h"
#include "support/counted.h"
#include "support/number.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/handles.h"
#include "transformesh/hull.h"
#include "transformesh/mesh_io.h"
#include "views/cameras/view.h"
#include "views/hull/silhouette.h"
#include "views/photo/photo_scene.h"
#include "views/photo/photo_steps.h"

namespace transformesh {
namespace {

/// Factor by which the stiffness grows after each explosion of the surface, and the limit of the
/// total factor.
constexpr double stiffer = 4;
constexpr double most_stiffness = 16;
/// PairOptions::spread above scale 1.
constexpr double near_spread = 1.5;
/// Least scale at which the loop starts again after an explosion; at finer scales too much work
/// would be repeated. Slightly below 2, because scales are rounded.
constexpr double stiffer_scale = 1.99;

/// The photographs at the most recently requested scale, and steps towards them.
class Photographs {
 public:
  Photographs(std::vector<View>& views, int width, const ReconstructionOptions& options,
              const InitialState& initial_state);

  /// Takes the steps of a sweep. The stiffness of the options is multiplied by `stiffness`.
  PhotoStepsResult sweep(Mesh& mesh, double scale, double loss, double stiffness,
                         const Progress& progress);
  /// Measures the surface by a step without movement. Compares pairs of views in one order or in
  /// both.
  PhotoStepResult look(Mesh mesh, double scale, bool in_one_order, const Progress& progress);
  /// Measures the surface at scale 1.
  SurfaceMeasures measures(const Mesh& mesh, const Progress& progress);
  int width() const { return width_; }
  double pixel() const { return pixel_size(views_); }

 private:
  const PhotoScene& at(double scale);
  /// Returns SurfaceMeasures::outlines.
  std::vector<double> outlines(const Mesh& mesh);
  /// Returns the options with the window radius of the scale and the silhouette weight for its
  /// pairs.
  PhotoStepsOptions steps_at(double scale);

  std::vector<View>& views_;
  int width_;
  bool spends_views_;
  PairOptions pairs_;
  /// Pairs above scale 1, where the surface may be inaccurate. Views that are far apart would
  /// compare places that the true surface occludes.
  PairOptions near_pairs_;
  PhotoStepsOptions steps_;
  std::optional<double> pull_;
  bool are_outlines_;  ///< true if silhouettes are outlines of the hull
  WindowRadii windows_;
  double scale_ = 0;  ///< scale of `scene_`; 0: none
  PhotoScene scene_;
};

Photographs::Photographs(std::vector<View>& views, int width, const ReconstructionOptions& options,
                         const InitialState& initial_state)
    : views_(views),
      width_(width),
      spends_views_(options.spends_views),
      pairs_(options.pairs),
      near_pairs_(options.pairs),
      steps_{.step = options.step},
      pull_(options.pull),
      are_outlines_(initial_state.outlined.has_value()),
      windows_(options.windows) {
  near_pairs_.spread = near_spread;
  steps_.iterations = options.iterations.value_or(initial_state.coarsest ? 8 : 5);
  steps_.momentum = options.momentum;
  steps_.step.meaning = are_outlines_ ? SilhouetteMeaning::least : options.initial.meaning;
}

const PhotoScene& Photographs::at(double scale) {
  if (scale == scale_) return scene_;
  scene_ = PhotoScene();
  // No other scale follows scale 1, so that the views are not needed any more.
  const bool is_last = spends_views_ && scale == 1;
  const PairOptions& pairs = scale > 1 ? near_pairs_ : pairs_;
  scene_ = is_last ? take_photo_scene(views_, scale, pairs) : photo_scene(views_, scale, pairs);
  scale_ = scale;
  return scene_;
}

PhotoStepsOptions Photographs::steps_at(double scale) {
  PhotoStepsOptions options = steps_;
  const double pull = pull_.value_or(is_wide(at(scale).pairs) ? 1.5 : 0.5);
  options.step.silhouettes = are_outlines_ ? read_back(significant(0.2 * pull, 9)) : pull;
  options.step.photographs.correlation.radius = windows_.at(scale);
  return options;
}

PhotoStepsResult Photographs::sweep(Mesh& mesh, double scale, double loss, double stiffness,
                                    const Progress& progress) {
  PhotoStepsOptions options = steps_at(scale);
  options.alternate = true;
  options.step.photographs.correlation.robust = loss;
  options.step.stiffness *= stiffness;
  return photo_steps(mesh, at(scale), options, progress);
}

PhotoStepResult Photographs::look(Mesh mesh, double scale, bool in_one_order,
                                  const Progress& progress) {
  PhotoStepsOptions options = steps_at(scale);
  options.iterations = 1;
  options.alternate = in_one_order;
  options.step.alpha = 0;
  return photo_steps(mesh, at(scale), options, progress).first;
}

SurfaceMeasures Photographs::measures(const Mesh& mesh, const Progress& progress) {
  return {
      look(mesh, 1, false, progress),
      surface_doubt(mesh, at(1), steps_.step.least_cosine, steps_at(1).step.photographs, progress),
      outlines(mesh)};
}

// Uses distances from silhouettes at scale 1, because silhouettes may have been cleared.
std::vector<double> Photographs::outlines(const Mesh& mesh) {
  std::vector<double> agreements;
  if (steps_.step.meaning != SilhouetteMeaning::exact) return agreements;
  const PhotoScene& scene = at(1);
  for (std::size_t v = 0; v < scene.views.size(); ++v) {
    if (scene.distances[v].empty()) continue;
    GrayImage silhouette = scene.distances[v];
    for (float& intensity : silhouette.pixels) intensity = intensity < 0 ? 255.0F : 0.0F;
    agreements.push_back(silhouette_agreement(mesh_silhouette(mesh, scene.views[v]), silhouette));
  }
  return agreements;
}

ScaleOptions scales_of(const ReconstructionOptions& options, const InitialState& initial_state) {
  ScaleOptions scales = options.scales;
  if (initial_state.coarsest) scales.largest = std::min(scales.largest, *initial_state.coarsest);
  return scales;
}

class ReconstructionLoop : public Loop {
 public:
  ReconstructionLoop(Photographs& photographs, const InitialState& initial_state,
                     const ReconstructionOptions& options)
      : photographs_(photographs),
        initial_(initial_state.document),
        options_(options),
        scale_steps_(coarse_to_fine(scales_of(options, initial_state), photographs.width(),
                                    photographs.pixel())),
        rule_(options.sweeps) {}

  std::string noun() const override { return "sweep"; }
  std::string column() const override { return "pass"; }
  void start(Document& document, const Progress& progress) override;
  void advance(Document& document, std::size_t iteration, const Progress& progress) override;
  bool is_done() const override { return scale_step_ == scale_steps_.size(); }
  void finish(Document& document, const Progress& progress) override;

  void remember(LoopState& loop_state) override;
  void measure(CsvRow& row) const override;
  std::string message() const override;

  const ReconstructionResult& result() const { return result_; }

 private:
  void judge(Document& document, const Progress& progress);
  void keep_start(Document& document, const std::string& reason);
  bool may_begin_finer() const;
  bool begins_stiffer(Document& document, const Progress& progress);
  bool drops_handles(Document& document, const Progress& progress);
  void drop_crumbs(Document& document);
  void begin_finer(Document& document, const Progress& progress);
  bool takes_sweep(Document& document, const Progress& progress);
  void take_sweep(Document& document, const Progress& progress);
  bool begin_robust();
  void begin_next_scale(Document& document, const Progress& progress);
  std::size_t pixels_compared(const Document& document, const Progress& progress) const {
    return photographs_.look(document.mesh, sweep_.scale_step.scale, true, progress).pixels;
  }

  Photographs& photographs_;
  const Document& initial_;
  const ReconstructionOptions& options_;
  std::vector<ScaleStep> scale_steps_;

  // State that is kept from sweep to sweep.
  std::size_t first_ = 0;       ///< index of the first scale
  std::size_t scale_step_ = 0;  ///< index of the scale of the next sweep
  ScaleRule rule_;
  ReconstructionFaults faults_;
  double loss_ = 0;
  double stiffness_ = 1;     ///< factor of the stiffness in the options
  std::size_t handles_ = 0;  ///< number of removed handles

  Sweep sweep_;  ///< the last sweep
  ReconstructionResult result_;
};

void ReconstructionLoop::start(Document& document, const Progress& progress) {
  document = initial_;
  document.mesh.vertex_columns.erase(doubt_column);
  coarsen(document, scale_steps_[scale_step_].edge, progress);
}

// True if all sweeps so far were at the first scale, and that scale was chosen by default.
bool ReconstructionLoop::may_begin_finer() const {
  return !options_.scales.coarsest && scale_step_ == first_ &&
         scale_step_ + 1 < scale_steps_.size();
}

void ReconstructionLoop::begin_finer(Document& document, const Progress& progress) {
  if (options_.on_detail)
    options_.on_detail("scale " + fixed(sweep_.scale_step.scale, 4) +
                       " is too coarse for this surface: beginning anew at the next");
  scale_step_ = ++first_;
  faults_.lost_at = 0;
  rule_.begin();
  start(document, progress);
}

// Returns true if the last sweep made the surface explode, and starts again with a stiffer one.
bool ReconstructionLoop::begins_stiffer(Document& document, const Progress& progress) {
  if (!is_exploded(sweep_, connected_components(initial_.mesh).components.size())) return false;
  const std::string what = "the surface explodes at scale " + fixed(sweep_.scale_step.scale, 4);
  if (sweep_.scale_step.scale < stiffer_scale || stiffness_ >= most_stiffness)
    throw GoalError(ErrorKind::surface_explodes,
                    what + ": photographs, cameras and masks may not belong together");
  stiffness_ *= stiffer;
  if (options_.on_note)
    options_.on_note(what + ": beginning anew, " + fixed(stiffness_, 0) + " times as stiff");
  scale_step_ = first_;
  faults_ = {};
  rule_.begin();
  start(document, progress);
  return true;
}

// Returns true if handles were removed. The mesh must then be cleaned again.
bool ReconstructionLoop::drops_handles(Document& document, const Progress& progress) {
  if (options_.handles == 0) return false;
  const HandleOptions options{options_.handles * scale_steps_.back().edge,
                              document.style.coordinate};
  const std::size_t removed = remove_handles(document.mesh, options, progress).removed;
  handles_ += removed;
  return removed > 0;
}

void ReconstructionLoop::drop_crumbs(Document& document) {
  const Components parts = connected_components(document.mesh);
  double largest = 0;
  for (const Component& part : parts.components) largest = std::max(largest, part.volume);
  std::vector<bool> keeps;
  for (const Component& part : parts.components)
    keeps.push_back(part.volume >= options_.crumbs * largest);
  result_.crumbs = static_cast<std::size_t>(std::count(keeps.begin(), keeps.end(), false));
  if (result_.crumbs == 0) return;
  std::vector<bool> keeps_face;
  for (const Index part : parts.of_face) keeps_face.push_back(keeps[part]);
  document.mesh = select_faces(document.mesh, keeps_face);
  const Components kept = connected_components(document.mesh);
  result_.topology = {kept.components.size(), kept.genus()};
}

void ReconstructionLoop::take_sweep(Document& document, const Progress& progress) {
  Stopwatch watch;
  IterationResult& mesh = sweep_.mesh;
  sweep_.scale_step = scale_steps_[scale_step_];
  remesh_to(document, sweep_.scale_step.edge, 2, progress);
  mesh.seconds_remesh = watch.lap();

  mesh.vertices = document.mesh.positions.size();
  sweep_.steps =
      photographs_.sweep(document.mesh, sweep_.scale_step.scale, loss_, stiffness_, progress);
  round_as_written(document);
  mesh.seconds_step = watch.lap();

  const CleanedTopology cleaned = clean_in_place(document, progress);
  mesh.pairs = cleaned.pairs;
  mesh.topology = cleaned.topology;
  if (is_late_scale(sweep_.scale_step.scale) && drops_handles(document, progress))
    mesh.topology = clean_in_place(document, progress).topology;
  mesh.faces = document.mesh.faces.size();
  mesh.seconds_clean = watch.lap();
}

bool ReconstructionLoop::takes_sweep(Document& document, const Progress& progress) {
  try {
    take_sweep(document, progress);
    return true;
  } catch (const CancelledError&) {
    throw;
  } catch (const std::runtime_error&) {
    if (!may_begin_finer()) throw;
    return false;
  }
}

void ReconstructionLoop::advance(Document& document, std::size_t /*iteration*/,
                                 const Progress& progress) {
  while (!takes_sweep(document, progress)) begin_finer(document, progress);
  if (begins_stiffer(document, progress)) return;
  const SweepVerdict verdict = rule_.add(sweep_);
  faults_.is_at_rest = verdict.is_at_rest;
  if (verdict.is_late && scale_step_ > first_) faults_.late_at = sweep_.scale_step.scale;
  if (!verdict.is_done) return;
  if (verdict.is_lost) faults_.lost_at = sweep_.scale_step.scale;
  if (!begin_robust()) begin_next_scale(document, progress);
}

// Begins further sweeps with a robust loss, once, after the last scale. Returns true if there are
// such sweeps. Earlier sweeps need the full weight of disagreeing windows, because these show where
// the surface is inaccurate.
bool ReconstructionLoop::begin_robust() {
  if (scale_step_ + 1 < scale_steps_.size() || loss_ > 0 || !faults_.is_at_rest) return false;
  loss_ = robust_loss(options_.robust, rule_.dissimilarity());
  if (loss_ > 0) rule_.begin();
  return loss_ > 0;
}

void ReconstructionLoop::begin_next_scale(Document& document, const Progress& progress) {
  const bool was_first = may_begin_finer();
  ++scale_step_;
  rule_.begin();
  if (was_first &&
      is_torn(pixels_compared(initial_, progress), pixels_compared(document, progress)))
    begin_finer(document, progress);
}

void ReconstructionLoop::finish(Document& document, const Progress& progress) {
  result_.topology = clean_in_place(document, progress).topology;
  if (drops_handles(document, progress))
    result_.topology = clean_in_place(document, progress).topology;
  result_.handles = handles_;
  drop_crumbs(document);
  result_.pixel = photographs_.pixel();
  judge(document, progress);
  result_.faces = document.mesh.faces.size();
}

void ReconstructionLoop::judge(Document& document, const Progress& progress) {
  const SurfaceMeasures start = photographs_.measures(initial_.mesh, progress);
  SurfaceMeasures end = photographs_.measures(document.mesh, progress);
  const std::string reason = options_.initial.is_given ? reason_to_keep(start, end) : "";
  if (!reason.empty()) {
    keep_start(document, reason);
    end = start;
  }
  result_.first = start.windows;
  result_.last = end.windows;
  result_.first_agreement = start.mean_outline();
  result_.agreement = end.mean_outline();
  result_.fault = faults_.in_words({result_.first_agreement, result_.agreement, end.doubt});
  set_doubt_column(document.mesh, end.doubt);
  result_.disagreement = end.doubt.disagreement;
  result_.noise_floor = end.doubt.floor;
  result_.doubtful = end.doubt.share;
  result_.doubtful_places = std::move(end.doubt.places);
}

// Makes the initial mesh the result. Faults of the sweeps are not faults of that mesh.
void ReconstructionLoop::keep_start(Document& document, const std::string& reason) {
  document = initial_;
  const Components parts = connected_components(document.mesh);
  result_.topology = {parts.components.size(), parts.genus()};
  result_.crumbs = result_.handles = 0;
  result_.kept = reason;
  faults_ = {.is_at_rest = true};
  if (options_.on_note) options_.on_note("the start is kept: " + reason);
}

void ReconstructionLoop::remember(LoopState& loop_state) {
  rule_.remember(loop_state);
  faults_.remember(loop_state);
  loop_state("first", first_)("level", scale_step_)("loss", loss_)("stiffness", stiffness_);
  loop_state("handles", handles_);
}

void ReconstructionLoop::measure(CsvRow& row) const {
  const auto& [scale_step, mesh, steps] = sweep_;
  row.share("scale", scale_step.scale).number("edge", scale_step.edge, 9);
  measure_mesh(mesh, row);
  row.share("dissimilarity", steps.last.dissimilarity, 6).count("pixels", steps.last.pixels);
  row.share("coverage", steps.last.coverage).share("mean_share", steps.last.mean_share, 5);
  row.count("outside", steps.last.outside).seconds("seconds_remesh", mesh.seconds_remesh);
  row.seconds("seconds_step", mesh.seconds_step).seconds("seconds_clean", mesh.seconds_clean);
  row.seconds("seconds", mesh.seconds_remesh + mesh.seconds_step + mesh.seconds_clean);
}

std::string ReconstructionLoop::message() const {
  return ", scale " + fixed(sweep_.scale_step.scale, 2) + ": " +
         in_words(sweep_.mesh.faces, sweep_.mesh.topology) + ", dissimilarity " +
         fixed(sweep_.steps.last.dissimilarity, 4);
}

}  // namespace

ReconstructionResult reconstruct(Document& document, std::vector<View>& views,
                                 const ReconstructionOptions& options, Record& record,
                                 const Progress& progress) {
  const InitialState initial_state =
      record.resumed()
          ? read_initial_state(record)
          : make_initial_state(document, views, {options.initial, options.pairs}, record, progress);
  if (initial_state.coarsest && options.on_detail)
    options.on_detail("photographs see into hollows of the hull: beginning with them open");
  if (initial_state.outlined) outline(views, *initial_state.outlined);
  const int width = views.front().image.width;
  if (options.spends_views) crop_views(views, initial_state.document.mesh);
  Photographs photographs(views, width, options, initial_state);
  ReconstructionLoop loop(photographs, initial_state, options);
  const LoopOptions unlimited{std::numeric_limits<std::size_t>::max(), options.on_sweep};
  run_loop(loop, document, unlimited, record, progress);
  ReconstructionResult result = loop.result();
  result.sweeps = record.iteration();
  return result;
}

ReconstructionResult reconstruct(Document& document, Views& views,
                                 const ReconstructionOptions& options,
                                 const RecordOptions& record_options, const Progress& progress) {
  Record record(record_options);
  if (record.resumed()) document = record.resumed()->document;
  return reconstruct(document, views.list(), options, record, progress);
}

std::string summary_of(const ReconstructionResult& result) {
  return counted(result.sweeps, "pass") + ": " + in_short(result.faces, result.topology) +
         "; dissimilarity from " + fixed(result.first.dissimilarity, 4) + " to " +
         fixed(result.last.dissimilarity, 4) + (result.kept.empty() ? "" : "; the start is kept") +
         (result.fault.empty() ? "" : "; " + result.fault);
}

}  // namespace transformesh
