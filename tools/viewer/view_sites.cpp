#include "viewer/view_sites.h"

#include <map>

#include "io/streams/streams.h"

namespace transformesh::tool {
namespace {

constexpr const char* html = "text/html; charset=utf-8";
constexpr const char* json = "application/json";
constexpr const char* bytes = "application/octet-stream";

// Longest time, in seconds, that one request may spend on preparing new meshes of an active run for
// the browser. A longer time delays answers; with a shorter time, a long run needs more requests.
constexpr double seconds_of_packing = 0.5;

constexpr const char* waiting_page =
    "<!doctype html><html lang=\"en\"><head><meta charset=\"utf-8\"><title>tm-view</title>"
    "<meta http-equiv=\"refresh\" content=\"1\"><link rel=\"icon\" href=\"data:,\">"
    "<style>:root{color-scheme:light dark}body{font:16px system-ui,sans-serif;margin:3rem}</style>"
    "</head><body><main><h1>tm-view</h1><p>Waiting for the first mesh of the run.</p></main>"
    "</body></html>\n";

std::map<std::string, std::string> blocks_of(const Page& page) {
  std::map<std::string, std::string> blocks;
  for (const auto& [name, block] : page_blocks(page.runs)) blocks[name] = *block;
  return blocks;
}

constexpr std::string_view block_prefix = "block/";

std::string short_name(const std::string& path) {
  return path == "-" ? input_name(path) : path.substr(path.rfind('/') + 1);
}

}  // namespace

std::vector<PageRun> runs_of(const std::vector<Document>& documents,
                             const std::vector<std::string>& names, bool is_beside) {
  std::vector<PageRun> runs(is_beside ? documents.size() : 1);
  for (std::size_t i = 0; i < documents.size(); ++i) {
    const std::string name = short_name(names[i]);
    PageRun& run = runs[is_beside ? i : 0];
    if (is_beside || documents.size() == 1) run.name = name;
    run.meshes.push_back({is_beside ? 0 : i, name, pack(documents[i].mesh)});
  }
  return runs;
}

std::string title_of(const std::vector<std::string>& names) {
  const std::string more = " and " + std::to_string(names.size() - 1) + " more";
  return short_name(names[0]) + (names.size() > 1 ? more : "");
}

PageServer::Site site_of(const Page& page, const std::string& viewer) {
  Page live = page;
  live.is_live = true;
  return [page_text = page_html(live, viewer), json_text = page_json(live),
          blocks = blocks_of(page)](const std::string& name) -> std::optional<Answer> {
    if (name.empty()) return Answer{html, page_text};
    if (name == "page.json") return Answer{json, json_text};
    if (!name.starts_with(block_prefix)) return std::nullopt;
    const auto found = blocks.find(name.substr(block_prefix.size()));
    if (found == blocks.end()) return std::nullopt;
    return Answer{bytes, found->second};
  };
}

PageServer::Site live_site(LiveRun& live, const Page& page, const std::string& viewer) {
  return [&live, page, viewer](const std::string& name) -> std::optional<Answer> {
    if (name.starts_with(block_prefix)) {
      const std::string* block = live.block(name.substr(block_prefix.size()));
      if (block == nullptr) return std::nullopt;
      return Answer{bytes, *block};
    }
    if (!name.empty() && name != "page.json") return std::nullopt;
    live.refresh(seconds_of_packing);
    Page now = page;
    now.is_live = true;
    now.runs = {live.run()};
    if (!name.empty()) return Answer{json, page_json(now)};
    return Answer{html, live.run().meshes.empty() ? waiting_page : page_html(now, viewer)};
  };
}

}  // namespace transformesh::tool
