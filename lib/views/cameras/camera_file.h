/// Camera files: Middlebury parameters, COLMAP's models, Bundler, OpenCV, Metashape, RealityCapture
/// and 3x4 matrices, distinguished by their content.
///
/// Middlebury: the number of cameras, then a line `name k11 .. k33 r11 .. r33 t1 t2 t3` for each.
/// COLMAP: cameras.txt and images.txt, in two files of a folder or joined in one text, or
/// cameras.bin and images.bin in a folder; its pixel centers are at 0.5. Bundler: bundle.out v0.3;
/// the principal point is the image's center. Matrices: twelve numbers in rows, K [R | t] up to
/// scale; several may follow each other in a file, each perhaps after a comment `# name`.
///
/// OpenCV: YAML or XML with camera_matrix, distortion_coefficients, and R and T, or rows of
/// extrinsic_parameters. Metashape: the XML of its cameras, aligned ones, in units of the chunk.
/// RealityCapture: its table (CSV) of internal and external parameters, or an XMP file a camera.
///
/// Distortion is known of Bundler, OpenCV, Metashape and RealityCapture, but for their terms beyond
/// r^6, and of COLMAP's models SIMPLE_RADIAL, RADIAL, OPENCV and FULL_OPENCV. All of them throw
/// InputError naming file and line for cameras that a pinhole, but for that, is not, for numbers
/// that are missing, not finite, beyond 1e100 or no numbers, for focal lengths that are nothing
/// beside the principal point, and for counts that disagree.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "raster/camera.h"
#include "raster/camera_record.h"

namespace transformesh {

enum class CameraFormat {
  middlebury,
  colmap,
  colmap_binary,  ///< to be written
  bundler,
  matrices,
  opencv,
  metashape,
  reality_capture
};

/// None where the beginning looks like no camera file.
std::optional<CameraFormat> camera_format(std::string_view bytes);

/// The cameras of a text, which is complete in itself; `name` is the text's, for messages. Matrices
/// without names are called after `stem`, or else the stem of `name`.
CameraList parse_cameras(std::string_view bytes, const std::string& name,
                         const std::string& stem = {});

/// The cameras of a file, a folder or a pattern, in order: several matrix files in natural order.
/// Of a folder the files are taken that look like camera files, which must be of one format.
CameraList cameras_from(const std::string& where);

/// A file with its name, where a format has several.
struct CameraText {
  std::string name;
  std::string text;
};

/// One text that reads back as the same cameras. Throws InputError for what the format cannot hold:
/// Bundler, Metashape and RealityCapture are only read, OpenCV holds one camera, COLMAP's binary
/// files are two, COLMAP needs the images' sizes, these three no skew, Middlebury and matrices no
/// distortion, Middlebury names without blanks, all of them names that are not empty; and for
/// cameras that are still to be given the size of their image.
std::string write_cameras(const CameraList& list, CameraFormat format);

/// As the programs of the format expect it in a folder: COLMAP's three files, for each camera a
/// matrix as `NAME.txt` or OpenCV's `NAME.yml`, Middlebury's `cameras_par.txt`.
std::vector<CameraText> write_camera_files(const CameraList& list, CameraFormat format);

}  // namespace transformesh
