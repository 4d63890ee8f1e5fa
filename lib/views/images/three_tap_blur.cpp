#include "views/images/three_tap_blur.h"

#include <algorithm>

namespace transformesh {
namespace {

/// Converts parts of rows of an image to floats. The parts have one more pixel than the result on
/// each side, unless they end at the border. Stores the last three rows.
class Rows {
 public:
  Rows(const std::vector<std::uint8_t>& bytes, int width, int first, int count)
      : bytes_(bytes), width_(width), first_(first), count_(count) {
    for (std::vector<float>& row : rows_) row.resize(static_cast<std::size_t>(count));
    held_.fill(-1);
  }

  const float* row(int y) {
    const auto slot = static_cast<std::size_t>(y % 3);
    if (held_[slot] != y) {
      held_[slot] = y;
      const std::uint8_t* const from = bytes_.data() + static_cast<std::ptrdiff_t>(y) * width_;
      std::copy_n(from + first_, count_, rows_[slot].begin());
    }
    return rows_[slot].data();
  }

 private:
  const std::vector<std::uint8_t>& bytes_;
  int width_, first_, count_;
  std::array<std::vector<float>, 3> rows_;
  std::array<int, 3> held_{};
};

void blend(const float* a, const float* b, const std::array<float, 2>& weights, int count,
           float* out) {
  for (int x = 0; x < count; ++x) out[x] = weights[0] * a[x] + weights[1] * b[x];
}

void blend(const float* a, const float* b, const float* c, const std::array<float, 3>& weights,
           int count, float* out) {
  for (int x = 0; x < count; ++x)
    out[x] = weights[0] * a[x] + weights[1] * b[x] + weights[2] * c[x];
}

}  // namespace

void blur_rectangle(const std::vector<std::uint8_t>& bytes, int width, int height,
                    const ThreeTapBlur& taps, const std::array<int, 2>& start, int columns,
                    int rows, float* out) {
  const auto [column, row] = start;
  const int first = std::max(column - 1, 0);
  const int count = std::min(column + columns + 1, width) - first;
  Rows source(bytes, width, first, count);
  std::vector<float> blended(static_cast<std::size_t>(count));
  float* const sums = blended.data();
  for (int y = row; y < row + rows; ++y, out += columns) {
    if (y == 0) {
      blend(source.row(0), source.row(1), taps.first, count, sums);
    } else if (y == height - 1) {
      blend(source.row(y - 1), source.row(y), taps.last, count, sums);
    } else {
      blend(source.row(y - 1), source.row(y), source.row(y + 1), taps.inside, count, sums);
    }
    // `at` points to the element of `sums` that belongs to the first pixel of the result. Pixels
    // from `inner_begin` to before `inner_end` have neighbors on both sides.
    const float* const at = sums + (column - first);
    const int inner_begin = column == 0 ? 1 : 0;
    const int inner_end = column + columns == width ? columns - 1 : columns;
    if (inner_begin == 1) blend(at, at + 1, taps.first, 1, out);
    blend(at + inner_begin - 1, at + inner_begin, at + inner_begin + 1, taps.inside,
          inner_end - inner_begin, out + inner_begin);
    if (inner_end < columns)
      blend(at + columns - 2, at + columns - 1, taps.last, 1, out + columns - 1);
  }
}

}  // namespace transformesh
