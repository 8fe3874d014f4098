// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of the documentation: every link inside the project leads somewhere.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

const fs::path root = II_SOURCE_FOLDER;

std::string text_of(const fs::path& file)
{
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// All Markdown pages but those in build folders and hidden ones.
std::vector<fs::path> pages()
{
  std::vector<fs::path> found;
  for (auto entry = fs::recursive_directory_iterator(root); entry != fs::recursive_directory_iterator(); ++entry) {
    const std::string name = entry->path().filename().string();
    if (entry->is_directory() && (name[0] == '.' || name == "build")) entry.disable_recursion_pending();
    if (entry->is_regular_file() && entry->path().extension() == ".md") found.push_back(entry->path());
  }
  return found;
}

bool belongs_to_a_word(unsigned char c) { return std::isalnum(c) || c == '_' || c == '-' || c >= 0x80; }

/// The name that GitHub gives to a heading: lower case, hyphens for spaces, no punctuation.
std::string anchor_of(const std::string& heading)
{
  std::string anchor;
  for (const char c : heading) {
    if (c == ' ')
      anchor += '-';
    else if (belongs_to_a_word(static_cast<unsigned char>(c)))
      anchor += char(std::tolower(static_cast<unsigned char>(c)));
  }
  return anchor;
}

std::set<std::string> anchors_of(const fs::path& page)
{
  std::set<std::string> anchors;
  std::istringstream lines(text_of(page));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t level = line.find_first_not_of('#');
    if (level > 0 && level != std::string::npos && line[level] == ' ')
      anchors.insert(anchor_of(line.substr(level + 1)));
  }
  return anchors;
}

/// What is wrong with a link of `page`; empty: nothing.
std::string fault_of(const fs::path& page, const std::string& link)
{
  if (link.find("://") != std::string::npos || link.rfind("mailto:", 0) == 0) return "";
  const std::size_t hash = link.find('#');
  const fs::path target = hash == 0 ? page : page.parent_path() / link.substr(0, hash);
  if (!fs::exists(target)) return "no such file";
  if (hash != std::string::npos && anchors_of(target).count(link.substr(hash + 1)) == 0) return "no such heading";
  return "";
}

std::vector<std::string> links_of(const fs::path& page)
{
  static const std::regex pattern(R"(\]\(([^)\s]+)\))");
  const std::string text = text_of(page);
  std::vector<std::string> links;
  for (std::sregex_iterator link(text.begin(), text.end(), pattern), end; link != end; ++link)
    links.push_back((*link)[1]);
  return links;
}

TEST(Docs, LinksLeadSomewhere)
{
  const std::vector<fs::path> all = pages();
  ASSERT_GT(all.size(), 5u);
  for (const fs::path& page : all)
    for (const std::string& link : links_of(page))
      EXPECT_EQ(fault_of(page, link), "") << fs::relative(page, root).string() << ": " << link;
}

TEST(Docs, ALinkThatLeadsNowhereIsFound)
{
  const fs::path readme = root / "README.md";
  EXPECT_EQ(fault_of(readme, "docs/no_such_page.md"), "no such file");
  EXPECT_EQ(fault_of(readme, "docs/accuracy.md#no-such-heading"), "no such heading");
  EXPECT_EQ(fault_of(readme, "docs/accuracy.md#the-families"), "");
  EXPECT_EQ(fault_of(readme, "https://example.org/anything"), "");
}

}  // namespace
