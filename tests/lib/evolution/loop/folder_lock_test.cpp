#include "evolution/loop/folder_lock.h"

#include <doctest/doctest.h>

#include <filesystem>

#include "helpers/temporary_folder.h"
#include "transformesh/errors.h"

using namespace transformesh;
using namespace transformesh::test;

namespace fs = std::filesystem;

TEST_CASE("a folder is locked once, and free after unlocking") {
  const TemporaryFolder folder;
  {
    const FolderLock lock(folder / "state");
    CHECK_THROWS_AS(FolderLock(folder / "./state"), OutputError);
    const FolderLock other(folder / "other");
  }
  const FolderLock again(folder / "state");
}

TEST_CASE("an empty folder goes with its lock, and the one above if the lock made it") {
  const TemporaryFolder folder;
  { const FolderLock lock(folder / "state"); }
  { const FolderLock lock(folder / "above/state"); }
  CHECK(folder.is_empty());
  {
    const FolderLock lock(folder / "state");
    make_file(folder / "state/mesh.ply", "");
  }
  CHECK(fs::exists(folder / "state/mesh.ply"));
}

TEST_CASE("a folder that was removed meanwhile is created and locked again") {
  const TemporaryFolder folder;
  const FolderLock lock(folder / "state");
  fs::remove(folder / "state");
  const FolderLock other(folder / "state");
  CHECK_THROWS_AS(FolderLock(folder / "state"), OutputError);
}
