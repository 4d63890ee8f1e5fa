#include "geometry/search/hilbert.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "mesh/point_bounds.h"
#include "support/parallel.h"
#include "support/raw_vector.h"

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

/// State transitions of the Hilbert curve. A state is 3 * entry + axis. `entry` is the octant at
/// which the curve enters a cell, and `axis` is the axis along which it leaves. For each state and
/// octant, the table contains 8 * (state in the octant) + (position of the octant on the curve).
constexpr auto make_transitions() {
  std::array<std::uint8_t, std::size_t{24} * 8> table{};
  for (unsigned entry = 0; entry < 8; ++entry) {
    for (unsigned axis = 0; axis < axes; ++axis) {
      for (unsigned octant = 0; octant < 8; ++octant) {
        // Transform the octant to the canonical orientation of the curve, in which its Gray code
        // gives the position on the curve.
        const unsigned digit = gray_inverse(rotate_left(octant ^ entry, 2 * axes - axis - 1));
        // Transform entry and exit axis of the curve in the octant back from the canonical
        // orientation.
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

/// State transitions of the Hilbert curve over two levels at once. For each state and two bits of
/// each coordinate, the table contains 64 * (state after two levels) + (two octal digits of the
/// position).
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

/// Returns the position of a cell along the Hilbert curve, from the leading `bits` bits of each
/// coordinate.
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

// Always inlined, so that the array stays in registers.
[[gnu::always_inline]] inline std::array<double, 3> center(const FloatBox& box) {
  return {transformesh::center(box, 0), transformesh::center(box, 1), transformesh::center(box, 2)};
}

/// Maps the center of a box to a cubic cell. The grid of cells fills the bounding box of all
/// centers along its longest side.
class Cells {
 public:
  explicit Cells(std::span<const FloatBox> boxes) {
    if (boxes.empty()) return;
    const auto [low, high] =
        bounds_of_points(boxes.size(), [&](std::size_t i) { return center(boxes[i]); });
    low_ = {low[0], low[1], low[2]};
    const double side = std::max(0.0, (high - low).maxCoeff());
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
  /// Largest cell coordinate along an axis.
  static constexpr double largest = (1U << hilbert_bits) - 1;
  std::array<double, 3> low_{};
  double cells_per_length_ = 0;
};

/// Sorts boxes by their positions along the Hilbert curve. A key contains the leading bits of the
/// position, followed by the box index. If keys have equal leading bits, which is rare, full
/// positions are compared.
class HilbertSort {
 public:
  explicit HilbertSort(std::span<const FloatBox> boxes) : boxes_(boxes), cells_(boxes) {
    const int index_bits = std::bit_width(boxes.size());
    index_mask_ = (Key{1} << index_bits) - 1;
  }

  std::vector<Index> order() {
    make_keys();
    if (keys_.size() < few) {
      sort(0, keys_.size());
    } else {
      sort_in_parts();
    }
    std::vector<Index> order(keys_.size());
    parallel_for(order.size(), boxes_per_task, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) order[i] = box_of(keys_[i]);
    });
    return order;
  }

 private:
  using Key = std::uint64_t;
  static constexpr int coarse_bits = 12;  ///< number of bits of each coordinate in a sorting key
  /// Number of leading bits of a key that determine its part (bucket) of the sort.
  static constexpr int part_bits = 12;
  /// Number of parts (buckets) of the sort.
  static constexpr std::size_t parts = std::size_t{1} << part_bits;
  static constexpr int key_bits = 64;   ///< number of bits of a sorting key
  static constexpr int digit_bits = 8;  ///< number of bits per pass of the radix sort within a part
  /// If there are fewer keys than this, all are sorted as one part. Affects time only.
  static constexpr std::size_t few = 1024;
  /// Parts (buckets) with fewer keys than this are sorted by comparison. Affects time only.
  static constexpr std::size_t few_in_part = 64;
  /// Number of keys that are counted together; affects time only.
  static constexpr std::size_t block = 16384;
  static constexpr std::size_t parts_per_task = 16;  ///< affects time only

  Index box_of(Key key) const { return static_cast<Index>(key & index_mask_); }
  std::pair<std::uint64_t, Index> full_place(Key key) const {
    const Index box = box_of(key);
    return {hilbert_index(cells_(boxes_[box])), box};
  }
  static std::size_t part_of(Key key) { return key >> (key_bits - part_bits); }

  void make_keys() {
    constexpr int shift = key_bits - static_cast<int>(axes) * coarse_bits;
    keys_.resize(boxes_.size());
    parallel_for(boxes_.size(), boxes_per_task, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        keys_[i] = (leading_index<coarse_bits>(cells_(boxes_[i])) << shift & ~index_mask_) | i;
    });
  }

  // Moves keys to parts (buckets) by their leading bits, in a parallel counting sort, and sorts
  // each part.
  void sort_in_parts() {
    const std::size_t blocks = (keys_.size() + block - 1) / block;
    std::vector<Index> slots(blocks * parts, 0);
    const auto for_each_key = [&](const auto& visit) {
      parallel_for(blocks, 1, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from * block; i < std::min(keys_.size(), to * block); ++i)
          visit(keys_[i], slots[i / block * parts + part_of(keys_[i])]);
      });
    };
    for_each_key([](Key, Index& count) { ++count; });
    std::vector<std::size_t> begin(parts + 1, 0);
    Index next = 0;
    for (std::size_t part = 0; part < parts; ++part) {
      for (std::size_t b = 0; b < blocks; ++b) next += std::exchange(slots[b * parts + part], next);
      begin[part + 1] = next;
    }
    RawVector<Key> sorted(keys_.size());
    for_each_key([&](Key key, Index& slot) { sorted[slot++] = key; });
    keys_.swap(sorted);
    parallel_for(parts, parts_per_task, [&](std::size_t first, std::size_t last) {
      for (std::size_t part = first; part < last; ++part) sort(begin[part], begin[part + 1]);
    });
  }

  // Sorts a range of keys. Then sorts runs of keys whose leading bits are equal by their full
  // positions along the curve.
  void sort(std::size_t begin, std::size_t end) {
    const std::span<Key> keys = std::span(keys_).subspan(begin, end - begin);
    if (keys.size() >= few_in_part) {
      sort_by_digits(keys);
      constexpr Key sorted_bits = ~Key{0} << (key_bits - part_bits - 2 * digit_bits);
      for_each_run(keys, sorted_bits,
                   [](std::span<Key> run) { std::sort(run.begin(), run.end()); });
    } else {
      std::sort(keys.begin(), keys.end());
    }
    for_each_run(keys, ~index_mask_, [this](std::span<Key> run) {
      std::sort(run.begin(), run.end(),
                [this](Key a, Key b) { return full_place(a) < full_place(b); });
    });
  }

  // Calls visit(run) for each maximal run of at least two keys that are equal in the bits of
  // `mask`.
  template <class Visit>
  static void for_each_run(std::span<Key> keys, Key mask, const Visit& visit) {
    for (std::size_t first = 0, last = 0; first < keys.size(); first = last) {
      last = first + 1;
      while (last < keys.size() && ((keys[last] ^ keys[first]) & mask) == 0) ++last;
      if (last - first > 1) visit(keys.subspan(first, last - first));
    }
  }

  // Sorts keys by the next 2 * digit_bits bits after the bits of their part, with two stable
  // counting sorts.
  static void sort_by_digits(std::span<Key> keys) {
    constexpr std::size_t digits = std::size_t{1} << digit_bits;  // values of a digit
    thread_local std::vector<Key> sorted;
    sorted.resize(std::max(sorted.size(), keys.size()));
    for (int pass = 2; pass > 0; --pass) {
      const int shift = key_bits - part_bits - pass * digit_bits;
      std::array<std::uint32_t, digits + 1> slot{};
      for (const Key key : keys) ++slot[(key >> shift & (digits - 1)) + 1];
      for (std::size_t i = 1; i < slot.size(); ++i) slot[i] += slot[i - 1];
      for (const Key key : keys) sorted[slot[key >> shift & (digits - 1)]++] = key;
      std::copy_n(sorted.begin(), keys.size(), keys.begin());
    }
  }

  std::span<const FloatBox> boxes_;
  Cells cells_;
  RawVector<Key> keys_;
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
