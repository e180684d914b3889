#include "runner/git.hpp"

#include "grading/process.hpp"

namespace carom::runner {

std::string Git::run(const std::vector<std::string>& words,
                     const std::vector<std::string>& environment, bool* failed) const {
  grading::Command command;
  command.words = {"git", "-C", folder_.string(), "-c", "core.quotepath=off", "-c", "gc.auto=0"};
  command.words.insert(command.words.end(), words.begin(), words.end());
  if (words[0] == "sh") command.words = words;
  command.environment = environment;
  command.environment.push_back("LC_ALL=C");
  command.limits = {.wallSeconds = 600, .cpuSeconds = 0, .outputKilobytes = 1 << 20};
  auto done = grading::run(command);
  if (!done.ok()) {
    if (failed) {
      *failed = true;
      return "";
    }
    throw Failure{ourFault,
                  "git " + words[0] + " failed (" + done.end + ")\n" + trimmed(done.output)};
  }
  return std::move(done.output);
}

std::string Git::operator()(const std::vector<std::string>& words,
                            const std::vector<std::string>& environment) const {
  std::string output = run(words, environment, nullptr);
  if (output.ends_with('\n')) output.pop_back();
  return output;
}

std::string Git::from(const fs::path& input, const std::vector<std::string>& words,
                      const std::vector<std::string>& environment) const {
  std::vector<std::string> all = {"sh",
                                  "-c",
                                  "in=$1; shift; exec git \"$@\" <\"$in\"",
                                  "sh",
                                  input.string(),
                                  "-C",
                                  folder_.string()};
  all.insert(all.end(), words.begin(), words.end());
  std::string output = run(all, environment, nullptr);
  if (output.ends_with('\n')) output.pop_back();
  return output;
}

std::optional<std::string> Git::tried(const std::vector<std::string>& words) const {
  bool failed = false;
  std::string output = run(words, {}, &failed);
  if (failed) return std::nullopt;
  if (output.ends_with('\n')) output.pop_back();
  return output;
}

Tree readTree(const Git& git, const std::string& commit) {
  Tree tree;
  const std::string listing = git({"ls-tree", "-r", "-z", commit});
  for (std::size_t at = 0; at < listing.size();) {
    const auto end = std::min(listing.find('\0', at), listing.size());
    const std::string entry = listing.substr(at, end - at);
    const auto tab = entry.find('\t');
    const auto facts = words(entry.substr(0, tab));
    if (facts.size() == 3 && facts[1] == "blob")
      tree[entry.substr(tab + 1)] = {.mode = facts[0], .blob = facts[2], .content = {}};
    at = end + 1;
  }
  return tree;
}

std::string writeTree(const Git& git, const Tree& tree, const fs::path& scratch) {
  const fs::path folder = scratch / "made";
  fs::remove_all(folder);
  fs::create_directories(folder);
  std::string paths;
  int number = 0;
  for (const auto& [path, file] : tree) {
    if (!file.content) continue;
    const fs::path made = folder / std::to_string(number++);
    writeFile(made, *file.content);
    paths += made.string() + "\n";
  }
  std::vector<std::string> blobs;
  if (number > 0) {
    writeFile(folder / "paths", paths);
    blobs = splitLines(
        git.from(folder / "paths", {"hash-object", "-w", "--no-filters", "--stdin-paths"}));
  }
  std::string index;
  std::size_t next = 0;
  for (const auto& [path, file] : tree) {
    const std::string& blob = file.content ? blobs.at(next++) : file.blob;
    index += file.mode + " " + blob + " 0\t" + path + '\0';
  }
  writeFile(folder / "entries", index);
  const std::string own = "GIT_INDEX_FILE=" + (folder / "index").string();
  git.from(folder / "entries", {"update-index", "-z", "--add", "--index-info"}, {own});
  return git({"write-tree"}, {own});
}

Signature committerOf(const Git& git, const std::string& commit) {
  const auto lines = splitLines(git({"log", "-1", "--format=%cn%n%ce%n%cI", commit}));
  return {lines.at(0), lines.at(1), lines.at(2)};
}

std::string commitTree(const Git& git, const std::string& tree, const std::string& parent,
                       const std::string& message, const Signature& signature) {
  std::vector<std::string> command = {"-c",   "commit.gpgsign=false", "commit-tree", tree, "-m",
                                      message};
  if (!parent.empty()) command.insert(command.end(), {"-p", parent});
  return git(command,
             {"GIT_AUTHOR_NAME=" + signature.name, "GIT_AUTHOR_EMAIL=" + signature.email,
              "GIT_AUTHOR_DATE=" + signature.date, "GIT_COMMITTER_NAME=" + signature.name,
              "GIT_COMMITTER_EMAIL=" + signature.email, "GIT_COMMITTER_DATE=" + signature.date});
}

std::vector<Blob> reachableBlobs(const Git& git, const std::string& commit,
                                 const fs::path& scratch) {
  fs::create_directories(scratch);
  writeFile(scratch / "objects", git({"rev-list", "--objects", commit}) + "\n");
  const std::string all =
      git.from(scratch / "objects",
               {"cat-file", "--batch=%(objectname) %(objecttype) %(objectsize) %(rest)"});
  std::vector<Blob> blobs;
  for (std::size_t at = 0; at < all.size();) {
    const auto end = all.find('\n', at);
    if (end == std::string::npos) break;
    const std::string head = all.substr(at, end - at);
    const auto facts = words(head);
    if (facts.size() < 3) throw Failure{ourFault, "git cat-file: " + head};
    const std::size_t size = std::stoul(facts[2]);
    if (facts[1] == "blob") {
      const auto path = facts[0].size() + facts[1].size() + facts[2].size() + 3;
      blobs.push_back(
          {facts[0], path < head.size() ? head.substr(path) : "", all.substr(end + 1, size)});
    }
    at = end + 1 + size + 1;
  }
  return blobs;
}

}  // namespace carom::runner
