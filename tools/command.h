/// A program as it was declared: what its help says and its runs go by.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "common_options.h"
#include "option_table.h"
#include "tool.h"

namespace transformesh::tool {

struct Command {
  std::string name;
  std::string synopsis;  ///< the usage without the program's name
  std::string summary;   ///< one line without full stop
  Reads reads = Reads::mesh;
  Writes writes = Writes::mesh;
  std::string words_placeholder = {};  ///< empty where no positional words are declared
  std::string words_help = {};
  std::vector<std::string>* words = nullptr;
  std::vector<std::string> epilogs = {};
  std::function<bool()> writes_mesh_if = {};
  const std::string* only_key = nullptr;
  std::vector<std::string> required = {};
  OptionTable table = {};
  CommonOptions common = {};
  std::vector<std::string> inputs = {};

  bool is_evolution() const { return writes == Writes::evolved_mesh; }
  bool reads_mesh() const { return reads == Reads::mesh || reads == Reads::meshes; }
  bool may_write_mesh() const { return writes == Writes::mesh || is_evolution() || writes_mesh_if; }
  bool may_print_report() const { return writes == Writes::report || writes == Writes::answer; }
  bool writes_mesh() const { return writes_mesh_if ? writes_mesh_if() : may_write_mesh(); }
};

}  // namespace transformesh::tool
