#include <array>
#include <cmath>
#include <map>

#include "flow/grid_files.h"
#include "io/document/scalar_bytes.h"
#include "io/streams/number_text.h"
#include "support/counted.h"

namespace transformesh {
namespace {

constexpr std::string_view blanks = " \t\r";
/// Largest number of values along an axis, so that no product of four sizes overflows 64 bits.
constexpr double most_values = 65535;

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

class NrrdReader {
 public:
  NrrdReader(const Source& source, std::size_t components)
      : source_(source), components_(components) {
    read_header();
  }

  FlowGrid read() const {
    check_encoding();
    FlowGrid grid;
    grid.components = components_;
    const std::size_t axes = set_sizes(grid);
    set_spacing(grid, axes);
    grid.values = field("type") == "float" ? values<float>(grid) : values<double>(grid);
    if (const std::string_view time = field("=time"); !time.empty())
      grid.time = numbers("=time", 1)[0];
    return grid;
  }

 private:
  /// Reads the lines of the header up to an empty line. A line is `name: value`, `key:=value`, or a
  /// comment.
  void read_header() {
    std::string_view rest = source_.bytes;
    for (bool is_first = true;; is_first = false) {
      const std::size_t end = rest.find('\n');
      if (end == std::string_view::npos)
        source_.fail("the NRRD header does not end with an empty line");
      const std::string_view line = trimmed(rest.substr(0, end));
      rest.remove_prefix(end + 1);
      if (line.empty()) break;
      if (!is_first && line[0] != '#') add_line(line);
    }
    data_ = rest;
  }

  void add_line(std::string_view line) {
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos)
      source_.fail_at_line(line.data(), "the NRRD header has a line without a colon");
    const bool is_key = line.substr(colon).starts_with(":=");
    std::string name(is_key ? 1 : 0, '=');
    name += line.substr(0, colon);
    fields_[name] = trimmed(line.substr(colon + (is_key ? 2 : 1)));
  }

  std::string_view field(const std::string& name) const {
    const auto found = fields_.find(name);
    return found == fields_.end() ? std::string_view() : found->second;
  }

  /// Reads `count` numbers, separated by blanks, commas and parentheses. Skips `none`, which stands
  /// for an axis without direction.
  std::vector<double> numbers(const std::string& name, std::size_t count) const {
    std::string text(field(name));
    for (char& c : text)
      if (c == '(' || c == ')' || c == ',') c = ' ';
    std::vector<double> result;
    const char* first = text.data();
    const char* const last = first + text.size();
    for (;;) {
      while (first != last && blanks.find(*first) != std::string_view::npos) ++first;
      if (first == last) break;
      if (std::string_view(first, static_cast<std::size_t>(last - first)).starts_with("none")) {
        first += 4;
        continue;
      }
      double value = 0;
      if (parse_number(first, last, value) != Parsed::ok) break;
      result.push_back(value);
    }
    if (first != last || result.size() != count)
      source_.fail("the NRRD field " + in_quotes(name) + " does not hold " +
                   counted(count, "number"));
    return result;
  }

  void check_encoding() const {
    if (!field("data file").empty() || !field("datafile").empty())
      source_.fail("NRRD data in a separate file is not supported");
    if (field("encoding") != "raw")
      source_.fail("the NRRD encoding is " + in_quotes(field("encoding")) +
                   "; only raw is supported");
    if (field("type") != "float" && field("type") != "double")
      source_.fail("the NRRD type is " + in_quotes(field("type")) +
                   "; only float and double are supported");
    if (field("endian") != "little" && field("endian") != "big")
      source_.fail(
          "the NRRD header does not state the byte order: write 'endian: little' or 'endian: big'");
  }

  /// Stores the sizes of the axes in `grid`, and returns the number of axes. If values have several
  /// components, these are the first axis.
  std::size_t set_sizes(FlowGrid& grid) const {
    const std::size_t axes = components_ == 1 ? 3 : 4;
    if (numbers("dimension", 1)[0] != static_cast<double>(axes))
      source_.fail("the NRRD dimension is " + std::string(field("dimension")) + ", but must be " +
                   std::to_string(axes));
    const std::vector<double> sizes = numbers("sizes", axes);
    for (const double size : sizes)
      if (!(size >= 1 && size <= most_values) || size != std::floor(size))
        source_.fail("the NRRD sizes must be whole numbers from 1 to 65535");
    if (axes == 4 && sizes[0] != static_cast<double>(components_))
      source_.fail("the first NRRD axis has " + std::to_string(static_cast<long>(sizes[0])) +
                   " values, but a vector has " + std::to_string(components_) + " components");
    for (std::size_t i = 0; i < 3; ++i)
      grid.size[i] = static_cast<std::size_t>(sizes[axes - 3 + i]);
    return axes;
  }

  void set_spacing(FlowGrid& grid, std::size_t axes) const {
    if (!field("space directions").empty()) {
      const std::vector<double> rows = numbers("space directions", 9);
      for (std::size_t i = 0; i < 9; ++i)
        if (i % 4 != 0 && rows[i] != 0)
          source_.fail("a grid with axes other than x, y and z is not supported");
      grid.spacing = {rows[0], rows[4], rows[8]};
    } else if (!field("spacings").empty()) {
      grid.spacing = last_three("spacings", axes);
    }
    if (!field("space origin").empty()) {
      const std::vector<double> origin = numbers("space origin", 3);
      grid.origin = {origin[0], origin[1], origin[2]};
    } else {
      const std::string name = field("axis mins").empty() ? "axismins" : "axis mins";
      if (!field(name).empty()) grid.origin = last_three(name, axes);
    }
  }

  Vec3 last_three(const std::string& name, std::size_t axes) const {
    const std::vector<double> values = numbers(name, axes);
    return {values[axes - 3], values[axes - 2], values[axes - 1]};
  }

  template <class T>
  std::vector<double> values(const FlowGrid& grid) const {
    const std::size_t count = grid.components * grid.size[0] * grid.size[1] * grid.size[2];
    if (count > data_.size() / sizeof(T))
      source_.fail("the NRRD header announces " + counted(count, "number") + ", but there are " +
                   counted(data_.size(), "byte"));
    const bool swapped = (field("endian") == "little") != host_is_little;
    std::vector<double> result(count);
    for (std::size_t i = 0; i < count; ++i)
      result[i] = static_cast<double>(load_scalar<T>(data_.data() + i * sizeof(T), swapped));
    return result;
  }

  const Source& source_;
  std::size_t components_;
  /// Fields of the header by name. Names of `key:=value` lines have '=' in front.
  std::map<std::string, std::string_view, std::less<>> fields_;
  std::string_view data_;
};

}  // namespace

bool is_nrrd(std::string_view bytes) { return bytes.starts_with("NRRD000"); }

FlowGrid read_nrrd_grid(const Source& source, std::size_t components) {
  return NrrdReader(source, components).read();
}

}  // namespace transformesh
