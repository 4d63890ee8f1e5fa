/// One self-contained HTML page that shows runs of loops, or meshes: the viewer (tools/viewer),
/// what there is to show as JSON, and each mesh as a packed block (pack.h) in base64, which the
/// viewer unpacks when it is wanted. The page asks for nothing from anywhere, and says so in its
/// Content-Security-Policy. Cost: linear. Deterministic for a version of zlib and a viewer.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "evolution/loop/recorded_views.h"
#include "page/pack.h"

namespace transformesh {

struct PageMesh {
  std::size_t number = 0;  ///< of the iteration, in the first column of the log; or of the file
  std::string label;       ///< empty: the number says it
  PackedMesh mesh;
  std::string block = {};  ///< name of its block, or empty
};

struct PageViews {
  std::size_t number = 0;  ///< of the time step
  std::vector<RunView> views;
};

/// A run, or meshes one of which is shown at a time, with the target and the views of its number,
/// else the next ones, else the last.
struct PageRun {
  std::string name, tool, version;        ///< the latter empty where these are just meshes
  std::vector<std::string> commands;      ///< that made it
  std::string log, report;                ///< CSV and JSON, or empty
  std::vector<PageMesh> meshes, targets;  ///< in order, and so are
  std::vector<PageViews> views;
};

struct Page {
  std::string title;
  std::string version;      ///< of what makes the page
  std::string color_by;     ///< column shown at first; empty: none
  std::string up = "auto";  ///< axis that points up; auto: in the photographs, where there are any
  bool is_live = false;     ///< the viewer asks for what is new, beside the page
  std::vector<PageRun> runs;
};

/// What there is to show, without the blocks. Throws InputError where a report is no JSON.
std::string page_json(const Page& page);
/// Names and bytes of their meshes, targets and photographs, as page_json() has them.
using PageBlocks = std::vector<std::pair<std::string, const std::string*>>;
PageBlocks page_blocks(std::span<const PageRun> runs);

/// Puts all of it into the viewer's page, whose places for that are comments: `<!--tm:title-->` in
/// the title, `<!--tm:data-->` in the body. A live page gets no blocks.
std::string page_html(const Page& page, std::string_view viewer);

}  // namespace transformesh
