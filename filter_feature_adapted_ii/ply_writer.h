// SPDX-License-Identifier: GPL-3.0-or-later
// Binary PLY files of any elements and properties.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace integral_invariant::filter {

/// One property of an element: a number a row, or a list of as many numbers a row.
struct PlyProperty {
  std::string type;                 ///< as in the header: "float", "list uchar int"
  std::string name;                 ///< spaces become underscores
  std::vector<unsigned char> data;  ///< as in the file, row by row
  std::size_t row_bytes = 0;
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;  ///< each with `count` rows
};

template <class Type>
constexpr const char* ply_type();
template <>
constexpr const char* ply_type<std::uint8_t>()
{
  return "uchar";
}
template <>
constexpr const char* ply_type<std::int32_t>()
{
  return "int";
}
template <>
constexpr const char* ply_type<float>()
{
  return "float";
}
template <>
constexpr const char* ply_type<double>()
{
  return "double";
}

/// A number a row, of this type in the file.
template <class Type, class ValueOf>
PlyProperty ply_property(const std::string& name, std::size_t count, ValueOf value_of)
{
  PlyProperty property{ply_type<Type>(), name, std::vector<unsigned char>(count * sizeof(Type)), sizeof(Type)};
  for (std::size_t row = 0; row < count; ++row) {
    const Type value = Type(value_of(row));
    std::memcpy(property.data.data() + row * sizeof value, &value, sizeof value);
  }
  return property;
}

/// Whether single precision holds the value as it is; what is no number has no digits to lose.
inline bool fits_single_precision(double value) { return double(float(value)) == value || value != value; }

/// A number a row, in single precision where that changes none of them, else in double.
template <class ValueOf>
PlyProperty exact_property(const std::string& name, std::size_t count, ValueOf value_of)
{
  std::size_t row = 0;
  while (row < count && fits_single_precision(value_of(row))) ++row;
  return row == count ? ply_property<float>(name, count, value_of) : ply_property<double>(name, count, value_of);
}

/// A list of `Length` numbers a row: list_of(row) is a std::array of them.
template <class Type, std::size_t Length, class ListOf>
PlyProperty ply_list(const std::string& name, std::size_t count, ListOf list_of)
{
  static_assert(Length < 256, "the length of a list is written as one byte");
  constexpr std::size_t bytes = 1 + Length * sizeof(Type);
  PlyProperty property{std::string("list uchar ") + ply_type<Type>(), name, std::vector<unsigned char>(count * bytes),
                       bytes};
  for (std::size_t row = 0; row < count; ++row) {
    const std::array<Type, Length> list = list_of(row);
    property.data[row * bytes] = static_cast<unsigned char>(Length);
    std::memcpy(property.data.data() + row * bytes + 1, list.data(), Length * sizeof(Type));
  }
  return property;
}

/// Writes the elements in their order; `comments` go into the header. The file appears whole or not at all.
/// \return the absolute path. \throw FileError
std::string write_ply(const std::vector<PlyElement>& elements, const std::vector<std::string>& comments,
                      const std::string& path);

}  // namespace integral_invariant::filter
