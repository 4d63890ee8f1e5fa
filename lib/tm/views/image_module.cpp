#include "tm/views/image_module.h"

#include <limits>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>

namespace {

using transformesh::Samples;

// OpenCV has colours in the order blue, green, red.
template <class Sample>
void append_row(const Sample* pixel, const cv::Mat& image, std::vector<std::uint16_t>& values) {
  const int channels = image.channels();
  for (int x = 0; x < image.cols; ++x, pixel += channels) {
    if (channels == 1) values.push_back(pixel[0]);
    if (channels == 3) values.insert(values.end(), {pixel[2], pixel[1], pixel[0]});
  }
}

bool decode(std::string_view bytes, Samples& samples) {
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) return false;
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  const cv::Mat encoded(1, static_cast<int>(bytes.size()), CV_8UC1,
                        const_cast<char*>(bytes.data()));
  const cv::Mat image =
      cv::imdecode(encoded, static_cast<int>(cv::IMREAD_ANYDEPTH) | cv::IMREAD_ANYCOLOR |
                                cv::IMREAD_IGNORE_ORIENTATION);
  const bool is_known = image.depth() == CV_8U || image.depth() == CV_16U;
  if (image.empty() || !is_known || (image.channels() != 1 && image.channels() != 3)) return false;
  samples.width = image.cols;
  samples.height = image.rows;
  samples.channels = image.channels();
  samples.maximum = image.depth() == CV_16U ? 65535 : 255;
  samples.values.clear();
  for (int y = 0; y < image.rows; ++y) {
    if (image.depth() == CV_16U) append_row(image.ptr<std::uint16_t>(y), image, samples.values);
    if (image.depth() == CV_8U) append_row(image.ptr<std::uint8_t>(y), image, samples.values);
  }
  return true;
}

}  // namespace

extern "C" bool tm_decode_image(std::string_view bytes, Samples& samples) noexcept {
  try {
    return decode(bytes, samples);
  } catch (...) {
    return false;
  }
}
