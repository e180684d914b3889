#pragma once
// Methods that race: each with several steps or tolerances, all timed in one run, and drawn as error
// against time.

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "bench/bench.hpp"

namespace carom::bench {

/// One setting of one method.
struct RacePoint {
  Real setting = 0;  ///< step [s], tolerance, or 0 for a closed form
  Real error = 0;    ///< at the end, infinite or not a number if the method failed
  Timing time;       ///< per simulated second [ns]
};

/// One method.
struct RaceCurve {
  std::string name;
  bool peer = false;
  const char* kind = "dt";  ///< what the setting is: "dt", "tolerance" or "query"
  std::vector<RacePoint> points;
};

/// What a comparison at one error found.
struct Comparison {
  std::string ours, peer;          ///< the cheapest of each that reaches the error
  Real ourTime = 0, peerTime = 0;  ///< per simulated second [us]; 0 if none reaches it
};

/// A problem with a known end, and the methods that solve it.
class Race {
 public:
  /// \param scene name for the tables \param unit of the error \param duration simulated [s]
  Race(std::string scene, std::string unit, int duration)
      : scene_(std::move(scene)), unit_(std::move(unit)), duration_(duration) {}

  /// Adds one setting of one method. \param run makes the whole motion and answers its end
  /// \param errorOf says how far from the truth an end is; not timed
  template <class Run, class ErrorOf>
  void add(const std::string& name, bool peer, const char* kind, Real setting, const Run& run,
           const ErrorOf& errorOf) {
    if (curves_.empty() || curves_.back().name != name) curves_.push_back({name, peer, kind, {}});
    curves_.back().points.push_back({setting, errorOf(run()), {}});
    cases_.push_back({name, static_cast<std::size_t>(duration_), [run] { keep(run()); }});
  }

  /// Times everything that was added.
  void time(const Options& options);

  /// Prints a table: for each method the time that it needs for each of some errors.
  void print(const std::vector<Real>& levels) const;

  /// Adds a row for each point.
  void write(Json& rows) const;

  /// Draws error against time. \param file where \param title above the diagram
  /// \param text for those who cannot see it \param level an error to mark \param low the lower end
  /// of the axis
  void draw(const std::filesystem::path& file, const std::string& title, const std::string& text,
            Real level, Real low) const;

  /// The cheapest of ours and of the peers for an error, between their points. \param level error
  /// \param closedForms whether ours may be a closed form
  Comparison compare(Real level, bool closedForms) const;

  /// Whether one of the methods is a closed form.
  bool hasClosedForm() const;

  /// The methods with what they measured.
  const std::vector<RaceCurve>& curves() const {
    return curves_;
  }

 private:
  std::string scene_, unit_;
  int duration_;
  std::vector<RaceCurve> curves_;
  std::vector<Case> cases_;
};

/// Time that a method needs for an error, between its points [us per simulated second]; 0 if it
/// never gets there.
Real timeFor(const RaceCurve& curve, Real level);

}  // namespace carom::bench
