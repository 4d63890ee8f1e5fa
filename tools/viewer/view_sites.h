/// Provides the contents that tm-view shows: meshes, or a run that may still be active. They are
/// available as a single page, or as a site: a function that answers the browser's requests.
#pragma once

#include <string>
#include <vector>

#include "page/live_run.h"
#include "page/page.h"
#include "transformesh/document.h"
#include "viewer/page_server.h"

namespace transformesh::tool {

/// Returns the meshes as runs: one run for each mesh if `is_beside` is set, otherwise one run with
/// all meshes.
std::vector<PageRun> runs_of(const std::vector<Document>& documents,
                             const std::vector<std::string>& names, bool is_beside);
std::string title_of(const std::vector<std::string>& names);

/// Returns a function that answers requests for a page whose contents do not change.
PageServer::Site site_of(const Page& page, const std::string& viewer);

/// Returns a function that answers requests for a page about an active run; each answer contains
/// the current state of the run. `page` contains everything except the run.
PageServer::Site live_site(LiveRun& live, const Page& page, const std::string& viewer);

}  // namespace transformesh::tool
