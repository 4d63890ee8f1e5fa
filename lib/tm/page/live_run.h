/// The folder of a run that goes on, for a page that asks again and again what is new. Files that
/// vanish or are half there meanwhile are taken the next time.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "tm/page/run_page.h"

namespace transformesh {

class LiveRun {
 public:
  /// Throws InputError where the folder is no run.
  explicit LiveRun(std::string folder);

  /// Looks at the folder again; packs what is new for at most about so long, the oldest first.
  void refresh(double seconds);
  /// The run as far as it is known; it may have no mesh yet.
  const PageRun& run() const { return run_; }
  /// A packed mesh by the name of its block, or a photograph by its own; null where there is none.
  const std::string* block(const std::string& name) const;

 private:
  struct Known {
    std::string stamp;  ///< of the file
    PageMesh mesh;
  };
  void read_texts();
  void read_target();
  void read_meshes(double seconds);
  std::optional<PageMesh> read_mesh(std::size_t number, const std::string& path) const;

  std::string folder_;
  PageRun run_;
  Mesh target_;
  std::string target_stamp_;
  std::map<std::string, Known> known_;  ///< by path
};

}  // namespace transformesh
