#include "views/cameras/camera_file.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "io/streams/file_list.h"
#include "transformesh/errors.h"
#include "views/cameras/camera_formats.h"

namespace transformesh {
namespace {

constexpr std::string_view known_formats =
    "Middlebury parameters, COLMAP's models, Bundler, OpenCV's YAML and XML, Metashape's XML, "
    "RealityCapture's CSV and XMP and 3x4 matrices are read";

/// Advances to the first row that is not a comment. Returns false if there is none.
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

/// Recognizes a format by words that only one program writes.
std::optional<CameraFormat> format_of_program(std::string_view beginning) {
  const auto has = [&](const char* word) { return beginning.find(word) != std::string_view::npos; };
  if (has("<document") && has("<chunk")) return CameraFormat::metashape;
  const bool is_xmp = has("<x:xmpmeta") && has("xcr:");
  if (is_xmp || beginning.starts_with("#name,") || has("\n#name,"))
    return CameraFormat::reality_capture;
  return {};
}

/// Recognizes a format by its first row, which contains words that are not numbers.
std::optional<CameraFormat> format_of_words(TextRows rows) {
  if (colmap_section(rows) != ColmapSection::none) return CameraFormat::colmap;
  if (rows.peek() == "CONTOUR") return CameraFormat::matrices;
  if (rows.words_left() < 20) return {};
  // Accept Middlebury's parameters without the leading number of cameras as well. The reader then
  // reports the missing number.
  rows.word();
  return are_numbers(rows) ? std::optional(CameraFormat::middlebury) : std::nullopt;
}

void check_names(const CameraList& list) {
  std::set<std::string_view> names;
  for (const CameraRecord& record : list.cameras) {
    if (!names.insert(record.name).second) {
      throw InputError("a second camera is called " + transformesh::quoted(record.name) + " (" +
                       record.place + ")");
    }
  }
}

// Names must not contain line breaks or outer blanks, because every format stores the name in a
// line of its own or in a line with numbers.
void check_written_name(const CameraRecord& record) {
  const std::string& name = record.name;
  const bool is_padded = name.empty() || name.starts_with(' ') || name.ends_with(' ');
  constexpr std::string_view refused("\n\r\t\v\f\0", 6);
  if (!is_padded && name.find_first_of(refused) == std::string::npos) return;
  throw InputError("no camera file can hold the name " + transformesh::quoted(name) + " (" +
                   record.place + "): rename the image, without line breaks and outer blanks");
}

void check_complete(const CameraList& list) {
  for (const CameraRecord& record : list.cameras) {
    check_written_name(record);
    if (!record.is_centered && !record.is_relative) continue;
    throw InputError("the principal point of " + transformesh::quoted(record.name) + " is " +
                     (record.is_centered ? "" : "counted from ") +
                     "the center of an image of unknown size (" + record.place +
                     "): name the images");
  }
}

/// Throws if a lens has distortion and the format cannot store distortion.
void check_undistorted(const CameraList& list, CameraFormat format) {
  if (format != CameraFormat::middlebury && format != CameraFormat::matrices) return;
  for (const CameraRecord& record : list.cameras) {
    if (record.distortion.is_none()) continue;
    throw InputError("the lens of " + transformesh::quoted(record.name) + " has distortion (" +
                     record.place +
                     "), which this format cannot hold: write COLMAP's, or undistort the images "
                     "with colmap image_undistorter");
  }
}

/// Throws if the format is supported only for reading, or needs several files.
void check_is_one_text(const CameraList& list, CameraFormat format) {
  const auto refuse = [](const char* program) {
    throw InputError(std::string(program) + "'s files are read, not written");
  };
  if (format == CameraFormat::bundler) refuse("Bundler");
  if (format == CameraFormat::metashape) refuse("Metashape");
  if (format == CameraFormat::reality_capture) refuse("RealityCapture");
  if (format == CameraFormat::colmap_binary)
    throw InputError("COLMAP's binary model has several files: name a folder for them");
  if (format == CameraFormat::opencv && list.cameras.size() != 1)
    throw InputError("OpenCV's files hold a camera each: name a folder for them");
}

/// Throws if two cameras would be written to one file, or if a file would be hidden.
void check_files(const std::vector<CameraText>& files, const CameraList& list) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string& name = files[i].name;
    const bool is_new = names.insert(name).second;
    if (is_new && !name.starts_with('.')) continue;
    throw InputError("the file of " + transformesh::quoted(list.cameras[i].name) + " (" +
                     list.cameras[i].place + ") would be in " + transformesh::quoted(name) +
                     (is_new ? ", a hidden file" : ", as another one is") + ": rename the image");
  }
}

CameraList parse(const Source& source, CameraFormat format, const std::string& stem) {
  switch (format) {
    case CameraFormat::middlebury:
      return read_middlebury(source);
    case CameraFormat::colmap:
      return read_colmap(source);
    case CameraFormat::bundler:
      return read_bundler(source);
    case CameraFormat::opencv:
      return read_opencv(source, stem);
    case CameraFormat::metashape:
      return read_metashape(source);
    case CameraFormat::reality_capture:
      return read_reality_capture(source, stem);
    case CameraFormat::colmap_binary:
    case CameraFormat::matrices:
      break;
  }
  return read_matrices(source, stem);
}

CameraFormat known_format(const Source& source) {
  if (source.bytes.empty()) source.fail("the input is empty: not a single camera");
  if (const auto format = camera_format(source.bytes)) return *format;
  source.fail("not a camera file, starting with " + quoted(source.bytes.substr(0, 16)) + ": " +
              std::string(known_formats));
}

/// True if the file is one of the two that COLMAP needs together.
bool is_colmap_section(const std::string& path) {
  const std::string name = std::filesystem::path(path).filename().string();
  return name == "cameras.txt" || name == "images.txt" || name == "cameras.bin" ||
         name == "images.bin";
}

bool has_colmap_files(const std::filesystem::path& folder, const std::string& extension) {
  return is_file((folder / ("cameras" + extension)).string()) &&
         is_file((folder / ("images" + extension)).string());
}

/// Returns the extension of the model's files. Prefers text, unless `where` names a binary file.
/// Returns "" if the folder has neither pair of files.
std::string colmap_extension(const std::filesystem::path& folder, const std::string& where) {
  const bool is_binary_named = where.ends_with(".bin");
  if (!is_binary_named && has_colmap_files(folder, ".txt")) return ".txt";
  const bool is_text_named = where.ends_with(".txt");
  return !is_text_named && has_colmap_files(folder, ".bin") ? ".bin" : "";
}

CameraList read_colmap_folder(const std::filesystem::path& folder, const std::string& extension) {
  const std::string cameras = (folder / ("cameras" + extension)).string();
  const std::string images = (folder / ("images" + extension)).string();
  const std::string camera_bytes = file_bytes(cameras);
  const std::string image_bytes = file_bytes(images);
  const Source camera_source{camera_bytes, cameras};
  const Source image_source{image_bytes, images};
  return extension == ".bin" ? read_colmap_binary(camera_source, image_source)
                             : read_colmap(camera_source, image_source);
}

/// Returns the camera files of a folder. Throws if their formats differ.
std::vector<std::string> camera_files_in(const std::string& folder) {
  std::vector<std::string> files;
  std::optional<CameraFormat> format;
  for (const std::string& path : files_at(folder)) {
    const auto found = camera_format(file_bytes(path, 4096));
    if (!found) continue;
    if (format && *format != *found) {
      throw InputError(std::string(folder)
                           .append(": camera files of different formats are in this folder, ")
                           .append(files.back())
                           .append(" and ")
                           .append(path)
                           .append(": name one, or a quoted pattern"));
    }
    format = found;
    files.push_back(path);
  }
  if (files.empty()) {
    throw InputError(folder +
                     ": there is no camera file in this folder: " + std::string(known_formats));
  }
  return files;
}

void append(CameraList& list, CameraList further) {
  list.names_images = list.names_images || further.names_images;
  std::move(further.cameras.begin(), further.cameras.end(), std::back_inserter(list.cameras));
}

CameraList read_file(const std::string& path) {
  const std::string bytes = file_bytes(path);
  const Source source{bytes, path};
  return parse(source, known_format(source), stem_of(path));
}

}  // namespace

std::optional<CameraFormat> camera_format(std::string_view bytes) {
  if (bytes.substr(0, 4096).find('\0') != std::string_view::npos) return {};
  if (bytes.starts_with("%YAML") || bytes.find("<opencv_storage") < 4096)
    return CameraFormat::opencv;
  if (const auto format = format_of_program(bytes.substr(0, 4096))) return format;
  const Source source{bytes, ""};
  TextRows rows(source, 0, {'\0', false});
  const bool has_row = first_row(rows);
  const std::size_t words = has_row ? rows.words_left() : 0;
  const bool has_numbers = has_row && are_numbers(rows);
  // A comment may be the name of a matrix. Hence numbers are examined before comments.
  if (has_numbers && (words == 4 || words == 12)) return CameraFormat::matrices;
  if (bytes.starts_with("# Bundle file")) return CameraFormat::bundler;
  if (has_numbers && words == 1) return CameraFormat::middlebury;
  return has_row && !has_numbers ? format_of_words(rows) : std::nullopt;
}

CameraList parse_cameras(std::string_view bytes, const std::string& name, const std::string& stem) {
  const Source source{bytes, name};
  CameraList list = parse(source, known_format(source), stem.empty() ? stem_of(name) : stem);
  check_names(list);
  return list;
}

CameraList cameras_from(const std::string& where) {
  const std::filesystem::path folder =
      is_folder(where) ? std::filesystem::path(where) : std::filesystem::path(where).parent_path();
  CameraList list;
  const bool may_be_colmap = is_folder(where) || is_colmap_section(where);
  const std::string extension = may_be_colmap ? colmap_extension(folder, where) : std::string();
  if (!extension.empty()) {
    list = read_colmap_folder(folder, extension);
  } else {
    const auto files = is_folder(where) ? camera_files_in(where) : files_at(where);
    for (const std::string& path : files) append(list, read_file(path));
  }
  check_names(list);
  return list;
}

std::string write_cameras(const CameraList& list, CameraFormat format) {
  check_complete(list);
  check_undistorted(list, format);
  check_is_one_text(list, format);
  if (format == CameraFormat::opencv) return write_opencv(list.cameras.front());
  if (format == CameraFormat::middlebury) return write_middlebury(list);
  if (format == CameraFormat::colmap) return write_colmap_cameras(list) + write_colmap_images(list);
  std::string text;
  for (const CameraRecord& record : list.cameras) {
    text += "# " + record.name + '\n' + write_matrix(record);
  }
  return text;
}

std::vector<CameraText> write_camera_files(const CameraList& list, CameraFormat format) {
  check_complete(list);
  check_undistorted(list, format);
  if (format == CameraFormat::colmap) {
    return {{"cameras.txt", write_colmap_cameras(list)},
            {"images.txt", write_colmap_images(list)},
            {"points3D.txt", "# No points\n"}};
  }
  if (format == CameraFormat::colmap_binary) {
    return {{"cameras.bin", binary_colmap_cameras(write_colmap_cameras(list))},
            {"images.bin", binary_colmap_images(write_colmap_images(list))},
            {"points3D.bin", std::string(8, '\0')}};
  }
  const bool is_opencv = format == CameraFormat::opencv;
  if (!is_opencv && format != CameraFormat::matrices)
    return {{"cameras_par.txt", write_cameras(list, format)}};
  std::vector<CameraText> files;
  for (const CameraRecord& record : list.cameras) {
    files.push_back({stem_of(record.name) + (is_opencv ? ".yml" : ".txt"),
                     is_opencv ? write_opencv(record) : write_matrix(record)});
  }
  check_files(files, list);
  return files;
}

}  // namespace transformesh
