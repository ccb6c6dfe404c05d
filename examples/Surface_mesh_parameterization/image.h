// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef IMAGE_H
#define IMAGE_H

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

typedef std::array<double, 3>   Color;       // red, green, blue from 0 to 1

struct Image
{
  std::size_t width, height;
  std::vector<Color> pixels;                 // row by row from the top

  Image(std::size_t width, std::size_t height, const Color& color = { 1, 1, 1 }) : width(width), height(height), pixels(width * height, color) { }
};

// Writes eight bits per color, every pixel as its difference to the one before it in its row, which compresses better.
inline void write_PNG(std::ostream& out, const Image& image)
{
  const auto big_endian = [](std::size_t number) {
    return std::string{ char(number >> 24 & 255), char(number >> 16 & 255), char(number >> 8 & 255), char(number & 255) };
  };
  const auto write_chunk = [&](const std::string& chunk) {      // with its type in front
    const uLong checksum = crc32(0, reinterpret_cast<const Bytef*>(chunk.data()), uInt(chunk.size()));
    out << big_endian(chunk.size() - 4) << chunk << big_endian(checksum);
  };
  std::string rows;
  for (std::size_t y = 0; y < image.height; ++y) {
    rows += char(1);
    std::array<std::uint8_t, 3> before = { 0, 0, 0 };
    for (std::size_t x = 0; x < image.width; ++x)
      for (int i = 0; i < 3; ++i) {
        const std::uint8_t byte = std::uint8_t(std::lround(255 * (std::min)(1., (std::max)(0., image.pixels[y * image.width + x][i]))));
        rows += char(std::uint8_t(byte - before[i]));
        before[i] = byte;
      }
  }
  uLongf size = compressBound(uLong(rows.size()));
  std::string data(size, 0);
  if (compress2(reinterpret_cast<Bytef*>(&data[0]), &size, reinterpret_cast<const Bytef*>(rows.data()), uLong(rows.size()), 9) != Z_OK)
    throw std::runtime_error("a picture cannot be compressed");
  out << "\x89PNG\r\n\x1a\n";
  write_chunk("IHDR" + big_endian(image.width) + big_endian(image.height) + std::string{ 8, 2, 0, 0, 0 });
  write_chunk("IDAT" + data.substr(0, size));
  write_chunk("IEND");
}

#endif // IMAGE_H
