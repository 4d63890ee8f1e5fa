/// Checks of the numbers in camera files, which all formats share.
#pragma once

#include <string>
#include <string_view>

#include "io/formats/text_rows.h"
#include "raster/camera_record.h"

namespace transformesh {

bool is_number(std::string_view word);

/// Returns the name of the source and the line that is read, for example `dino_par.txt line 3`.
std::string place_of(const TextRows& rows, const Source& source);

/// Returns what is wrong with the numbers of the camera `who`, in a sentence; empty if nothing is.
std::string intrinsics_problem(const Eigen::Matrix3d& intrinsics, const std::string& who);
std::string translation_problem(const Vec3& translation, const std::string& who);

/// Each throws InputError at the line of rows, and says what is wrong with `who`.
void check_intrinsics(const TextRows& rows, const Eigen::Matrix3d& intrinsics,
                      const std::string& who);
void check_rotation(const TextRows& rows, const Eigen::Matrix3d& rotation, const std::string& who);
void check_translation(const TextRows& rows, const Vec3& translation, const std::string& who);

/// Throws InputError where the camera that would be read again is none: `again` is the record's
/// after writing and reading.
void check_read_again(const CameraRecord& record, const PinholeCamera& again);

}  // namespace transformesh
