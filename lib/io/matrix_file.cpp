#include "io/matrix_file.h"

#include <algorithm>

#include "io/formats/text_rows.h"
#include "support/number.h"

namespace transformesh {

Eigen::Matrix4d parse_matrix(std::string_view bytes, const std::string& name) {
  std::string text(bytes);
  std::replace(text.begin(), text.end(), ',', ' ');
  const Source source{text, name};
  TextRows rows(source, 0, {.comment = '#'});

  Eigen::Matrix4d matrix;
  Eigen::Index count = 0;
  while (rows.next_row())
    while (rows.has_more()) {
      const auto number = rows.finite_number<double>([] { return std::string("a number"); });
      if (count == 16) rows.fail("a 4x4 matrix has 16 numbers, but the file has more");
      matrix(count / 4, count % 4) = number;
      ++count;
    }
  if (count < 16)
    source.fail("a 4x4 matrix has 16 numbers, but there " +
                std::string(count == 1 ? "is " : "are ") + std::to_string(count));
  return matrix;
}

std::string matrix_text(const Eigen::Matrix4d& matrix) {
  std::string text;
  for (Eigen::Index row = 0; row < 4; ++row)
    for (Eigen::Index column = 0; column < 4; ++column)
      text += shortest_text(matrix(row, column)) + (column < 3 ? ' ' : '\n');
  return text;
}

}  // namespace transformesh
