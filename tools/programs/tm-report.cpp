/// tm-report: makes a page that shows recorded runs of evolutions and reconstructions.
#include "frame/run.h"
#include "page/run_page.h"
#include "transformesh/errors.h"
#include "viewer/viewer_file.h"

namespace {

using namespace transformesh;

struct Options {
  std::string title, color_by;
  std::string up = "auto";
  RunPageOptions page;
};

void declare(tool::Program& program, Options& options) {
  program.options.integer("every", &options.page.every, 1, 999999999,
                          "use the first, every Nth and the last frame");
  program.options.text(
      "color-by", &options.color_by, "PROPERTY",
      "property by which meshes are colored at first; distance is the distance from the target");
  program.options.choice("up", &options.up, {"auto", "x", "y", "z", "-x", "-y", "-z"},
                         "axis that points up; auto: the upward axis of the photographs, else y");
  program.options.text("title", &options.title, "TEXT",
                       "title of the page (default: the names of the runs)");
}

void report(const Options& options, tool::Run& run) {
  if (run.in().names().empty())
    throw UsageError(
        "RUN is missing: name a folder that tm-evolve, tm-morph or tm-reconstruct has written with "
        "--run");
  if (run.out().is_terminal())
    throw UsageError("not writing a page to a terminal: name a file with -o");
  const std::string viewer = tool::read_viewer();
  Page page = read_runs_page(run.in().names(), options.page, run.progress());
  if (!options.color_by.empty() && !has_column(page, options.color_by))
    throw UsageError("--color-by: no mesh has a property '" + options.color_by + "' of numbers");
  page.color_by = options.color_by;
  if (!options.title.empty()) page.title = options.title;
  page.version = run.program().name + ' ' + tool::Run::version();
  page.up = options.up;
  std::size_t meshes = 0;
  for (const PageRun& shown : page.runs) meshes += shown.meshes.size();
  run.report("runs", page.runs.size());
  run.report("meshes", meshes);
  std::string html = page_html(page, viewer);
  run.report("bytes", html.size());
  run.out().set_bytes(std::move(html));
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  tool::Program program{
      "tm-report",
      "[OPTION]... RUN... [-o PAGE.html]",
      "Makes one HTML page that shows runs of tm-evolve, tm-morph or tm-reconstruct",
      {tool::Reads::words},
      {tool::Writes::page}};
  program.words = {
      "RUN",
      "folder that one of these programs has written with --run; several are shown side "
      "by side"};
  program.words.are_folders = true;
  declare(program, options);
  program.example = "tm-morph a.ply --target b.ply --run morph && tm-report morph -o morph.html";
  return program.run(argc, argv, [&](tool::Run& run) { report(options, run); });
}
