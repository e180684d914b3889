// Grader of 09.sinking_tower: loads of all contacts, each over the stiffness of its spring.

#include <numbers>

#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

const Within kMargin = withinRelative(0.05, "a prediction may be 5% off");

// How far the box with this number, from 1, sinks in a tower [mm].
Real sinks(int box, int boxes, Real mass, Real hertz) {
  const Real w = 2 * std::numbers::pi * hertz;
  Real way = 0;
  for (int below = 0; below < box; ++below) {
    const Real load = (boxes - below) * mass * 9.81;
    const Real inverse = below == 0 ? 1 / mass : 2 / mass;
    way += load * inverse / (w * w);
  }
  return 1000 * way;
}

}  // namespace

TEST_CASE("ground") {
  GRADE(predicted("ground_overlap_10_boxes", "mm"), sinks(1, 10, 1, 30), kMargin, unit("mm"),
        about("ten boxes at 30 Hz: how deep the lowest one stands in the ground"));
}

TEST_CASE("sum") {
  GRADE(predicted("top_sinks_10_boxes", "mm"), sinks(10, 10, 1, 30), kMargin, unit("mm"),
        about("ten boxes at 30 Hz: how far the top sinks"));
}

TEST_CASE("forty") {
  GRADE(predicted("top_sinks_40_boxes", "mm"), sinks(40, 40, 1, 30), kMargin, unit("mm"),
        about("forty boxes at 30 Hz: how far the top sinks"));
}

TEST_CASE("mass") {
  GRADE(predicted("top_sinks_10_heavy_boxes", "mm"), sinks(10, 10, 10, 30), kMargin, unit("mm"),
        about("ten boxes of 10 kg at 30 Hz: how far the top sinks"));
}

TEST_CASE("stiff") {
  GRADE(predicted("top_sinks_10_boxes_60_hz", "mm"), sinks(10, 10, 1, 60), kMargin, unit("mm"),
        about("ten boxes at 60 Hz: how far the top sinks"));
}

PROBES() {
  PROBE(predicted("ground_overlap_10_boxes", "mm"));
  PROBE(predicted("top_sinks_10_boxes", "mm"));
  PROBE(predicted("top_sinks_40_boxes", "mm"));
  PROBE(predicted("top_sinks_10_heavy_boxes", "mm"));
  PROBE(predicted("top_sinks_10_boxes_60_hz", "mm"));
}
