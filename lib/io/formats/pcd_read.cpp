#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "io/document/scalar.h"
#include "io/document/scalar_bytes.h"
#include "io/formats/column_groups.h"
#include "io/formats/finite_values.h"
#include "io/formats/pcd.h"
#include "io/formats/text_rows.h"
#include "io/streams/expand.h"
#include "io/streams/lzf.h"
#include "mesh/index_limits.h"
#include "support/counted.h"

namespace transformesh {
namespace {

struct Field {
  std::string name;
  /// Kind of numbers: F for floating point, I for signed and U for unsigned integers.
  char kind = 'F';
  std::size_t bytes = 4;       ///< size of one number in bytes
  std::size_t count = 1;       ///< number of numbers for each point
  std::size_t offset = 0;      ///< offset of the first number within a point, in bytes
  std::vector<double> values;  ///< for each point, its first number in this field

  bool is_color() const { return (name == "rgb" || name == "rgba") && bytes == 4; }
  std::size_t size() const { return bytes * count; }
};

/// Calls f with a zero of the field's C++ type. Returns false if there is no such type.
template <class Function>
bool with_type(const Field& field, const Function& f) {
  if (field.kind == 'F' && field.bytes == 4) return f(float{}), true;
  if (field.kind == 'F' && field.bytes == 8) return f(double{}), true;
  const bool is_signed = field.kind == 'I';
  if (!is_signed && field.kind != 'U') return false;
  if (field.bytes == 1) return is_signed ? f(std::int8_t{}) : f(std::uint8_t{}), true;
  if (field.bytes == 2) return is_signed ? f(std::int16_t{}) : f(std::uint16_t{}), true;
  if (field.bytes == 4) return is_signed ? f(std::int32_t{}) : f(std::uint32_t{}), true;
  if (field.bytes == 8) return is_signed ? f(std::int64_t{}) : f(std::uint64_t{}), true;
  return false;
}

class PcdReader {
 public:
  explicit PcdReader(const Source& source)
      : source_(source), rows_(source, 0, rules_with_comments) {}

  ReadResult read() {
    Style& style = result_.document.style;
    style.format = Format::xyz;
    style.element_order = {"vertex"};
    read_header();
    if (encoding_ == "ascii") {
      read_text();
    } else {
      read_bytes();
    }
    for (Field& field : fields_) {
      if (field.kind != 'F')
        note_rounded_integers(field.values, "field " + in_quotes(field.name), "pcd", result_.notes);
      if (!field.is_color()) fit_to_type(field);
    }
    make_mesh();
    return std::move(result_);
  }

 private:
  // --- Header ------------------------------------------------------------------------------------

  void read_header() {
    while (encoding_.empty()) {
      if (!rows_.next_row()) rows_.fail("the PCD header ends before the line DATA");
      const std::string key(rows_.word());
      if (key == "FIELDS" || key == "COLUMNS") {
        while (rows_.has_more()) fields_.emplace_back().name = rows_.word();
      } else if (key == "SIZE") {
        for (Field& field : fields_) field.bytes = count("a size");
      } else if (key == "COUNT") {
        for (Field& field : fields_) field.count = count("a count");
      } else if (key == "TYPE") {
        for (Field& field : fields_) field.kind = rows_.peek().empty() ? '?' : rows_.word()[0];
      } else if (key == "WIDTH" || key == "HEIGHT") {
        (key == "WIDTH" ? width_ : height_) = count("the size of the cloud");
      } else if (key == "POINTS") {
        points_ = count("the number of points");
      } else if (key == "DATA") {
        encoding_ = rows_.word();
      }
      rows_.skip_row();
    }
    check_fields();
  }

  std::size_t count(const char* what) {
    return rows_.number<std::uint32_t>([&] { return std::string(what); });
  }

  void check_fields() {
    if (points_ == 0) points_ = width_ * height_;
    for (Field& field : fields_) {
      // Largest number of values of a field per point. Descriptors of points, the longest fields in
      // use, have a few hundred.
      constexpr std::size_t most_numbers = 1U << 16U;
      if (field.count > most_numbers)
        rows_.fail("the PCD field " + in_quotes(field.name) + " has " +
                   counted(field.count, "number"));
      field.offset = point_size_;
      if (!with_type(field, [](auto) {}))
        rows_.fail("the PCD field " + in_quotes(field.name) + " has a type that is not supported");
      point_size_ += field.size();
    }
    for (const char* name : {"x", "y", "z"})
      if (find(name) == nullptr) rows_.fail(std::string("the PCD header has no field ") + name);
    if (points_ >= no_index) rows_.fail(too_many_vertices);
  }

  Field* find(std::string_view name) {
    const auto found = std::find_if(fields_.begin(), fields_.end(),
                                    [&](const Field& field) { return field.name == name; });
    return found == fields_.end() ? nullptr : &*found;
  }

  [[noreturn]] void fail_short(std::size_t present) const {
    source_.fail("the PCD header announces " + counted(points_, "point") + ", but only " +
                 counted(present, "byte") + " follow: the file is cut off or its header is wrong");
  }

  // --- Data --------------------------------------------------------------------------------------

  void read_text() {
    const auto left = static_cast<std::size_t>(source_.end() - rows_.rest());
    if (points_ > left / 2 + 1) fail_short(left);
    for (std::size_t point = 0; point < points_; ++point) {
      if (!rows_.next_row())
        rows_.fail("the data ends before point " + std::to_string(point) + " of " +
                   std::to_string(points_));
      for (Field& field : fields_)
        for (std::size_t i = 0; i < field.count; ++i) {
          const double value = text_value(field, point);
          if (i == 0) field.values.push_back(value);
        }
      rows_.end_row([&] { return "point " + std::to_string(point); });
    }
  }

  /// Converts the numbers of a field, which may come from text, to the field's type, or to double
  /// if a number does not fit.
  static void fit_to_type(Field& field) {
    bool is_held = true;
    with_type(field, [&](auto zero) {
      using T = decltype(zero);
      if constexpr (std::is_floating_point_v<T>) {
        for (double& value : field.values) value = static_cast<double>(static_cast<T>(value));
      } else {
        is_held = std::all_of(field.values.begin(), field.values.end(), [](double value) {
          return static_cast<double>(to_scalar<T>(value)) == value;
        });
      }
    });
    if (!is_held) field.kind = 'F', field.bytes = 8;
  }

  /// Reads a number from text. A color in a text file is a float whose bits encode the color, or
  /// these bits as an integer.
  double text_value(const Field& field, std::size_t point) {
    const auto name = [&] { return field.name + " of point " + std::to_string(point); };
    const double value = rows_.number_or_nan<double>(name);
    if (!field.is_color() || field.kind != 'F') return value;
    return std::bit_cast<std::uint32_t>(static_cast<float>(value));
  }

  void read_bytes() {
    const char* const place = rows_.rest();
    const std::string_view bytes(place, static_cast<std::size_t>(source_.end() - place));
    if (encoding_ == "binary") {
      if (points_ * point_size_ > bytes.size()) fail_short(bytes.size());
      return load(bytes, point_size_, 1);
    }
    if (encoding_ != "binary_compressed")
      source_.fail("PCD data of the encoding " + in_quotes(encoding_) + " is not supported");
    load(expanded(bytes), 0, points_);
  }

  /// Returns the decompressed data, which holds the fields one after the other, each with the
  /// values of all points.
  std::string expanded(std::string_view bytes) const {
    constexpr std::size_t header = 8;  // two 32-bit sizes
    if (bytes.size() < header) fail_short(bytes.size());
    const std::size_t stored = load_scalar<std::uint32_t>(bytes.data(), !host_is_little);
    const std::size_t size = load_scalar<std::uint32_t>(bytes.data() + 4, !host_is_little);
    if (stored > bytes.size() - header || size != points_ * point_size_) fail_short(bytes.size());
    ExpansionBudget budget(source_);
    budget.spend(size);
    const std::optional<std::string> result = expand_lzf(bytes.substr(header, stored), size);
    if (!result) source_.fail("the compressed PCD data is damaged");
    return *result;
  }

  /// Loads the values of all fields. In `bytes`, points are `step` bytes apart. If `step` is 0, the
  /// fields follow each other instead, each with the values of `block` points.
  void load(std::string_view bytes, std::size_t step, std::size_t block) {
    for (Field& field : fields_)
      with_type(field, [&](auto zero) {
        using T = decltype(zero);
        const std::size_t apart = step == 0 ? field.size() : step;
        const char* const first = bytes.data() + field.offset * block;
        field.values.reserve(points_);
        for (std::size_t point = 0; point < points_ && field.count > 0; ++point) {
          const char* const from = first + point * apart;
          field.values.push_back(field.is_color()
                                     ? load_scalar<std::uint32_t>(from, !host_is_little)
                                     : static_cast<double>(load_scalar<T>(from, !host_is_little)));
        }
      });
  }

  // --- Mesh --------------------------------------------------------------------------------------

  void make_mesh() {
    Mesh& mesh = result_.document.mesh;
    const Field &x = *find("x"), &y = *find("y"), &z = *find("z");
    if (x.count * y.count * z.count == 0)
      source_.fail("the PCD fields x, y and z have a count of 0");
    for (std::size_t i = 0; i < points_; ++i)
      mesh.positions.emplace_back(x.values[i], y.values[i], z.values[i]);
    const auto is_single = [](const Field& field) { return field.kind == 'F' && field.bytes == 4; };
    const bool are_single = is_single(x) && is_single(y) && is_single(z);
    result_.document.style.coordinate = are_single ? Scalar::float32 : Scalar::float64;
    for (Field& field : fields_) add_column(field, mesh.vertex_columns);
    zero_values_not_finite(mesh.vertex_columns, source_, "point", "pcd", result_.notes);
    drop_points_not_finite(mesh, 0, "pcd", result_.notes);
  }

  void add_column(Field& field, Columns& columns) {
    const bool is_padding = field.name == "_";
    if (is_padding || (field.name.size() == 1 && field.name[0] >= 'x' && field.name[0] <= 'z'))
      return;
    if (field.count != 1) {
      result_.notes.push_back("pcd: field " + in_quotes(field.name) + " of " +
                              counted(field.count, "number") + " left out");
    } else if (field.is_color()) {
      add_colors(field, columns);
    } else {
      const bool is_normal = field.name.starts_with("normal_") && field.name.size() == 8;
      const std::string name =
          is_normal ? std::string{'n', field.name[7]} : column_name(field.name);
      columns.get(name, type_of(field), 0).values = std::move(field.values);
    }
  }

  static Scalar type_of(const Field& field) {
    if (field.kind == 'F') return field.bytes == 4 ? Scalar::float32 : Scalar::float64;
    const bool is_signed = field.kind == 'I';
    if (field.bytes == 1) return is_signed ? Scalar::int8 : Scalar::uint8;
    if (field.bytes == 2) return is_signed ? Scalar::int16 : Scalar::uint16;
    if (field.bytes == 4) return is_signed ? Scalar::int32 : Scalar::uint32;
    return Scalar::float64;
  }

  /// Adds the color columns of a field with packed colors. From the highest byte, the four bytes
  /// are alpha, red, green and blue.
  static void add_colors(const Field& field, Columns& columns) {
    constexpr std::array<unsigned, 4> shifts{16, 8, 0, 24};
    for (std::size_t c = 0; c < (field.name == "rgba" ? 4U : 3U); ++c) {
      Column& column = columns.get(color_channels[c], Scalar::uint8, field.values.size());
      for (std::size_t i = 0; i < field.values.size(); ++i)
        column.values[i] = to_scalar<std::uint32_t>(field.values[i]) >> shifts[c] & 255U;
    }
  }

  const Source& source_;
  TextRows rows_;
  std::vector<Field> fields_;
  std::string encoding_;
  std::size_t width_ = 0, height_ = 1, points_ = 0;
  std::size_t point_size_ = 0;
  ReadResult result_;
};

}  // namespace

bool is_pcd(std::string_view bytes) {
  const Source start{bytes.substr(0, 4096), ""};
  TextRows rows(start, 0, rules_with_comments);
  if (!rows.next_row()) return false;
  const std::string_view word = rows.word();
  return word == "VERSION" ? !rows.peek().empty() : word == "FIELDS" && rows.words_left() >= 3;
}

ReadResult read_pcd(const Source& source) { return PcdReader(source).read(); }

}  // namespace transformesh
