// Writes a sphere as PLY, OFF, OBJ and STL, reads each file again and compares the volume.
#include <transformesh/mesh_io.h>
#include <transformesh/shapes.h>

#include <cmath>
#include <filesystem>

using namespace transformesh;

int main() {
  const Mesh mesh = make_sphere(Vec3::Zero(), 1, 500);
  std::filesystem::create_directory("mesh_io-files");
  for (const char* ending : {"ply", "off", "obj", "stl"}) {
    const std::string path = std::string("mesh_io-files/sphere.") + ending;
    write_mesh_file(path, mesh);
    const Mesh read = read_mesh_file(path);
    if (read.faces.size() != mesh.faces.size()) return 1;
    if (std::abs(volume(read) - volume(mesh)) > 1e-5) return 1;
  }
  std::filesystem::remove_all("mesh_io-files");
  const WriteResult written = write_mesh({.mesh = mesh});
  const ReadResult read = read_mesh(written.bytes, "memory");
  if (read.document.mesh.faces != mesh.faces || !read.notes.empty()) return 1;
  if (read.document.mesh.positions != mesh.positions) return 1;
  try {
    read_mesh("this is no mesh", "text");
  } catch (const InputError&) {
    return 0;
  }
  return 1;
}
