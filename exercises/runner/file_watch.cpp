#include "runner/file_watch.hpp"

#include <algorithm>

#include "runner/text.hpp"

namespace carom::runner {

using std::chrono::minutes;
using std::chrono::seconds;

FileWatch::FileWatch(const std::optional<std::string>& content, Clock::time_point now)
    : accepted_(content ? hashOf(*content) : ""), last_(now) {}

FileWatch::Seen FileWatch::look(const std::optional<std::string>& content, Clock::time_point now,
                                Milliseconds cost) {
  // The slowest of the last looks counts, and is forgotten slowly: one look may be answered from memory.
  cost_ = std::max(cost, cost_ - cost_ / 8);
  if (!content) {
    candidate_.clear();
    if (!missing_) missing_ = now;
    if (saidGone_ || now - *missing_ <= seconds(1)) return Seen::nothing;
    saidGone_ = true;
    accepted_.clear();
    return Seen::gone;
  }
  missing_.reset();
  saidGone_ = false;
  const std::string hash = hashOf(*content);
  if (hash == accepted_) {
    candidate_.clear();
    return Seen::nothing;
  }
  last_ = now;
  if (hash != candidate_) {
    candidate_ = hash;
    return Seen::nothing;
  }
  accepted_ = hash;
  candidate_.clear();
  return Seen::changed;
}

FileWatch::Milliseconds FileWatch::wait(Clock::time_point now) const {
  const auto idle = now - last_;
  Milliseconds wait(1000);
  if (!candidate_.empty())
    wait = Milliseconds(40);
  else if (missing_ || idle < minutes(2))
    wait = Milliseconds(200);
  else if (idle < minutes(20))
    wait = Milliseconds(500);
  return std::max(wait, 20 * cost_);
}

}  // namespace carom::runner
