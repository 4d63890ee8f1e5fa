/// Where the bytes of an output go that is named by a path, and names beside it.
#pragma once

#include <string>

namespace transformesh {

/// Where the path's symbolic links lead, be it to no file yet; at most to the name of an open
/// descriptor such as /dev/stdout or /dev/fd/63. Throws OutputError where they run in a circle.
std::string end_of_links(const std::string& path);

/// The same for all paths that lead to the same file; the path itself where that is not known.
std::string place_of(const std::string& path);

/// Whether both lead to the same file.
bool is_same_place(const std::string& first, const std::string& second);

/// What is not to be replaced: stdout as `-`, devices, FIFOs, and names of open descriptors.
bool is_written_directly(const std::string& path);

/// A descriptor for such a path; one that is open already is duplicated, so that nothing of what it
/// was appended to is lost. Throws OutputError.
int open_directly(const std::string& path);

/// A further name in the same folder: prefix, the path's own name, suffix. A long name is cut, as
/// 255 bytes is what file systems allow, and distinguished from others by a number that is computed
/// from it.
std::string name_beside(const std::string& path, const std::string& prefix,
                        const std::string& suffix);

/// Throws the OutputError that errno means.
[[noreturn]] void throw_not_written(const std::string& path);

}  // namespace transformesh
