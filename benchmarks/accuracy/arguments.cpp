// SPDX-License-Identifier: GPL-3.0-or-later
#include "arguments.h"

#include <algorithm>

namespace accuracy {

Arguments::Arguments(const std::vector<std::string>& argv, const std::vector<std::string>& names,
                     const std::string& usage)
{
  constexpr std::size_t first_option = 2;
  for (std::size_t i = first_option; i < argv.size(); i += 2) {
    if (i + 1 == argv.size() || std::find(names.begin(), names.end(), argv[i]) == names.end())
      throw std::invalid_argument(usage);
    values_[argv[i]] = argv[i + 1];
  }
}

std::string Arguments::text(const std::string& name, const std::string& fallback) const
{
  const auto found = values_.find(name);
  return found == values_.end() ? fallback : found->second;
}

std::uint32_t Arguments::number(const std::string& name, std::uint32_t fallback) const
{
  const auto found = values_.find(name);
  return found == values_.end() ? fallback : std::uint32_t(std::stoul(found->second));
}

}  // namespace accuracy
