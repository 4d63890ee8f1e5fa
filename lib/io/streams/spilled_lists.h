/// Lists of indices that grow together and are kept in a nameless file rather than in memory.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace transformesh {

class SpilledLists {
 public:
  /// Makes empty lists, in a file in this folder that has no name and ends with the process.
  /// Throws OutputError.
  SpilledLists(std::string folder, std::size_t count);
  ~SpilledLists();
  SpilledLists(const SpilledLists&) = delete;
  SpilledLists& operator=(const SpilledLists&) = delete;

  /// Appends to a list. Throws OutputError, as if the disk is full.
  void add(std::size_t list, std::uint32_t index);
  /// Returns a list.
  std::vector<std::uint32_t> read(std::size_t list) const;

 private:
  struct List {
    std::vector<std::uint32_t> last;     ///< indices that are not yet in the file
    std::vector<std::uint64_t> offsets;  ///< places of full blocks in the file
  };

  void write(List& list);

  std::string folder_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
  std::vector<List> lists_;
};

}  // namespace transformesh
