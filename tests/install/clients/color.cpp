// Colors a sphere from four photographs of one color and reads the color at the vertices.
#include <transformesh/color.h>
#include <transformesh/shapes.h>

#include <cmath>
#include <filesystem>
#include <fstream>

using namespace transformesh;

int main() {
  std::filesystem::create_directory("color-files");
  std::ofstream cameras("color-files/cameras_par.txt");
  cameras << "4\n";
  for (int view = 0; view < 4; ++view) {  // Cameras on a circle of radius 4 in the plane z = 0.
    const std::string name = "photo" + std::to_string(view) + ".png";
    const std::string png = write_png(Image(64, 64, {200, 100, 50, 255}));
    std::ofstream("color-files/" + name, std::ios::binary) << png;
    const double c = std::cos(view * std::acos(0.0)), s = std::sin(view * std::acos(0.0));
    cameras << name << " 80 0 31.5 0 80 31.5 0 0 1 " << -s << ' ' << c << " 0 0 0 -1 " << -c << ' '
            << -s << " 0 0 0 4\n";
  }
  cameras.close();
  Mesh mesh = make_sphere(Vec3::Zero(), 1, 500);
  const ViewSources sources{.cameras = "color-files/cameras_par.txt", .images = "color-files"};
  const ColorResult result = color_vertices(mesh, sources);
  const Column* red = mesh.vertex_columns.find("red");
  if (!red) return 1;
  for (const double value : red->values)
    if (std::abs(value - 200) > 1) return 1;
  const Atlas atlas = texture_surface(mesh, sources, {.most_size = 256});
  std::filesystem::remove_all("color-files");
  if (result.unseen > mesh.positions.size() / 2 || result.disagreement > 1) return 1;
  return atlas.charts > 0 && !atlas.picture.empty() && mesh.face_columns.find("texcoord") ? 0 : 1;
}
