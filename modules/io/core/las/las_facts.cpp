#include "io/core/las/las_facts.h"

namespace bole::io::las {

Facts read_facts(Bytes file, const LasInfo& info, std::vector<std::string>& warnings) {
  const auto* vlr = find_vlr(info, facts_user, facts_record);
  if (vlr == nullptr) return {};
  if (vlr->length > max_vlr_bytes) {
    warnings.emplace_back("the facts of the file are damaged (too long) and were left out");
    return {};
  }
  const Bytes data = vlr_data(file, *vlr);
  return facts_from_json({reinterpret_cast<const char*>(data.data()), data.size()}, warnings);
}

}  // namespace bole::io::las
