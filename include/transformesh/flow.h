/// Motions of surfaces by name, for evolve_in_time(): velocity fields of the literature, grids of
/// velocities, and geometric flows. Deterministic for any number of threads.
/// Formulas: lib/flow and tm-flow(1).
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "transformesh/errors.h"
#include "transformesh/motion.h"

namespace transformesh {

/// Values at the nodes of a regular grid at one time; x varies fastest among the nodes.
struct FlowGrid {
  Vec3 origin = Vec3::Zero();                ///< position of the first node, in input units
  Vec3 spacing = Vec3::Ones();               ///< distance of neighboring nodes; > 0
  std::array<std::size_t, 3> size{1, 1, 1};  ///< nodes per axis; 1: constant along this axis
  std::size_t components = 3;                ///< 3: velocities; 1: speeds
  std::vector<double> values;                ///< the components of a node are side by side
  std::optional<double> time = {};
};

/// Reads VTK ImageData (.vti) or NRRD with this number of components. Throws InputError.
FlowGrid read_flow_grid(std::string_view bytes, const std::string& name, std::size_t components);

/// Each flow has some of these options. Setting one that a flow lacks is a UsageError.
struct FlowOptions {
  double speed = 1;                   ///< multiplies the velocity; > 0 in curvature flows
  std::optional<double> period = {};  ///< > 0; default by flow: rotation 1, vortex 8, deformation 3
  std::optional<Vec3> center = {};    ///< default (.5, .5, .5), the center of the unit cube
  std::optional<Vec3> direction = {};  ///< default: z axis for rotation, x for translation; not 0
  std::optional<std::string> column = {};  ///< flow `normal`: vertex column of speeds
  std::vector<FlowGrid> grids = {};        ///< flow `grid`: velocities; `normal`: speeds
};

struct FlowKind {
  std::string name;
  std::string summary;
  std::vector<std::string> parameters;  ///< FlowOptions members of this flow, besides `speed`
};
const std::vector<FlowKind>& flow_kinds();

/// Counts of vertices that were outside of the grids, or kept fixed at a border.
struct FlowCounts {
  std::size_t outside = 0;  ///< largest number of vertices outside of the grids in one evaluation
  bool is_time_outside = false;  ///< a time was before the first grid or after the last one
  std::size_t fixed = 0;         ///< largest number of fixed border vertices in one evaluation
};

struct Flow {
  Motion motion;
  std::shared_ptr<const FlowCounts> counts;
};

/// Returns the named flow. Throws UsageError for an unknown name and for options that it lacks.
Flow make_flow(const std::string& name, FlowOptions options = {});

}  // namespace transformesh
