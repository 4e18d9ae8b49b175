// What columns of tables are called for people. Files, filters and options keep the names of the data.
#pragma once

#include <QString>
#include <string>

namespace bole::desktop {

struct ColumnWords {
  QString title, unit, help;  // "DBH", "cm", "Diameter at breast height"; unit and help may be empty
  QString header() const;     // "DBH (cm)"
};

// Of a column that nobody described: its name without underscores, and the unit in which the name ends.
ColumnWords column_words(const std::string& name);

}  // namespace bole::desktop
