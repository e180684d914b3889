#include "bench/scenes_rows.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <sstream>

#include "bench/allocations.hpp"
#include "carom_io/table.hpp"
#include "scenes/engines.hpp"

namespace carom::bench {
namespace {

using scenes::EngineKind;
using scenes::Figure;
using scenes::Scene;

std::vector<std::string> parts(const std::string& list) {
  std::vector<std::string> all;
  std::stringstream stream(list);
  for (std::string part; std::getline(stream, part, ',');) all.push_back(part);
  return all;
}

bool beginsWithOne(const std::string& name, const std::vector<std::string>& beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](const std::string& b) { return name.starts_with(b); });
}

Json named(const std::vector<Figure>& figures) {
  Json all = Json::object();
  for (const Figure& figure : figures) all[figure.name] = figure.value;
  return all;
}

std::string inHex(std::uint64_t number) {
  char text[20];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(number));
  return text;
}

// What the child does: the run, as text.
std::string runHere(const EngineKind& kind, const Scene& scene, Real dt,
                    const SceneOptions& options) {
  Json row;
  try {
    const scenes::Run run = scenes::runScene(kind, scene, dt,
                                             {.repeats = options.common.runs,
                                              .batch = options.batch,
                                              .allocations = allocationsSoFar,
                                              .bytes = bytesTaken});
    row["allocations"] = run.allocations;
    row["bytes"] = run.bytes;
    row["steps"] = run.steps;
    row["sim_s"] = run.simulated;
    row["cpu_s"] = run.seconds;
    row["ms_per_step"] = 1000 * run.seconds / static_cast<Real>(run.steps);
    row["ms_per_sim_s"] = 1000 * run.seconds / run.simulated;
    row["error"] = named(run.figures);
    row["counters"] = named(run.counters);
    row["hash"] = inHex(run.hash);
    if (!run.finite) row["failed"] = "a state that is no number";
    if (!run.repeats) row["failed"] = "another run ended in another state";
  } catch (const std::exception& problem) {
    row["failed"] = problem.what();
  }
  return row.dump();
}

void writeAll(int file, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t now = write(file, text.data() + done, text.size() - done);
    if (now <= 0) return;
    done += static_cast<std::size_t>(now);
  }
}

std::string readAll(int file) {
  std::string text;
  char buffer[4096];
  for (ssize_t now; (now = read(file, buffer, sizeof buffer)) > 0;) {
    text.append(buffer, static_cast<std::size_t>(now));
  }
  return text;
}

[[noreturn]] void wrongUse(const std::string& message) {
  std::cerr << message
            << "\nOptions: --engine A,B  --scene A,B  --rates 60,240  --limit SECONDS  --most N  "
               "--list\n";
  std::exit(4);
}

}  // namespace

SceneOptions readSceneOptions(int argc, char** argv) {
  SceneOptions options;
  std::vector<char*> rest{argv[0]};
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    if (name == "--list") {
      options.list = true;
      continue;
    }
    if (i + 1 == argc) wrongUse(name + " stands alone or is not known");
    const std::string value = argv[i + 1];
    if (name == "--engine") {
      options.engines = parts(value);
    } else if (name == "--scene") {
      options.scenes = parts(value);
    } else if (name == "--rates") {
      options.rates.clear();
      for (const std::string& rate : parts(value)) {
        options.rates.push_back(std::atof(rate.c_str()));
        if (!(options.rates.back() > 0)) wrongUse("--rates " + value + ": must be positive");
      }
    } else if (name == "--limit" || name == "--most") {
      const int number = std::atoi(value.c_str());
      if (number < 1) wrongUse(name + " " + value + ": must be at least 1");
      (name == "--limit" ? options.limit : options.most) = number;
    } else {
      rest.push_back(argv[i]);
      rest.push_back(argv[i + 1]);
    }
    ++i;
  }
  options.common = readOptions(static_cast<int>(rest.size()), rest.data());
  return options;
}

std::vector<EngineKind> enginesOf(const SceneOptions& options) {
  std::vector<EngineKind> kinds;
  for (EngineKind& kind : scenes::allEngines()) {
    if (options.engines.empty() || beginsWithOne(kind.name, options.engines)) {
      kinds.push_back(std::move(kind));
    }
  }
  if (kinds.empty()) wrongUse("--engine: none of that name was found when this was built");
  return kinds;
}

bool runs(const SceneOptions& options, const EngineKind& kind, const Scene& scene) {
  if (!kind.can(scene)) return false;
  const bool asked =
      std::find(options.engines.begin(), options.engines.end(), kind.name) != options.engines.end();
  // "bullet" alone means its best settings, "bullet it50" means these.
  return kind.best(scene) || (asked && kind.name.find(' ') != std::string::npos);
}

Json rowOf(const std::string& suite, const EngineKind& kind, const Scene& scene, Real rate,
           const SceneOptions& options) {
  Json row{{"suite", suite},
           {"scene", scene.name},
           {"engine", kind.name},
           {"version", kind.version},
           {"dt", 1 / rate},
           {"threads", kind.threads},
           {"bodies", scene.bodies.size()},
           {"duration", scene.duration}};
  int ends[2];
  if (pipe(ends) != 0) {
    row["failed"] = "no pipe";
    return row;
  }
  std::cout.flush();
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    // What engines have to say on the way is not for the table.
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, 1);
    dup2(nowhere, 2);
    const rlimit seconds{static_cast<rlim_t>(options.limit), static_cast<rlim_t>(options.limit)};
    setrlimit(RLIMIT_CPU, &seconds);
    writeAll(ends[1], runHere(kind, scene, 1 / rate, options));
    close(ends[1]);
    _exit(0);
  }
  close(ends[1]);
  const std::string text = readAll(ends[0]);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  const Json found = Json::parse(text, nullptr, false);
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    const bool late = signal == SIGXCPU || signal == SIGKILL;
    row["failed"] = late ? "took more than " + std::to_string(options.limit) + " s"
                         : "ended by signal " + std::to_string(signal);
  } else if (found.is_discarded() || !found.is_object()) {
    row["failed"] = "ended without a word, status " + std::to_string(WEXITSTATUS(status));
  } else {
    row.update(found);
  }
  return row;
}

void printEngines(const std::vector<EngineKind>& kinds) {
  std::cout << "Engines and settings\n\n";
  for (const EngineKind& kind : kinds) {
    std::cout << "  " << kind.name << " (" << kind.version << "): " << kind.settings << '\n';
  }
  std::cout << '\n';
}

void printRows(const Json& rows) {
  std::vector<std::string> names;
  for (const Json& row : rows) {
    if (!row.contains("error")) continue;
    for (const auto& item : row["error"].items()) {
      if (std::find(names.begin(), names.end(), item.key()) == names.end()) {
        names.push_back(item.key());
      }
    }
  }
  io::Table table;
  table.column("engine").column("1/dt", io::significant(4)).column("us a step", io::significant(3));
  for (const std::string& name : names) table.column(name, io::significant(3));
  for (const Json& row : rows) {
    std::vector<io::Cell> cells{row["engine"].get<std::string>(), 1 / row["dt"].get<Real>()};
    if (row.contains("failed")) {
      cells.emplace_back("failed: " + row["failed"].get<std::string>());
      for (std::size_t i = 0; i < names.size(); ++i) cells.emplace_back("");
    } else {
      cells.emplace_back(1000 * row["ms_per_step"].get<Real>());
      for (const std::string& name : names) {
        const auto found = row["error"].find(name);
        if (found == row["error"].end() || !found->is_number()) {
          cells.emplace_back("");
        } else {
          cells.emplace_back(found->get<Real>());
        }
      }
    }
    table.row(cells);
  }
  std::cout << table << '\n' << std::flush;
}

}  // namespace carom::bench
