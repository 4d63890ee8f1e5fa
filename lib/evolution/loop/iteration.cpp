#include "transformesh/iteration.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <utility>

#include "clean/exterior/exterior.h"
#include "evolution/loop/stages.h"
#include "evolution/loop/stopwatch.h"
#include "io/document/round_as_written.h"
#include "io/length_basis.h"
#include "remesh/check_remesh_options.h"
#include "remesh/pinch.h"
#include "remesh/remesh_connected.h"
#include "support/counted.h"
#include "support/empty_result_error.h"
#include "support/parallel.h"
#include "support/run_concurrently.h"
#include "transformesh/clean.h"
#include "transformesh/components.h"
#include "transformesh/control.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"
#include "transformesh/mesh_io.h"

namespace transformesh {
namespace {

Topology topology_of(const Components& found) { return {found.components.size(), found.genus()}; }

RemeshOptions remesh_options(const Document& document, const IterationOptions& options) {
  const auto resolved = [&](const Length& length) {
    const bool is_factor = !options.remesh.size_column.empty();
    const double base = is_factor ? 1 : options.reference_edge;
    const bool needs_diagonal = length.unit == Length::Unit::diagonal;
    const double diagonal = needs_diagonal ? diagonal_of(bounding_box(document.mesh)) : 0;
    return length.resolve(diagonal, base);
  };
  RemeshOptions result = options.remesh;
  result.min_edge = resolved({options.edge_factor * options.min_edge.value, options.min_edge.unit});
  result.max_edge = resolved({options.edge_factor * options.max_edge.value, options.max_edge.unit});
  result.coordinate = document.style.coordinate;
  return result;
}

/// Removes enclosed components, as CleanOptions::outermost does, from a result of clean() that was
/// computed without this option.
void drop_enclosed(CleanResult& result) {
  if (!result.changed || drop_enclosed_components(result.mesh) == 0) return;
  result.connectivity.reset();
}

/// Remeshes a document in another thread while it is being cleaned. The result is used only if
/// cleaning changes nothing.
class EarlyRemesh {
 public:
  EarlyRemesh(Document document, const IterationOptions& options, const Progress& progress)
      : document_(std::move(document)), options_(options), progress_(progress) {}

  void run() {
    try {
      const Progress goes_on([this](std::string_view phase, double fraction) {
        if (is_awaited_) progress_(phase, fraction);
        return !is_cancelled_;
      });
      result_ = remesh_in_place(document_, options_, goes_on);
    } catch (...) {
      error_ = std::current_exception();
    }
  }
  void cancel() { is_cancelled_ = true; }
  /// Call when cleaning has ended, but remeshing has not. Afterwards remeshing reports its
  /// progress, and the progress function can cancel it.
  void await() { is_awaited_ = true; }
  RemeshResult take(Document& document) {
    if (error_) std::rethrow_exception(error_);
    document = std::move(document_);
    return std::move(result_);
  }

 private:
  Document document_;
  const IterationOptions& options_;
  const Progress& progress_;
  std::atomic<bool> is_cancelled_{false}, is_awaited_{false};
  RemeshResult result_;
  std::exception_ptr error_;
};

/// Cleans and remeshes a document. Stores all members of IterationResult, except those of the step
/// that moved the vertices before.
class CleanAndRemesh {
 public:
  CleanAndRemesh(Document& document, const IterationOptions& options, const Progress& progress,
                 IterationResult& result)
      : document_(document), options_(options), progress_(progress), result_(result) {}

  void run() {
    RemeshResult remeshed;
    const bool pinches = options_.remesh.pinch != 0;
    if (pinches) check_options(remesh_options(document_, options_));
    if (allowed_thread_count() == 1 || options_.expects_changes || pinches) {
      clean();
      pinch();
      remeshed = remesh();
    } else {
      remeshed = run_both();
    }
    result_.seconds_remesh = watch_.lap();
    result_.topology = {cleaned_.topology.components - remeshed.components_removed.count,
                        cleaned_.topology.genus};
    result_.faces = document_.mesh.faces.size();
  }

 private:
  void clean() {
    cleaned_ = clean_in_place(document_, progress_, options_.outermost, options_.on_cleaned);
    result_.pairs = cleaned_.pairs;
    result_.was_cleaned = cleaned_.changed;
    result_.seconds_clean = watch_.lap();
  }
  /// Returns the largest length of the closed curves around which thin parts are cut; 0 for no
  /// cuts. If cleaning changed a closed surface that is remeshed with RemeshOptions::curved, the
  /// length is at least `min_edge`. The reason: if a flow tears a surface, cleaning leaves threads
  /// and handles much thinner than `min_edge`. Edge collapses do not remove these, as this would
  /// change the genus. The threads intersect each other in later steps, and without cuts their
  /// number doubles from step to step.
  double pinch_length() const {
    const RemeshOptions& remeshing = options_.remesh;
    const bool has_threads = remeshing.curved && cleaned_.changed &&
                             remeshing.size_column.empty() && remeshing.keep_out.surface == nullptr;
    if (!has_threads || !check_manifold(document_.mesh).is_closed()) return remeshing.pinch;
    return std::max(remeshing.pinch, remesh_options(document_, options_).min_edge);
  }
  /// Cuts thin parts. This is done before remeshing and not as a part of it, so that `on_cleaned`
  /// is called for this change, too.
  void pinch() {
    const double length = pinch_length();
    if (length == 0) return;
    Mesh before;
    if (options_.on_cleaned) before = document_.mesh;
    const PinchResult pinched =
        transformesh::pinch(document_.mesh, length, document_.style.coordinate, progress_);
    if (pinched.cut == 0) return;
    cleaned_.opposites.clear();
    if (options_.on_cleaned) options_.on_cleaned(before, document_.mesh);
    cleaned_.topology = topology_of(connected_components(document_.mesh));
  }
  RemeshResult remesh() {
    return remesh_in_place(document_, options_, progress_, std::move(cleaned_.opposites));
  }
  RemeshResult run_both() {
    EarlyRemesh early(document_, options_, progress_);
    const auto clean_or_cancel = [&] {
      try {
        clean();
        progress_("remesh");
        cleaned_.changed ? early.cancel() : early.await();
      } catch (...) {
        early.cancel();
        throw;
      }
    };
    run_concurrently(clean_or_cancel, [&] { early.run(); });
    if (!cleaned_.changed) return early.take(document_);
    pinch();
    return remesh();
  }

  Document& document_;
  const IterationOptions& options_;
  const Progress& progress_;
  IterationResult& result_;
  CleanedTopology cleaned_;
  Stopwatch watch_;
};

/// If nothing is left of the surface after cleaning, throws an error that names the step as the
/// cause. Does nothing for components that are too small for remeshing, because the message of
/// remeshing names the cause.
void throw_if_vanished(const GoalError& error) {
  if (!is_nothing_left(error.kind()) || error.kind() == ErrorKind::component_too_small) return;
  throw GoalError(ErrorKind::surface_vanished,
                  "no surface is left after this step: it has shrunk to nothing, or its walls are "
                  "thinner than the length of the step",
                  error.data());
}

}  // namespace

Step step_along(Velocity velocity, const DisplaceOptions& options) {
  return [velocity = std::move(velocity), options](Mesh& mesh, const Progress& progress) {
    return displace(mesh, velocity(mesh, progress), options);
  };
}

RemeshOptions smoothed_by(double factor) {
  RemeshOptions options;
  options.smoothing = Smoothing::laplace;
  options.smooth_first = factor;
  return options;
}

IterationOptions completed(IterationOptions options, const Mesh& mesh) {
  if (options.reference_edge == 0) options.reference_edge = measured_reference_edge(mesh);
  return options;
}

CleanedTopology clean_in_place(
    Document& document, const Progress& progress, bool outermost,
    const std::function<void(const Mesh& before, Mesh& cleaned)>& on_cleaned) {
  const bool drops_later = outermost && on_cleaned;
  CleanResult result = clean(
      document.mesh,
      {.outermost = outermost && !on_cleaned, .coordinate = document.style.coordinate}, progress);
  if (on_cleaned && result.changed) on_cleaned(document.mesh, result.mesh);
  if (drops_later) drop_enclosed(result);
  document.mesh = std::move(result.mesh);
  round_as_written(document);
  CleanedTopology cleaned{{}, result.changed, result.pairs, {}};
  if (result.connectivity) {
    cleaned.topology = topology_of(connected_components(document.mesh, *result.connectivity));
    cleaned.opposites = std::move(result.connectivity->opposites);
  } else {
    cleaned.topology = topology_of(connected_components(document.mesh));
  }
  return cleaned;
}

RemeshResult remesh_in_place(Document& document, const IterationOptions& options,
                             const Progress& progress, std::vector<Index> opposites) {
  RemeshOptions remeshing = remesh_options(document, options);
  remeshing.pinch = 0;
  RemeshResult result = remesh_connected(document.mesh, remeshing, progress, std::move(opposites));
  round_as_written(document);
  return result;
}

void split_long_edges(Document& document, const IterationOptions& options,
                      const Progress& progress) {
  RemeshOptions splits = remesh_options(document, options);
  if (!(edge_lengths(document.mesh).maximum > splits.max_edge)) return;
  splits.min_edge = 1e-9 * splits.max_edge;  // so short that no edge collapses
  splits.adaptive_error = 0;
  splits.flip = FlipRule::none;
  splits.smoothing = Smoothing::none;
  splits.pinch = 0;
  transformesh::remesh(document.mesh, splits, progress);
  round_as_written(document);
}

IterationResult iterate(Document& document, const Step& step, const IterationOptions& options,
                        const Progress& progress) {
  IterationResult result;
  result.vertices = document.mesh.positions.size();
  Stopwatch watch;
  result.displaced = step(document.mesh, progress);
  round_as_written(document);
  result.seconds_step = watch.lap();

  try {
    CleanAndRemesh(document, options, progress, result).run();
  } catch (const GoalError& error) {
    throw_if_vanished(error);
    throw;
  }
  result.seconds = result.seconds_step + result.seconds_clean + result.seconds_remesh;
  return result;
}

}  // namespace transformesh
