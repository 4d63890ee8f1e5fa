/// Files that one word names: a file, a folder, or a pattern as shells have it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace transformesh {

/// The files of `where` in natural order. A folder stands for the files in it, without those in
/// its folders and those with a dot in front. A pattern has *, ? or [ and names no file. Throws
/// InputError where there is nothing of the name.
std::vector<std::string> files_at(const std::string& where);
/// The folders of a folder, or whatever a pattern matches, likewise; nothing where there is none.
std::vector<std::string> folders_at(const std::string& where);

bool is_folder(const std::string& path);
bool is_file(const std::string& path);

/// All bytes, or the first `limit`. Throws InputError.
std::string file_bytes(const std::string& path, std::size_t limit = std::string::npos);

/// `dinoR0000` of `data/dinoR0000.png`. What begins with a digit is no extension: view.001.
std::string stem_of(std::string_view path);

/// Compares with runs of digits as numbers: view9 comes before view10.
bool is_natural_less(std::string_view first, std::string_view second);

}  // namespace transformesh
