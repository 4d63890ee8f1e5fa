#include "tm/evolution/sequence.h"

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <optional>
#include <utility>

#include "tm/evolution/csv_row.h"
#include "tm/evolution/reconstruction_rules.h"
#include "tm/evolution/stopwatch.h"
#include "tm/io/atomic_file.h"
#include "tm/io/mesh_io.h"
#include "tm/support/counted.h"
#include "tm/support/error.h"
#include "tm/views/hull/silhouette.h"

namespace transformesh {
namespace {

constexpr const char* from_hull = "hull";
constexpr const char* from_given = "given";
constexpr const char* from_before = "before";

struct Surface {
  Document document;
  std::string start;  ///< one of the three above
  ReconstructionResult result;
  double agreement = 0;  ///< mean over the views
  SurfaceQuality quality;
};

class SequenceLoop : public Loop {
 public:
  SequenceLoop(const std::vector<std::string>& names,
               const std::function<std::vector<View>(std::size_t)>& views_of,
               const SequenceOptions& options)
      : names_(names), views_of_(views_of), options_(options) {}

  void start(Document& document, const Progress& progress) override;
  void advance(Document& document, std::size_t iteration, const Progress& progress) override;
  bool is_done() const override { return result_.time_steps == names_.size(); }

  Values values() const override;
  void restore(const Values& values) override;
  std::string csv_header() const override;
  std::string csv_row(std::size_t iteration) const override;
  std::string message(std::size_t iteration) const override;

  const SequenceResult& result() const { return result_; }

 private:
  const std::string& name() const { return names_[result_.time_steps]; }
  std::string state_of(const std::string& start) const;
  ReconstructionOptions options_from(const std::string& start) const;
  Surface made(const std::string& start, Document document, const Progress& progress);
  Surface made_from_hull(const Progress& progress);
  std::optional<Surface> tracked(const Document& before, const Progress& progress);
  void take_better(std::optional<Surface> tracked, const Progress& progress);
  void find_masks(const Progress& progress);
  void publish() const;
  void remember();

  const std::vector<std::string>& names_;
  const std::function<std::vector<View>(std::size_t)>& views_of_;
  const SequenceOptions& options_;

  // What is remembered from time step to time step.
  SequenceResult result_;
  SurfaceQuality reference_;

  // The last time step.
  std::vector<View> views_;
  bool are_outlines_ = false;  ///< in the place of masks
  Surface surface_;
  std::string fault_;  ///< of the surface that was tracked
  double seconds_ = 0;
};

std::string SequenceLoop::state_of(const std::string& start) const {
  return options_.states.empty() ? "" : options_.states + '/' + start;
}

// Nothing within a time step is left of another run.
void SequenceLoop::start(Document& /*document*/, const Progress& /*progress*/) {
  if (options_.states.empty()) return;
  for (const char* start : {from_hull, from_given, from_before})
    StateFolder(state_of(start)).remove();
}

ReconstructionOptions SequenceLoop::options_from(const std::string& start) const {
  ReconstructionOptions options = options_.reconstruction;
  options.start.is_given = start != from_hull;
  if (are_outlines_) options.start.meaning = SilhouetteMeaning::least;
  if (start == from_before) {
    options.start.clips_by_hull = false;
    options.scales.coarsest = options_.track;
  }
  return options;
}

Surface SequenceLoop::made(const std::string& start, Document document, const Progress& progress) {
  const ReconstructionOptions options = options_from(start);
  if (options.on_detail) options.on_detail(name() + ": from " + start);
  RecordOptions kept;
  kept.state = state_of(start);
  kept.settings = "time step " + name() + " from " + start;
  kept.resume = true;
  Record record(kept);
  Surface surface;
  surface.start = start;
  surface.result = reconstruct(document, views_, options, record, progress);
  const std::vector<double> agreements = silhouette_agreements(document.mesh, views_);
  surface.agreement = std::accumulate(agreements.begin(), agreements.end(), 0.0) /
                      static_cast<double>(agreements.size());
  surface.quality = {surface.result.last.dissimilarity, surface.result.last.coverage,
                     *std::min_element(agreements.begin(), agreements.end())};
  surface.document = std::move(document);
  return surface;
}

Surface SequenceLoop::made_from_hull(const Progress& progress) {
  Document document;
  document.style.comments = options_.comments;
  return made(from_hull, std::move(document), progress);
}

// Nothing where the surface was lost altogether.
std::optional<Surface> SequenceLoop::tracked(const Document& before, const Progress& progress) {
  try {
    return made(from_before, before, progress);
  } catch (const InputError&) {
  } catch (const GoalError&) {
  }
  StateFolder(state_of(from_before)).remove();
  if (options_.on_note)
    options_.on_note("time step " + std::to_string(result_.time_steps + 1) + ", " + name() +
                     ": the surface before is lost");
  return std::nullopt;
}

void SequenceLoop::take_better(std::optional<Surface> tracked, const Progress& progress) {
  const SurfaceQuality quality = tracked ? tracked->quality : SurfaceQuality();
  fault_ = tracking_faults(quality, reference_);
  if (tracked && fault_.empty()) {
    surface_ = std::move(*tracked);
    return;
  }
  surface_ = made_from_hull(progress);
  if (tracked && !is_better(surface_.quality, quality, reference_)) surface_ = std::move(*tracked);
}

void SequenceLoop::find_masks(const Progress& progress) {
  are_outlines_ = views_.front().silhouette.empty();
  if (!are_outlines_) return;
  const Mesh hull = hull_of(views_, options_.reconstruction.start, std::nullopt, progress);
  outline(views_, hull);
}

void SequenceLoop::advance(Document& document, std::size_t iteration, const Progress& progress) {
  const Stopwatch watch;
  views_ = views_of_(iteration - 1);
  find_masks(progress);
  fault_.clear();
  if (iteration > 1) {
    take_better(tracked(document, progress), progress);
  } else if (options_.reconstruction.start.is_given) {
    surface_ = made(from_given, document, progress);
  } else {
    surface_ = made_from_hull(progress);
  }
  publish();
  document = surface_.document;
  remember();
  seconds_ = watch.seconds();
}

void SequenceLoop::publish() const {
  Document published = surface_.document;
  published.style.format = options_.format;
  std::error_code error;
  std::filesystem::create_directories(options_.folder, error);
  if (error)
    throw OutputError("cannot make the folder '" + options_.folder + "': " + error.message());
  const std::string extension = options_.format == Format::off ? ".off" : ".ply";
  write_file(options_.folder + '/' + name() + extension, write_mesh(published).bytes);
}

void SequenceLoop::remember() {
  const bool is_tracked = surface_.start == from_before;
  ++result_.time_steps;
  result_.tracked += is_tracked ? 1 : 0;
  result_.accepted += fault_.empty() || !is_tracked ? 1 : 0;
  if (is_tracked) return;
  // As the CSV file has it.
  const SurfaceQuality& quality = surface_.quality;
  reference_ = {read_back(fixed(quality.dissimilarity, 6)), read_back(fixed(quality.coverage, 4)),
                read_back(fixed(quality.least_agreement, 4))};
}

Values SequenceLoop::values() const {
  return {{"steps", static_cast<double>(result_.time_steps)},
          {"tracked", static_cast<double>(result_.tracked)},
          {"accepted", static_cast<double>(result_.accepted)},
          {"dissimilarity", reference_.dissimilarity},
          {"coverage", reference_.coverage},
          {"agreement", reference_.least_agreement}};
}

void SequenceLoop::restore(const Values& values) {
  if (!values.contains("steps")) throw InputError("the state of the run is not that of a sequence");
  const auto count = [&](const char* name) {
    return static_cast<std::size_t>(value_or(values, name, 0));
  };
  result_ = {count("steps"), count("tracked"), count("accepted")};
  reference_ = {value_or(values, "dissimilarity", 0), value_or(values, "coverage", 0),
                value_or(values, "agreement", 0)};
}

std::string SequenceLoop::csv_header() const {
  return "step,name,start,accepted,fault,faces,components,genus,dissimilarity,coverage,"
         "silhouette_agreement,least_silhouette_agreement,passes,seconds";
}

std::string SequenceLoop::csv_row(std::size_t iteration) const {
  const ReconstructionResult& result = surface_.result;
  const bool is_accepted = fault_.empty() || surface_.start != from_before;
  CsvRow row;
  row.count(iteration).text(names_[iteration - 1]).text(surface_.start);
  row.text(is_accepted ? "yes" : "no").text(fault_).count(result.faces);
  row.count(result.topology.components).count(result.topology.genus);
  row.text(fixed(result.last.dissimilarity, 6)).share(result.last.coverage);
  row.share(surface_.agreement).share(surface_.quality.least_agreement);
  return row.count(result.passes).seconds(seconds_).line();
}

std::string SequenceLoop::message(std::size_t iteration) const {
  const ReconstructionResult& result = surface_.result;
  return "time step " + std::to_string(iteration) + " of " + std::to_string(names_.size()) + ", " +
         names_[iteration - 1] + ", from " + surface_.start + ": " + counted(result.faces, "face") +
         ", components " + std::to_string(result.topology.components) + ", genus " +
         std::to_string(result.topology.genus) + ", dissimilarity " +
         fixed(result.last.dissimilarity, 4) +
         (fault_.empty() ? "" : "; lost by tracking: " + fault_);
}

}  // namespace

SequenceResult reconstruct_sequence(
    Document& document, const std::vector<std::string>& names,
    const std::function<std::vector<View>(std::size_t step)>& views_of,
    const SequenceOptions& options, Record& record, const Progress& progress) {
  SequenceLoop loop(names, views_of, options);
  const LoopOptions loop_options{names.size(), "time step", options.on_step};
  const LoopResult result = run_loop(loop, document, loop_options, record, progress);
  if (result.is_done) record.end();
  return loop.result();
}

}  // namespace transformesh
