#include "pipeline/result_names.h"

#include <mutex>
#include <set>

namespace bole::pipeline {
namespace {

struct Names {
  std::mutex mutex;
  std::set<std::string, std::less<>> all{"summary.json"};
};

Names& names() {
  static Names list;
  return list;
}

}  // namespace

void add_result_names(const std::vector<std::string_view>& more) {
  const std::lock_guard lock(names().mutex);
  for (const auto name : more) names().all.emplace(name);
}

bool is_result_name(std::string_view name) {
  const std::lock_guard lock(names().mutex);
  return names().all.contains(name);
}

}  // namespace bole::pipeline
