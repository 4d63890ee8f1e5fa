#include "io/formats/gltf_file.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "io/document/scalar_bytes.h"
#include "io/streams/expand.h"
#include "io/streams/streams.h"
#include "support/base64.h"
#include "support/counted.h"

namespace transformesh {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t chunk_header_size = 8;  ///< size of a chunk header in bytes, by the standard
constexpr std::string_view json_chunk = "JSON";
constexpr std::string_view binary_chunk("BIN\0", 4);

/// True for extensions that do not affect the shape, such as lights and textures.
bool is_about_looks(std::string_view extension) {
  for (const std::string_view start : {"KHR_materials_", "KHR_texture_", "KHR_lights_",
                                       "EXT_texture_", "KHR_xmp", "MSFT_texture_"})
    if (extension.starts_with(start)) return true;
  return extension == "KHR_mesh_quantization" || extension == "EXT_mesh_manifold";
}

std::string compression_name(std::string_view extension) {
  if (extension == "KHR_draco_mesh_compression") return "Draco";
  if (extension.ends_with("meshopt_compression")) return "meshopt";
  return {};
}

/// Decodes percent escapes such as %20.
std::string without_escapes(std::string_view uri) {
  const auto digit = [](char c) {
    constexpr std::string_view digits = "0123456789abcdef0123456789ABCDEF";
    const std::size_t at = digits.find(c);
    return at == std::string_view::npos ? -1 : static_cast<int>(at % 16);
  };
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool is_escape =
        uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0;
    text += is_escape ? static_cast<char>(16 * digit(uri[i + 1]) + digit(uri[i + 2])) : uri[i];
    if (is_escape) i += 2;
  }
  return text;
}

}  // namespace

bool is_gltf_text(std::string_view bytes) {
  // Number of bytes in which `asset` is searched. Writers put it first or after a few nodes.
  constexpr std::size_t searched = 1U << 16U;
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || bytes[first] != '{') return false;
  const std::string_view start = bytes.substr(0, searched);
  const bool is_small = bytes.size() <= searched;
  return start.find("\"asset\"") != std::string_view::npos ||
         (!is_small && start.find("\"bufferView\"") != std::string_view::npos);
}

GltfFile::GltfFile(const Source& source, std::string folder)
    : source_(source), folder_(std::move(folder)) {
  if (source_.bytes.starts_with("glTF")) {
    read_container();
  } else {
    parse(source_.bytes);
  }
  check_version();
  check_extensions();
  read_buffers();
}

void GltfFile::read_container() {
  const std::string_view bytes = source_.bytes;
  const auto number = [&](std::size_t at) -> std::size_t {
    if (at + sizeof(std::uint32_t) > bytes.size())
      source_.fail_at_byte(bytes.data() + bytes.size(), "the GLB file is cut off in a header");
    return load_scalar<std::uint32_t>(bytes.data() + at, !host_is_little);
  };
  if (const std::size_t version = number(4); version != 2)
    source_.fail("GLB of version " + std::to_string(version) + " is not supported, only version 2");
  const std::size_t end = number(8);
  if (end > bytes.size())
    source_.fail("the GLB header announces " + counted(end, "byte") + ", but there are " +
                 std::to_string(bytes.size()) + ": the file is cut off");
  rest_ = bytes.size() - end;
  bool has_json = false;
  constexpr std::size_t header_size = 12;  // size of the GLB header in bytes, by the standard
  for (std::size_t at = header_size; at < end;) {
    const std::size_t size = number(at);
    number(at + 4);
    if (size > end - std::min(end, at + chunk_header_size))
      source_.fail_at_byte(bytes.data() + at, "a GLB chunk extends beyond the end of the file");
    const std::string_view kind = bytes.substr(at + 4, 4);
    const std::string_view content = bytes.substr(at + chunk_header_size, size);
    if (kind == json_chunk && !has_json) has_json = true, parse(content);
    if (kind == binary_chunk && !has_binary_) has_binary_ = true, binary_ = content;
    at += chunk_header_size + size;
  }
  if (!has_json) source_.fail("the GLB file has no JSON chunk");
}

void GltfFile::parse(std::string_view text) {
  try {
    json_ = GltfJson::parse(text);
  } catch (const GltfJson::parse_error& error) {
    const std::size_t at = std::min(error.byte, text.size());
    source_.fail_at_byte(text.data() + (at > 0 ? at - 1 : 0), "the glTF JSON is malformed");
  }
  if (!json_.is_object()) fail("the JSON is not an object");
}

void GltfFile::check_version() const {
  const auto asset = json_.find("asset");
  const bool has_version = asset != json_.end() && asset->is_object() &&
                           asset->contains("version") && (*asset)["version"].is_string();
  if (!has_version) fail("the JSON has no asset with a version");
  const std::string version = (*asset)["version"];
  if (!version.starts_with("2."))
    fail("version " + in_quotes(version) + " is not supported, only 2");
}

/// Throws InputError if the file requires an extension that is not supported. Extensions that are
/// used, but not required, have a fallback.
void GltfFile::check_extensions() const {
  const auto list = json_.find("extensionsRequired");
  if (list == json_.end() || !list->is_array()) return;
  for (const GltfJson& entry : *list) {
    const std::string name = entry.is_string() ? entry.get<std::string>() : "";
    if (is_about_looks(name)) continue;
    const std::string compression = compression_name(name);
    if (!compression.empty())
      fail("meshes are compressed by " + compression + " (" + name +
           "), which is not supported: write the file without compression");
    fail("the file requires the extension " + in_quotes(name) + ", which is not supported");
  }
}

// --- Elements ------------------------------------------------------------------------------------

std::size_t GltfFile::count(const char* array) const {
  const auto found = json_.find(array);
  return found != json_.end() && found->is_array() ? found->size() : 0;
}

const GltfJson& GltfFile::element(const char* array, std::size_t index) const {
  if (index >= count(array))
    fail("element " + std::to_string(index) + " of " + array + " is used, but " +
         there_are(count(array), "element"));
  const GltfJson& found = json_.find(array)->at(index);
  if (!found.is_object())
    fail("element " + std::to_string(index) + " of " + array + " is not an object");
  return found;
}

std::size_t GltfFile::whole(const GltfJson& object, const std::string& key, const std::string& what,
                            std::optional<std::size_t> fallback) const {
  const auto found = object.find(key);
  if (found == object.end()) {
    if (fallback) return *fallback;
    fail(what + " has no " + in_quotes(key));
  }
  if (!found->is_number_unsigned())
    fail(in_quotes(key) + " of " + what + " is not a whole number of 0 or more");
  return found->get<std::size_t>();
}

// --- Buffers -------------------------------------------------------------------------------------

void GltfFile::read_buffers() {
  buffers_.resize(count("buffers"));
  for (std::size_t i = 0; i < buffers_.size(); ++i) {
    const GltfJson& entry = element("buffers", i);
    const auto uri = entry.find("uri");
    if (uri == entry.end()) continue;
    if (!uri->is_string()) fail("uri of buffer " + std::to_string(i) + " is not a string");
    buffers_[i] = read_uri(i, uri->get<std::string>());
  }
}

std::string GltfFile::read_uri(std::size_t index, const std::string& uri) const {
  if (!uri.starts_with("data:")) return read_beside(without_escapes(uri));
  constexpr std::string_view mark = ";base64,";
  const std::size_t at = uri.find(mark);
  const auto bytes = at == std::string::npos
                         ? std::nullopt
                         : bytes_of_base64(std::string_view(uri).substr(at + mark.size()));
  if (!bytes) fail("the data of buffer " + std::to_string(index) + " is not base64");
  return *bytes;
}

/// Reads a file in the folder of the glTF file. Rejects names that lead out of the folder, directly
/// or by a symbolic link. Also rejects devices, whose data may be endless.
std::string GltfFile::read_beside(const std::string& name) const {
  const fs::path path(name);
  const bool leaves = path.is_absolute() || name.find("://") != std::string::npos ||
                      std::find(path.begin(), path.end(), "..") != path.end() ||
                      name.find('\0') != std::string::npos;
  if (leaves) fail("the buffer " + in_quotes(name) + " is not in the folder of the file");
  if (folder_.empty())
    fail("the buffer " + in_quotes(name) +
         " is in another file, which can be read only if the input is given by its file name");
  std::error_code error;
  const fs::path folder = fs::canonical(folder_, error);
  const fs::path place = fs::canonical(folder / path, error);
  if (error || !fs::is_regular_file(place, error))
    fail("the buffer " + in_quotes(name) + " is missing beside the file");
  const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), place.begin(), place.end());
  if (end != folder.end())
    fail("the buffer " + in_quotes(name) + " is not in the folder of the file");
  return std::string(read_all(place.string()).view());
}

std::string_view GltfFile::buffer(std::size_t index) const {
  const GltfJson& entry = element("buffers", index);
  const std::string what = "buffer " + std::to_string(index);
  const bool is_binary_chunk = !entry.contains("uri");
  if (is_binary_chunk && (index != 0 || !has_binary_)) fail(what + " has no data");
  const std::string_view bytes = is_binary_chunk ? binary_ : buffers_[index];
  const std::size_t size = whole(entry, "byteLength", what);
  if (size > bytes.size())
    fail(what + " announces " + counted(size, "byte") + ", but there are " +
         std::to_string(bytes.size()));
  return bytes.substr(0, size);
}

std::string_view GltfFile::view(std::size_t index) const {
  const GltfJson& entry = element("bufferViews", index);
  const std::string what = "bufferView " + std::to_string(index);
  const std::string_view bytes = buffer(whole(entry, "buffer", what));
  const std::size_t start = whole(entry, "byteOffset", what, 0);
  const std::size_t size = whole(entry, "byteLength", what);
  if (start > bytes.size() || size > bytes.size() - start)
    fail(what + " reaches beyond its buffer of " + counted(bytes.size(), "byte"));
  return bytes.substr(start, size);
}

}  // namespace transformesh
