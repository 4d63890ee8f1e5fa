/// The operations of a repair, applied one after the other to one mesh and recorded. Each function
/// applies one operation to the mesh as its program would read and write it, so that the recorded
/// operations give the same mesh as programs on pipes. An operation that changes nothing is not
/// recorded.
#pragma once

#include "transformesh/repair.h"

namespace transformesh {

class RepairSteps {
 public:
  RepairSteps(Mesh mesh, Scalar coordinate, const Progress& progress)
      : mesh_(std::move(mesh)), coordinate_(coordinate), progress_(progress) {}

  const Mesh& mesh() const { return mesh_; }

  /// Throws InputError for a surface with one side if it is to be oriented.
  void stitch(const StitchOptions& options);
  /// Closes all holes of at most this diameter, by patches that may intersect the mesh.
  void fill(bool fair, double max_diameter);
  void clean();
  /// Drops components with less area.
  void drop_components(double least_area);

  std::vector<RepairStep> take_steps() { return std::move(steps_); }
  Mesh take_mesh() { return std::move(mesh_); }

 private:
  /// Rounds `after` as it would be written, measures the change and takes it over.
  void record(Mesh after, RepairStep step);

  Mesh mesh_;
  Scalar coordinate_;
  const Progress& progress_;
  std::vector<RepairStep> steps_;
};

}  // namespace transformesh
