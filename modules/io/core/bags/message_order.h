// What the recording times of a topic tell before a message is decoded.
#pragma once

#include "base/report.h"
#include "io/core/bags/bag.h"

namespace bole::io {

// The usual time between messages, by their recording times. 0.1 s where there are too few.
double usual_period_s(const std::vector<BagMessage>& messages);

// Drops messages that are there twice, as in a bag merged with itself: recorded at once, with the same stamp.
// Reports them, messages that are missing between others, and recording times that cannot be.
void check_order(const Bag& bag, const BagTopic& topic, std::vector<BagMessage>& messages, const Run& run,
                 Report& report);

}  // namespace bole::io
