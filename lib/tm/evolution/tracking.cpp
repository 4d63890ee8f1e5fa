#include "tm/evolution/tracking.h"

#include <utility>

#include "tm/evolution/csv_row.h"
#include "tm/evolution/stopwatch.h"
#include "tm/support/counted.h"
#include "tm/support/error.h"

namespace transformesh {
namespace {

/// Edges across the narrow places of a target that was not followed with edges of one length.
constexpr double gap_edges_again = 1.5;

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char character : text) result += character == '"' ? "\"\"" : std::string(1, character);
  return result + '"';
}

class TrackingLoop : public Loop {
 public:
  TrackingLoop(const std::vector<std::string>& names,
               const std::function<Target(std::size_t)>& target_of, const TrackingOptions& options)
      : names_(names), target_of_(target_of), options_(options) {}

  void start(Document& document, const Progress& progress) override {
    clean_in_place(document, progress);
  }
  void advance(Document& document, std::size_t iteration, const Progress& progress) override;
  bool is_done() const override { return done_ == names_.size(); }

  Values values() const override {
    return {{"done", static_cast<double>(done_)}, {"converged", static_cast<double>(converged_)}};
  }
  void restore(const Values& values) override;
  std::string csv_header() const override {
    return "frame,name,stop,iterations,faces,components,genus,target_components,target_genus,"
           "rms_distance_to_target,rms_distance_from_target,hausdorff_to_target,"
           "hausdorff_from_target,mean_edge,again,seconds,fault";
  }
  std::string csv_row(std::size_t iteration) const override;
  std::string message(std::size_t iteration) const override;

  std::size_t converged() const { return converged_; }

 private:
  MorphingResult follow(Document& document, const Target& target, const MorphingOptions& options,
                        const Progress& progress) const;
  void follow_again(const Document& before, Document& document, Target target,
                    const Progress& progress);

  const std::vector<std::string>& names_;
  const std::function<Target(std::size_t)>& target_of_;
  const TrackingOptions& options_;
  std::size_t done_ = 0;
  std::size_t converged_ = 0;
  MorphingResult result_;  ///< of the last frame
  bool was_tried_again_ = false;
  std::size_t faces_ = 0;
  double seconds_ = 0;
};

MorphingResult TrackingLoop::follow(Document& document, const Target& target,
                                    const MorphingOptions& options,
                                    const Progress& progress) const {
  Record none;
  return morph(document, target, options, {.iterations = options_.iterations}, none, progress);
}

// The first surface is kept unless the second one converges.
void TrackingLoop::follow_again(const Document& before, Document& document, Target target,
                                const Progress& progress) {
  MorphingOptions options = options_.morphing;
  options.step.gap_edges = gap_edges_again;
  prepare_target(target, options, progress);
  Document again = before;
  const MorphingResult result = follow(again, target, options, progress);
  if (result.stop != MorphingStop::converged) return;
  again.mesh.vertex_columns.erase("size");
  document = std::move(again);
  result_ = result;
  was_tried_again_ = true;
}

void TrackingLoop::advance(Document& document, std::size_t iteration, const Progress& progress) {
  const Stopwatch watch;
  Target target = target_of_(iteration - 1);
  prepare_target(target, options_.morphing, progress);
  const Document before = document;
  was_tried_again_ = false;
  result_ = follow(document, target, options_.morphing, progress);
  const bool has_sizes = options_.morphing.step.gap_edges > 0;
  if (result_.stop != MorphingStop::converged && target.is_mesh() && !has_sizes)
    follow_again(before, document, std::move(target), progress);
  faces_ = document.mesh.faces.size();
  converged_ += result_.stop == MorphingStop::converged ? 1 : 0;
  done_ = iteration;
  seconds_ = watch.seconds();
}

void TrackingLoop::restore(const Values& values) {
  const auto done = values.find("done");
  const auto converged = values.find("converged");
  if (done == values.end() || converged == values.end())
    throw InputError("the state of the run is not that of a sequence");
  done_ = static_cast<std::size_t>(done->second);
  converged_ = static_cast<std::size_t>(converged->second);
}

std::string TrackingLoop::csv_row(std::size_t iteration) const {
  const std::optional<Topology>& expected = result_.expected;
  const auto optional = [](const std::optional<double>& value) {
    return value ? significant(*value, 6) : std::string();
  };
  CsvRow row;
  row.count(iteration).text(quoted(names_[iteration - 1])).text(name_of(result_.stop));
  row.count(result_.iterations).count(faces_);
  row.count(result_.topology.components).count(result_.topology.genus);
  row.text(expected ? std::to_string(expected->components) : "");
  row.text(expected ? std::to_string(expected->genus) : "");
  row.number(result_.distances.to_target.rms).number(result_.distances.from_target.rms);
  row.text(optional(result_.agreement.to_target)).text(optional(result_.agreement.from_target));
  row.number(result_.distances.displaced.mean_edge).text(was_tried_again_ ? "yes" : "no");
  return row.seconds(seconds_).text(quoted(result_.agreement.fault)).line();
}

std::string TrackingLoop::message(std::size_t iteration) const {
  std::string text = "frame " + std::to_string(iteration) + " of " + std::to_string(names_.size()) +
                     ", " + names_[iteration - 1] + ": " + name_of(result_.stop) + " after " +
                     counted(result_.iterations, "iteration") + ", " + counted(faces_, "face") +
                     ", " + counted(result_.topology.components, "part") + ", genus " +
                     std::to_string(result_.topology.genus);
  if (!result_.agreement.fault.empty()) text += "; " + result_.agreement.fault;
  return text;
}

}  // namespace

TrackingResult track(Document& document, const std::vector<std::string>& names,
                     const std::function<Target(std::size_t frame)>& target_of,
                     const TrackingOptions& options,
                     const std::function<void(const std::string& message)>& on_frame,
                     Record& record, const Progress& progress) {
  TrackingOptions complete = options;
  double& reference_edge = complete.morphing.iteration.reference_edge;
  if (reference_edge == 0) reference_edge = measured_reference_edge(document.mesh);
  TrackingLoop loop(names, target_of, complete);
  const LoopOptions loop_options{names.size(), "frame", on_frame};
  const LoopResult result = run_loop(loop, document, loop_options, record, progress);
  if (result.is_done) record.end();
  return {result.iterations, loop.converged()};
}

}  // namespace transformesh
