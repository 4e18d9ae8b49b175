// A training that was interrupted goes on from a file, and ends as if it had not been.
#pragma once

#include <filesystem>
#include <string>

#include "plant/core/training/training_state.h"

namespace bole::plant {

// Names what a training starts from: the options that shape it, the region, and the pictures, cameras and poses of the
// views. A checkpoint serves for the same key only. The time limit and the cloud are no part of it.
std::string training_key(const FieldOptions& options, const Region& region, const std::vector<FieldView>& views);

// Writes the whole state; the file appears complete or not at all. Throws Error{failed} where it cannot be written.
void write_checkpoint(const std::filesystem::path& path, const std::string& key, TrainingState& state);

// Sets the state to that of the file. Throws Error{bad_input} where the file is damaged or belongs to another training;
// the state is of no use then.
void read_checkpoint(const std::filesystem::path& path, const std::string& key, const FieldOptions& options,
                     bool has_depth, TrainingState& state);

}  // namespace bole::plant
