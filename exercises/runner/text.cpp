#include "runner/text.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace carom::runner {

std::optional<std::string> readIfThere(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || fs::is_directory(path)) return std::nullopt;
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
}

std::string readFile(const fs::path& path) {
  auto content = readIfThere(path);
  if (!content) throw Failure{ourFault, "cannot read " + path.string()};
  return *content;
}

void writeFile(const fs::path& path, std::string_view content) {
  if (path.has_parent_path()) fs::create_directories(path.parent_path());
  fs::path beside = path;
  beside += ".new";
  {
    std::ofstream file(beside, std::ios::binary);
    file << content;
    file.flush();
    if (!file) throw Failure{ourFault, "cannot write " + beside.string()};
  }
  fs::rename(beside, path);
}

std::vector<std::string> splitLines(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const auto end = text.find('\n');
    auto line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.emplace_back(line);
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 1);
  }
  return lines;
}

std::string trimmed(std::string_view text) {
  const auto from = text.find_first_not_of(" \t\r\n");
  if (from == std::string_view::npos) return "";
  return std::string(text.substr(from, text.find_last_not_of(" \t\r\n") - from + 1));
}

std::vector<std::string> words(std::string_view text) {
  std::istringstream in{std::string(text)};
  std::vector<std::string> all;
  for (std::string word; in >> word;) all.push_back(word);
  return all;
}

std::string wrapped(std::string_view text, std::size_t width, std::string_view indent) {
  std::string result;
  std::string line(indent);
  for (const auto& word : words(text)) {
    if (line.size() > indent.size() && line.size() + 1 + word.size() > width) {
      result += line + "\n";
      line = indent;
    }
    if (line.size() > indent.size()) line += ' ';
    line += word;
  }
  return result + line;
}

std::string spoken(std::string_view text) {
  struct Sign {
    std::string_view sign, words;
  };
  static constexpr Sign raised[] = {{"⁰", "0"}, {"¹", "1"}, {"²", "2"}, {"³", "3"},
                                    {"⁴", "4"}, {"⁵", "5"}, {"⁶", "6"}, {"⁷", "7"},
                                    {"⁸", "8"}, {"⁹", "9"}, {"⁻", "-"}, {"ᵀ", "T"}};
  static constexpr Sign other[] = {{"×", "x"},
                                   {"·", " "},
                                   {"−", "-"},
                                   {"–", "-"},
                                   {"—", "-"},
                                   {"±", "+-"},
                                   {"≤", "<="},
                                   {"≥", ">="},
                                   {"≠", "!="},
                                   {"≈", "about "},
                                   {"√", "sqrt "},
                                   {"∞", "infinity"},
                                   {"∫", "integral of "},
                                   {"∑", "sum of "},
                                   {"°", " degrees"},
                                   {"½", "1/2"},
                                   {"¼", "1/4"},
                                   {"→", "->"},
                                   {"…", "..."},
                                   {"‘", "'"},
                                   {"’", "'"},
                                   {"“", "\""},
                                   {"”", "\""},
                                   {"π", "pi"},
                                   {"ω", "omega"},
                                   {"μ", "mu"},
                                   {"µ", "mu"},
                                   {"θ", "theta"},
                                   {"φ", "phi"},
                                   {"α", "alpha"},
                                   {"β", "beta"},
                                   {"ε", "epsilon"},
                                   {"λ", "lambda"},
                                   {"τ", "tau"},
                                   {"Δ", "delta "},
                                   {"✓", "passed"},
                                   {"✗", "failed"},
                                   {"ä", "ae"},
                                   {"ö", "oe"},
                                   {"ü", "ue"},
                                   {"ß", "ss"},
                                   {"é", "e"},
                                   {"è", "e"},
                                   {"ê", "e"},
                                   {"ë", "e"},
                                   {"ï", "i"},
                                   {"á", "a"},
                                   {"à", "a"},
                                   {"ç", "c"},
                                   {"ñ", "n"},
                                   {"ô", "o"},
                                   {"ó", "o"},
                                   {"\u00a0", " "}};
  std::string result;
  bool up = false;
  while (!text.empty()) {
    const auto is = [&](const Sign& s) { return text.starts_with(s.sign); };
    if (static_cast<unsigned char>(text[0]) < 0x80) {
      result += text[0];
      text.remove_prefix(1);
      up = false;
    } else if (const auto power = std::find_if(std::begin(raised), std::end(raised), is);
               power != std::end(raised)) {
      result += std::string(up ? "" : "^") + std::string(power->words);
      text.remove_prefix(power->sign.size());
      up = true;
    } else {
      const auto known = std::find_if(std::begin(other), std::end(other), is);
      result += known != std::end(other) ? known->words : "?";
      std::size_t size = known != std::end(other) ? known->sign.size() : 1;
      // The rest of a character that is not known.
      while (known == std::end(other) && size < text.size() &&
             (static_cast<unsigned char>(text[size]) & 0xc0) == 0x80)
        ++size;
      text.remove_prefix(size);
      up = false;
    }
  }
  return result;
}

char32_t nextCharacter(std::string_view text, std::size_t& length) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  length = 1;
  const unsigned char first = byte(0);
  if (first < 0x80) return first;
  const std::size_t need = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : first >= 0xc2 ? 2 : 0;
  if (need == 0 || first > 0xf4 || text.size() < need) return 0;
  char32_t c = first & (0xffu >> (need + 1));
  for (std::size_t i = 1; i < need; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
    c = (c << 6) | (byte(i) & 0x3f);
  }
  length = need;
  const bool tooLong = c < (need == 2 ? 0x80u : need == 3 ? 0x800u : 0x10000u);
  return tooLong || (c >= 0xd800 && c < 0xe000) || c > 0x10ffff ? 0 : c;
}

bool unseen(char32_t c) {
  return c < 0xa0 || c == 0xad || (c >= 0x200b && c <= 0x200f) || (c >= 0x2028 && c <= 0x202f) ||
         (c >= 0x2060 && c <= 0x206f) || c == 0xfeff || (c >= 0xfff0 && c <= 0xffff) ||
         c >= 0xe0000;
}

std::string printable(std::string_view text) {
  std::string clean;
  while (!text.empty()) {
    std::size_t length = 1;
    const char32_t c = nextCharacter(text, length);
    const bool seen = c == '\n' || c == '\t' || (c >= ' ' && c < 0x7f) || !unseen(c);
    clean += seen ? text.substr(0, length) : "?";
    text.remove_prefix(length);
  }
  return clean;
}

std::string hashOf(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const unsigned char c : text) hash = (hash ^ c) * 0x100000001b3u;
  char out[17];
  std::snprintf(out, sizeof out, "%016llx", static_cast<unsigned long long>(hash));
  return out;
}

}  // namespace carom::runner
