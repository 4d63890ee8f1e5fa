/// Files that tm-photograph writes.
#pragma once

#include <string>

#include "frame/run.h"
#include "views/cameras/camera_ring.h"
#include "views/photo/photograph.h"

namespace transformesh::tool {

struct PhotographFiles {
  std::string cameras;      ///< camera file to read; empty: use a ring of cameras
  std::string images;       ///< output folder for photographs; empty: none
  std::string silhouettes;  ///< output folder for silhouettes; empty: none
  std::string masks;        ///< masks with which silhouettes are compared; empty: none
  bool is_shaded = false;   ///< true: draw shaded surfaces as tm-render does, without the texture
  bool size_is_given = false;  ///< true if the size of images was given as an option
  TextureOptions texture;
  PhotographOptions sensor;
};

/// Renders photographs for the cameras in the file, or for the ring, and reports the agreement with
/// the masks. Returns the cameras as Middlebury parameters. Throws errors of reading cameras and
/// masks.
std::string write_photographs(const Mesh& mesh, const CameraRing& ring,
                              const PhotographFiles& files, Run& run);

}  // namespace transformesh::tool
