#include "views/wrap/colmap_points.h"

#include <array>
#include <cmath>
#include <cstdint>

#include "io/formats/text_rows.h"
#include "transformesh/columns.h"
#include "transformesh/errors.h"
#include "views/cameras/little_endian.h"

namespace transformesh {
namespace {

constexpr std::array column_names{"red", "green", "blue", "error", "track_length"};
/// Bytes of one observation of a point in binary files: the indices of image and feature.
constexpr std::size_t observation_size = 8;

/// The data of one point that text and binary files contain.
struct Row {
  Vec3 position;
  std::array<double, column_names.size()> values{};
};

void add(const Row& row, Mesh& mesh,
         std::array<std::vector<double>, column_names.size()>& columns) {
  mesh.positions.push_back(row.position);
  for (std::size_t i = 0; i < column_names.size(); ++i) columns[i].push_back(row.values[i]);
}

Mesh mesh_of_rows(const std::vector<Row>& rows) {
  Mesh mesh;
  std::array<std::vector<double>, column_names.size()> columns;
  for (const Row& row : rows) add(row, mesh, columns);
  for (std::size_t i = 0; i < column_names.size(); ++i) {
    const Scalar type = i < 3 ? Scalar::uint8 : i == 3 ? Scalar::float64 : Scalar::int32;
    mesh.vertex_columns.get(column_names[i], type, 0).values = std::move(columns[i]);
  }
  return mesh;
}

bool is_text(const Source& source) {
  return source.bytes.starts_with("# 3D point list") || source.name.ends_with("points3D.txt");
}

Mesh read_text(const Source& source) {
  TextRows rows(source, 0, {'#', false});
  std::vector<Row> points;
  while (rows.next_row()) {
    const std::string who = "point " + std::string(rows.word());
    const auto number = [&](const char* name) {
      return rows.finite_number<double>([&] { return name + (" of " + who); });
    };
    Row row;
    for (int i = 0; i < 3; ++i) row.position[i] = number("a coordinate");
    for (std::size_t i = 0; i < 4; ++i) row.values[i] = number(column_names[i]);
    const std::size_t words = rows.words_left();
    if (words % 2 != 0) rows.fail("the track of " + who + " has an odd number of entries");
    row.values[4] = static_cast<double>(words / 2);
    rows.skip_row();
    points.push_back(row);
  }
  return mesh_of_rows(points);
}

/// Reads all points. Throws InputError if the file ends too early.
std::vector<Row> read_rows(const Source& source, LittleEndianReader& bytes) {
  std::vector<Row> points;
  const auto count = bytes.take<std::uint64_t>();
  for (std::uint64_t i = 0; i < count; ++i) {
    bytes.take<std::uint64_t>();  // identifier
    Row row;
    for (double& coordinate : row.position) coordinate = bytes.take<double>();
    for (std::size_t j = 0; j < 3; ++j) row.values[j] = bytes.take<std::uint8_t>();
    row.values[3] = bytes.take<double>();
    const auto track = bytes.take<std::uint64_t>();
    row.values[4] = static_cast<double>(track);
    bytes.skip(track, observation_size);
    if (!row.position.allFinite() || !std::isfinite(row.values[3]))
      source.fail("point " + std::to_string(i) +
                  " of the COLMAP points file has a number that is not "
                  "finite");
    points.push_back(row);
  }
  return points;
}

}  // namespace

std::optional<Mesh> read_colmap_points(const Source& source) {
  if (is_text(source)) return read_text(source);
  const bool is_named = source.name.ends_with("points3D.bin");
  LittleEndianReader bytes(source, "the COLMAP points file");
  if (is_named) return mesh_of_rows(read_rows(source, bytes));
  try {
    const std::vector<Row> points = read_rows(source, bytes);
    if (bytes.is_at_end()) return mesh_of_rows(points);
  } catch (const InputError&) {
    // Not an error: the file is not one of COLMAP's, and another reader will read it or report a
    // better message.
  }
  return {};
}

}  // namespace transformesh
