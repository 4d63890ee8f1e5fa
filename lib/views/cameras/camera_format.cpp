#include "views/cameras/camera_format.h"

#include "io/streams/zip_archive.h"
#include "views/cameras/camera_formats.h"

namespace transformesh {
namespace {

/// Number of bytes at the beginning of a file in which format_of_json() and format_of_program()
/// search for words that are typical of a format.
constexpr std::size_t searched = 4096;

/// Advances to the first row that does not begin with `#`. Returns false if there is none.
bool first_row(TextRows& rows) {
  while (rows.next_row()) {
    if (!rows.peek().starts_with('#')) return true;
  }
  return false;
}

bool are_numbers(TextRows rows) {
  while (rows.has_more()) {
    if (!is_number(rows.word())) return false;
  }
  return true;
}

std::optional<CameraFormat> format_of_signature(std::string_view bytes) {
  if (bytes.starts_with(npy_signature)) return CameraFormat::llff;
  if (is_zip(bytes)) return CameraFormat::neus;
  if (bytes.starts_with("MVSI")) return CameraFormat::openmvs;
  if (bytes.starts_with("NVM_V3")) return CameraFormat::nvm;
  return {};
}

/// Recognizes the format of a JSON file by keys. Each key is written by only one program.
std::optional<CameraFormat> format_of_json(std::string_view beginning) {
  const auto has = [&](const char* key) { return beginning.find(key) != std::string_view::npos; };
  const std::size_t first = beginning.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || beginning[first] != '{') return {};
  if (has("\"sfm_data_version\"")) return CameraFormat::openmvg;
  for (const char* key : {"\"frames\"", "\"camera_angle_x\"", "\"transform_matrix\"", "\"fl_x\""})
    if (has(key)) return CameraFormat::transforms;
  // Project files of Meshroom contain views, but no poses.
  const bool is_meshroom = has("\"viewId\"") || has("\"featuresFolders\"");
  if (is_meshroom && !has("\"nodeType\"")) return CameraFormat::meshroom;
  return {};
}

/// Recognizes the format of a text file by words. Each word is written by only one program.
std::optional<CameraFormat> format_of_program(std::string_view beginning) {
  const auto has = [&](const char* word) { return beginning.find(word) != std::string_view::npos; };
  if (beginning.starts_with("%YAML") || has("<opencv_storage")) return CameraFormat::opencv;
  if (has("<document") && has("<chunk")) return CameraFormat::metashape;
  const bool is_xmp = has("<x:xmpmeta") && has("xcr:");
  if (is_xmp || beginning.starts_with("#name,") || has("\n#name,"))
    return CameraFormat::reality_capture;
  if (has("[camera]") && has("focal_length")) return CameraFormat::mve;
  return format_of_json(beginning);
}

/// Recognizes a format by the current row, which is the first row that is not a comment. At least
/// one word of the row is not a number.
std::optional<CameraFormat> format_of_words(TextRows rows) {
  if (colmap_section(rows) != ColmapSection::none) return CameraFormat::colmap;
  if (rows.peek() == "CONTOUR") return CameraFormat::matrices;
  if (rows.peek() == "extrinsic" && rows.words_left() == 1) return CameraFormat::mvsnet;
  if (rows.words_left() < 20) return {};
  // Also recognize Middlebury's files if the first line, the number of cameras, is missing. The
  // reader then reports the missing number.
  rows.word();
  return are_numbers(rows) ? std::optional(CameraFormat::middlebury) : std::nullopt;
}

}  // namespace

std::optional<CameraFormat> camera_format(std::string_view bytes) {
  if (const auto format = format_of_signature(bytes)) return format;
  const std::string_view beginning = bytes.substr(0, searched);
  if (beginning.find('\0') != std::string_view::npos) return {};
  if (const auto format = format_of_program(beginning)) return format;
  const Source source{bytes, ""};
  TextRows rows(source, 0, {'\0', false});
  const bool has_row = first_row(rows);
  const std::size_t words = has_row ? rows.words_left() : 0;
  const bool has_numbers = has_row && are_numbers(rows);
  // In a file of matrices, a comment may contain any text, even "# Bundle file", because comments
  // are names of matrices. Hence this test precedes the test for Bundler's format.
  if (has_numbers && (words == 4 || words == 12)) return CameraFormat::matrices;
  if (bytes.starts_with("# Bundle file")) return CameraFormat::bundler;
  if (has_numbers && words == 1) return CameraFormat::middlebury;
  return has_row && !has_numbers ? format_of_words(rows) : std::nullopt;
}

}  // namespace transformesh
