/// Pages shown by the user's browser.
#pragma once

#include <string>

namespace transformesh::tool {

/// A new file of the user's own in the folder for temporary files, which stays: a browser may read
/// it any time later. Returns its path. Throws OutputError.
std::string write_temporary_page(const std::string& html);

/// Asks xdg-open to open a file or an address. Throws GoalError where it is not installed or fails
/// at once.
void open_in_browser(const std::string& what);

}  // namespace transformesh::tool
