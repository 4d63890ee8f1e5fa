/// Readers and writers of all camera formats, with one source file per format. Used only in this
/// folder.
#pragma once

#include "io/formats/text_rows.h"
#include "io/streams/source.h"
#include "io/streams/text_buffer.h"
#include "raster/camera.h"
#include "raster/camera_checks.h"
#include "raster/camera_record.h"
#include "raster/middlebury.h"
#include "views/cameras/camera_format.h"
#include "views/cameras/npy_array.h"

namespace transformesh {

/// In files of COLMAP, MVSNet and transforms.json, the center of the first pixel is (0.5, 0.5);
/// ours is (0, 0).
inline constexpr double pixel_center = 0.5;

/// All readers throw InputError as described in camera_file.h.
CameraList read_bundler(const Source& source);
/// Names cameras after `stem`.
CameraList read_opencv(const Source& source, const std::string& stem);
CameraList read_metashape(const Source& source);
/// Reads a CSV table of cameras, or the XMP file of one camera. The camera of an XMP file is named
/// after `stem`.
CameraList read_reality_capture(const Source& source, const std::string& stem);
/// Reads 3x4 projection matrices. Cameras without a name in the file are named after `stem`.
CameraList read_matrices(const Source& source, const std::string& stem);
/// Reads a text that contains both cameras.txt and images.txt.
CameraList read_colmap(const Source& source);
/// Reads cameras.txt and images.txt.
CameraList read_colmap(const Source& cameras, const Source& images);
/// Reads cameras.bin and images.bin.
CameraList read_colmap_binary(const Source& cameras, const Source& images);

CameraList read_transforms(const Source& source);
CameraList read_meshroom(const Source& source);
CameraList read_openmvg(const Source& source);
/// Names the camera after `stem`.
CameraList read_mvsnet(const Source& source, const std::string& stem);
/// Names cameras after `stem`.
CameraList read_llff(const Source& source, const std::string& stem);
CameraList read_neus(const Source& source, const std::string& stem);
CameraList read_nvm(const Source& source);
/// Reads the file meta.ini of one view. Its camera is named after the folder of `source`. Returns
/// an empty list if the view has no pose.
CameraList read_mve(const Source& source);
CameraList read_openmvs(const Source& source);

/// Decomposes a projection into intrinsics and pose of `camera`. Returns "" if this succeeds, else
/// an error message, in which `who` is the name of the camera.
std::string decompose(const Projection& projection, const std::string& who, PinholeCamera& camera);

/// The COLMAP text file to which a row belongs: cameras.txt, images.txt or neither.
enum class ColmapSection { none, cameras, images };
ColmapSection colmap_section(TextRows rows);

std::string write_matrix(const CameraRecord& record);
std::string write_colmap_cameras(const CameraList& list);
std::string write_colmap_images(const CameraList& list);
/// Convert the texts of cameras.txt and images.txt to cameras.bin and images.bin.
std::string binary_colmap_cameras(const std::string& text);
std::string binary_colmap_images(const std::string& text);
std::string write_opencv(const CameraRecord& record);
std::string write_transforms(const CameraList& list);
std::string write_meshroom(const CameraList& list);
std::string write_openmvs(const CameraList& list);

/// Throws InputError unless the record is a pinhole camera without skew for an image of known size.
/// Also throws if the principal point is so large that adding half a pixel to it loses digits.
/// Messages contain `program`, the name of the format.
void check_sized_pinhole(const CameraRecord& record, const std::string& program);

/// Returns the index of the first camera in the list that has the same intrinsics, distortion and
/// image size as `record`.
std::size_t lens_of(const CameraList& list, const CameraRecord& record);

}  // namespace transformesh
