// The rows of the table of file formats. Their order is that in which they are asked.
#pragma once

#include <vector>

#include "io/core/formats.h"

namespace bole::io {

// Scans, clouds and folders of views: those known by their first bytes, then those whose ending decides where the
// content does not (scan_format_rows.cpp).
void add_scan_formats(std::vector<Format>& rows);

// Tables, tracks and trajectories. They are told apart by the stage that reads them, then by their content
// (table_format_rows.cpp).
void add_table_formats(std::vector<Format>& rows);

}  // namespace bole::io
