// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of the documentation: every link inside the project leads somewhere, every file and member that is named
// exists.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
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

/// What the pattern's parentheses hold, everywhere on the page.
std::vector<std::string> matches(const fs::path& page, const std::regex& pattern)
{
  const std::string text = text_of(page);
  std::vector<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
    found.push_back((*match)[1]);
  return found;
}

std::vector<std::string> links_of(const fs::path& page)
{
  static const std::regex pattern(R"(\]\(([^)\s]+)\))");
  return matches(page, pattern);
}

/// Words in code quotes with a folder in them, such as `moments/engine.h`.
std::vector<std::string> named_files_of(const fs::path& page)
{
  static const std::regex pattern(R"(`([a-z_]+(?:/[a-z0-9_]+)+(?:\.(?:h|cpp|py|md|txt))?)`)");
  return matches(page, pattern);
}

/// Whether there is such a file or folder, seen from the page, the root or the core; a header and its source have one
/// name. What a build makes is not asked for.
bool exists_in_tree(const fs::path& page, const std::string& name)
{
  if (name.rfind("build/", 0) == 0) return true;
  for (const fs::path& folder : {page.parent_path(), root, root / "vcg_ext/integral_invariant"})
    for (const char* ending : {"", ".h", ".cpp"})
      if (fs::exists(folder / (name + ending))) return true;
  return false;
}

TEST(Docs, LinksLeadSomewhere)
{
  const std::vector<fs::path> all = pages();
  ASSERT_GT(all.size(), 5u);
  for (const fs::path& page : all)
    for (const std::string& link : links_of(page))
      EXPECT_EQ(fault_of(page, link), "") << fs::relative(page, root).string() << ": " << link;
}

TEST(Docs, NamedFilesExist)
{
  for (const fs::path& page : pages())
    for (const std::string& name : named_files_of(page))
      EXPECT_TRUE(exists_in_tree(page, name)) << fs::relative(page, root).string() << ": " << name;
}

/// Members in code quotes, such as `NoiseLevel::sigma`.
std::vector<std::string> named_members_of(const fs::path& page)
{
  static const std::regex pattern(R"(`([A-Z][A-Za-z0-9]*::[a-z_0-9]+)(?:\(\))?`)");
  return matches(page, pattern);
}

std::vector<std::string> sources()
{
  std::vector<std::string> texts;
  for (const char* folder : {"vcg_ext", "filter_feature_adapted_ii"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder))
      if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp")
        texts.push_back(text_of(entry.path()));
  return texts;
}

bool has_word(const std::string& text, const std::string& word)
{
  const auto is_part = [&](std::size_t i) {
    return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) || text[i] == '_');
  };
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    if (!(at > 0 && is_part(at - 1)) && !is_part(at + word.size())) return true;
  return false;
}

TEST(Docs, NamedMembersExist)
{
  const std::vector<std::string> texts = sources();
  for (const fs::path& page : pages())
    for (const std::string& name : named_members_of(page)) {
      const std::string type = name.substr(0, name.find(':')), member = name.substr(name.rfind(':') + 1);
      EXPECT_TRUE(std::any_of(texts.begin(), texts.end(),
                              [&](const std::string& text) {
                                return (has_word(text, "struct " + type) || has_word(text, "class " + type)) &&
                                       has_word(text, member);
                              }))
          << fs::relative(page, root).string() << ": " << name;
    }
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
