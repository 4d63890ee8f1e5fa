/// The formats of camera files, one source each. Internal to camera_file.
#pragma once

#include "io/formats/text_rows.h"
#include "io/streams/text_buffer.h"
#include "raster/camera_checks.h"
#include "raster/middlebury.h"
#include "views/cameras/camera_file.h"

namespace transformesh {

/// Each throws InputError for what camera_file.h refuses.
CameraList read_bundler(const Source& source);
/// Cameras are called after the stem.
CameraList read_opencv(const Source& source, const std::string& stem);
CameraList read_metashape(const Source& source);
/// The table of cameras, or the XMP file of one, which is called after the stem.
CameraList read_reality_capture(const Source& source, const std::string& stem);
/// Cameras without a name are called after the stem.
CameraList read_matrices(const Source& source, const std::string& stem);
/// Cameras and images in one text.
CameraList read_colmap(const Source& source);
/// Cameras and images in two texts.
CameraList read_colmap(const Source& cameras, const Source& images);
/// The same of cameras.bin and images.bin.
CameraList read_colmap_binary(const Source& cameras, const Source& images);

/// Which of COLMAP's files has such a row.
enum class ColmapSection { none, cameras, images };
ColmapSection colmap_section(TextRows rows);

std::string write_matrix(const CameraRecord& record);
std::string write_colmap_cameras(const CameraList& list);
std::string write_colmap_images(const CameraList& list);
/// cameras.bin and images.bin of their texts.
std::string binary_colmap_cameras(const std::string& text);
std::string binary_colmap_images(const std::string& text);
std::string write_opencv(const CameraRecord& record);

}  // namespace transformesh
