/// Shows pages in the user's browser.
#pragma once

#include <string>

namespace transformesh::tool {

/// Writes a page to a new temporary file that only the user can read, and returns its path. The
/// file is not removed, because a browser may read it at any later time. Throws OutputError.
std::string write_temporary_page(const std::string& html);

/// Calls xdg-open for a file or a URL. Throws GoalError if xdg-open is not installed or fails at
/// once.
void open_in_browser(const std::string& what);

}  // namespace transformesh::tool
