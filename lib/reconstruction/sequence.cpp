#include "reconstruction/sequence.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "evolution/loop/csv_row.h"
#include "evolution/loop/iteration_text.h"
#include "evolution/loop/loop.h"
#include "evolution/loop/record.h"
#include "evolution/loop/stopwatch.h"
#include "io/streams/atomic_file.h"
#include "reconstruction/initial_mesh.h"
#include "reconstruction/recorded_reconstruction.h"
#include "reconstruction/surface_quality.h"
#include "support/number.h"
#include "transformesh/errors.h"
#include "transformesh/hull.h"
#include "transformesh/mesh_io.h"
#include "views/cameras/view.h"
#include "views/hull/silhouette.h"

namespace transformesh {
namespace {

constexpr const char* from_hull = "hull";
constexpr const char* from_given = "given";
constexpr const char* from_before = "before";

struct Surface {
  Document document;
  /// Initial mesh from which this surface was reconstructed: `from_hull`, `from_given` or
  /// `from_before`.
  std::string start;
  ReconstructionResult result;
  /// Mean intersection over union of outline and silhouette, over the views.
  double agreement = 0;
  SurfaceQuality quality;

  bool is_tracked() const { return start == from_before; }
};

class SequenceLoop : public Loop {
 public:
  SequenceLoop(const std::vector<TimeStep>& time_steps,
               const std::function<std::vector<View>(const TimeStep&)>& views_of,
               const SequenceOptions& options)
      : time_steps_(time_steps), views_of_(views_of), options_(options) {}

  std::string noun() const override { return "time step"; }
  std::string column() const override { return "step"; }
  void start(Document& document, const Progress& progress) override;
  void advance(Document& document, std::size_t iteration, const Progress& progress) override;
  bool is_done() const override { return result_.time_steps == time_steps_.size(); }
  void finish(Document& /*document*/, const Progress& /*progress*/) override {}

  void remember(LoopState& loop_state) override {
    loop_state("steps", result_.time_steps)("tracked", result_.tracked)("accepted",
                                                                        result_.accepted);
    reference_.remember(loop_state);
  }
  void measure(CsvRow& row) const override;
  std::string message() const override;

  const SequenceResult& result() const { return result_; }

 private:
  std::string state_of(const std::string& start) const;
  ReconstructionOptions options_from(const std::string& start) const;
  Surface made(const std::string& start, Document document, const Progress& progress);
  Surface made_from_hull(const Progress& progress);
  std::optional<Surface> tracked(const Document& before, const Progress& progress);
  Surface better_of(std::optional<Surface> tracked, const Progress& progress);
  void find_masks(const Progress& progress);
  void publish() const;
  void count();
  bool is_accepted() const { return fault_.empty() || !surface_.is_tracked(); }

  const std::vector<TimeStep>& time_steps_;
  const std::function<std::vector<View>(const TimeStep&)>& views_of_;
  const SequenceOptions& options_;

  // State that is kept from time step to time step.
  SequenceResult result_;
  SurfaceQuality reference_;

  // State of the last time step.
  std::string name_;
  std::vector<View> views_;
  /// True if the views have no masks, and their silhouettes are the outlines of a hull.
  bool are_outlines_ = false;
  Surface surface_;
  std::string fault_;  ///< faults of the tracked surface; see tracking_faults()
  double seconds_ = 0;
};

std::string SequenceLoop::state_of(const std::string& start) const {
  return options_.states.empty() ? "" : options_.states + '/' + start;
}

// Removes the states of unfinished time steps that another run left in the same folder.
void SequenceLoop::start(Document& /*document*/, const Progress& /*progress*/) {
  for (const char* start : {from_hull, from_given, from_before}) remove_state(state_of(start));
}

ReconstructionOptions SequenceLoop::options_from(const std::string& start) const {
  ReconstructionOptions options = options_.reconstruction;
  options.initial.is_given = start != from_hull;
  if (are_outlines_) options.initial.meaning = SilhouetteMeaning::least;
  if (start == from_before) {
    options.initial.clips_by_hull = false;
    options.scales.coarsest = options_.track;
  }
  return options;
}

Surface SequenceLoop::made(const std::string& start, Document document, const Progress& progress) {
  const ReconstructionOptions options = options_from(start);
  if (options.on_detail) options.on_detail(name_ + ": from " + start);
  RecordOptions kept;
  kept.state = state_of(start);
  kept.settings = "time step " + name_ + " from " + start;
  kept.resume = true;
  Record record(kept);
  const ReconstructionResult result = reconstruct(document, views_, options, record, progress);
  const std::vector<double> agreements = silhouette_agreements(document.mesh, views_);
  const double sum = std::accumulate(agreements.begin(), agreements.end(), 0.0);
  const SurfaceQuality quality{result.last.dissimilarity, result.last.coverage,
                               *std::min_element(agreements.begin(), agreements.end())};
  return {std::move(document), start, result, sum / static_cast<double>(agreements.size()),
          quality};
}

Surface SequenceLoop::made_from_hull(const Progress& progress) {
  Document document;
  document.style.comments = options_.comments;
  return made(from_hull, std::move(document), progress);
}

// Reconstructs a time step from the surface of the previous time step. Returns nothing if this
// fails.
std::optional<Surface> SequenceLoop::tracked(const Document& before, const Progress& progress) {
  try {
    return made(from_before, before, progress);
  } catch (const InputError&) {
  } catch (const GoalError&) {
  }
  remove_state(state_of(from_before));
  if (options_.on_note)
    options_.on_note("time step " + std::to_string(result_.time_steps + 1) + ", " + name_ +
                     ": tracking from the previous surface failed");
  return std::nullopt;
}

Surface SequenceLoop::better_of(std::optional<Surface> tracked, const Progress& progress) {
  const SurfaceQuality quality = tracked ? tracked->quality : SurfaceQuality();
  fault_ = tracking_faults(quality, reference_);
  if (fault_.empty() && tracked) return std::move(*tracked);
  Surface anew = made_from_hull(progress);
  return !tracked || is_better(anew.quality, quality, reference_) ? anew : std::move(*tracked);
}

void SequenceLoop::find_masks(const Progress& progress) {
  are_outlines_ = views_.front().silhouette.empty();
  if (!are_outlines_) return;
  const Mesh hull = hull_of(views_, options_.reconstruction.initial, std::nullopt, progress);
  outline(views_, hull);
}

void SequenceLoop::advance(Document& document, std::size_t iteration, const Progress& progress) {
  const Stopwatch watch;
  name_ = time_steps_[iteration - 1].name;
  views_ = views_of_(time_steps_[iteration - 1]);
  find_masks(progress);
  fault_.clear();
  if (iteration > 1) {
    surface_ = better_of(tracked(document, progress), progress);
  } else if (options_.reconstruction.initial.is_given) {
    surface_ = made(from_given, document, progress);
  } else {
    surface_ = made_from_hull(progress);
  }
  publish();
  document = surface_.document;
  count();
  seconds_ = watch.seconds();
}

void SequenceLoop::publish() const {
  if (options_.folder.empty()) return;
  Document published = surface_.document;
  published.style.format = options_.format;
  const std::string extension = options_.format == Format::off ? ".off" : ".ply";
  make_folder(options_.folder);
  write_file(options_.folder + '/' + name_ + extension, write_mesh(published).bytes);
}

void SequenceLoop::count() {
  ++result_.time_steps;
  result_.tracked += surface_.is_tracked() ? 1 : 0;
  result_.accepted += is_accepted() ? 1 : 0;
  if (surface_.is_tracked()) return;
  // Round as in the CSV file, so that a resumed run decides in the same way.
  const SurfaceQuality& quality = surface_.quality;
  reference_ = {read_back(fixed(quality.dissimilarity, 6)), read_back(fixed(quality.coverage, 4)),
                read_back(fixed(quality.least_agreement, 4))};
}

void SequenceLoop::measure(CsvRow& row) const {
  const ReconstructionResult& result = surface_.result;
  row.text("name", name_).text("start", surface_.start);
  row.text("accepted", is_accepted() ? "yes" : "no").text("fault", fault_);
  row.count("faces", result.faces).count("components", result.topology.components);
  row.count("genus", result.topology.genus);
  row.share("dissimilarity", result.last.dissimilarity, 6);
  row.share("coverage", result.last.coverage).share("silhouette_agreement", surface_.agreement);
  row.share("least_silhouette_agreement", surface_.quality.least_agreement);
  row.count("passes", result.sweeps).seconds("seconds", seconds_);
}

std::string SequenceLoop::message() const {
  const ReconstructionResult& result = surface_.result;
  return " of " + std::to_string(time_steps_.size()) + ", " + name_ + ", from " + surface_.start +
         ": " + in_short(result.faces, result.topology) + ", dissimilarity " +
         fixed(result.last.dissimilarity, 4) +
         (fault_.empty() ? "" : "; tracking failed: " + fault_);
}

}  // namespace

SequenceResult reconstruct_sequence(
    Document& document, const std::vector<TimeStep>& time_steps,
    const std::function<std::vector<View>(const TimeStep& time_step)>& views_of,
    const SequenceOptions& options, Record& record, const Progress& progress) {
  SequenceLoop loop(time_steps, views_of, options);
  run_loop(loop, document, {time_steps.size(), options.on_step}, record, progress);
  return loop.result();
}

}  // namespace transformesh
