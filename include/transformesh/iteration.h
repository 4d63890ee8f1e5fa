/// One iteration of an evolution (paper 5.1, Fig. 8): every vertex takes a step, clean() removes
/// the self-intersections that the step made, remesh() keeps the surface well sampled.
///
/// Guarantees: the result is an oriented manifold without self-intersections, within the limits of
/// remesh(). Columns are carried. After each stage coordinates and columns are rounded to the types
/// in which they will be written. Throws as the stages do. Deterministic for any number of threads.
#pragma once

#include "transformesh/displace.h"
#include "transformesh/document.h"
#include "transformesh/length.h"
#include "transformesh/remesh.h"

namespace transformesh {

/// Returns one vector per vertex.
using Velocity = std::function<std::vector<Vec3>(const Mesh& mesh, const Progress& progress)>;

/// Moves the vertices and changes nothing else.
using Step = std::function<DisplaceResult(Mesh& mesh, const Progress& progress)>;

/// Returns a step that calls displace() with this velocity.
Step step_along(Velocity velocity, const DisplaceOptions& options = {});

/// Returns options that smooth by a factor in [0, 1] of the Laplace-Beltrami operator.
RemeshOptions smoothed_by(double factor);

struct IterationOptions {
  Length min_edge{0.7, Length::Unit::reference_edge};
  Length max_edge{1.5, Length::Unit::reference_edge};
  double reference_edge = 0;                ///< length `1x`, in input units; 0: initial mean edge
  double edge_factor = 1;                   ///< multiplies `min_edge` and `max_edge`
  RemeshOptions remesh = smoothed_by(0.1);  ///< its `min_edge`, `max_edge`, `coordinate` are unused
  bool outermost = true;                    ///< drop cavities (CleanOptions::outermost)
  bool expects_changes = false;  ///< clean() probably changes the mesh; affects only the speed
  /// Called after clean() changed the mesh, before cavities are dropped, and after necks are cut.
  std::function<void(const Mesh& before, Mesh& cleaned)> on_cleaned = {};
};

struct Topology {
  std::size_t components = 0;
  long genus = 0;  ///< sum over all components
  bool operator==(const Topology&) const = default;
};

struct IterationResult {
  std::size_t vertices = 0;  ///< number of vertices before the step
  std::size_t faces = 0;     ///< number of faces after the iteration
  std::size_t pairs = 0;     ///< intersecting pairs of faces that were removed
  bool was_cleaned = false;  ///< clean() changed the mesh
  Topology topology;         ///< topology after the iteration
  DisplaceResult displaced;
  double seconds_step = 0, seconds_clean = 0, seconds_remesh = 0, seconds = 0;
};

/// Makes one iteration.
IterationResult iterate(Document& document, const Step& step, const IterationOptions& options,
                        const Progress& progress = Progress());

}  // namespace transformesh
