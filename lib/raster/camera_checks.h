/// Checks the numbers of cameras that are read from files; used by all formats of camera files.
#pragma once

#include <string>
#include <string_view>

#include "io/formats/text_rows.h"
#include "raster/camera_record.h"

namespace transformesh {

/// Returns the file name of `source` and the current line of `rows` for messages, for example
/// `dino_par.txt line 3`.
std::string place_of(const TextRows& rows, const Source& source);

/// Return "" if the numbers are valid, else an error message, in which `who` is the name of the
/// camera.
std::string intrinsics_problem(const Eigen::Matrix3d& intrinsics, const std::string& who);
std::string translation_problem(const Vec3& translation, const std::string& who);

/// Throw InputError if numbers are not valid. The message contains the current line of `rows` and
/// `who`, the name of the camera.
void check_intrinsics(const TextRows& rows, const Eigen::Matrix3d& intrinsics,
                      const std::string& who);
void check_rotation(const TextRows& rows, const Eigen::Matrix3d& rotation, const std::string& who);
void check_translation(const TextRows& rows, const Vec3& translation, const std::string& who);

/// Throws InputError unless `again` is valid. `again` is the camera that results if the camera of
/// `record` is written to a file and read from it.
void check_read_again(const CameraRecord& record, const PinholeCamera& again);

}  // namespace transformesh
