#include "tm/geometry/hilbert.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "tm/support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t boxes_per_task = 4096;
constexpr unsigned axes = 3;

constexpr unsigned rotate_left(unsigned octant, unsigned by) {
  by %= axes;
  return (octant << by | octant >> (axes - by)) & 7U;
}

constexpr unsigned gray(unsigned digit) { return digit ^ digit >> 1; }

constexpr unsigned gray_inverse(unsigned octant) { return octant ^ octant >> 1 ^ octant >> 2; }

/// The number of trailing ones.
constexpr unsigned trailing_ones(unsigned digit) {
  return static_cast<unsigned>(std::countr_one(digit));
}

/// How the curve runs inside a cell: from which octant it enters, and along which axis it leaves.
/// A state is 3 * entry + axis; for each octant the table holds 8 * (state inside) + digit.
constexpr auto make_transitions() {
  std::array<std::uint8_t, std::size_t{24} * 8> table{};
  for (unsigned entry = 0; entry < 8; ++entry) {
    for (unsigned axis = 0; axis < axes; ++axis) {
      for (unsigned octant = 0; octant < 8; ++octant) {
        // The octant is seen as by the untransformed curve, which gives its place along the curve.
        const unsigned digit = gray_inverse(rotate_left(octant ^ entry, 2 * axes - axis - 1));
        // The entry and the axis of the curve inside the octant are transformed back.
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

/// Steps over two levels at once: for two bits of each axis the table holds 64 * (state inside)
/// plus two digits.
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

struct Key {
  std::uint64_t place;
  Index box;
  bool operator<(const Key& other) const {
    return place != other.place ? place < other.place : box < other.box;
  }
};

/// Maps centers to cells: cubes that fill the box around all centers along its longest side.
class Cells {
 public:
  explicit Cells(std::span<const FloatBox> boxes) {
    low_.fill(std::numeric_limits<double>::infinity());
    std::array<double, 3> high;
    high.fill(-std::numeric_limits<double>::infinity());
    for (const FloatBox& box : boxes) {
      for (std::size_t axis = 0; axis < axes; ++axis) {
        low_[axis] = std::min(low_[axis], center(box, axis));
        high[axis] = std::max(high[axis], center(box, axis));
      }
    }
    double side = 0;
    for (std::size_t axis = 0; axis < axes; ++axis) side = std::max(side, high[axis] - low_[axis]);
    if (side > 0) cells_per_length_ = largest / side;
  }

  std::array<std::uint32_t, 3> operator()(const FloatBox& box) const {
    std::array<std::uint32_t, 3> cell;
    for (std::size_t axis = 0; axis < axes; ++axis)
      cell[axis] = static_cast<std::uint32_t>((center(box, axis) - low_[axis]) * cells_per_length_);
    return cell;
  }

 private:
  static constexpr double largest = (1U << hilbert_bits) - 1;
  std::array<double, 3> low_;
  double cells_per_length_ = 0;
};

/// A radix sort by the leading 36 bits; the few keys that agree in them are then sorted by
/// comparison.
void sort_keys(std::vector<Key>& keys) {
  constexpr int digit_bits = 12;
  constexpr std::uint64_t digit_mask = (1U << digit_bits) - 1;
  constexpr int first_bit = axes * hilbert_bits - 3 * digit_bits;

  // Three stable counting sorts, the least significant digit first, make the radix sort.
  std::vector<Key> sorted(keys.size());
  for (int shift = first_bit; shift < static_cast<int>(axes) * hilbert_bits; shift += digit_bits) {
    std::vector<std::size_t> slot(digit_mask + 2, 0);
    for (const Key& key : keys) ++slot[(key.place >> shift & digit_mask) + 1];
    for (std::size_t i = 1; i < slot.size(); ++i) slot[i] += slot[i - 1];
    for (const Key& key : keys) sorted[slot[key.place >> shift & digit_mask]++] = key;
    keys.swap(sorted);
  }

  for (std::size_t first = 0; first < keys.size();) {
    std::size_t last = first + 1;
    while (last < keys.size() && keys[last].place >> first_bit == keys[first].place >> first_bit)
      ++last;
    if (last - first > 1)
      std::sort(keys.begin() + static_cast<std::ptrdiff_t>(first),
                keys.begin() + static_cast<std::ptrdiff_t>(last));
    first = last;
  }
}

}  // namespace

std::uint64_t hilbert_index(const std::array<std::uint32_t, 3>& cell) {
  std::uint64_t place = 0;
  unsigned state = 0;
  for (int bit = hilbert_bits - 2; bit >= 0; bit -= 2) {
    const unsigned bits =
        (cell[0] >> bit & 3U) | (cell[1] >> bit & 3U) << 2 | (cell[2] >> bit & 3U) << 4;
    const unsigned entry = double_transitions[64 * state + bits];
    place = place << 2 * axes | (entry & 63U);
    state = entry >> 6U;
  }
  return place;
}

std::vector<Index> hilbert_order(std::span<const FloatBox> boxes) {
  std::vector<Key> keys(boxes.size());
  const Cells cells(boxes);
  parallel_for(boxes.size(), boxes_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      keys[i] = {hilbert_index(cells(boxes[i])), static_cast<Index>(i)};
  });
  sort_keys(keys);

  std::vector<Index> order(boxes.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = keys[i].box;
  return order;
}

std::vector<Index> hilbert_order(std::span<const Vec3> points) {
  std::vector<FloatBox> boxes(points.size());
  parallel_for(points.size(), boxes_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last; ++p) boxes[p] = float_box(points[p], points[p]);
  });
  return hilbert_order(boxes);
}

}  // namespace transformesh
