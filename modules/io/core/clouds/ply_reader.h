// PLY files (Stanford polygon format): the vertices, from ascii and both binary encodings.
// Source: G. Turk, "The PLY Polygon File Format".
#pragma once

#include "io/core/clouds/cloud_reader.h"

namespace bole::io {

// The facts of a cloud are a comment in the header, as a JSON object of texts:
//   comment Bole facts {"sensor":"VLP-32C"}
inline constexpr std::string_view ply_facts_comment = "comment Bole facts ";

bool looks_like_ply(Bytes file);

// Reads all scalar types; list properties and other elements are skipped. Throws Error{bad_input} that names the header
// line that cannot be used. Warns of points missing at the end.
CloudReading read_ply(Bytes file, const CloudReadOptions& options, const Run& run);

}  // namespace bole::io
