/// Resolves the path of an output, and makes temporary names beside it.
#pragma once

#include <string>

namespace transformesh {

/// Resolves the symbolic links of a path, even if the final file does not exist. Stops at names of
/// open descriptors such as /dev/stdout or /dev/fd/63. Throws OutputError for a cycle of links.
std::string end_of_links(const std::string& path);

/// Returns a name that is the same for all paths to one file. Returns the path itself if such a
/// name is unknown.
std::string place_of(const std::string& path);

/// True if both paths lead to the same file.
bool is_same_place(const std::string& first, const std::string& second);

/// True for targets that must not be replaced: stdout as `-`, devices, FIFOs, and names of open
/// descriptors.
bool is_written_directly(const std::string& path);

/// Opens a path that is written directly. A descriptor that is already open is duplicated, so that
/// earlier output is not truncated. Throws OutputError.
int open_directly(const std::string& path);

/// Returns a name in the same folder: prefix, the path's file name, suffix. A name that exceeds 255
/// bytes, the limit of file systems, is cut and made unique by a hash.
std::string name_beside(const std::string& path, const std::string& prefix,
                        const std::string& suffix);

/// Throws an OutputError whose reason is errno.
[[noreturn]] void throw_not_written(const std::string& path);

}  // namespace transformesh
