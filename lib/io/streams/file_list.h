/// Resolves an argument that is a file, a folder, or a shell pattern.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace transformesh {

/// Returns the files at `where` in natural order. A folder yields its files, except hidden files
/// and files in subfolders. An argument that is neither file nor folder and contains *, ? or [ is a
/// pattern. Throws InputError if there is no file.
std::vector<std::string> files_at(const std::string& where);
/// Returns the subfolders of a folder, or everything that matches a pattern, in natural order.
/// Returns nothing if there is no match.
std::vector<std::string> folders_at(const std::string& where);

bool is_folder(const std::string& path);
bool is_file(const std::string& path);

/// Returns the first `limit` bytes of a file, at most. Throws InputError if the file cannot be
/// read.
std::string file_bytes(const std::string& path, std::size_t limit = std::string::npos);

/// Returns the file name without folder and extension: `dinoR0000` for `data/dinoR0000.png`. A
/// suffix that begins with a digit is not an extension: `view.001` stays.
std::string stem_of(std::string_view path);

/// Natural order: compares runs of digits as numbers, so that view9 comes before view10.
bool is_natural_less(std::string_view first, std::string_view second);

}  // namespace transformesh
