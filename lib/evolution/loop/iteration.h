/// One iteration of an evolution (paper 5.1, Fig. 8): every vertex takes a step, clean() removes
/// the self-intersections that this makes, remesh() keeps the surface well sampled.
///
/// Guarantees: after each of the three, coordinates and columns are rounded as they would be
/// written, so that an evolution in one process makes the same bytes as the filters on pipes, and
/// can be continued from a file. The result is an oriented manifold without self-intersections as
/// far as remesh() promises; columns are carried as by clean() and remesh().
/// Throws what the three throw. Deterministic for any number of threads.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "evolution/loop/csv_row.h"
#include "io/document/document.h"
#include "io/length_basis.h"
#include "remesh/remesh.h"
#include "step/displace.h"
#include "support/length.h"
#include "support/progress.h"

namespace transformesh {

/// One vector per vertex.
using Velocity = std::function<std::vector<Vec3>(const Mesh& mesh, const Progress& progress)>;
/// Moves the vertices and nothing else.
using Step = std::function<DisplaceResult(Mesh& mesh, const Progress& progress)>;

/// The step that displace() makes of a velocity.
Step step_along(Velocity velocity, const DisplaceOptions& options = {});

/// Smoothing by a factor of the Laplace-Beltrami operator (paper 5.1.2); else remesh()'s defaults.
RemeshOptions smoothed_by(double factor);

struct IterationOptions {
  Length min_edge{0.7, Length::Unit::reference_edge};
  Length max_edge{1.5, Length::Unit::reference_edge};
  double reference_edge = 0;  ///< input units; 0: the mean edge when the evolution begins
  double edge_factor = 1;     ///< both lengths are so many times as long
  /// All but its lengths and its coordinate type, which come from above and from the document. With
  /// a size column the lengths are factors of it.
  RemeshOptions remesh = smoothed_by(0.1);
  bool outermost = true;  ///< of clean(): what lies inside goes, cavities too
  /// Whether clean() is likely to change the mesh. Where not, and threads are free, remesh() begins
  /// beside it, and again where it did. Results are the same.
  bool expects_changes = false;
};
/// With the reference edge of the mesh where there is none.
IterationOptions completed(IterationOptions options, const Mesh& mesh);

struct Topology {
  std::size_t components = 0;
  long genus = 0;  ///< of all components
  bool operator==(const Topology&) const = default;
};
/// "812 faces, 1 part, genus 0".
std::string in_words(std::size_t faces, const Topology& topology);
/// "812 faces, components 1, genus 0".
std::string in_short(std::size_t faces, const Topology& topology);

struct IterationResult {
  std::size_t vertices = 0;  ///< that took the step
  std::size_t faces = 0;     ///< of the mesh afterwards
  std::size_t pairs = 0;     ///< intersecting pairs of faces that were removed
  bool was_cleaned = false;  ///< whether clean() changed anything
  Topology topology;         ///< of the mesh afterwards
  DisplaceResult displaced;
  double seconds_step = 0, seconds_clean = 0, seconds_remesh = 0;
  double seconds = 0;  ///< of all three

  double moved_share() const;
  double clamped_share() const;
  /// The columns of the CSV file that iterations have in common: of the mesh afterwards, and of
  /// the edges before with the times.
  void measure_mesh(CsvRow& row) const;
  void measure_times(CsvRow& row) const;
};

IterationResult iterate(Document& document, const Step& step, const IterationOptions& options,
                        const Progress& progress = Progress());

/// Its third part alone.
RemeshResult remesh_in_place(Document& document, const IterationOptions& options,
                             const Progress& progress = Progress(),
                             std::vector<Index> opposites = {});

struct CleanedTopology {
  Topology topology;
  bool changed = false;
  std::size_t pairs = 0;
  std::vector<Index> opposites;  ///< for remesh(), where they were found
};

/// clean(), rounded as written.
CleanedTopology clean_in_place(Document& document, const Progress& progress = Progress(),
                               bool outermost = true);

}  // namespace transformesh
