/// Contents that tm-view shows: meshes, or a run that may be active, as a page and as a served
/// site.
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

/// Returns the site of a page that does not change.
PageServer::Site site_of(const Page& page, const std::string& viewer);

/// Returns the site of an active run. `page` contains everything except the run.
PageServer::Site live_site(LiveRun& live, const Page& page, const std::string& viewer);

}  // namespace transformesh::tool
