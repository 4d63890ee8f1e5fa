#include "geometry/search/hilbert.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t boxes_per_task = 4096;  ///< affects time only
constexpr unsigned axes = 3;                  ///< x, y and z

constexpr unsigned rotate_left(unsigned octant, unsigned by) {
  by %= axes;
  return (octant << by | octant >> (axes - by)) & 7U;
}

constexpr unsigned gray(unsigned digit) { return digit ^ digit >> 1; }

constexpr unsigned gray_inverse(unsigned octant) { return octant ^ octant >> 1 ^ octant >> 2; }

constexpr unsigned trailing_ones(unsigned digit) {
  return static_cast<unsigned>(std::countr_one(digit));
}

/// State transitions of the curve. A state is 3 * entry + axis: the octant at which the curve
/// enters a cell, and the axis along which it leaves. For each octant the table contains 8 * (state
/// in the octant) + digit.
constexpr auto make_transitions() {
  std::array<std::uint8_t, std::size_t{24} * 8> table{};
  for (unsigned entry = 0; entry < 8; ++entry) {
    for (unsigned axis = 0; axis < axes; ++axis) {
      for (unsigned octant = 0; octant < 8; ++octant) {
        // Transform the octant to the canonical curve, which gives its position along the curve.
        const unsigned digit = gray_inverse(rotate_left(octant ^ entry, 2 * axes - axis - 1));
        // Transform entry and axis of the curve in the octant back.
        const unsigned local_entry = digit == 0 ? 0 : gray(2 * ((digit - 1) / 2));
        const unsigned local_axis =
            digit == 0 ? 0 : trailing_ones(digit % 2 == 0 ? digit - 1 : digit) % axes;
        const unsigned inner_entry = entry ^ rotate_left(local_entry, axis + 1);
        const unsigned inner_axis = (axis + local_axis + 1) % axes;
        table[8 * (axes * entry + axis) + octant] =
            static_cast<std::uint8_t>(8 * (axes * inner_entry + inner_axis) + digit);
      }
    }
  }
  return table;
}

constexpr auto transitions = make_transitions();

/// State transitions over two levels at once. For two bits of each axis the table contains 64 *
/// (state in the octant) + two digits.
constexpr auto make_double_transitions() {
  std::array<std::uint16_t, std::size_t{24} * 64> table{};
  for (unsigned state = 0; state < 24; ++state) {
    for (unsigned bits = 0; bits < 64; ++bits) {
      const unsigned inner = (bits & 1U) | (bits >> 2 & 1U) << 1 | (bits >> 4 & 1U) << 2;
      const unsigned outer = (bits >> 1 & 1U) | (bits >> 3 & 1U) << 1 | (bits >> 5 & 1U) << 2;
      const unsigned first = transitions[8 * state + outer];
      const unsigned second = transitions[8 * (first >> axes) + inner];
      table[64 * state + bits] =
          static_cast<std::uint16_t>((second >> axes) << 6U | (first & 7U) << axes | (second & 7U));
    }
  }
  return table;
}

constexpr auto double_transitions = make_double_transitions();
static_assert(hilbert_bits % 2 == 0);

/// Returns the position along the curve from the leading `bits` bits of each coordinate.
template <int bits>
std::uint64_t leading_index(const std::array<std::uint32_t, 3>& cell) {
  std::uint64_t place = 0;
  unsigned state = 0;
  for (int bit = hilbert_bits - 2; bit >= hilbert_bits - bits; bit -= 2) {
    const unsigned octants =
        (cell[0] >> bit & 3U) | (cell[1] >> bit & 3U) << 2 | (cell[2] >> bit & 3U) << 4;
    const unsigned entry = double_transitions[64 * state + octants];
    place = place << 2 * axes | (entry & 63U);
    state = entry >> 6U;
  }
  return place;
}

// The array stays in registers.
[[gnu::always_inline]] inline std::array<double, 3> center(const FloatBox& box) {
  return {transformesh::center(box, 0), transformesh::center(box, 1), transformesh::center(box, 2)};
}

/// Maps centers to cubic cells that fill the box of all centers along its longest side.
class Cells {
 public:
  explicit Cells(std::span<const FloatBox> boxes) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    auto [x0, y0, z0] = std::array{infinity, infinity, infinity};
    auto [x1, y1, z1] = std::array{-infinity, -infinity, -infinity};
    for (const FloatBox& box : boxes) {
      const auto [x, y, z] = center(box);
      x0 = std::min(x0, x), y0 = std::min(y0, y), z0 = std::min(z0, z);
      x1 = std::max(x1, x), y1 = std::max(y1, y), z1 = std::max(z1, z);
    }
    low_ = {x0, y0, z0};
    const double side = std::max({0.0, x1 - x0, y1 - y0, z1 - z0});
    if (side > 0) cells_per_length_ = largest / side;
  }

  std::array<std::uint32_t, 3> operator()(const FloatBox& box) const {
    const auto [x, y, z] = center(box);
    const auto cell = [&](double length) {
      return static_cast<std::uint32_t>(length * cells_per_length_);
    };
    return {cell(x - low_[0]), cell(y - low_[1]), cell(z - low_[2])};
  }

 private:
  static constexpr double largest = (1U << hilbert_bits) - 1;  ///< largest cell along an axis
  std::array<double, 3> low_{};
  double cells_per_length_ = 0;
};

/// Sorts boxes by their positions along the curve. A key contains the leading bits of the position,
/// followed by the box index. Boxes with equal leading bits are rare; their full positions are
/// compared.
class HilbertSort {
 public:
  explicit HilbertSort(std::span<const FloatBox> boxes) : boxes_(boxes), cells_(boxes) {
    const int index_bits = std::bit_width(boxes.size());
    index_mask_ = (Key{1} << index_bits) - 1;
  }

  std::vector<Index> order() {
    make_keys();
    sort_by_leading_bits();
    sort_runs();
    std::vector<Index> order(keys_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = box_of(keys_[i]);
    return order;
  }

 private:
  using Key = std::uint64_t;
  static constexpr int coarse_bits = 12;  ///< bits per axis in a key
  static constexpr int digit_bits = 12;   ///< bits per pass of the radix sort
  /// Different digits of a radix sort.
  static constexpr std::size_t digits = std::size_t{1} << digit_bits;
  static constexpr int key_bits = 64;           ///< bits of a sorting key
  static constexpr std::size_t few = 1024;      ///< fewer keys are sorted by comparison
  static constexpr std::size_t many = 1 << 20;  ///< more keys take a third pass

  Index box_of(Key key) const { return static_cast<Index>(key & index_mask_); }
  std::pair<std::uint64_t, Index> full_place(Key key) const {
    const Index box = box_of(key);
    return {hilbert_index(cells_(boxes_[box])), box};
  }
  int passes() const { return keys_.size() < few ? 0 : keys_.size() < many ? 2 : 3; }
  Key leading_mask() const {
    const int bits = passes() * digit_bits;
    return bits == 0 ? 0 : ~Key{0} << (key_bits - bits);
  }

  void make_keys() {
    constexpr int shift = key_bits - static_cast<int>(axes) * coarse_bits;
    keys_.resize(boxes_.size());
    parallel_for(boxes_.size(), boxes_per_task, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        keys_[i] = (leading_index<coarse_bits>(cells_(boxes_[i])) << shift & ~index_mask_) | i;
    });
  }

  // Radix sort: stable counting sorts, starting with the least significant digit.
  void sort_by_leading_bits() {
    std::vector<Key> sorted(passes() > 0 ? keys_.size() : 0);
    for (int pass = passes(); pass > 0; --pass) {
      const int shift = key_bits - pass * digit_bits;
      std::array<std::uint32_t, digits + 1> slot{};
      for (const Key key : keys_) ++slot[(key >> shift & (digits - 1)) + 1];
      for (std::size_t i = 1; i < slot.size(); ++i) slot[i] += slot[i - 1];
      for (const Key key : keys_) sorted[slot[key >> shift & (digits - 1)]++] = key;
      keys_.swap(sorted);
    }
  }

  bool comes_before(Key a, Key b) const {
    return ((a ^ b) & ~index_mask_) != 0 ? a < b : full_place(a) < full_place(b);
  }

  /// Sorts runs of keys that are equal in the bits sorted so far.
  void sort_runs() {
    const Key mask = leading_mask();
    const auto begin = keys_.begin();
    for (std::size_t first = 0, last = 0; first < keys_.size(); first = last) {
      last = first + 1;
      while (last < keys_.size() && ((keys_[last] ^ keys_[first]) & mask) == 0) ++last;
      if (last - first > 1)
        std::sort(begin + static_cast<std::ptrdiff_t>(first),
                  begin + static_cast<std::ptrdiff_t>(last),
                  [this](Key a, Key b) { return comes_before(a, b); });
    }
  }

  std::span<const FloatBox> boxes_;
  Cells cells_;
  std::vector<Key> keys_;
  Key index_mask_;
};

}  // namespace

std::uint64_t hilbert_index(const std::array<std::uint32_t, 3>& cell) {
  return leading_index<hilbert_bits>(cell);
}

std::vector<Index> hilbert_order(std::span<const FloatBox> boxes) {
  return HilbertSort(boxes).order();
}

std::vector<Index> hilbert_order(std::span<const Vec3> points) {
  std::vector<FloatBox> boxes(points.size());
  parallel_for(points.size(), boxes_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last; ++p) boxes[p] = float_box(points[p], points[p]);
  });
  return hilbert_order(boxes);
}

}  // namespace transformesh
