#pragma once
// How long does something take, and compared with what?
//
// What is measured is the processor time of this process on one core, so that other programs on the
// machine count little. Every case is repeated until a run lasts long enough to be read; the runs
// of all cases take turns, so that a processor that gets slower or faster does so for all of them;
// the median of the runs is reported. A figure is worth something only beside another one of the
// same run of the program, so claims are ratios.

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "carom/core/real.hpp"
#include "carom_io/plot.hpp"

namespace carom::bench {

using Json = nlohmann::ordered_json;

/// Keeps the optimiser from removing the work that made a value: it must assume that the value is
/// read, and that everything in memory may have changed.
template <class T>
inline void keep(const T& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

/// What the command line of every suite says.
struct Options {
  std::filesystem::path json;   ///< where to write the figures; empty: nowhere
  std::filesystem::path plots;  ///< folder for diagrams; empty: none
  int runs = 5;                 ///< of each case
  Real seconds = 0.2;           ///< least length of a run [s of processor time]
};

/// Reads --json FILE, --plots FOLDER, --runs N, --seconds S. Ends the program, after saying why, if
/// there is anything else.
Options readOptions(int argc, char** argv);

/// A thing to be timed.
struct Case {
  std::string name;
  std::size_t items = 1;      ///< triangles, steps, ...: what one call works through
  std::function<void()> run;  ///< one call
};

/// What came out [ns of processor time per item].
struct Timing {
  Real median = 0;
  Real least = 0;
  Real most = 0;
};

/// Times cases side by side. The process is bound to the core that it runs on.
/// \return a timing for each case, in the same order
std::vector<Timing> measure(const std::vector<Case>& cases, const Options& options);

/// Processor, compiler and flags, and how it was measured.
Json circumstances(const Options& options);

/// The same in a line for people.
std::string circumstancesInALine();

/// Writes processor, compiler and flags into a figure, in three lines.
/// \param x left end of the lines \param top height of the first
/// \param factor from each to the next on a logarithmic axis
void sign(io::Plot& plot, Real x, Real top, Real factor);

/// How curve number i of many is drawn: peers thin and grey, methods in colours of their own.
io::CurveStyle styleOf(std::size_t i, bool peer);

/// Slope of a straight line through the logarithms: the exponent of a power law.
Real slopeOf(const std::vector<Real>& x, const std::vector<Real>& y);

/// Writes the figures where the options ask for them, and says so.
void writeJson(const Options& options, const Json& figures);

}  // namespace carom::bench
