// SPDX-License-Identifier: GPL-3.0-or-later
// Fuzzing: bytes as numbers and choices.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

namespace fuzz {

/// Hands out bytes from first to last; zeros once they are used up, so that every input means something.
class ByteReader {
 public:
  ByteReader(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  bool is_empty() const { return size_ == 0; }
  std::uint8_t byte()
  {
    if (size_ == 0) return 0;
    --size_;
    return *data_++;
  }
  bool flag() { return byte() & 1; }
  /// From 0 to count − 1, count at most 65536.
  std::uint32_t below(std::uint32_t count) { return count <= 256 ? byte() % count : (byte() | byte() << 8) % count; }
  /// From 0 to 1.
  double unit() { return double(byte() | byte() << 8) / 65535; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// A power of ten of either sign of the exponent, over the whole range of double and beyond.
  double magnitude() { return std::pow(10.0, double(below(700)) - 350); }

  std::int32_t any_int()
  {
    constexpr std::int32_t special[] = {
        0, 1, -1, 2, 32, 33, 1000, std::numeric_limits<std::int32_t>::max(), std::numeric_limits<std::int32_t>::min()};
    const std::uint32_t choice = below(16);
    return choice < std::size(special) ? special[choice] : std::int32_t(byte()) - 64;
  }
  double any_real()
  {
    using Limits = std::numeric_limits<double>;
    constexpr double special[] = {0,
                                  -0.0,
                                  1,
                                  -1,
                                  Limits::quiet_NaN(),
                                  Limits::infinity(),
                                  -Limits::infinity(),
                                  Limits::max(),
                                  -Limits::max(),
                                  Limits::min(),
                                  Limits::denorm_min(),
                                  1e-20,
                                  1e15,
                                  1e8};
    const std::uint32_t choice = below(24);
    if (choice < std::size(special)) return special[choice];
    if (choice < 20) return between(-2, 20);
    return magnitude() * (flag() ? 1 : -1);
  }
  std::string rest()
  {
    std::string text(reinterpret_cast<const char*>(data_), size_);
    size_ = 0;
    return text;
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};

}  // namespace fuzz
