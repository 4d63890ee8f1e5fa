/// Reads the folder of a running evolution for a page that polls for changes. Each refresh reads
/// what has changed. Files that disappear or are incomplete are read at a later refresh.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "page/run_page.h"

namespace transformesh {

class LiveRun {
 public:
  /// Throws InputError if the folder does not hold a run.
  explicit LiveRun(std::string folder);

  /// Reads the folder again. Starts packing new meshes, in order of their numbers, until `seconds`
  /// have passed.
  void refresh(double seconds);
  /// Returns the run as read so far; it may have no mesh yet.
  const PageRun& run() const { return run_; }
  /// Returns a packed mesh or a photograph by its name in page_json(), null if there is none.
  const std::string* block(const std::string& name) const;

 private:
  /// Maps a path to the identity of the file (stamp_of()) and the data that were read from it. The
  /// identity changes if the file is replaced.
  template <class What>
  using Known = std::map<std::string, std::pair<std::string, What>>;

  void read_views();
  void read_meshes(double seconds);
  void read_target(std::size_t number, const std::string& path);
  std::optional<PageMesh> read_mesh(std::size_t number, const std::string& path,
                                    const RunPaths::value_type* target);

  std::string folder_;
  PageRun run_;
  Known<PageMesh> meshes_, targets_;
  Known<PageViews> views_;
  Mesh target_;              ///< target mesh of the evolution that was read last
  std::string target_path_;  ///< path and stamp_of() of the file of `target_`
};

}  // namespace transformesh
