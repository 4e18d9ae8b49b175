// Which columns of a field list are what, by their headings.
#pragma once

#include <string>
#include <vector>

#include "cloud/table.h"

namespace bole::evaluation {

// One quantity that an evaluation takes and the units that a list may have it in.
struct FieldColumn {
  std::string name;                // as the evaluation calls it: x_m, y_m, dbh_cm, ...
  std::vector<std::string> units;  // the usual one first; none for ids and words
  bool needed = false;             // unless azimuth and distance stand for x and y
};
const std::vector<FieldColumn>& field_columns();

struct FieldMapping {
  struct Entry {
    std::string name, source, unit;
  };
  std::vector<Entry> entries;
  // As the option reference_columns takes it: "x_m=E, dbh_cm=DIAM:mm". Columns that have our names and units are left
  // out.
  std::string text() const;
  // Whether there is a column for the diameter, and for x and y or azimuth and distance.
  bool complete() const;
};

// By the headings in English, German and Chinese. Units in them are respected ("Diameter (mm)"); diameters without a
// unit whose middle is above 150 are millimetres.
FieldMapping guess_mapping(const Table& list);

}  // namespace bole::evaluation
