/// Options --keep-out and --gap: an obstacle, and the distance that a moving surface keeps from it.
#pragma once

#include <optional>
#include <string>

#include "frame/run.h"
#include "support/counted.h"
#include "transformesh/errors.h"
#include "transformesh/mesh.h"

namespace transformesh::tool {

class KeepOutOption {
 public:
  void declare(Program& program) {
    program.options.text("keep-out", &file_, "FILE",
                         "obstacle: do not come nearer to this mesh than --gap");
    program.options.length("gap", &gap_, "distance to keep from the mesh of --keep-out");
  }

  /// Reads the mesh of --keep-out. The result points to this object, which must outlive it.
  KeepOutOptions options(Run& run) {
    if (file_.empty() != !gap_)
      throw UsageError(
          "give both --keep-out FILE, the mesh to keep away from, and --gap LENGTH, the distance "
          "to keep");
    if (file_.empty()) return {};
    const double gap = run.length(*gap_);
    if (!(gap > 0)) throw UsageError("--gap must be above 0");
    surface_ = run.in().read(file_).mesh;
    if (surface_.faces.empty())
      throw InputError(file_ + " has no faces: there is nothing to keep away from");
    return {&surface_, gap};
  }

  void note_near(std::size_t faces, Run& run) const {
    if (faces == 0) return;
    run.note(counted(faces, "face") + (faces == 1 ? " is" : " are") + " nearer to " + file_ +
             " than the gap in the input; they come no nearer");
  }

 private:
  std::string file_;
  std::optional<Length> gap_;
  Mesh surface_;
};

}  // namespace transformesh::tool
