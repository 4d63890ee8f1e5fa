#include "support/base64.h"

#include <array>
#include <cstdint>

namespace transformesh {
namespace {

constexpr std::string_view letters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t no_digit = 64;  ///< digits are 0 to 63

/// Returns the digit of each byte, or `no_digit`.
constexpr std::array<std::uint8_t, 256> digit_table() {
  std::array<std::uint8_t, 256> digits{};
  digits.fill(no_digit);
  for (std::size_t i = 0; i < letters.size(); ++i)
    digits[static_cast<unsigned char>(letters[i])] = static_cast<std::uint8_t>(i);
  return digits;
}

/// Collects six bits per digit and extracts whole bytes.
struct Digits {
  std::uint32_t bits = 0;
  unsigned count = 0;

  void add(std::uint8_t digit, std::string& bytes) {
    bits = bits << 6U | digit;
    count += 6;
    if (count < 8) return;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 255U);
  }
};

}  // namespace

std::string base64(std::string_view bytes) {
  const auto byte = [&](std::size_t i) {
    return i < bytes.size() ? static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i])) : 0;
  };
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::uint32_t group = byte(i) << 16U | byte(i + 1) << 8U | byte(i + 2);
    for (int shift = 18; shift >= 0; shift -= 6) text += letters[(group >> shift) & 63U];
  }
  const std::size_t missing = (3 - bytes.size() % 3) % 3;
  text.replace(text.size() - missing, missing, missing, '=');
  return text;
}

std::optional<std::string> bytes_of_base64(std::string_view text) {
  constexpr std::array<std::uint8_t, 256> table = digit_table();
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  Digits digits;
  for (const char c : text) {
    if (c == ' ' || (c >= '\t' && c <= '\r')) continue;
    const std::uint8_t digit = table[static_cast<unsigned char>(c)];
    if (digit == no_digit && c != '=') return std::nullopt;
    if (c == '=') {
      digits = {};
    } else {
      digits.add(digit, bytes);
    }
  }
  return bytes;
}

}  // namespace transformesh
