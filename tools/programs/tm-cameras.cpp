/// tm-cameras: converts camera files, and lists the cameras.

#include <map>

#include "frame/run.h"
#include "options/camera_table.h"
#include "options/source_options.h"
#include "transformesh/errors.h"
#include "transformesh/pinhole_camera.h"
#include "views/cameras/camera_output.h"
#include "views/cameras/view_files.h"

namespace {

using namespace transformesh;

struct Options {
  std::string format = "middlebury";
  std::string folder;
  ViewSources sources;  ///< paths of images, and options for reading them
  bool list = false;
  bool json = false;
  std::size_t neighbors = PairOptions().neighbors;
  std::vector<double> center;
};

const std::map<std::string, CameraFormat> formats{
    {"middlebury", CameraFormat::middlebury},       {"colmap", CameraFormat::colmap},
    {"colmap-binary", CameraFormat::colmap_binary}, {"opencv", CameraFormat::opencv},
    {"matrices", CameraFormat::matrices},           {"transforms", CameraFormat::transforms},
    {"meshroom", CameraFormat::meshroom},           {"openmvs", CameraFormat::openmvs}};

CameraList read(const std::string& where, const Options& options, tool::Run& run) {
  run.progress()("reading cameras");
  CameraList list = where == "-"
                        ? parse_cameras(run.in().read_bytes("-"), "standard input", "camera")
                        : cameras_from(where);
  run.report("cameras", list.cameras.size());
  for (CameraRecord& record : list.cameras)
    if (options.sources.mirror) record.camera = record.camera.mirrored();
  if (options.sources.images.empty()) return list;
  run.progress()("reading images");
  ViewSources sources = options.sources;
  sources.cameras = where;
  sources.on_note = [&run](const std::string& text) { run.note(text); };
  list = cameras_of_images(std::move(list), sources);
  run.report("images", list.cameras.size());
  return list;
}

std::string table(CameraList list, const Options& options, tool::Run& run) {
  const tool::CameraTable table =
      tool::table_of(std::move(list), options.center, options.neighbors);
  if (table.is_center_assumed)
    run.note(
        "one camera alone determines no depth: the scene's center is taken one unit in front of "
        "it; set it with --center");
  const Vec3& center = table.scene_center;
  run.report("scene_center", std::vector<double>{center.x(), center.y(), center.z()});
  if (table.pixel_size) run.report("pixel_size", *table.pixel_size);
  if (!table.pixel_size) run.note("the scene's center is behind all cameras: set it with --center");
  run.report("pairs", table.pairs.size());
  return options.json ? json_of(table) : text_of(table);
}

// Returns the converted cameras. If a folder is named, writes them there and returns nothing.
std::string convert(const CameraList& list, const Options& options, tool::Run& run) {
  const CameraFormat format = formats.at(options.format);
  if (options.folder.empty()) return write_cameras(list, format);
  const auto files = write_camera_files(list, format);
  for (const CameraText& file : files) run.out().write_into(options.folder, file.name, file.text);
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  tool::Program program{"tm-cameras",
                        "[OPTION]... [WHERE]",
                        "Converts the camera files of calibrated photographs, or lists them",
                        {tool::Reads::file},
                        {tool::Writes::text}};
  program.input.are_cameras = true;
  program.options.choice("format", &options.format,
                         {"middlebury", "colmap", "colmap-binary", "opencv", "matrices",
                          "transforms", "meshroom", "openmvs"},
                         "format of the output; the format of the input is detected");
  program.options.text("folder", &options.folder, "FOLDER",
                       "write the files of the format to this folder, and nothing to stdout");
  program.options.text("images", &options.sources.images, "WHERE",
                       "images, whose names and sizes are written");
  tool::declare_reading(program, options.sources);
  program.options.flag("list", &options.list,
                       "print a table of the cameras and their pairs, and convert nothing");
  program.options.flag("json", &options.json, "print the table as JSON");
  program.options.integer("pairs", &options.neighbors, 0, 1000,
                          "maximum number of neighbors of each view in the table");
  program.options.numbers(
      "center", &options.center, "X,Y,Z",
      "center of the scene, for the table (default: point nearest to all viewing axes)");
  program.epilog = "WHERE is a file, a folder or a quoted pattern; stdin is one file.";
  program.example = "tm-cameras --list par.txt";
  return program.run(argc, argv, [&](tool::Run& run) {
    CameraList list = read(run.in().name(), options, run);
    const bool is_table = options.list || options.json;
    run.out().set_bytes(is_table ? table(std::move(list), options, run)
                                 : convert(list, options, run));
  });
}
