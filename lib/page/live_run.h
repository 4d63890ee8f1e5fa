/// The folder of a run that goes on, for a page that asks again and again what is new. Files that
/// vanish or are half there meanwhile are taken the next time.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "page/run_page.h"

namespace transformesh {

class LiveRun {
 public:
  /// Throws InputError where the folder is no run.
  explicit LiveRun(std::string folder);

  /// Looks at the folder again; packs what is new for at most about so long, the oldest first.
  void refresh(double seconds);
  /// The run as far as it is known; it may have no mesh yet.
  const PageRun& run() const { return run_; }
  /// A packed mesh or a photograph by the name that page_json() has; null where there is none.
  const std::string* block(const std::string& name) const;

 private:
  /// Maps a path to the identity of the file, which changes if the file is replaced.
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
  Mesh target_;              ///< the one read last
  std::string target_path_;  ///< with its stamp
};

}  // namespace transformesh
