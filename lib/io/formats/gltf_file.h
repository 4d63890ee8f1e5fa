/// A glTF 2.0 file (ISO/IEC 12113:2022), binary (GLB) or text: its JSON and its buffers. Every
/// number in the file is checked.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/streams/source.h"

namespace transformesh {

/// JSON of a glTF file.
using GltfJson = nlohmann::json;

class GltfFile {
 public:
  /// Reads the container and the buffers. External files are read from `folder` and its subfolders;
  /// if `folder` is empty, they are rejected. Throws InputError.
  GltfFile(const Source& source, std::string folder);

  const Source& source() const { return source_; }
  const GltfJson& json() const { return json_; }
  /// Returns the number of bytes that follow the end of the file as stated in the GLB header.
  std::size_t rest() const { return rest_; }

  /// Returns the number of elements of a top-level JSON array such as "nodes" or "meshes".
  std::size_t count(const char* array) const;
  /// Returns an element of a top-level JSON array such as "nodes". Throws InputError if the element
  /// is missing or is not an object.
  const GltfJson& element(const char* array, std::size_t index) const;
  /// Returns the member `key` of an object as a nonnegative integer, or `fallback` if the member is
  /// missing. Throws InputError if the member is something else, or if it is missing and there is
  /// no fallback. `what` is the name of the object in messages.
  std::size_t whole(const GltfJson& object, const std::string& key, const std::string& what,
                    std::optional<std::size_t> fallback = {}) const;
  /// Returns the bytes of a buffer view. Throws InputError if the view exceeds its buffer.
  std::string_view view(std::size_t index) const;

  [[noreturn]] void fail(const std::string& what) const { source_.fail("glTF: " + what); }

 private:
  void read_container();
  void parse(std::string_view text);
  void check_version() const;
  void check_extensions() const;
  std::string_view buffer(std::size_t index) const;
  void read_buffers();
  std::string read_uri(std::size_t index, const std::string& uri) const;
  std::string read_beside(const std::string& name) const;

  Source source_;
  std::string folder_;
  GltfJson json_;
  std::string_view binary_;  ///< bytes of the binary chunk of GLB
  bool has_binary_ = false;
  std::vector<std::string> buffers_;  ///< bytes of the buffers other than the binary chunk
  std::size_t rest_ = 0;
};

/// True if the bytes start like JSON of glTF: the first 64 KB contain the key `asset`, or also
/// `bufferView` if the file is larger.
bool is_gltf_text(std::string_view bytes);

}  // namespace transformesh
