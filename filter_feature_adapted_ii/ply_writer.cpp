// SPDX-License-Identifier: GPL-3.0-or-later
#include "ply_writer.h"

#include <algorithm>

#include "whole_file.h"

namespace integral_invariant::filter {

namespace {

/// Numbers are written in this machine's order of bytes.
constexpr const char* format_line()
{
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
  return "format binary_big_endian 1.0\n";
#else
  return "format binary_little_endian 1.0\n";
#endif
}

/// A word of the header is ended by a space.
std::string as_word(std::string name)
{
  for (char& c : name)
    if (static_cast<unsigned char>(c) <= ' ') c = '_';
  return name;
}

std::string header(const std::vector<PlyElement>& elements, const std::vector<std::string>& comments)
{
  std::string text = std::string("ply\n") + format_line();
  for (const std::string& comment : comments) text += "comment " + comment + "\n";
  for (const PlyElement& element : elements) {
    text += "element " + element.name + " " + std::to_string(element.count) + "\n";
    for (const PlyProperty& property : element.properties)
      text += "property " + property.type + " " + as_word(property.name) + "\n";
  }
  return text + "end_header\n";
}

/// Row by row, a block at a time: many rows a call, and little memory beside the properties'.
void write_rows(const PlyElement& element, WholeFile& file)
{
  constexpr std::size_t block_rows = 16384;
  std::vector<unsigned char> block;
  for (std::size_t begin = 0; begin < element.count; begin += block_rows) {
    const std::size_t end = std::min(element.count, begin + block_rows);
    block.clear();
    for (std::size_t row = begin; row < end; ++row)
      for (const PlyProperty& property : element.properties) {
        const unsigned char* first = property.data.data() + row * property.row_bytes;
        block.insert(block.end(), first, first + property.row_bytes);
      }
    file.write(block.data(), block.size());
  }
}

}  // namespace

std::string write_ply(const std::vector<PlyElement>& elements, const std::vector<std::string>& comments,
                      const std::string& path)
{
  WholeFile file(path);
  const std::string text = header(elements, comments);
  file.write(text.data(), text.size());
  for (const PlyElement& element : elements) write_rows(element, file);
  return file.commit();
}

}  // namespace integral_invariant::filter
