/// tm-tile: splits a mesh larger than memory into tiles for tm-clean, and joins the clean tiles.
#include <filesystem>

#include "clean/tiles/join_tiles.h"
#include "clean/tiles/split_tiles.h"
#include "frame/run.h"
#include "support/counted.h"
#include "transformesh/errors.h"

namespace {

using namespace transformesh;

void split(const std::string& path, std::optional<long> tiles, tool::Run& run) {
  const std::string& folder = run.out().name();
  if (!tiles) throw UsageError("the number of tiles is missing: give it with --tiles N");
  if (folder == "-") throw UsageError("tiles are files in a folder: name it with -o");
  const PlyRows rows(path);
  SplitResult result = split_tiles(rows, static_cast<std::size_t>(*tiles), folder, run.progress());
  for (AtomicFile& file : result.files) file.commit();
  run.report({{"tiles", result.files.size()},
              {"faces", result.faces},
              {"tile_faces", result.tile_faces},
              {"largest_tile", result.largest_tile},
              {"empty_tiles", result.empty_tiles}});
  if (result.empty_tiles > 0)
    run.note(counted(result.empty_tiles, "tile") +
             (result.empty_tiles == 1 ? " has no face of its own" : " have no faces of their own"));
}

void join(const std::string& folder, tool::Run& run) {
  if (run.out().is_terminal())
    throw UsageError("not writing binary data to a terminal: redirect it or name a file with -o");
  AtomicFile file(run.out().name());
  const JoinResult result = join_tiles(
      folder, run.program().name + ' ' + tool::Run::version() + " join", file, run.progress());
  file.commit();
  run.report({{"tiles", result.tiles},
              {"vertices", result.vertices},
              {"faces", result.faces},
              {"joined_vertices", result.joined_vertices}});
}

void split_or_join(std::optional<long> tiles, tool::Run& run) {
  const std::vector<std::string>& words = run.in().names();
  tool::check_command(run.program(), words);
  if (words.size() != 2)
    throw UsageError("one " + std::string(words[0] == "split" ? "mesh" : "folder") +
                     " is needed after '" + words[0] + "'");
  run.out().write_nothing();
  words[0] == "split" ? split(words[1], tiles, run) : join(words[1], run);
}

}  // namespace

int main(int argc, char** argv) {
  std::optional<long> tiles;
  tool::Program program{"tm-tile",
                        "[OPTION]... split MESH --tiles N -o FOLDER | join FOLDER",
                        "Splits a mesh larger than memory for tm-clean, and joins the results",
                        {tool::Reads::words},
                        {tool::Writes::text}};
  program.words = {"split MESH | join FOLDER",
                   "write the tiles of a mesh, or join the cleaned tiles"};
  program.words.choices = {"join", "split"};
  program.options.integer("tiles", &tiles, 1, 9999, "number of tiles");
  program.epilog =
      "tm-tile split huge.ply --tiles 16 -o tiles\n"
      "for tile in tiles/tile-*.ply; do tm-clean $tile -o ${tile/tile-/clean-}; done\n"
      "tm-tile join tiles > clean.ply";
  program.example = "tm-tile split large.ply --tiles 2 -o tiles";
  return program.run(argc, argv, [&](tool::Run& run) { split_or_join(tiles, run); });
}
