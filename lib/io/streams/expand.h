/// Decompresses bytes in memory, within a limit. References: RFC 1950 (zlib), RFC 1952 (gzip).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "io/streams/source.h"

namespace transformesh {

/// Returns the largest number of bytes to which `size` bytes of input may expand, by decompression
/// or because its parts are used repeatedly. The limit protects against decompression bombs.
std::uint64_t expansion_limit(std::size_t size);

/// Limits the memory into which an input expands: decompressed files, and parts that are used
/// repeatedly, such as instances of an object.
class ExpansionBudget {
 public:
  explicit ExpansionBudget(const Source& source)
      : source_(source), left_(expansion_limit(source.bytes.size())) {}

  /// Adds the bytes of one part. Throws InputError if the sum exceeds expansion_limit().
  void spend(std::uint64_t bytes);

 private:
  const Source& source_;
  std::uint64_t left_;
};

/// True if the bytes start with the signature of gzip.
bool is_gzip(std::string_view bytes);

/// Removes `.gz` from a name, so that the rest shows the format.
std::string_view without_gz(std::string_view name);

struct Expanded {
  std::string bytes;
  std::size_t rest = 0;  ///< number of bytes after the end of the compressed data
};

/// Decompresses all members of a gzip file. Zeros after the last member are padding and do not
/// count as `rest`. Throws InputError, with the byte offset, for damaged data and for more bytes
/// than expansion_limit().
Expanded expand_gzip(const Source& source);

/// Decompresses a zlib stream of at most `most` bytes. Throws InputError, with `what` as prefix,
/// for damaged or incomplete data and for more than `most` bytes.
std::string expand_zlib(const Source& source, std::string_view stream, std::size_t most,
                        const std::string& what);

}  // namespace transformesh
