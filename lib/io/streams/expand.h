/// Expands compressed bytes in memory, within a limit. References: RFC 1950 (zlib), RFC 1952
/// (gzip).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "io/streams/source.h"

namespace transformesh {

/// Returns how many bytes `size` bytes of input may become by expansion, or by repeated parts. An
/// input of a few kilobytes that exceeds the limit is made to fill the memory.
std::uint64_t expansion_limit(std::size_t size);

/// Refuses inputs whose repeated parts become more than expansion_limit() bytes.
class ExpansionBudget {
 public:
  explicit ExpansionBudget(const Source& source)
      : source_(source), left_(expansion_limit(source.bytes.size())) {}

  /// Throws InputError beyond the limit.
  void spend(std::uint64_t bytes);

 private:
  const Source& source_;
  std::uint64_t left_;
};

/// True if the bytes start as a gzip file does.
bool is_gzip(std::string_view bytes);

/// The ending of a name without `.gz`, which says how the bytes are stored and not in what format.
std::string_view without_gz(std::string_view name);

struct Expanded {
  std::string bytes;
  std::size_t rest = 0;  ///< bytes behind the end of the compressed data
};

/// Expands all members of a gzip file. Zeros behind the last member are padding and do not count as
/// rest. Throws InputError with the byte offset for damage, and beyond expansion_limit().
Expanded expand_gzip(const Source& source);

/// Expands a zlib stream that becomes at most `most` bytes. Throws InputError with `what` in front
/// for damage, for a missing end, and for more bytes.
std::string expand_zlib(const Source& source, std::string_view stream, std::size_t most,
                        const std::string& what);

}  // namespace transformesh
