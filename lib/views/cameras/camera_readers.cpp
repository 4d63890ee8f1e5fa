#include "views/cameras/camera_readers.h"

#include <algorithm>
#include <array>

#include "views/cameras/camera_formats.h"

namespace transformesh {
namespace {

/// Adapts a reader without the parameter `stem` to CameraReader::read. Its files contain names of
/// all cameras.
template <CameraList (*read)(const Source&)>
CameraList named(const Source& source, const std::string&) {
  return read(source);
}

constexpr std::array readers{
    CameraReader{CameraFormat::colmap, "COLMAP", named<read_colmap>},
    CameraReader{CameraFormat::middlebury, "Middlebury", named<read_middlebury>},
    CameraReader{CameraFormat::bundler, "Bundler", named<read_bundler>},
    CameraReader{CameraFormat::opencv, "OpenCV", read_opencv},
    CameraReader{CameraFormat::metashape, "Metashape", named<read_metashape>},
    CameraReader{CameraFormat::reality_capture, "RealityCapture", read_reality_capture},
    CameraReader{CameraFormat::transforms, "transforms.json of NeRF", named<read_transforms>},
    CameraReader{CameraFormat::meshroom, "Meshroom", named<read_meshroom>},
    CameraReader{CameraFormat::openmvg, "OpenMVG", named<read_openmvg>},
    CameraReader{CameraFormat::mvsnet, "MVSNet", read_mvsnet},
    CameraReader{CameraFormat::llff, "LLFF", read_llff},
    CameraReader{CameraFormat::neus, "NeuS", read_neus},
    CameraReader{CameraFormat::nvm, "VisualSFM", named<read_nvm>},
    CameraReader{CameraFormat::mve, "MVE", named<read_mve>},
    CameraReader{CameraFormat::openmvs, "OpenMVS", named<read_openmvs>},
    CameraReader{CameraFormat::matrices, "3x4 matrices", read_matrices}};

}  // namespace

const CameraReader& reader_of(CameraFormat format) {
  const auto* const found =
      std::find_if(readers.begin(), readers.end(),
                   [&](const CameraReader& reader) { return reader.format == format; });
  return found == readers.end() ? readers.front() : *found;
}

std::string known_camera_formats() {
  std::string text = "files of ";
  for (const CameraReader& reader : readers) {
    if (&reader != readers.data()) text += &reader == &readers.back() ? " and " : ", ";
    text += reader.program;
  }
  return text + " are read";
}

}  // namespace transformesh
