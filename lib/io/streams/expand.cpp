#include "io/streams/expand.h"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <new>

namespace transformesh {
namespace {

/// log2 of zlib's largest window in bytes, plus 16, which makes zlib expect a gzip header.
constexpr int gzip_window = 15 + 16;
constexpr int zlib_window = 15;  ///< log2 of zlib's largest window in bytes

/// A zlib decompressor of bytes in memory, which appends to a string.
class Inflater {
 public:
  Inflater(std::string_view from, int window) : from_(from) {
    if (inflateInit2(&stream_, window) != Z_OK) throw std::bad_alloc();
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  void restart() { inflateReset(&stream_); }
  std::size_t used() const { return used_; }
  bool has_more() const { return used_ < from_.size(); }

  /// Runs to the end of the stream, or until `to` exceeds `most` bytes. Returns zlib's code:
  /// Z_STREAM_END at the end, Z_OK beyond the limit, Z_BUF_ERROR if the input is incomplete.
  int run(std::string& to, std::uint64_t most) {
    int code = Z_OK;
    std::size_t size = to.size();
    while (code == Z_OK && size <= most) {
      if (size == to.size())
        to.resize(std::min<std::uint64_t>(std::max(least_room, 2 * size), most + 1));
      code = step(to, size);
    }
    to.resize(size);
    return code;
  }

 private:
  static constexpr std::size_t least_room = 1U << 16U;  // a smaller buffer needs more calls of zlib

  int step(std::string& to, std::size_t& size) {
    constexpr std::size_t most_at_once = std::numeric_limits<uInt>::max();
    const auto given = static_cast<uInt>(std::min(from_.size() - used_, most_at_once));
    const auto room = static_cast<uInt>(std::min(to.size() - size, most_at_once));
    // The cast is safe: zlib only reads through this pointer.
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(from_.data() + used_));
    stream_.avail_in = given;
    stream_.next_out = reinterpret_cast<Bytef*>(to.data() + size);
    stream_.avail_out = room;
    const int code = inflate(&stream_, Z_NO_FLUSH);
    used_ += given - stream_.avail_in;
    size += room - stream_.avail_out;
    return code;
  }

  std::string_view from_;
  std::size_t used_ = 0;
  z_stream stream_{};
};

[[noreturn]] void fail_expansion(const Source& source, std::uint64_t most) {
  source.fail("the compressed data expands to more than " + std::to_string(most >> 20U) +
              " MB, more than any mesh in a file of this size");
}

std::size_t without_padding(std::string_view rest) { return rest.find_last_not_of('\0') + 1; }

}  // namespace

std::uint64_t expansion_limit(std::size_t size) {
  // Largest allowed ratio of expanded to compressed bytes. Text meshes usually compress to a third,
  // rarely to a fiftieth. With a smaller ratio, regular grids would be rejected. Without a limit, a
  // file could grow by a factor of 1000, the maximum of Deflate.
  constexpr std::uint64_t ratio = 200;
  // Small files may compress better, so this number of bytes (64 MB) is always allowed.
  constexpr std::uint64_t always_allowed = std::uint64_t{1} << 26U;
  return std::max(always_allowed, ratio * size);
}

void ExpansionBudget::spend(std::uint64_t bytes) {
  if (bytes > left_)
    source_.fail("repeated parts expand to more than " +
                 std::to_string(expansion_limit(source_.bytes.size()) >> 20U) +
                 " MB, more than any mesh in a file of this size");
  left_ -= bytes;
}

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

std::string_view without_gz(std::string_view name) {
  for (const std::string_view ending : {".gz", ".GZ"})
    if (name.ends_with(ending)) return name.substr(0, name.size() - ending.size());
  return name;
}

Expanded expand_gzip(const Source& source) {
  const std::uint64_t most = expansion_limit(source.bytes.size());
  Inflater inflater(source.bytes, gzip_window);
  Expanded result;
  do {
    const int code = inflater.run(result.bytes, most);
    const char* place = source.begin() + inflater.used();
    if (code == Z_BUF_ERROR) source.fail_at_byte(place, "the compressed data is cut off");
    if (result.bytes.size() > most) fail_expansion(source, most);
    if (code == Z_MEM_ERROR) throw std::bad_alloc();
    if (code != Z_STREAM_END) source.fail_at_byte(place, "the compressed data is damaged");
    inflater.restart();
  } while (is_gzip(source.bytes.substr(inflater.used())));
  result.rest = without_padding(source.bytes.substr(inflater.used()));
  return result;
}

std::string expand_zlib(const Source& source, std::string_view stream, std::size_t most,
                        const std::string& what) {
  Inflater inflater(stream, zlib_window);
  std::string bytes;
  const int code = inflater.run(bytes, most);
  if (code == Z_MEM_ERROR) throw std::bad_alloc();
  if (code == Z_BUF_ERROR) source.fail(what + ": the compressed data is cut off");
  if (bytes.size() > most)
    source.fail(what + ": the compressed data expands to more than " + std::to_string(most) +
                " bytes");
  if (code != Z_STREAM_END) source.fail(what + ": the compressed data is damaged");
  return bytes;
}

}  // namespace transformesh
