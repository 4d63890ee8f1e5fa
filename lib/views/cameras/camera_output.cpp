#include "views/cameras/camera_output.h"

#include <algorithm>
#include <array>
#include <set>

#include "io/streams/file_list.h"
#include "transformesh/errors.h"
#include "views/cameras/camera_formats.h"
#include "views/cameras/camera_readers.h"

namespace transformesh {
namespace {

// Names must not contain line breaks or outer blanks, because every format stores the name in a
// line of its own or in a line with numbers.
void check_written_name(const CameraRecord& record) {
  const std::string& name = record.name;
  const bool is_padded = name.empty() || name.starts_with(' ') || name.ends_with(' ');
  constexpr std::string_view refused("\n\r\t\v\f\0", 6);
  if (!is_padded && name.find_first_of(refused) == std::string::npos) return;
  throw InputError(
      "no camera file can hold the name " + in_quotes(name) + " (" + record.place +
      "): rename the image so that its name has no line breaks and no leading or trailing blanks");
}

void check_complete(const CameraList& list) {
  for (const CameraRecord& record : list.cameras) {
    check_written_name(record);
    if (!record.is_centered && record.unit == IntrinsicsUnit::pixel) continue;
    throw InputError("the principal point of " + in_quotes(record.name) +
                     " depends on the size of its image, which is unknown (" + record.place +
                     "): name the images");
  }
}

/// Throws InputError if a lens has distortion and the format cannot store distortion.
void check_undistorted(const CameraList& list, CameraFormat format) {
  const bool is_pinhole = format == CameraFormat::middlebury || format == CameraFormat::matrices ||
                          format == CameraFormat::openmvs;
  if (!is_pinhole) return;
  for (const CameraRecord& record : list.cameras) {
    if (record.distortion.is_none()) continue;
    throw InputError(
        "the lens of " + in_quotes(record.name) + " has distortion (" + record.place +
        "), which this format cannot hold: write a COLMAP model, or undistort the images "
        "with colmap image_undistorter");
  }
}

/// A camera format that can be written as one text. `name` is the file name that is used if an
/// output folder is given. It is empty if the format then has several files.
struct TextFormat {
  CameraFormat format;
  const char* name;
  std::string (*write)(const CameraList& list);
};

std::string write_colmap(const CameraList& list) {
  return write_colmap_cameras(list) + write_colmap_images(list);
}

std::string write_matrices(const CameraList& list) {
  std::string text;
  for (const CameraRecord& record : list.cameras)
    text += "# " + record.name + '\n' + write_matrix(record);
  return text;
}

std::string write_only_opencv(const CameraList& list) {
  if (list.cameras.size() != 1)
    throw InputError("OpenCV writes one file per camera: name a folder for them");
  return write_opencv(list.cameras.front());
}

/// All formats that can be written as one text. If an output folder is given, formats with an empty
/// name are written as several files.
constexpr std::array text_formats{
    TextFormat{CameraFormat::middlebury, "cameras_par.txt", write_middlebury},
    TextFormat{CameraFormat::transforms, "transforms.json", write_transforms},
    TextFormat{CameraFormat::meshroom, "cameras.sfm", write_meshroom},
    TextFormat{CameraFormat::openmvs, "scene.mvs", write_openmvs},
    TextFormat{CameraFormat::colmap, "", write_colmap},
    TextFormat{CameraFormat::matrices, "", write_matrices},
    TextFormat{CameraFormat::opencv, "", write_only_opencv}};

/// Returns the row of a format in `text_formats`. Throws InputError if the format is only read, or
/// needs several files.
const TextFormat& text_format(CameraFormat format) {
  if (format == CameraFormat::colmap_binary)
    throw InputError("COLMAP's binary model has several files: name a folder for them");
  const auto* const found =
      std::find_if(text_formats.begin(), text_formats.end(),
                   [&](const TextFormat& row) { return row.format == format; });
  if (found == text_formats.end())
    throw InputError(std::string(reader_of(format).program) +
                     " files can be read, but not written");
  return *found;
}

/// Throws InputError if two cameras would be written to one file, or if the name of a file begins
/// with a dot.
void check_files(const std::vector<CameraText>& files, const CameraList& list) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string& name = files[i].name;
    const bool is_new = names.insert(name).second;
    if (is_new && !name.starts_with('.')) continue;
    throw InputError("the file of " + in_quotes(list.cameras[i].name) + " (" +
                     list.cameras[i].place + ") would be in " + in_quotes(name) +
                     (is_new ? ", a hidden file" : ", which another camera uses") +
                     ": rename the image");
  }
}

}  // namespace

std::string write_cameras(const CameraList& list, CameraFormat format) {
  check_complete(list);
  check_undistorted(list, format);
  return text_format(format).write(list);
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
  const TextFormat& single = text_format(format);
  if (*single.name != '\0') return {{single.name, single.write(list)}};
  const bool is_opencv = format == CameraFormat::opencv;
  std::vector<CameraText> files;
  for (const CameraRecord& record : list.cameras) {
    files.push_back({stem_of(record.name) + (is_opencv ? ".yml" : ".txt"),
                     is_opencv ? write_opencv(record) : write_matrix(record)});
  }
  check_files(files, list);
  return files;
}

}  // namespace transformesh
