/// Reads and writes a 4x4 matrix as text: 16 numbers row by row, with blanks, commas or line ends
/// between them; what follows # is comment. Throws InputError with the line for anything else.
/// Locale-free.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>

namespace transformesh {

Eigen::Matrix4d parse_matrix(std::string_view bytes, const std::string& name);

/// Four lines of four numbers, which parse_matrix() reads back exactly.
std::string matrix_text(const Eigen::Matrix4d& matrix);

}  // namespace transformesh
