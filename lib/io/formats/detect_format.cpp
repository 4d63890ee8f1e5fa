#include "io/formats/detect_format.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "io/document/scalar_bytes.h"
#include "io/formats/gltf_file.h"
#include "io/formats/off.h"
#include "io/formats/pcd.h"
#include "io/formats/point_table.h"
#include "io/formats/point_text.h"
#include "io/formats/stl.h"
#include "io/formats/text_rows.h"
#include "io/formats/vtk.h"
#include "io/formats/vtk_xml.h"
#include "io/formats/vtp.h"
#include "io/streams/expand.h"
#include "io/streams/zip_archive.h"
#include "support/lower_case.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

/// Size of the header in bytes: 80 bytes of text and the number of facets.
constexpr std::size_t stl_header_size = 84;

bool has_extension(const Source& source, std::string_view extension) {
  const std::string name = lower_case(without_gz(source.name));
  return name.size() >= extension.size() &&
         std::string_view(name).substr(name.size() - extension.size()) == extension;
}

/// Returns the first word outside of comments, which start with #.
std::string_view first_word(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n\v\f";
  std::size_t first = text.find_first_not_of(blanks);
  while (first != std::string_view::npos && text[first] == '#') {
    first = text.find_first_of("\r\n", first);
    first = text.find_first_not_of(blanks, first);
  }
  if (first == std::string_view::npos) return text.substr(text.size());
  const std::size_t last = text.find_first_of(" \t\r\n\v\f#", first);
  return text.substr(first, last - first);
}

/// True if the first line is `ply`.
bool is_ply_start(std::string_view bytes) {
  if (bytes.substr(0, 3) != "ply") return false;
  const std::size_t next = bytes.find_first_not_of(" \t", 3);
  return next == std::string_view::npos || bytes[next] == '\r' || bytes[next] == '\n';
}

/// True if the file is text STL. Many binary STL files also start with `solid`, but only text files
/// continue with `facet` or `endsolid`. The end of the searched bytes may be within this word.
bool is_ascii_stl(std::string_view bytes) {
  const std::string start = lower_case(bytes.substr(0, 2000));
  if (first_word(start) != "solid" || start.find('\0') != std::string::npos) return false;
  const std::size_t word = start.find("solid");
  const std::size_t line_end = std::min(start.find_first_of("\r\n", word), start.size());
  const std::string_view next = first_word(std::string_view(start).substr(line_end));
  const bool is_cut = next.data() + next.size() == start.data() + start.size();
  const auto continues_with = [&](std::string_view keyword) {
    return next == keyword || (is_cut && keyword.starts_with(next));
  };
  return continues_with("facet") || continues_with("endsolid");
}

bool is_obj_start(std::string_view bytes, std::string_view word) {
  constexpr std::array<std::string_view, 10> keywords{"v", "vn", "vt", "vp",     "f",
                                                      "o", "g",  "s",  "mtllib", "usemtl"};
  const auto end = static_cast<std::size_t>(word.data() + word.size() - bytes.data());
  const bool has_values = end < bytes.size() && (bytes[end] == ' ' || bytes[end] == '\t');
  return has_values && std::find(keywords.begin(), keywords.end(), word) != keywords.end();
}

/// True if one of the first lines is a vertex of OBJ: `v` and three numbers.
bool has_obj_vertex(std::string_view bytes) {
  // Number of bytes that are searched for a vertex; chosen by hand. If comments before the first
  // vertex are longer, the format is not recognized.
  constexpr std::size_t searched = 4096;
  const Source start{bytes.substr(0, searched), ""};
  TextRows rows(start, 0, {'#', true});
  while (rows.next_row()) {
    if (rows.word() != "v" || rows.words_left() < 3) continue;
    const std::string_view word = rows.word();
    const char* first = word.data();
    double value = 0;
    if (parse_number(first, word.data() + word.size(), value) == Parsed::ok) return true;
  }
  return false;
}

/// True if the text is UTF-16: it has a byte order mark, or every second of its first bytes is 0
/// and the others are ASCII.
bool is_utf16(std::string_view bytes) {
  if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff")) return true;
  // Number of tested bytes; in ASCII text as UTF-16, every other byte is zero.
  constexpr std::size_t looked_at = 16;
  if (bytes.size() < looked_at) return false;
  std::array<std::size_t, 2> zeros{}, letters{};
  for (std::size_t i = 0; i < looked_at; ++i) {
    if (bytes[i] == '\0') ++zeros[i % 2];
    if (bytes[i] >= '\t' && bytes[i] <= '~') ++letters[i % 2];
  }
  // Number of tested bytes with even index, and also with odd index.
  constexpr std::size_t half = looked_at / 2;
  return (zeros[0] == half && letters[1] == half) || (zeros[1] == half && letters[0] == half);
}

/// True if the size of the file is exactly that of a binary STL file with its stated number of
/// facets. Files of other formats have this size only by coincidence.
bool is_stl_of_stated_size(std::string_view bytes) {
  if (bytes.size() < stl_header_size) return false;
  const std::uint64_t facets = load_scalar<std::uint32_t>(bytes.data() + 80, !host_is_little);
  return bytes.size() - stl_header_size == stl_facet_size * facets;
}

std::optional<FileKind> kind_of_bytes(std::string_view bytes) {
  const std::string_view word = first_word(bytes);
  if (is_ply_start(bytes)) return FileKind::ply;
  if (is_stl_of_stated_size(bytes)) return FileKind::stl_binary;
  if (bytes.starts_with("glTF") || is_gltf_text(bytes)) return FileKind::gltf;
  if (is_zip(bytes)) return FileKind::three_mf;
  if (is_vtk(bytes)) return FileKind::vtk;
  if (is_vtk_xml(bytes)) return FileKind::vtp;
  if (is_pcd(bytes)) return FileKind::pcd;
  // Text is hardly mistaken for binary STL here: its four characters at the place of the facet
  // count would have to match the file size.
  if (is_binary_stl_by_size(bytes)) return FileKind::stl_binary;
  if (is_off_keyword(word)) return FileKind::off;
  if (is_ascii_stl(bytes)) return FileKind::stl_ascii;
  if (is_obj_start(bytes, word) || has_obj_vertex(bytes)) return FileKind::obj;
  return {};
}

std::optional<FileKind> kind_of_name(const Source& source) {
  if (has_extension(source, ".ply")) return FileKind::ply;
  if (has_extension(source, ".off")) return FileKind::off;
  if (has_extension(source, ".obj")) return FileKind::obj;
  if (has_extension(source, ".stl")) return FileKind::stl_binary;
  return {};
}

}  // namespace

bool is_binary_stl_by_size(std::string_view bytes) {
  if (bytes.size() < stl_header_size) return false;
  const bool swapped = !host_is_little;
  const std::uint64_t facets = load_scalar<std::uint32_t>(bytes.data() + 80, swapped);
  const std::size_t rest = bytes.size() - stl_header_size;
  // Programs that stream their output may leave the number of facets at 0. A text file does not
  // have four zero bytes at this place.
  const bool is_left_open = facets == 0 && rest % stl_facet_size == 0;
  return rest == stl_facet_size * facets || is_left_open;
}

FileKind detect_format(const Source& source) {
  const std::string_view bytes = source.bytes;
  if (bytes.empty()) source.fail("the input is empty: it contains no mesh");
  if (const auto kind = kind_of_bytes(bytes)) return *kind;
  if (is_gzip(bytes)) source.fail("the input is compressed twice by gzip: expand it once");
  if (is_utf16(bytes))
    source.fail("the input is text in UTF-16: convert it with iconv -f UTF-16 -t UTF-8");
  if (is_point_text(source)) return FileKind::points;
  if (is_point_table(source)) return FileKind::point_table;
  if (const auto kind = kind_of_name(source)) return *kind;
  check_point_text(source);
  refuse_unknown_format(source);
}

void refuse_unknown_format(const Source& source) {
  throw InputError(
      ErrorKind::unknown_format,
      "unknown mesh format, starting with " + in_quotes(source.bytes.substr(0, 16)) +
          ": PLY, OFF, OBJ, STL, glTF, 3MF, VTK, VTP, PCD and points as text are read" + " (" +
          source.name + ")",
      {.name = source.name});
}

}  // namespace transformesh
