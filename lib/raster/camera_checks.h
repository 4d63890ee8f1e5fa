/// Checks of numbers that all formats of camera files share.
#pragma once

#include <string>
#include <string_view>

#include "io/formats/text_rows.h"
#include "raster/camera_record.h"

namespace transformesh {

bool is_number(std::string_view word);

/// Returns the name of the source and the line that is read, for example `dino_par.txt line 3`.
std::string place_of(const TextRows& rows, const Source& source);

/// Return what is wrong with the numbers of the camera `who`, as a sentence; "" if nothing is.
std::string intrinsics_problem(const Eigen::Matrix3d& intrinsics, const std::string& who);
std::string translation_problem(const Vec3& translation, const std::string& who);

/// Throw InputError at the current line of `rows`, with what is wrong with `who`.
void check_intrinsics(const TextRows& rows, const Eigen::Matrix3d& intrinsics,
                      const std::string& who);
void check_rotation(const TextRows& rows, const Eigen::Matrix3d& rotation, const std::string& who);
void check_translation(const TextRows& rows, const Vec3& translation, const std::string& who);

/// Throws InputError if the camera would not be valid after writing and reading. `again` is the
/// camera of `record` after that.
void check_read_again(const CameraRecord& record, const PinholeCamera& again);

}  // namespace transformesh
