#include "views/cameras/image_files.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "io/streams/file_list.h"
#include "support/counted.h"
#include "transformesh/errors.h"
#include "views/images/image_file.h"

namespace transformesh {
namespace {

namespace fs = std::filesystem;

/// Returns the subfolders of `where` that occur in names of cameras and exist. For example, the
/// name `left/0001` of a camera yields the subfolder `left`.
std::vector<std::string> image_folders(const CameraList& cameras, const std::string& where) {
  std::set<std::string> folders;
  for (const CameraRecord& record : cameras.cameras) {
    const fs::path folder = fs::path(record.name).parent_path().lexically_normal();
    const bool leads_out = folder.is_absolute() || (!folder.empty() && *folder.begin() == "..");
    if (!leads_out) folders.insert((fs::path(where) / folder).string());
  }
  std::erase_if(folders, [](const std::string& folder) { return !is_folder(folder); });
  return {folders.begin(), folders.end()};
}

/// Returns `where` if it is a folder, else the part of the path up to the last slash before the
/// first wildcard.
std::string root_of(const std::string& where) {
  if (is_folder(where)) return where;
  const std::string start = where.substr(0, where.find_first_of("*?["));
  return start.substr(0, start.rfind('/') + 1);
}

/// Removes the elements at `indices`, which must be ascending.
template <class Element>
void erase_indices(const std::vector<std::size_t>& indices, std::vector<Element>& elements) {
  for (auto i = indices.rbegin(); i != indices.rend(); ++i)
    elements.erase(elements.begin() + static_cast<std::ptrdiff_t>(*i));
}

std::string first_of(const NamedFiles& files, const std::vector<std::size_t>& indices) {
  const std::size_t i = indices.front();
  return files.paths[i] + (files.places.empty() ? "" : " (" + files.places[i] + ")");
}

/// Cameras without an image are left out only if at least this many cameras remain. Otherwise the
/// folder of images is probably the wrong one.
constexpr std::size_t least_cameras = 3;

}  // namespace

NamedFiles image_files(const std::string& kind, const std::string& where,
                       const CameraList& cameras) {
  NamedFiles files{kind, where, {}, {}, root_of(where)};
  const bool has_folders =
      is_folder(where) &&
      std::any_of(cameras.cameras.begin(), cameras.cameras.end(), [](const CameraRecord& record) {
        return record.name.find('/') != std::string::npos;
      });
  std::vector<std::string> folders;
  if (has_folders) folders = image_folders(cameras, where);
  if (folders.empty()) folders = {where};
  for (const std::string& folder : folders) {
    const std::vector<std::string> paths = files_at(folder);
    files.paths.insert(files.paths.end(), paths.begin(), paths.end());
  }
  if (!is_folder(where)) return files;
  std::erase_if(files.paths,
                [](const std::string& path) { return !is_image(file_bytes(path, 16)); });
  if (files.paths.empty()) throw InputError(where + ": there is no image in this folder");
  return files;
}

NamedFiles names_of(const CameraList& cameras, const std::string& where) {
  NamedFiles files{"camera", where, {}, {}};
  for (const CameraRecord& record : cameras.cameras) {
    files.paths.push_back(record.name);
    files.places.push_back(record.place);
  }
  return files;
}

PairedFiles pair_files(NamedFiles names, NamedFiles files, bool names_must_agree,
                       const ViewSources& sources) {
  const auto note = [&](const std::string& text) {
    if (sources.on_note) sources.on_note(text);
  };
  PairedFiles pairs;
  for (std::size_t i = 0; i < names.paths.size(); ++i) pairs.kept.push_back(i);
  const Unpaired unpaired = find_unpaired(names, files);
  const bool may_skip = !sources.needs_all_images && unpaired.has_pairs;
  const bool skips_files =
      may_skip && (names_must_agree || names.kind == "image") && unpaired.first.empty();
  const bool skips_names = may_skip && names_must_agree && unpaired.second.empty() &&
                           unpaired.first.size() + least_cameras <= names.paths.size();
  if (skips_files && !unpaired.second.empty()) {
    note(counted(unpaired.second.size(), files.kind) + " in " + files.where + " without " +
         names.kind + " left out, the first is " + first_of(files, unpaired.second));
    erase_indices(unpaired.second, files.paths);
  }
  if (skips_names && !unpaired.first.empty()) {
    note(counted(unpaired.first.size(), names.kind) + " without " + files.kind + " in " +
         files.where + " left out, the first is " + first_of(names, unpaired.first));
    erase_indices(unpaired.first, pairs.kept);
    erase_indices(unpaired.first, names.paths);
    if (!names.places.empty()) erase_indices(unpaired.first, names.places);
  }
  for (const std::size_t i : pair_by_name(names, files, names_must_agree))
    pairs.paths.push_back(files.paths[i]);
  return pairs;
}

}  // namespace transformesh
