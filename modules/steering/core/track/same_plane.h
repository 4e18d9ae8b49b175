// Coordinates are compared in one plane only.
#pragma once

#include <string>

#include "base/error.h"
#include "cloud/known_facts.h"
#include "cloud/table.h"

namespace bole::steering {

// Throws Error{bad_input} where both tables say in which plane they lie, and differ. `names`: "lines and log".
inline void check_same_plane(const Table& a, const Table& b, const std::string& names) {
  const auto p = fact_text(a.facts, facts::crs), q = fact_text(b.facts, facts::crs);
  if (p && q && *p != *q)
    throw bad_input(names + " lie in different planes", "one plane for both",
                    "Set the same plane and zone for both (stage geo.project)");
}

}  // namespace bole::steering
