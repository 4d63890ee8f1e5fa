/// Limits of a run: --max-memory and --max-time. A run that exceeds a limit ends with a one-line
/// message and writes no output.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace transformesh::tool {

/// Parses a size: `500M`, `2G`, `1.5GiB` or a number of bytes. K, M, G and T are powers of 1024.
/// Throws UsageError.
std::uint64_t parse_size(const std::string& text);
/// Returns a size as text with three digits, such as `1.46G`.
std::string size_text(std::uint64_t bytes);

/// Returns the memory that this process may use: the memory of the machine, or the limit of a
/// control group if it is smaller.
std::uint64_t available_memory();

/// Limits the memory of the process, by default to available_memory(). Allocations beyond the limit
/// throw std::bad_alloc. In code that cannot throw, such as GMP, the process ends at once with the
/// same message. Returns this message.
std::string limit_memory(const std::string& program, std::optional<std::uint64_t> limit);

}  // namespace transformesh::tool
