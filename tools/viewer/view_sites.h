/// What tm-view shows: meshes, or a run that may go on, as a page and as a site that is served.
#pragma once

#include <string>
#include <vector>

#include "page/live_run.h"
#include "page/page.h"
#include "transformesh/document.h"
#include "viewer/page_server.h"

namespace transformesh::tool {

/// The meshes that these names stand for: each a run of its own, or all one after the other.
std::vector<PageRun> runs_of(const std::vector<Document>& documents,
                             const std::vector<std::string>& names, bool is_beside);
std::string title_of(const std::vector<std::string>& names);

/// The site of a page that does not change.
PageServer::Site site_of(const Page& page, const std::string& viewer);

/// The site of a run that goes on; `page` has all but the run.
PageServer::Site live_site(LiveRun& live, const Page& page, const std::string& viewer);

}  // namespace transformesh::tool
