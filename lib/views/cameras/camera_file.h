/// Reads and writes camera files. The format is recognized by the content.
///
/// Middlebury: the number of cameras, then one line `name k11 .. k33 r11 .. r33 t1 t2 t3` per
/// camera.
/// COLMAP: cameras.txt and images.txt, as two files of a folder or concatenated in one text; or
/// cameras.bin and images.bin in a folder. Pixel centers are at 0.5.
/// Bundler: bundle.out v0.3. The principal point is the image's center.
/// Matrices: twelve numbers in rows, K [R | t] up to scale. A file may contain several matrices. A
/// comment `# name` before a matrix is its name.
/// OpenCV: YAML or XML with camera_matrix and distortion_coefficients, and either R and T or rows
/// of extrinsic_parameters.
/// Metashape: the XML of the cameras. Only aligned cameras are read, in units of the chunk.
/// RealityCapture: the table (CSV) of internal and external parameters, or one XMP file per camera.
///
/// Distortion is read from Bundler, OpenCV, Metashape and RealityCapture (except for terms beyond
/// r^6), and from COLMAP's models SIMPLE_RADIAL, RADIAL, OPENCV and FULL_OPENCV.
///
/// All readers throw InputError, naming file and line, if a camera is not a pinhole with such
/// distortion. They also throw if a number is missing, malformed, not finite or beyond 1e100, and
/// if counts disagree. A focal length that is negligible compared with the principal point is an
/// error, too.
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
  colmap_binary,  ///< format for writing only
  bundler,
  matrices,
  opencv,
  metashape,
  reality_capture
};

/// Recognizes the format by the beginning of a file. Returns nothing if it is not a camera file.
std::optional<CameraFormat> camera_format(std::string_view bytes);

/// Reads cameras from a text, which must be complete in itself. `name` is the name of the text in
/// messages. Matrices without names are named after `stem`, or after the stem of `name` if `stem`
/// is empty.
CameraList parse_cameras(std::string_view bytes, const std::string& name,
                         const std::string& stem = {});

/// Reads cameras from a file, a folder or a pattern, in the order of the files. Several matrix
/// files are sorted in natural order. In a folder, only files that look like camera files are read;
/// they must have the same format.
CameraList cameras_from(const std::string& where);

/// A camera file to be written.
struct CameraText {
  std::string name;
  std::string text;
};

/// Returns one text that is read back as the same cameras. Throws InputError if the format cannot
/// store the cameras:
/// - Bundler, Metashape and RealityCapture are only read.
/// - OpenCV's files contain one camera, and COLMAP's binary model has several files.
/// - COLMAP needs the sizes of the images; OpenCV and COLMAP have no skew.
/// - Middlebury and matrices have no distortion.
/// - Middlebury needs names without blanks; all formats need names that are not empty.
///
/// Also throws if a camera depends on the size of an image that is not known.
std::string write_cameras(const CameraList& list, CameraFormat format);

/// Returns the files that programs of the format expect in a folder. These are COLMAP's three
/// files, Middlebury's `cameras_par.txt`, or for each camera a matrix `NAME.txt` or OpenCV's
/// `NAME.yml`. Throws as write_cameras() does, except that several files are possible.
std::vector<CameraText> write_camera_files(const CameraList& list, CameraFormat format);

}  // namespace transformesh
