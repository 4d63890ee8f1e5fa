#include <algorithm>
#include <cmath>

#include "io/document/scalar.h"
#include "io/document/scalar_bytes.h"
#include "io/formats/face_rows.h"
#include "io/formats/stl.h"
#include "io/formats/text_rows.h"
#include "support/counted.h"
#include "support/lower_case.h"
#include "transformesh/mesh_io.h"

namespace transformesh {
namespace {

constexpr std::size_t header_text_size = 80;  ///< size of the header in bytes: 80 bytes of text
/// Offset of the first facet in bytes, after the header and the number of facets.
constexpr std::size_t facets_start = 84;
/// Largest number of facets for which vertex indices are valid: each facet gets three new vertices.
constexpr std::size_t most_facets = no_index / 3;
constexpr const char* too_many_facets =
    "more than 1431655765 facets are not supported: split the input into smaller files";

void note_soup(ReadResult& result) {
  const std::size_t faces = result.document.mesh.faces.size();
  if (faces == 0) return;
  result.soup_note = result.notes.size();
  result.notes.push_back("stl: " + counted(faces, "face") +
                         " read as a soup of separate triangles");
}

void note_bad_facets(std::size_t count, std::vector<std::string>& notes) {
  if (count == 0) return;
  notes.push_back("stl: " + counted(count, "facet") +
                  " with a coordinate that is not finite dropped");
}

/// True if a facet with its normal begins at the next word of the line.
bool is_at_facet(TextRows rows) {
  return lower_case(rows.peek()) == "facet" && !rows.word().empty() &&
         lower_case(rows.word()) == "normal" && is_number(rows.peek());
}

class TextReader {
 public:
  explicit TextReader(const Source& source) : source_(source), rows_(source, 0, {}) {}

  ReadResult read() {
    while (next_word(false)) {
      expect("solid");
      read_solid();
    }
    Style& style = result_.document.style;
    style.format = Format::stl_ascii;
    style.is_from_stl = true;
    style.coordinate = Scalar::float32;
    polygons_.move_into(result_.document.mesh, "stl", result_.notes);
    note_bad_facets(bad_facets_, result_.notes);
    note_soup(result_);
    if (has_no_end_)
      result_.notes.emplace_back("stl: 'endsolid' is missing at the end: the file may be cut off");
    if (solids_ > 1) {
      result_.notes.push_back("stl: " + counted(solids_, "solid") + " read as one mesh");
    }
    return std::move(result_);
  }

 private:
  /// Moves to the next word. Line ends count as blanks.
  bool find_word(bool is_needed) {
    while (!rows_.has_more()) {
      if (rows_.next_row()) continue;
      if (is_needed) rows_.fail("the data ends within " + place_name() + ", before 'endsolid'");
      return false;
    }
    return true;
  }

  /// Reads the next word, in lower case.
  bool next_word(bool is_needed) {
    if (!find_word(is_needed)) return false;
    word_ = lower_case(rows_.word());
    return true;
  }

  void expect(std::string_view word) {
    if (word_ == word) return;
    rows_.fail(in_quotes(word) + " is missing in " + place_name() + ", which has " +
               in_quotes(word_));
  }

  void need(std::string_view word) {
    next_word(true);
    expect(word);
  }

  std::string place_name() const {
    return solids_ == 0 ? "the first line" : "facet " + std::to_string(polygons_.rows());
  }

  /// Reads the name of a solid, which ends with the line, or before a facet in the same line.
  std::string_view read_name() {
    const std::string_view first = rows_.peek();
    std::string_view last = first.substr(0, 0);
    while (rows_.has_more() && !is_at_facet(rows_)) last = rows_.word();
    return {first.data(), static_cast<std::size_t>(last.data() + last.size() - first.data())};
  }

  void read_solid() {
    const std::string_view name = read_name();
    ++solids_;
    if (solids_ == 1 && !name.empty()) result_.document.style.comments.emplace_back(name);
    while (next_word(source_.is_strict)) {
      if (word_ == "endsolid") {
        read_name();
        if (!rows_.has_more()) return;
        // The next solid begins in the same line.
        ++solids_;
        next_word(true);
      }
      expect("facet");
      read_facet();
    }
    has_no_end_ = true;
  }

  /// Reads a facet. Its normal in the file is ignored, because files often contain arbitrary
  /// values, and the corners determine the normal.
  void read_facet() {
    need("normal");
    for (int i = 0; i < 3; ++i) next_word(true);
    need("outer");
    need("loop");
    corners_.clear();
    for (next_word(true); word_ != "endloop"; next_word(true)) {
      expect("vertex");
      read_vertex();
    }
    need("endfacet");
    if (!is_finite(corners_)) {
      result_.document.mesh.positions.resize(corners_[0]);
      ++bad_facets_;
      return;
    }
    polygons_.add(corners_);
  }

  bool is_finite(const std::vector<Index>& corners) {
    return std::all_of(corners.begin(), corners.end(), [&](Index corner) {
      return result_.document.mesh.positions[corner].allFinite();
    });
  }

  void read_vertex() {
    std::vector<Vec3>& positions = result_.document.mesh.positions;
    if (positions.size() >= 3 * most_facets) rows_.fail(too_many_facets);
    corners_.push_back(static_cast<Index>(positions.size()));
    Vec3& position = positions.emplace_back();
    for (const Eigen::Index axis : {0, 1, 2}) {
      find_word(true);
      position[axis] = static_cast<double>(
          rows_.number_or_nan<float>([&] { return "a coordinate of " + place_name(); }));
    }
  }

  const Source& source_;
  TextRows rows_;
  std::string word_;
  FaceRows polygons_;
  std::vector<Index> corners_;
  std::size_t solids_ = 0;
  std::size_t bad_facets_ = 0;
  bool has_no_end_ = false;
  ReadResult result_;
};

constexpr bool is_stl_swapped = !host_is_little;

/// Returns the text of the header without padding, or an empty text if it is not ASCII.
std::string header_text(const Source& source) {
  std::string text(source.bytes.substr(0, header_text_size));
  text.resize(std::min(text.find('\0'), text.size()));
  while (!text.empty() && text.back() == ' ') text.pop_back();
  const bool is_text =
      std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
  return is_text ? text : std::string();
}

/// Returns the number of facets in the file. The number stated in the header may be 0 if a program
/// streamed its output.
std::size_t checked_facet_count(const Source& source, std::vector<std::string>& notes) {
  if (source.bytes.size() < facets_start) {
    source.fail("not an STL file: neither the word 'solid' nor a binary header of 84 bytes");
  }
  const auto count =
      std::size_t{load_scalar<std::uint32_t>(source.begin() + header_text_size, is_stl_swapped)};
  const std::size_t present = (source.bytes.size() - facets_start) / stl_facet_size;
  if (count > present) {
    source.fail_at_byte(source.begin() + header_text_size,
                        "the header announces " + counted(count, "facet") + ", but only " +
                            std::to_string(present) + " follow: the file is cut off or not STL");
  }
  if (count == 0 && present > 0) {
    const std::string claim = "the header announces 0 facets, but " + std::to_string(present) +
                              (present == 1 ? " follows" : " follow");
    if (source.is_strict) source.fail_at_byte(source.begin() + header_text_size, claim);
    notes.push_back("stl: " + claim + " and " + (present == 1 ? "is" : "are") + " read");
  }
  const std::size_t read = count == 0 ? present : count;
  if (read > most_facets) source.fail(too_many_facets);
  return read;
}

const char* facet_at(const Source& source, std::size_t row) {
  return source.begin() + facets_start + row * stl_facet_size;
}

/// Appends the corners of a facet to `positions`, and returns true if they are finite. If they are
/// not and reading is strict, throws InputError.
bool read_facet(const Source& source, std::size_t row, std::vector<Vec3>& positions) {
  constexpr std::size_t normal_size = 12;  // three floats
  const char* place = facet_at(source, row) + normal_size;
  bool is_finite = true;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    Vec3& position = positions.emplace_back();
    for (const Eigen::Index axis : {0, 1, 2}) {
      position[axis] = static_cast<double>(load_scalar<float>(place, is_stl_swapped));
      is_finite = is_finite && std::isfinite(position[axis]);
      if (source.is_strict && !is_finite)
        source.fail_at_byte(
            place, "a coordinate of facet " + std::to_string(row) + " is not a finite number");
      place += sizeof(float);
    }
  }
  return is_finite;
}

/// Reads all facets, and returns the indices of facets with finite corners.
std::vector<std::uint32_t> read_facets(const Source& source, std::size_t count, Mesh& mesh) {
  std::vector<std::uint32_t> rows;
  rows.reserve(count);
  mesh.positions.reserve(3 * count);
  mesh.faces.reserve(count);
  for (std::size_t row = 0; row < count; ++row) {
    const auto first = static_cast<Index>(mesh.positions.size());
    if (!read_facet(source, row, mesh.positions)) {
      mesh.positions.resize(first);
      continue;
    }
    mesh.faces.push_back({first, first + 1, first + 2});
    rows.push_back(static_cast<std::uint32_t>(row));
  }
  return rows;
}

void read_attributes(const Source& source, const std::vector<std::uint32_t>& rows, Mesh& mesh) {
  std::vector<double> values;
  values.reserve(rows.size());
  bool is_used = false;
  for (const std::uint32_t row : rows) {
    const char* place = facet_at(source, row) + stl_facet_size - sizeof(std::uint16_t);
    values.push_back(load_scalar<std::uint16_t>(place, is_stl_swapped));
    is_used = is_used || values.back() != 0;
  }
  if (!is_used) return;
  mesh.face_columns.get("attribute", Scalar::uint16, 0).values = std::move(values);
}

}  // namespace

ReadResult read_stl_text(const Source& source) { return TextReader(source).read(); }

ReadResult read_stl_binary(const Source& source) {
  ReadResult result;
  const std::size_t count = checked_facet_count(source, result.notes);
  Mesh& mesh = result.document.mesh;
  const std::vector<std::uint32_t> rows = read_facets(source, count, mesh);
  read_attributes(source, rows, mesh);

  result.document.style.format = Format::stl_binary;
  result.document.style.is_from_stl = true;
  result.document.style.coordinate = Scalar::float32;
  const std::string text = header_text(source);
  if (!text.empty()) result.document.style.comments.push_back(text);
  note_bad_facets(count - rows.size(), result.notes);
  note_soup(result);
  const std::size_t rest = source.bytes.size() - facets_start - count * stl_facet_size;
  if (rest > 0)
    result.notes.push_back("stl: " + counted(rest, "byte") + " after the last facet ignored");
  return result;
}

}  // namespace transformesh
