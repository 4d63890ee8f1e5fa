// Encodes an image as PNG, decodes its bytes as a photograph and compares the intensities.
#include <transformesh/image.h>

#include <cmath>

using namespace transformesh;

int main() {
  Image image(3, 2, {10, 20, 30, 255});
  image.at(2, 1) = {250, 0, 0, 255};
  const GrayImage gray = decode_photograph(write_png(image), "image.png");
  if (gray.width != 3 || gray.height != 2) return 1;
  const double expected = 0.299 * 10 + 0.587 * 20 + 0.114 * 30;
  if (std::abs(gray.at(0, 0) - expected) > 1) return 1;
  if (std::abs(gray.at(2, 1) - 0.299 * 250) > 1) return 1;
  try {
    decode_photograph("no image", "text.png");
  } catch (const InputError& error) {
    return std::string(error.what()).find("text.png") != std::string::npos ? 0 : 1;
  }
  return 1;
}
