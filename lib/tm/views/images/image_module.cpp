#include "tm/views/images/image_module.h"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <limits>
#include <mutex>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>

namespace {

using transformesh::Samples;

/// What libraries write to stderr while this lives, which is for no user's eyes: OpenCV reports
/// there what it cannot decode, and libjpeg what it decodes nevertheless. One at a time.
class CapturedErrors {
 public:
  CapturedErrors() : lock_(mutex()), file_(std::tmpfile()), stderr_(dup(STDERR_FILENO)) {
    if (file_ != nullptr) dup2(fileno(file_), STDERR_FILENO);
  }
  ~CapturedErrors() {
    std::fflush(stderr);
    if (stderr_ >= 0) dup2(stderr_, STDERR_FILENO);
    if (stderr_ >= 0) close(stderr_);
    if (file_ != nullptr) std::fclose(file_);
  }
  CapturedErrors(const CapturedErrors&) = delete;
  CapturedErrors& operator=(const CapturedErrors&) = delete;

  /// libjpeg's report of damage, empty where there is none.
  std::string damage() {
    if (file_ == nullptr) return {};
    std::fflush(stderr);
    std::rewind(file_);
    std::array<char, 256> line{};
    while (std::fgets(line.data(), static_cast<int>(line.size()), file_) != nullptr) {
      std::string text(line.data());
      if (text.starts_with("Corrupt JPEG") || text.starts_with("Premature end")) {
        return text.substr(0, text.find('\n'));
      }
    }
    return {};
  }

 private:
  static std::mutex& mutex() {
    static std::mutex only;
    return only;
  }

  std::lock_guard<std::mutex> lock_;
  std::FILE* file_;
  int stderr_;
};

// OpenCV has colours in the order blue, green, red.
template <class Sample>
void append_row(const Sample* pixel, const cv::Mat& image, std::vector<Sample>& values) {
  const int channels = image.channels();
  for (int x = 0; x < image.cols; ++x, pixel += channels) {
    if (channels == 1) values.push_back(pixel[0]);
    if (channels == 3) values.insert(values.end(), {pixel[2], pixel[1], pixel[0]});
  }
}

bool decode(std::string_view bytes, Samples& samples) {
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) return false;
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  const cv::_InputArray encoded(reinterpret_cast<const unsigned char*>(bytes.data()),
                                static_cast<int>(bytes.size()));
  const cv::Mat image =
      cv::imdecode(encoded, static_cast<int>(cv::IMREAD_ANYDEPTH) | cv::IMREAD_ANYCOLOR |
                                cv::IMREAD_IGNORE_ORIENTATION);
  const bool is_known = image.depth() == CV_8U || image.depth() == CV_16U;
  if (image.empty() || !is_known || (image.channels() != 1 && image.channels() != 3)) return false;
  samples.width = image.cols;
  samples.height = image.rows;
  samples.channels = image.channels();
  samples.maximum = image.depth() == CV_16U ? 65535 : 255;
  samples.shallow.clear();
  samples.deep.clear();
  for (int y = 0; y < image.rows; ++y) {
    if (image.depth() == CV_16U) append_row(image.ptr<std::uint16_t>(y), image, samples.deep);
    if (image.depth() == CV_8U) append_row(image.ptr<std::uint8_t>(y), image, samples.shallow);
  }
  return true;
}

}  // namespace

extern "C" bool tm_decode_image(std::string_view bytes, Samples& samples,
                                std::string& problem) noexcept {
  try {
    CapturedErrors errors;
    const bool is_decoded = decode(bytes, samples);
    problem = errors.damage();
    return is_decoded && problem.empty();
  } catch (...) {
    return false;
  }
}
