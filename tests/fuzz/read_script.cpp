// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/read_script.h"

#include <cstdlib>

#include "filter_feature_adapted_ii/utf8.h"
#include "fuzz/invariants.h"

namespace fuzz {

namespace {

std::string unescaped(const std::string& text)
{
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    require(c >= 0x20 || c == '\n' || c == '\t' || c == '\r', "XML has no control characters");
    require(c != '<', "a value has no angle bracket");
    if (c == '\n' || c == '\t' || c == '\r') {
      plain += ' ';
    } else if (c != '&') {
      plain += text[i];
    } else {
      const std::size_t end = text.find(';', i);
      require(end != std::string::npos, "an entity ends");
      const std::string name = text.substr(i + 1, end - i - 1);
      if (name == "amp")
        plain += '&';
      else if (name == "lt")
        plain += '<';
      else if (name == "gt")
        plain += '>';
      else if (name == "quot")
        plain += '"';
      else if (name.size() > 1 && name[0] == '#')
        plain += char(std::atoi(name.c_str() + 1));
      else
        require(false, "an entity is known");
      i = end;
    }
  }
  return plain;
}

/// The value of the attribute in an element's text.
std::string attribute(const std::string& element, const std::string& name)
{
  const std::string opening = " " + name + "=\"";
  const std::size_t begin = element.find(opening);
  require(begin != std::string::npos, "an element has its attributes");
  const std::size_t first = begin + opening.size(), end = element.find('"', first);
  require(end != std::string::npos, "a quote is closed");
  return unescaped(element.substr(first, end - first));
}

}  // namespace

ReadScript read_script(const std::string& xml)
{
  require(integral_invariant::filter::is_utf8(xml), "XML is UTF-8");
  ReadScript script;
  for (std::size_t begin = xml.find('<'); begin != std::string::npos; begin = xml.find('<', begin + 1)) {
    const std::size_t end = xml.find('>', begin);
    require(end != std::string::npos, "an element ends");
    const std::string element = xml.substr(begin, end - begin);
    if (element.rfind("<filter", 0) == 0) script.filter = attribute(element, "name");
    if (element.rfind("<Param", 0) == 0)
      script.assignments.push_back(attribute(element, "name") + "=" + attribute(element, "value"));
  }
  return script;
}

}  // namespace fuzz
