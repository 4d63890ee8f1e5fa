#include <utility>

#include "evolution/loop/csv_row.h"
#include "evolution/loop/iteration_text.h"
#include "evolution/loop/loop.h"
#include "evolution/loop/record.h"
#include "evolution/loop/stages.h"
#include "evolution/loop/stopwatch.h"
#include "evolution/recorded_loops.h"
#include "support/counted.h"
#include "support/number.h"
#include "transformesh/morph.h"

namespace transformesh {
namespace {

/// Value of MorphStepOptions::gap_edges in the second attempt, if a morph with edges of uniform
/// length did not converge. With more edges across narrow places, thinner places are resolved, and
/// a morph takes more time.
constexpr double gap_edges_again = 1.5;

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char character : text) result += character == '"' ? "\"\"" : std::string(1, character);
  return result + '"';
}

class TrackingLoop : public Loop {
 public:
  TrackingLoop(const std::vector<std::string>& names,
               const std::function<Target(std::size_t)>& target_of, const MorphOptions& options,
               std::size_t iterations)
      : names_(names), target_of_(target_of), options_(options), iterations_(iterations) {}

  std::string noun() const override { return "frame"; }
  void advance(Document& document, std::size_t iteration, const Progress& progress) override;
  bool is_done() const override { return result_.frames == names_.size(); }
  void finish(Document& /*document*/, const Progress& /*progress*/) override {}

  void remember(LoopState& loop_state) override {
    loop_state("done", result_.frames)("converged", result_.converged);
  }
  void measure(CsvRow& row) const override;
  std::string message() const override;

  const TrackResult& result() const { return result_; }

 private:
  MorphResult follow(Document& document, const Target& target, const MorphOptions& options,
                     const Progress& progress) const {
    Record none;
    return morph(document, target, options, {.iterations = iterations_}, none, progress);
  }
  void follow_again(Document again, Document& document, const Target& target,
                    const Progress& progress);

  const std::vector<std::string>& names_;
  const std::function<Target(std::size_t)>& target_of_;
  const MorphOptions& options_;
  std::size_t iterations_;
  TrackResult result_;

  // Data of the last frame.
  std::string name_;
  MorphResult morphed_;
  bool was_tried_again_ = false;
  std::size_t faces_ = 0;
  double seconds_ = 0;
};

// Repeats the morph with shorter edges at narrow places, starting from `again`. Keeps the first
// result unless the second morph converges.
void TrackingLoop::follow_again(Document again, Document& document, const Target& target,
                                const Progress& progress) {
  MorphOptions options = options_;
  options.step.gap_edges = gap_edges_again;
  const MorphResult result = follow(again, target, options, progress);
  if (result.stop != MorphStop::converged) return;
  again.mesh.vertex_columns.erase("size");
  document = std::move(again);
  morphed_ = result;
  was_tried_again_ = true;
}

void TrackingLoop::advance(Document& document, std::size_t iteration, const Progress& progress) {
  const Stopwatch watch;
  name_ = names_[iteration - 1];
  const Target target = target_of_(iteration - 1);
  Document before = document;
  was_tried_again_ = false;
  morphed_ = follow(document, target, options_, progress);
  const bool has_sizes = options_.step.gap_edges > 0;
  if (morphed_.stop != MorphStop::converged && target.is_mesh() && !has_sizes)
    follow_again(std::move(before), document, target, progress);
  faces_ = document.mesh.faces.size();
  result_.frames = iteration;
  result_.converged += morphed_.stop == MorphStop::converged ? 1 : 0;
  seconds_ = watch.seconds();
}

void TrackingLoop::measure(CsvRow& row) const {
  const MorphResult& r = morphed_;
  const auto distance = [](const std::optional<double>& value) {
    return value ? significant(*value, 6) : std::string();
  };
  row.text("name", quoted(name_)).text("stop", name_of(r.stop)).count("iterations", r.iterations);
  row.count("faces", faces_);
  row.count("components", r.topology.components).count("genus", r.topology.genus);
  row.text("target_components", r.expected ? std::to_string(r.expected->components) : "");
  row.text("target_genus", r.expected ? std::to_string(r.expected->genus) : "");
  row.number("rms_distance_to_target", r.distances.to_target.rms);
  row.number("rms_distance_from_target", r.distances.from_target.rms);
  row.text("hausdorff_to_target", distance(r.to_target));
  row.text("hausdorff_from_target", distance(r.from_target));
  row.number("mean_edge", r.distances.displaced.mean_edge);
  row.text("again", was_tried_again_ ? "yes" : "no").seconds("seconds", seconds_);
  row.text("fault", quoted(r.fault));
}

std::string TrackingLoop::message() const {
  const std::string& fault = morphed_.fault;
  return " of " + std::to_string(names_.size()) + ", " + name_ + ": " + name_of(morphed_.stop) +
         " after " + counted(morphed_.iterations, "iteration") + ", " +
         in_words(faces_, morphed_.topology) + (fault.empty() ? "" : "; " + fault);
}

}  // namespace

TrackResult track(Document& document, const std::vector<std::string>& names,
                  const std::function<Target(std::size_t frame)>& target_of,
                  const MorphOptions& options, const LoopOptions& loop_options, Record& record,
                  const Progress& progress) {
  MorphOptions complete = options;
  complete.iteration = completed(options.iteration, document.mesh);
  if (options.features == Features::automatic) complete.features = Features::off;
  TrackingLoop loop(names, target_of, complete, loop_options.iterations);
  run_loop(loop, document, {names.size(), loop_options.on_iteration}, record, progress);
  return loop.result();
}

TrackResult track(Document& document, const std::vector<std::string>& names,
                  const std::function<Target(std::size_t frame)>& target_of,
                  const MorphOptions& options, const LoopOptions& loop, const Progress& progress) {
  Record record(loop.record);
  return track(document, names, target_of, options, loop, record, progress);
}

}  // namespace transformesh
