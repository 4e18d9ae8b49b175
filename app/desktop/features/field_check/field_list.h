// A list of trees measured in the field: which of its columns are what, and what the options of the evaluation are
// then.
#pragma once

#include <string>
#include <vector>

#include "cloud/table.h"
#include "pipeline/document.h"

namespace bole::desktop {

// One quantity that the evaluation needs and the columns whose names say that they are it.
struct FieldColumn {
  std::string name;                // as the evaluation calls it: x_m, y_m, dbh_cm, ...
  std::vector<std::string> units;  // that it may be measured in, the usual one first
  bool needed = false;             // unless azimuth and distance stand for x and y
};
const std::vector<FieldColumn>& field_columns();

struct FieldMapping {
  struct Entry {
    std::string name, source, unit;
  };
  std::vector<Entry> entries;
  // As the option reference_columns takes it: "x_m=E, dbh_cm=DIAM:mm".
  std::string text() const;
};

// By the names of the columns in English, German and Chinese; units in them are respected ("Diameter (mm)").
FieldMapping guess_mapping(const Table& list);

// The document with the list as the reference of its evaluation; the two stages are added where they are not there.
// `align` is a choice of the option align_stems. Throws Error{bad_input} when there are no stems to evaluate.
pipeline::PipelineDocument with_field_list(const pipeline::PipelineDocument& document, const std::string& file,
                                           const FieldMapping& mapping, const std::string& align);

}  // namespace bole::desktop
