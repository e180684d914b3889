#pragma once
// Bodies that follow a law, as an engine: what a perfect engine, or one with a known error, would
// do. Judges are tested by it.

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "scenes/run_scene.hpp"
#include "scenes/scene.hpp"

namespace carom::scenes {

/// An engine whose bodies are where a law says.
class Law : public Engine {
 public:
  /// State of a body at a time since the start [s].
  using Motion = std::function<State(int, Real)>;
  /// \param motion the law
  explicit Law(Motion motion) : motion_(std::move(motion)) {}
  void build(const Scene&) override {}
  void step(Real dt) override {
    ++steps_, dt_ = dt;
  }
  State state(int body) const override {
    // Not a sum: its rounding would be an error of the law.
    return motion_(body, static_cast<Real>(steps_) * dt_);
  }

 private:
  Motion motion_;
  long steps_ = 0;
  Real dt_ = 0;
};

/// What a judge found, by name.
inline std::map<std::string, Real> figuresOf(const Judge& judge) {
  std::map<std::string, Real> all;
  for (const Figure& figure : judge.figures()) all[figure.name] = figure.value;
  return all;
}

/// What the judge of a scene says of a law.
inline std::map<std::string, Real> runLaw(const Scene& scene, Real dt, const Law::Motion& motion) {
  const EngineKind kind{"law", "", "", {}, {}, [motion] { return std::make_unique<Law>(motion); }};
  std::map<std::string, Real> all;
  const Run run = runScene(kind, scene, dt);
  for (const Figure& figure : run.figures) all[figure.name] = figure.value;
  return all;
}

}  // namespace carom::scenes
