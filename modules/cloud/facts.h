// What is known of clouds, tables, trajectories and recordings as a whole. Facts travel with the data: a stage hands on
// those that it does not change, files keep them, and no stage guesses them from the options of another.
#pragma once

#include <functional>
#include <map>
#include <string>

namespace bole {
inline namespace cloud {

using Facts = std::map<std::string, std::string, std::less<>>;

}  // namespace cloud
}  // namespace bole
