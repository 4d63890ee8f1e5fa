/// What a run may take: --max-memory and --max-time. Both end it with one line and nothing written.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace transformesh::tool {

/// `500M`, `2G`, `1.5GiB` or a number of bytes; K, M, G and T are powers of 1024. Throws
/// UsageError.
std::uint64_t parse_size(const std::string& text);
/// The other way, with three digits: `1.46G`.
std::string size_text(std::uint64_t bytes);

/// What the system can give this process: its memory, or less where a control group says so.
std::uint64_t available_memory();

/// From now on allocations beyond the limit fail with std::bad_alloc, by default those beyond all
/// that is available. Returns what to say then. Where no exception can be thrown, as in GMP, the
/// process ends at once in the same way.
std::string limit_memory(const std::string& program, std::optional<std::uint64_t> limit);

}  // namespace transformesh::tool
