#include <algorithm>
#include <cmath>

#include "tm/io/document/scalar.h"
#include "tm/io/document/scalar_bytes.h"
#include "tm/io/formats/polygons.h"
#include "tm/io/formats/stl.h"
#include "tm/io/formats/text_rows.h"
#include "tm/support/counted.h"

namespace transformesh {
namespace {

constexpr std::size_t header_size = 80;
constexpr std::size_t facets_start = 84;
constexpr std::size_t facet_size = 50;
constexpr std::size_t most_facets = no_index / 3;

void note_soup(std::size_t faces, std::vector<std::string>& notes) {
  if (faces == 0) return;
  notes.push_back("stl: " + counted(faces, "face") +
                  " read as a soup of separate triangles; tm-stitch joins them");
}

class TextReader {
 public:
  explicit TextReader(const Source& source) : rows_(source, 0, {}) {}

  ReadResult read() {
    while (next_word(false)) {
      expect("solid");
      read_solid();
    }
    Style& style = result_.document.style;
    style.format = Format::stl_ascii;
    style.coordinate = Scalar::float32;
    polygons_.move_into(result_.document.mesh, "stl", result_.notes);
    note_soup(result_.document.mesh.faces.size(), result_.notes);
    if (solids_ > 1) {
      result_.notes.push_back("stl: " + counted(solids_, "solid") + " read as one mesh");
    }
    return std::move(result_);
  }

 private:
  /// Moves to the next word, in lower case; line ends mean nothing.
  bool next_word(bool is_needed) {
    while (!rows_.has_more()) {
      if (rows_.next_row()) continue;
      if (is_needed) rows_.fail("the data ends within " + place_name() + ", before 'endsolid'");
      return false;
    }
    word_ = rows_.word();
    std::transform(word_.begin(), word_.end(), word_.begin(), [](char c) {
      return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return true;
  }

  void expect(std::string_view word) {
    if (word_ == word) return;
    rows_.fail(quoted(word) + " is needed in " + place_name() + ", not " + quoted(word_));
  }

  void need(std::string_view word) {
    next_word(true);
    expect(word);
  }

  std::string place_name() const {
    return solids_ == 0 ? "the first line" : "facet " + std::to_string(polygons_.rows());
  }

  void read_solid() {
    const std::string_view name = rows_.skip_row();
    ++solids_;
    if (solids_ == 1 && !name.empty()) result_.document.style.comments.emplace_back(name);
    for (next_word(true); word_ != "endsolid"; next_word(true)) {
      expect("facet");
      read_facet();
    }
    rows_.skip_row();
  }

  /// The normal follows from the corners, and programs write anything there.
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
    polygons_.add(corners_);
  }

  void read_vertex() {
    std::vector<Vec3>& positions = result_.document.mesh.positions;
    if (positions.size() >= 3 * most_facets) rows_.fail("more vertices than 32 bits can count");
    corners_.push_back(static_cast<Index>(positions.size()));
    Vec3& position = positions.emplace_back();
    for (const Eigen::Index axis : {0, 1, 2}) {
      position[axis] = static_cast<double>(
          rows_.finite_number<float>([&] { return "a coordinate of " + place_name(); }));
    }
  }

  TextRows rows_;
  std::string word_;
  PolygonFans polygons_;
  std::vector<Index> corners_;
  std::size_t solids_ = 0;
  ReadResult result_;
};

constexpr bool swapped = !host_is_little;

/// The header without its padding, where it is ASCII text.
std::string header_text(const Source& source) {
  std::string text(source.bytes.substr(0, header_size));
  text.resize(std::min(text.find('\0'), text.size()));
  while (!text.empty() && text.back() == ' ') text.pop_back();
  const bool is_text =
      std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
  return is_text ? text : std::string();
}

std::size_t checked_facet_count(const Source& source) {
  if (source.bytes.size() < facets_start) {
    source.fail("not an STL file: neither the word 'solid' nor a binary header of 84 bytes");
  }
  const auto count = std::size_t{load_scalar<std::uint32_t>(source.begin() + header_size, swapped)};
  const std::size_t present = (source.bytes.size() - facets_start) / facet_size;
  if (count > present) {
    source.fail_at_byte(source.begin() + header_size,
                        "the header announces " + counted(count, "facet") + ", but only " +
                            std::to_string(present) + " follow: the file is cut off or not STL");
  }
  if (count > most_facets) source.fail("more vertices than 32 bits can count");
  return count;
}

void read_facet(const Source& source, std::size_t row, Mesh& mesh) {
  constexpr std::size_t normal_size = 12;
  const char* place = source.begin() + facets_start + row * facet_size + normal_size;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    Vec3& position = mesh.positions[3 * row + corner];
    for (const Eigen::Index axis : {0, 1, 2}) {
      position[axis] = static_cast<double>(load_scalar<float>(place, swapped));
      if (!std::isfinite(position[axis])) {
        source.fail_at_byte(
            place, "a coordinate of facet " + std::to_string(row) + " is not a finite number");
      }
      place += sizeof(float);
    }
    mesh.faces[row][corner] = static_cast<Index>(3 * row + corner);
  }
}

void read_attributes(const Source& source, Mesh& mesh) {
  std::vector<double> values(mesh.faces.size());
  const char* place = source.begin() + facets_start + facet_size - sizeof(std::uint16_t);
  bool is_used = false;
  for (double& value : values) {
    value = load_scalar<std::uint16_t>(place, swapped);
    is_used = is_used || value != 0;
    place += facet_size;
  }
  if (!is_used) return;
  mesh.face_columns.get("attribute", Scalar::uint16, 0).values = std::move(values);
}

}  // namespace

ReadResult read_stl_text(const Source& source) { return TextReader(source).read(); }

ReadResult read_stl_binary(const Source& source) {
  const std::size_t count = checked_facet_count(source);
  ReadResult result;
  Mesh& mesh = result.document.mesh;
  mesh.positions.resize(3 * count);
  mesh.faces.resize(count);
  for (std::size_t row = 0; row < count; ++row) read_facet(source, row, mesh);
  read_attributes(source, mesh);

  result.document.style.format = Format::stl_binary;
  result.document.style.coordinate = Scalar::float32;
  const std::string text = header_text(source);
  if (!text.empty()) result.document.style.comments.push_back(text);
  note_soup(count, result.notes);
  const std::size_t rest = source.bytes.size() - facets_start - count * facet_size;
  if (rest > 0)
    result.notes.push_back("stl: " + counted(rest, "byte") + " after the last facet ignored");
  return result;
}

}  // namespace transformesh
