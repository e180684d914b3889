// The suite `toi`: first contacts, how soon they are found and how right they are.

#include <filesystem>
#include <iostream>

#include "bench/bench.hpp"
#include "bench/toi_bodies.hpp"
#include "bench/toi_features.hpp"

int main(int argc, char** argv) {
  const carom::bench::Options options = carom::bench::readOptions(argc, argv);
  carom::bench::Json figures{{"suite", "toi"},
                             {"circumstances", carom::bench::circumstances(options)}};
  std::cout << carom::bench::circumstancesInALine() << "\n\n";
  if (!options.plots.empty()) std::filesystem::create_directories(options.plots);
  figures["rows"] = carom::bench::raceFeatures(options);
  for (const carom::bench::Json& row : carom::bench::raceBodies(options)) {
    figures["rows"].push_back(row);
  }
  carom::bench::writeJson(options, figures);
}
