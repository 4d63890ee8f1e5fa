#include "page/pack.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

#include "mesh/color_scale.h"
#include "page/encode.h"

namespace transformesh {
namespace {

using HeaderJson = nlohmann::ordered_json;

// The largest integer of 16 bits.
constexpr double most = 65535;
constexpr std::uint32_t not_finite = 65535;

/// Builds the bytes of a packed mesh from streams of integers.
class Streams {
 public:
  void add(std::span<const std::uint32_t> numbers, int bytes) {
    for (int byte = 0; byte < bytes; ++byte)
      for (const std::uint32_t number : numbers)
        bytes_ += static_cast<char>((number >> (8 * byte)) & 255U);
  }
  /// Adds the first number and the difference of each number from the previous one, modulo
  /// 256^bytes.
  void add_differences(std::vector<std::uint32_t> numbers, int bytes) {
    for (std::size_t i = numbers.size(); i-- > 1;) numbers[i] -= numbers[i - 1];
    add(numbers, bytes);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Vertices in the order in which faces use them.
struct Order {
  std::vector<Index> vertices;       ///< original indices
  std::vector<std::uint32_t> codes;  ///< codes of the corners (pack.h)
};

Order order_of_use(const Mesh& mesh) {
  Order order;
  std::vector<Index> place(mesh.positions.size(), no_index);
  const auto use = [&](Index vertex) {
    const auto next = static_cast<Index>(order.vertices.size());
    if (place[vertex] != no_index) return next - place[vertex];
    place[vertex] = next;
    order.vertices.push_back(vertex);
    return Index{0};
  };
  for (const Face& face : mesh.faces)
    for (const Index corner : face) order.codes.push_back(use(corner));
  for (Index vertex = 0; vertex < place.size(); ++vertex) use(vertex);
  return order;
}

std::uint32_t code(double value, double low, double high, double codes) {
  // Both numbers are halved, so that their difference does not overflow.
  const double extent = high / 2 - low / 2;
  if (!(extent > 0)) return 0;
  const double share = std::clamp((value / 2 - low / 2) / extent, 0.0, 1.0);
  return static_cast<std::uint32_t>(std::floor(share * codes + 0.5));
}

void set_box(const Mesh& mesh, PackedMesh& packed) {
  if (mesh.positions.empty()) return;
  packed.low = packed.high = mesh.positions[0];
  for (const Vec3& position : mesh.positions) {
    packed.low = packed.low.cwiseMin(position);
    packed.high = packed.high.cwiseMax(position);
  }
  const Vec3 middle = packed.low / 2 + packed.high / 2;
  for (const Vec3& position : mesh.positions)
    packed.radius = std::max(packed.radius, (position - middle).stableNorm());
}

void add_positions(const Mesh& mesh, const Order& order, const PackedMesh& packed,
                   Streams& streams) {
  std::vector<std::uint32_t> codes(order.vertices.size());
  for (int axis = 0; axis < 3; ++axis) {
    std::ranges::transform(order.vertices, codes.begin(), [&](Index vertex) {
      return code(mesh.positions[vertex][axis], packed.low[axis], packed.high[axis], most);
    });
    streams.add_differences(codes, 2);
  }
}

bool is_shown(const Column& column) {
  constexpr std::array names{"nx", "ny", "nz", "vx", "vy", "vz", "red", "green", "blue", "alpha"};
  return !column.list_count_type && std::ranges::find(names, column.name) == names.end();
}

PackedColumn numbers_of(const Column& column, PackedColumn::Of of) {
  PackedColumn packed{of, column.name};
  bool is_first = true;
  for (const double value : column.values) {
    if (!std::isfinite(value)) continue;
    packed.low = is_first ? value : std::min(packed.low, value);
    packed.high = is_first ? value : std::max(packed.high, value);
    is_first = false;
  }
  return packed;
}

void add_numbers(const Column& column, const PackedColumn& packed, auto row_of, std::size_t rows,
                 Streams& streams) {
  std::vector<std::uint32_t> codes(rows);
  for (std::size_t i = 0; i < rows; ++i) {
    const double value = column.values[row_of(i)];
    codes[i] = std::isfinite(value) ? code(value, packed.low, packed.high, most - 1) : not_finite;
  }
  streams.add_differences(std::move(codes), 2);
}

void add_colors(const Columns& columns, const Order& order, PackedMesh& packed, Streams& streams) {
  const std::array channels{columns.find("red"), columns.find("green"), columns.find("blue")};
  for (const Column* channel : channels)
    if (channel == nullptr || channel->list_count_type) return;
  packed.columns.push_back({PackedColumn::Of::color, "color"});
  std::vector<std::uint32_t> bytes(order.vertices.size());
  for (const Column* channel : channels) {
    std::ranges::transform(order.vertices, bytes.begin(), [&](Index vertex) {
      const double value = channel->values[vertex];
      return std::isfinite(value) ? code(value, 0, full_intensity(channel->type), 255) : 0;
    });
    streams.add_differences(bytes, 1);
  }
}

void add_columns(const Mesh& mesh, const Order& order, PackedMesh& packed, Streams& streams) {
  for (const Column& column : mesh.vertex_columns.columns) {
    if (!is_shown(column)) continue;
    packed.columns.push_back(numbers_of(column, PackedColumn::Of::vertex));
    add_numbers(
        column, packed.columns.back(), [&](std::size_t i) { return order.vertices[i]; },
        order.vertices.size(), streams);
  }
  for (const Column& column : mesh.face_columns.columns) {
    if (!is_shown(column)) continue;
    packed.columns.push_back(numbers_of(column, PackedColumn::Of::face));
    add_numbers(
        column, packed.columns.back(), [](std::size_t i) { return i; }, mesh.faces.size(), streams);
  }
  add_colors(mesh.vertex_columns, order, packed, streams);
}

HeaderJson corner_json(const Vec3& vector) { return {vector.x(), vector.y(), vector.z()}; }

std::string header_of(const PackedMesh& packed) {
  HeaderJson columns = HeaderJson::array();
  for (const PackedColumn& column : packed.columns) {
    constexpr std::array names{"vertex", "face", "color"};
    columns.push_back({{"name", column.name},
                       {"of", names[static_cast<std::size_t>(column.of)]},
                       {"low", column.low},
                       {"high", column.high}});
  }
  const HeaderJson json = {{"vertices", packed.vertices},
                           {"faces", packed.faces},
                           {"low", corner_json(packed.low)},
                           {"high", corner_json(packed.high)},
                           {"columns", columns}};
  return json.dump(-1, ' ', false, HeaderJson::error_handler_t::replace);
}

std::string size_bytes(std::size_t size) {
  Streams streams;
  const auto number = static_cast<std::uint32_t>(size);
  for (int byte = 0; byte < 4; ++byte) streams.add(std::array{number >> (8 * byte)}, 1);
  return streams.bytes();
}

}  // namespace

PackedMesh pack(const Mesh& mesh) {
  PackedMesh packed;
  packed.vertices = mesh.positions.size();
  packed.faces = mesh.faces.size();
  set_box(mesh, packed);

  const Order order = order_of_use(mesh);
  Streams streams;
  streams.add(order.codes, packed.vertices <= 65535 ? 2 : 4);
  add_positions(mesh, order, packed, streams);
  add_columns(mesh, order, packed, streams);

  const std::string header = header_of(packed);
  packed.block = deflated(size_bytes(header.size()) + header + streams.bytes());
  return packed;
}

}  // namespace transformesh
