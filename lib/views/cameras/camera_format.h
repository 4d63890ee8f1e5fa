/// Formats of camera files, and how they are recognized.
#pragma once

#include <optional>
#include <string_view>

namespace transformesh {

enum class CameraFormat {
  middlebury,
  colmap,
  colmap_binary,  ///< format for writing only
  bundler,
  matrices,
  opencv,
  metashape,
  reality_capture,
  transforms,  ///< transforms.json of NeRF, instant-ngp and nerfstudio
  meshroom,
  openmvg,
  mvsnet,
  llff,  ///< poses_bounds.npy
  neus,  ///< cameras_sphere.npz
  nvm,   ///< VisualSFM
  mve,
  openmvs
};

/// Recognizes the format by the beginning of a file. Returns nothing if it is not a camera file.
std::optional<CameraFormat> camera_format(std::string_view bytes);

}  // namespace transformesh
