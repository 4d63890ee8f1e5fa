/// Reads and writes a 4x4 matrix as text: 16 numbers by rows, separated by blanks, commas or line
/// ends. Text from # to the end of the line is a comment. The reader throws InputError, with the
/// line, for anything else. Independent of the locale.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>

namespace transformesh {

Eigen::Matrix4d parse_matrix(std::string_view bytes, const std::string& name);

/// Returns four lines of four numbers, which parse_matrix() reads back exactly.
std::string matrix_text(const Eigen::Matrix4d& matrix);

}  // namespace transformesh
