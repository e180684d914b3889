// Vertices and faces, edges and edges: every answer of a set of queries against the known one.
//
//   test_feature_queries FILE.json    the project's own set (tests/cases/toi_queries.json)
//   test_feature_queries FOLDER       the public Sample Queries; without a name: skipped (77)
//
// A false negative, a false positive, a time that is late by anything, or early by more than a
// unit in the last place: each is a failure.

#include <cmath>
#include <iostream>
#include <limits>

#include "carom/toi/feature_impact.hpp"
#include "support/ccd_queries.hpp"

int main(int argc, char** argv) {
  const std::string path = argc > 1 ? argv[1] : "";
  if (path.empty()) {
    std::cout << "skipped: give the folder of the queries as CAROM_CCD_QUERIES_DIR\n";
    return 77;
  }
  const bool own = std::filesystem::path(path).extension() == ".json";
  const auto queries = own ? carom_test::ownQueries(path) : carom_test::publicQueries(path);

  int hits = 0, timed = 0, falseNegatives = 0, falsePositives = 0, late = 0, early = 0;
  long double earliest = 0;
  for (const auto& q : queries) {
    const carom::FeatureImpact result = q.pair == carom::FeaturePair::kVertexFace
                                            ? carom::vertexFaceImpact(q.points)
                                            : carom::edgeEdgeImpact(q.points);
    const bool isHit = result.impact.status == carom::ImpactStatus::kHit;
    hits += q.isHit;
    falseNegatives += q.isHit && !isHit;
    falsePositives += !q.isHit && isHit;
    if (!isHit || !q.time) continue;
    ++timed;
    // The reference has 19 digits here, of the 25 it is written with.
    const long double ahead = *q.time - static_cast<long double>(result.impact.time);
    const long double unit =
        std::nextafter(result.impact.time, 2) - static_cast<long double>(result.impact.time);
    late += ahead < -2 * std::numeric_limits<long double>::epsilon() * *q.time;
    early += ahead > 1.001L * unit;
    earliest = std::max(earliest, ahead);
  }
  std::cout << queries.size() << " queries, " << hits << " hits: " << falseNegatives
            << " false negatives, " << falsePositives << " false positives; of " << timed
            << " times " << late << " late, " << early
            << " early by more than a unit in the last place, at most by " << earliest << '\n';
  const bool enough = queries.size() > 100 && hits > 50 && timed == hits;
  return enough && falseNegatives + falsePositives + late + early == 0 ? 0 : 1;
}
