/// Applies the operations of a repair to a mesh, one after the other, and records them. Each
/// operation reads and returns rounded coordinates, like a program that reads and writes files. The
/// recorded operations therefore give the same mesh as a pipeline of programs. An operation that
/// changes nothing is not recorded.
#pragma once

#include "transformesh/repair.h"

namespace transformesh {

class RepairSteps {
 public:
  RepairSteps(Mesh mesh, Scalar coordinate, const Progress& progress)
      : mesh_(std::move(mesh)), coordinate_(coordinate), progress_(progress) {}

  const Mesh& mesh() const { return mesh_; }

  /// Stitches the mesh. Throws InputError if `options` request an orientation and the surface is
  /// one-sided.
  void stitch(const StitchOptions& options);
  /// Fills all holes whose diameter is at most `max_diameter`, with patches that may intersect the
  /// mesh.
  void fill(bool fair, double max_diameter);
  void clean();
  /// Removes components with an area below `least_area`.
  void drop_components(double least_area);

  std::vector<RepairStep> take_steps() { return std::move(steps_); }
  Mesh take_mesh() { return std::move(mesh_); }

 private:
  /// Rounds `after` as if it were written, measures the change, and makes `after` the current mesh.
  void record(Mesh after, RepairStep step);

  Mesh mesh_;
  Scalar coordinate_;
  const Progress& progress_;
  std::vector<RepairStep> steps_;
};

}  // namespace transformesh
