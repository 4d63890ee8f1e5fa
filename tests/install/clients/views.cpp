// Adds a photograph with its silhouette to a list of views and rejects sizes that differ.
#include <transformesh/views.h>

using namespace transformesh;

int main() {
  Views views;
  if (views.size() != 0) return 1;
  PinholeCamera camera;
  camera.intrinsics << 50, 0, 8, 0, 50, 6, 0, 0, 1;
  views.add("first", camera, GrayImage(16, 12, 100.0F), GrayImage(16, 12, 255.0F));
  if (views.size() != 1 || views.name(0) != "first") return 1;
  if (views.camera(0).intrinsics != camera.intrinsics) return 1;
  try {
    views.add("second", camera, GrayImage(16, 12), GrayImage(12, 16));
    return 1;
  } catch (const UsageError&) {
    if (views.size() != 1) return 1;
  }
  try {
    read_views({.cameras = "no-such-file.txt"});
  } catch (const InputError& error) {
    const std::string message = error.what();
    return message.find("no-such-file.txt") != std::string::npos ? 0 : 1;
  }
  return 1;
}
