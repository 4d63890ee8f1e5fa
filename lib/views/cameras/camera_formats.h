/// Readers and writers of single camera formats, with one source file per format. Internal to
/// camera_file.
#pragma once

#include "io/formats/text_rows.h"
#include "io/streams/text_buffer.h"
#include "raster/camera_checks.h"
#include "raster/middlebury.h"
#include "views/cameras/camera_file.h"

namespace transformesh {

/// All readers throw InputError as described in camera_file.h.
CameraList read_bundler(const Source& source);
/// Names cameras after `stem`.
CameraList read_opencv(const Source& source, const std::string& stem);
CameraList read_metashape(const Source& source);
/// Reads the table of cameras, or the XMP file of one camera, which is named after `stem`.
CameraList read_reality_capture(const Source& source, const std::string& stem);
/// Names cameras without a name after `stem`.
CameraList read_matrices(const Source& source, const std::string& stem);
/// Reads cameras and images from one text.
CameraList read_colmap(const Source& source);
/// Reads cameras and images from two texts.
CameraList read_colmap(const Source& cameras, const Source& images);
/// Reads cameras.bin and images.bin.
CameraList read_colmap_binary(const Source& cameras, const Source& images);

/// The COLMAP text file to which a row belongs.
enum class ColmapSection { none, cameras, images };
ColmapSection colmap_section(TextRows rows);

std::string write_matrix(const CameraRecord& record);
std::string write_colmap_cameras(const CameraList& list);
std::string write_colmap_images(const CameraList& list);
/// Convert the texts of cameras.txt and images.txt to cameras.bin and images.bin.
std::string binary_colmap_cameras(const std::string& text);
std::string binary_colmap_images(const std::string& text);
std::string write_opencv(const CameraRecord& record);

}  // namespace transformesh
