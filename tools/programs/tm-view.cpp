/// tm-view: shows meshes, or an active run, in a browser.
#include "frame/run.h"
#include "transformesh/errors.h"
#include "viewer/open_page.h"
#include "viewer/view_sites.h"
#include "viewer/viewer_file.h"

namespace {

using namespace transformesh;

struct Options {
  std::string run, color_by, title;
  std::string up = "auto";
  bool is_beside = false, is_opened = false, is_served = false;
  int port = 0;
};

void declare(tool::Program& program, Options& options) {
  program.options.flag("beside", &options.is_beside,
                       "show meshes side by side (default: one after the other)");
  program.options.text(
      "run", &options.run, "FOLDER",
      "show the run in this folder, which tm-evolve, tm-morph or tm-reconstruct writes with "
      "--run, instead of meshes");
  program.options.flag("serve", &options.is_served,
                       "serve the page at an address of this machine until Ctrl-C, and print the "
                       "address; new frames of a run appear");
  program.options.integer("port", &options.port, 0, 65535, "port of --serve; 0: any free port");
  program.options.flag("open", &options.is_opened,
                       "open the page in the browser even if stdout is not a terminal");
  program.options.text("color-by", &options.color_by, "PROPERTY",
                       "property by which meshes are colored at first");
  program.options.choice("up", &options.up, {"auto", "x", "y", "z", "-x", "-y", "-z"},
                         "axis that points up; auto: the upward axis of the photographs, else y");
  program.options.text("title", &options.title, "TEXT",
                       "title of the page (default: the names of the meshes)");
  program.epilog = "Show a morph in progress: tm-view --serve --run morph";
  program.input.is_absent = [&options] { return !options.run.empty(); };
}

void serve(const Options& options, const tool::PageServer::Site& site) {
  tool::PageServer server(options.port);
  tool::Outputs::print_line(server.address());
  if (options.is_opened) tool::open_in_browser(server.address());
  server.serve(site);
}

void show(const Options& options, tool::Run& run) {
  if (options.is_served && run.out().name() != "-")
    throw UsageError("give either --serve or --output, not both");
  const std::string viewer = tool::read_viewer();
  Page page;
  page.version = run.program().name + ' ' + tool::Run::version();
  page.color_by = options.color_by;
  page.up = options.up;
  page.title = options.title;
  if (options.is_served && !options.run.empty()) {
    LiveRun live(options.run);
    if (page.title.empty()) page.title = live.run().name;
    serve(options, tool::live_site(live, page, viewer));
  }
  page.runs = options.run.empty()
                  ? tool::runs_of(run.in().documents(), run.in().names(), options.is_beside)
                  : std::vector<PageRun>{read_run_page(options.run, {}, run.progress())};
  if (page.title.empty())
    page.title = options.run.empty() ? tool::title_of(run.in().names()) : page.runs[0].name;
  if (options.is_served) serve(options, tool::site_of(page, viewer));
  run.report("meshes",
             run.in().names().empty() ? page.runs[0].meshes.size() : run.in().names().size());
  const std::string html = page_html(page, viewer);
  if (!options.is_opened && !run.out().is_terminal()) return run.out().set_bytes(html);
  run.out().write_nothing();
  const std::string path = tool::write_temporary_page(html);
  tool::open_in_browser(path);
  run.note("opened '" + path + "', which stays until you remove it");
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  tool::Program program{"tm-view",
                        "[OPTION]... [MESH]...",
                        "Shows meshes in a browser, in 3D",
                        {tool::Reads::meshes},
                        {tool::Writes::page}};
  declare(program, options);
  program.example = "tm-view mesh.ply > mesh.html";
  return program.run(argc, argv, [&](tool::Run& run) { show(options, run); });
}
