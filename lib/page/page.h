/// A self-contained HTML page that shows recorded evolutions of a mesh, or meshes. Contains the
/// viewer (tools/viewer), its data as JSON, and each mesh as a packed block (pack.h) in base64,
/// which the viewer unpacks on demand. The page loads nothing over the network, which its
/// Content-Security-Policy enforces. Cost: linear. Deterministic for a given viewer and version of
/// zlib.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "evolution/loop/recorded_views.h"
#include "page/pack.h"

namespace transformesh {

struct PageMesh {
  std::size_t number = 0;  ///< iteration (first column of the log), or number of the file
  std::string label;       ///< label in the viewer; empty: the number
  PackedMesh mesh;
  std::string block = {};  ///< name of the packed mesh in the page's data; may be empty
};

struct PageViews {
  std::size_t number = 0;  ///< number of the time step
  std::vector<RunView> views;
};

/// The recorded run of an evolution, or meshes that are shown one at a time. A mesh is shown with
/// the target mesh and the views of the same number, or else of the next larger number, or else the
/// last ones.
struct PageRun {
  std::string name, tool, version;        ///< tool and version are empty if there is no run
  std::vector<std::string> commands;      ///< commands of the run
  std::string log, report;                ///< log as CSV and report as JSON; may be empty
  std::string events;                     ///< CSV of the events (events.h), or empty
  std::vector<PageMesh> meshes, targets;  ///< ascending by number, as `views` is
  std::vector<PageViews> views;
};

struct Page {
  std::string title;
  std::string version;      ///< version of the program that makes the page
  std::string color_by;     ///< initial color column; empty: none
  std::string up = "auto";  ///< axis that points up; auto: from the cameras, if there are any
  bool is_live = false;     ///< true: the viewer polls the server of the page for changes
  std::vector<PageRun> runs;
};

/// Returns the page's data as JSON, without the packed meshes and photographs. Throws InputError if
/// a report is not JSON.
std::string page_json(const Page& page);
/// Names (as in page_json()) and bytes of packed meshes, targets and photographs.
using PageBlocks = std::vector<std::pair<std::string, const std::string*>>;
PageBlocks page_blocks(std::span<const PageRun> runs);

/// Inserts the page into the HTML of the viewer, at the placeholders `<!--tm:title-->` in the title
/// and `<!--tm:data-->` in the body. Meshes and photographs are inserted unless the page is live.
std::string page_html(const Page& page, std::string_view viewer);

}  // namespace transformesh
