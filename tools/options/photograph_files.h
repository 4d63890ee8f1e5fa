/// What tm-photograph writes.
#pragma once

#include <string>

#include "frame/run.h"
#include "views/cameras/camera_ring.h"
#include "views/photo/photograph.h"

namespace transformesh::tool {

struct PhotographFiles {
  std::string cameras;      ///< empty: a ring
  std::string images;       ///< folder to write to; empty: none
  std::string silhouettes;  ///< likewise
  std::string masks;        ///< to compare with; empty: none
  std::string look = "texture";
  bool size_is_given = false;  ///< that of the ring was asked for
  long waves = TextureOptions().waves;
  TextureOptions texture;
  PhotographOptions sensor;
};

/// Photographs by the cameras, or by the ring, and reports the agreement with the masks. Returns
/// the cameras as Middlebury parameters. Throws what reading cameras and masks does.
std::string write_photographs(const Mesh& mesh, const CameraRing& ring,
                              const PhotographFiles& files, Run& run);

}  // namespace transformesh::tool
