#include "tm/evolution/reconstruction.h"

#include <limits>

#include "tm/evolution/csv_row.h"
#include "tm/evolution/reconstruction_rules.h"
#include "tm/evolution/stopwatch.h"
#include "tm/io/mesh_io.h"
#include "tm/remesh/remesh.h"
#include "tm/support/counted.h"
#include "tm/support/error.h"

namespace transformesh {
namespace {

constexpr const char* start_name = "start.ply";
constexpr const char* hull_name = "hull.ply";

/// The photographs, at the scale that was asked for last, and steps towards them.
class Photographs {
 public:
  Photographs(const std::vector<View>& views, const ReconstructionOptions& options,
              bool are_outlines)
      : views_(views), options_(options), are_outlines_(are_outlines) {}

  PhotoStepsResult pass(Mesh& mesh, double scale, double loss, const Progress& progress);
  /// One step in which nothing moves; of pairs in one order, or in both.
  PhotoStepResult look(Mesh mesh, double scale, bool in_one_order, const Progress& progress);
  int width() const { return views_.front().image.width; }
  double pixel() const { return pixel_size(views_); }

 private:
  const PhotoScene& at(double scale);
  PhotoStepsOptions steps() const;

  const std::vector<View>& views_;
  const ReconstructionOptions& options_;
  bool are_outlines_;
  double scale_ = 0;  ///< of the scene; 0: none
  PhotoScene scene_;
};

const PhotoScene& Photographs::at(double scale) {
  if (scale == scale_) return scene_;
  scene_ = PhotoScene();
  scene_ = photo_scene(views_, scale, options_.pairs);
  scale_ = scale;
  return scene_;
}

PhotoStepsOptions Photographs::steps() const {
  PhotoStepsOptions steps;
  steps.step.stiffness = options_.stiffness;
  steps.step.meaning = are_outlines_ ? SilhouetteMeaning::least : options_.start.meaning;
  steps.step.silhouettes =
      are_outlines_ ? read_back(significant(0.2 * options_.pull, 9)) : options_.pull;
  steps.step.photographs.correlation.radius = options_.window;
  return steps;
}

PhotoStepsResult Photographs::pass(Mesh& mesh, double scale, double loss,
                                   const Progress& progress) {
  PhotoStepsOptions options = steps();
  options.iterations = options_.iterations;
  options.alternate = true;
  options.step.photographs.correlation.robust = loss;
  return photo_steps(mesh, at(scale), options, progress);
}

PhotoStepResult Photographs::look(Mesh mesh, double scale, bool in_one_order,
                                  const Progress& progress) {
  PhotoStepsOptions options = steps();
  options.alternate = in_one_order;
  options.step.alpha = 0;
  return photo_steps(mesh, at(scale), options, progress).first;
}

class ReconstructionLoop : public Loop {
 public:
  ReconstructionLoop(Photographs& photographs, const Document& start,
                     const ReconstructionOptions& options)
      : photographs_(photographs),
        start_(start),
        options_(options),
        levels_(coarse_to_fine(options.scales, photographs.width(), photographs.pixel())),
        rule_(options.passes) {}

  void start(Document& document, const Progress& progress) override;
  void advance(Document& document, std::size_t iteration, const Progress& progress) override;
  bool is_done() const override { return level_ == levels_.size(); }

  Values values() const override;
  void restore(const Values& values) override;
  std::string csv_header() const override;
  std::string csv_row(std::size_t iteration) const override;
  std::string message(std::size_t iteration) const override;

  std::string fault() const { return fault_of(faults_); }

 private:
  bool may_begin_finer() const;
  void begin_finer(Document& document, const Progress& progress);
  void take_pass(Document& document, const Progress& progress);
  void take_pass_or_begin_finer(Document& document, const Progress& progress);
  PassMeasures measures() const;
  bool begin_robust();
  void begin_next_level(Document& document, const Progress& progress);
  std::size_t pixels_compared(const Document& document, const Progress& progress) const;

  Photographs& photographs_;
  const Document& start_;
  const ReconstructionOptions& options_;
  std::vector<Level> levels_;

  // What is remembered from pass to pass.
  std::size_t first_ = 0;  ///< level with which it began
  std::size_t level_ = 0;  ///< of the next pass
  LevelRule rule_;
  ReconstructionFaults faults_;
  double loss_ = 0;

  // The last pass.
  Level now_;
  std::size_t vertices_ = 0, faces_ = 0;
  PhotoStepsResult steps_;
  CleanedTopology cleaned_;
  double seconds_remesh_ = 0, seconds_step_ = 0, seconds_clean_ = 0;
};

void ReconstructionLoop::start(Document& document, const Progress& progress) {
  document = start_;
  coarsen(document, levels_[level_].edge, progress);
}

// Where nothing was done yet but at the first scale, and nobody asked for that one.
bool ReconstructionLoop::may_begin_finer() const {
  return !options_.scales.coarsest && level_ == first_ && level_ + 1 < levels_.size();
}

void ReconstructionLoop::begin_finer(Document& document, const Progress& progress) {
  if (options_.on_detail)
    options_.on_detail("scale " + fixed(now_.scale, 4) +
                       " is too coarse for this surface: beginning anew at the next");
  level_ = ++first_;
  faults_.lost_at = 0;
  rule_.begin();
  start(document, progress);
}

void ReconstructionLoop::take_pass(Document& document, const Progress& progress) {
  Stopwatch watch;
  now_ = levels_[level_];
  RemeshOptions remeshing;
  remeshing.iterations = 2;
  remeshing.min_edge = edge_times(0.7, now_.edge);
  remeshing.max_edge = edge_times(1.4, now_.edge);
  remeshing.coordinate = document.style.coordinate;
  remesh(document.mesh, remeshing, progress);
  round_as_written(document);
  seconds_remesh_ = watch.lap();

  vertices_ = document.mesh.positions.size();
  steps_ = photographs_.pass(document.mesh, now_.scale, loss_, progress);
  round_as_written(document);
  seconds_step_ = watch.lap();

  cleaned_ = clean_in_place(document, progress);
  faces_ = document.mesh.faces.size();
  seconds_clean_ = watch.lap();
}

void ReconstructionLoop::take_pass_or_begin_finer(Document& document, const Progress& progress) {
  for (bool is_taken = false; !is_taken;) {
    try {
      take_pass(document, progress);
      is_taken = true;
    } catch (const CancelledError&) {
      throw;
    } catch (const std::runtime_error&) {
      if (!may_begin_finer()) throw;
      begin_finer(document, progress);
    }
  }
}

PassMeasures ReconstructionLoop::measures() const {
  const PhotoStepResult& last = steps_.last;
  PassMeasures m;
  m.scale = now_.scale;
  m.vertices = vertices_;
  m.outside = last.outside;
  m.mean_share = last.mean_share;
  m.dissimilarity = last.dissimilarity;
  m.coverage = last.coverage;
  m.first_coverage = steps_.first.coverage;
  m.pixels = last.pixels;
  m.first_pixels = steps_.first.pixels;
  m.topology = cleaned_.topology;
  return m;
}

void ReconstructionLoop::advance(Document& document, std::size_t /*iteration*/,
                                 const Progress& progress) {
  take_pass_or_begin_finer(document, progress);
  const PassVerdict verdict = rule_.add(measures());
  faults_.is_at_rest = verdict.is_at_rest;
  if (verdict.is_late && level_ > first_) faults_.late_at = now_.scale;
  if (!verdict.is_done) return;
  if (verdict.is_lost) faults_.lost_at = now_.scale;
  if (!begin_robust()) begin_next_level(document, progress);
}

// Some more passes of the last level, once. Before, windows that disagree are needed, as they show
// where the surface is still far off.
bool ReconstructionLoop::begin_robust() {
  if (level_ + 1 < levels_.size() || loss_ > 0 || !faults_.is_at_rest) return false;
  loss_ = robust_loss(options_.robust, rule_.dissimilarity());
  if (loss_ > 0) rule_.begin();
  return loss_ > 0;
}

void ReconstructionLoop::begin_next_level(Document& document, const Progress& progress) {
  const bool was_first = may_begin_finer();
  ++level_;
  rule_.begin();
  if (was_first && is_torn(pixels_compared(start_, progress), pixels_compared(document, progress)))
    begin_finer(document, progress);
}

std::size_t ReconstructionLoop::pixels_compared(const Document& document,
                                                const Progress& progress) const {
  return photographs_.look(document.mesh, now_.scale, true, progress).pixels;
}

Values ReconstructionLoop::values() const {
  Values values = rule_.values();
  values["first"] = static_cast<double>(first_);
  values["level"] = static_cast<double>(level_);
  values["lost"] = faults_.lost_at;
  values["late"] = faults_.late_at;
  values["rest"] = faults_.is_at_rest ? 1 : 0;
  values["loss"] = loss_;
  return values;
}

void ReconstructionLoop::restore(const Values& values) {
  if (!values.contains("level"))
    throw InputError("the state of the run is not that of a reconstruction");
  rule_.restore(values);
  first_ = static_cast<std::size_t>(value_or(values, "first", 0));
  level_ = static_cast<std::size_t>(value_or(values, "level", 0));
  faults_ = {value_or(values, "lost", 0), value_or(values, "late", 0),
             value_or(values, "rest", 0) != 0};
  loss_ = value_or(values, "loss", 0);
}

std::string ReconstructionLoop::csv_header() const {
  return "pass,scale,edge,faces,pairs,components,genus,dissimilarity,pixels,coverage,mean_share,"
         "outside,seconds_remesh,seconds_step,seconds_clean,seconds";
}

std::string ReconstructionLoop::csv_row(std::size_t iteration) const {
  const PhotoStepResult& last = steps_.last;
  CsvRow row;
  row.count(iteration).share(now_.scale).text(significant(now_.edge, 9)).count(faces_);
  row.count(cleaned_.pairs).count(cleaned_.topology.components).count(cleaned_.topology.genus);
  row.text(fixed(last.dissimilarity, 6)).count(last.pixels).share(last.coverage);
  row.text(fixed(last.mean_share, 5)).count(last.outside).seconds(seconds_remesh_);
  row.seconds(seconds_step_).seconds(seconds_clean_);
  return row.seconds(seconds_remesh_ + seconds_step_ + seconds_clean_).line();
}

std::string ReconstructionLoop::message(std::size_t iteration) const {
  return "pass " + std::to_string(iteration) + ", scale " + fixed(now_.scale, 2) + ": " +
         counted(faces_, "face") + ", " + counted(cleaned_.topology.components, "part") +
         ", genus " + std::to_string(cleaned_.topology.genus) + ", dissimilarity " +
         fixed(steps_.last.dissimilarity, 4);
}

Document document_of(const std::optional<std::string>& bytes) {
  if (bytes) return read_mesh(*bytes, start_name).document;
  throw InputError("the state of the run is not that of a reconstruction");
}

struct Beginning {
  Document start;
  std::optional<Mesh> outlined;  ///< the hull whose outlines take the place of masks
};

Beginning found_in(const Record& record) {
  Beginning found{document_of(record.find(start_name)), std::nullopt};
  if (const auto hull = record.find(hull_name)) found.outlined = document_of(hull).mesh;
  return found;
}

Beginning begun(const Document& document, std::vector<View>& views,
                const ReconstructionOptions& options, Record& record, const Progress& progress) {
  Beginning begun{document, std::nullopt};
  begun.outlined = begin_surface(begun.start, views, options.start, pixel_size(views), progress);
  record.add(start_name, write_mesh(begun.start).bytes);
  if (begun.outlined) record.add(hull_name, write_mesh({*begun.outlined, {}, {}}).bytes);
  return begun;
}

}  // namespace

ReconstructionResult reconstruct(Document& document, std::vector<View>& views,
                                 const ReconstructionOptions& options, Record& record,
                                 const Progress& progress) {
  const Beginning beginning =
      record.resumed() ? found_in(record) : begun(document, views, options, record, progress);
  if (beginning.outlined) outline(views, *beginning.outlined);
  Photographs photographs(views, options, beginning.outlined.has_value());
  ReconstructionLoop loop(photographs, beginning.start, options);
  const LoopOptions loop_options{std::numeric_limits<std::size_t>::max(), "pass", options.on_pass};

  ReconstructionResult result;
  result.passes = run_loop(loop, document, loop_options, record, progress).iterations;
  result.fault = loop.fault();
  result.topology = clean_in_place(document, progress).topology;
  result.pixel = photographs.pixel();
  result.faces = document.mesh.faces.size();
  result.first = photographs.look(beginning.start.mesh, 1, false, progress);
  result.last = photographs.look(document.mesh, 1, false, progress);
  record.end();
  return result;
}

std::string summary_of(const ReconstructionResult& result) {
  return counted(result.passes, "pass") + ": " + counted(result.faces, "face") + ", components " +
         std::to_string(result.topology.components) + ", genus " +
         std::to_string(result.topology.genus) + "; dissimilarity from " +
         fixed(result.first.dissimilarity, 4) + " to " + fixed(result.last.dissimilarity, 4) +
         (result.fault.empty() ? "" : "; " + result.fault);
}

}  // namespace transformesh
