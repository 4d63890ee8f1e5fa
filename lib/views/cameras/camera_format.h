/// Formats of camera files, and recognition of the format of a file.
#pragma once

#include <optional>
#include <string_view>

namespace transformesh {

enum class CameraFormat {
  middlebury,
  colmap,
  colmap_binary,  ///< files cameras.bin and images.bin; this value is used for writing only
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

/// Recognizes the format of a file by its first bytes. Returns nothing if it is no known camera
/// file.
std::optional<CameraFormat> camera_format(std::string_view bytes);

}  // namespace transformesh
